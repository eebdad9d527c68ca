// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "library.hpp"

#include <kith/base/cos_turn.hpp>
#include <kith/crease/sharp_rules.hpp>
#include <kith/limit/limit.hpp>
#include <kith/mask/weight_table.hpp>
#include <kith/split/require_faces.hpp>
#include <kith/split/triangle_split.hpp>
#include <kith/step/blocks.hpp>

#include <cstddef>
#include <cstdint>

namespace kith {

enum class loop_weights : unsigned char {
    loop,  ///< Loop 1987, with cosines
    warren ///< Warren 1995: 3/16 at valence 3, else 3/(8n)
};

/// Loop: quartic box splines for triangle meshes. Loop 1987; boundary Hoppe et al. 1994 with the cubic B-spline curve.
/// C2, at vertices of valence other than 6 C1. Cost: O(corners).
struct loop {
    loop_weights weights = loop_weights::loop;
    boundary_corner corners = boundary_corner::kept;
    creases sharpness{}; ///< of this level's edges and vertices; handed on to the next level

    static constexpr auto traits()
    {
        return scheme_traits{.name = "loop",
                             .faces = face_shape::triangles,
                             .trusted = true,
                             .require = [](const auto& level, int) { require_three_faces<loop>(level); },
                             .reach = [](const loop& s, int rings) { return s.sharpness.reach(rings); },
                             .state = &loop::sharpness,
                             .ignores_numbers = [](const loop& s) { return s.sharpness.empty(); }};
    }
    static constexpr auto columns() { return triangle_split::columns(); }

    /// CGAL, OpenMesh and libigl smooth boundary corners; libigl takes Warren's weights.
    static loop like(library other)
    {
        const bool keep = other == library::kith or other == library::opensubdiv;
        return {.weights = other == library::libigl ? loop_weights::warren : loop_weights::loop,
                .corners = keep ? boundary_corner::kept : boundary_corner::smoothed};
    }

    /// The weight of each neighbour of a vertex of valence n.
    [[nodiscard]] constexpr double beta(std::size_t n) const
    {
        if (weights == loop_weights::warren)
            return n == 3 ? 3. / 16 : 3. / (8. * double(n));
        const double c = 3. / 8 + cos_turn(1, std::int64_t(n)) / 4;
        return (5. / 8 - c * c) / double(n);
    }

    /// The left eigenvector of the vertex's own matrix; `use(mask)` is called unless no closed mask is known for v.
    template <class Level, class Use>
    void limit_position(const sharp_rules<Level>& sharp, const vertex<Level>& v, const Use& use) const
    {
        if (not sharp.is_smooth(v))
            return limit_on_curve(sharp, v, use);
        const double n = double(v.valence());
        const double g = 1 / (n + 3 / (8 * beta(v.valence())));
        use((1 - n * g) * v + g * sum(v.neighbors()));
    }
    /// Two tangents, counter-clockwise. Hoppe et al. 1994; at boundary vertices with other than three faces the left
    /// eigenvector of the plain rule, docs/schemes.md.
    template <class Level, class Use>
    void limit_tangents(const sharp_rules<Level>& sharp, const vertex<Level>& v, const Use& use) const
    {
        const std::size_t k = v.face_count();
        const bool inside = sharp.is_smooth(v);
        if (not inside and not sharp.is_on_boundary_curve(v))
            return limit_at_corner(sharp, v, use);
        const auto turns = std::int64_t(inside ? k : 2 * k); // the ring spans a full turn, or half of one
        const auto sine = [turns](std::size_t j) { return sin_turn(std::int64_t(j), turns); };
        if (inside) {
            use(sum(v.neighbors(), [turns](std::size_t j) { return cos_turn(std::int64_t(j), turns); }),
                sum(v.neighbors(), sine));
        } else {
            const double cotangent = cos_turn(1, 2 * turns) / sin_turn(1, 2 * turns);
            const double x = (sine(1) - cotangent) / (1 + 2 * cos_turn(1, turns));
            use(v.first_rim() - v.last_rim(), // the sines of the two boundary edges are zero
                -(2 * x + cotangent) * v + x * (v.first_rim() + v.last_rim()) + sum(v.neighbors(), sine));
        }
    }

    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        const auto& [coarse, assoc, generation] = r;
        const sharp_rules sharp(coarse, sharpness, corners);
        const weight_table<real> betas([this](std::size_t n) { return beta(n); });

        in_blocks(r, [&](const auto& block) {
            sharp.make_edges(block, [](auto e) {
                return 3. / 8 * (e.org() + e.dst()) + 1. / 8 * (e.lcorner().prev().v() + e.rcorner().prev().v());
            });

            sharp.make_vertices(block, [&](auto v) {
                const auto ring = v.corners().map([](auto c) { return c.next().v(); });
                return around(v, ring, [&betas](std::size_t n) {
                    const real beta = betas[n];
                    return ring_weights<real>{1 - real(double(n)) * beta, beta};
                });
            });

            triangle_split::connect(block);
        });
    }
};

} // namespace kith
