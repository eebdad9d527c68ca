// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/cos_turn.hpp>
#include <kith/crease/sharp_rules.hpp>
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

    /// The weight of each neighbour of a vertex of valence n.
    [[nodiscard]] constexpr double beta(std::size_t n) const
    {
        if (weights == loop_weights::warren)
            return n == 3 ? 3. / 16 : 3. / (8. * double(n));
        const double c = 3. / 8 + cos_turn(1, std::int64_t(n)) / 4;
        return (5. / 8 - c * c) / double(n);
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
