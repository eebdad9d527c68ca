// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/exact_cos.hpp>
#include <kith/numbering/step/rules.hpp>
#include <kith/schemes/crease/sharp_rules.hpp>
#include <kith/schemes/split/require_faces.hpp>
#include <kith/schemes/split/triangle_split.hpp>

#include <cstddef>

namespace kith {

/// The weight of each neighbour in the point of an inner vertex.
enum class loop_weights : unsigned char { loop, warren }; ///< Loop 1987; Warren 1995: 3/16 at valence 3, else 3/(8n)

/// Loop: quartic box splines for triangle meshes. Loop 1987; boundary Hoppe et al. 1994 with the cubic B-spline curve.
/// C2, at vertices of valence other than 6 C1. Cost: O(corners).
struct loop {
    loop_weights weights = loop_weights::loop;
    boundary_corner corners = boundary_corner::kept;
    creases sharpness{}; ///< of this level's edges and vertices; each step computes those of the next level
    friend bool operator==(const loop&, const loop&) = default;

    /// Returns the weight of each neighbour of a vertex of valence n.
    [[nodiscard]] constexpr double beta(std::size_t n) const
    {
        const double c = 3. / 8 + exact_cos(1, long(n)) / 4;
        return weights == loop_weights::loop ? (5. / 8 - c * c) / double(n) : n == 3 ? 3. / 16 : 3. / (8. * double(n));
    }

    static constexpr auto traits()
    {
        return scheme_traits{.name = "loop",
                             .faces = face_shape::triangles,
                             .trusted = true,
                             .require = three_faces_at_vertices,
                             .reach = [](const loop& s, int rings) { return s.sharpness.reach(rings); },
                             .state = &loop::sharpness,
                             .ignores_numbers = [](const loop& s) { return s.sharpness.empty(); }};
    }
    static constexpr auto columns() { return triangle_split::columns(); }

    template <step_context R>
    void operator()(const R& r) const
    {
        const sharp_rules sharp(r.coarse, sharpness, corners);
        const auto betas = by_valence(r, [this](std::size_t n) { return beta(n); });
        const auto tips = [](auto e) { return e.lcorner().prev().v() + e.rcorner().prev().v(); };
        const auto edge_point = [=](auto e) { return 3. / 8 * (e.org() + e.dst()) + 1. / 8 * tips(e); };
        const auto vertex_point = [&](auto v) {
            const auto ring = v.corners().map([](auto c) { return c.next().v(); });
            return around(v, ring, betas, [](auto n, auto b, auto v, auto sum) { return (1 - n * b) * v + b * sum; });
        };
        subdivide(triangle_split(), r, sharp.at_edges(edge_point), sharp.at_vertices(vertex_point));
    }
};

} // namespace kith
#define KITH_SCHEME loop
#include <kith/schemes/compiled/in_library.hpp>
