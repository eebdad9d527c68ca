// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/rules.hpp>
#include <kith/numbering/step/scheme_traits.hpp>
#include <kith/schemes/crease/sharp_rules.hpp>
#include <kith/schemes/split/quad_split.hpp>

namespace kith {

/// Catmull-Clark: uniform bicubic B-splines for polygon meshes of any kind. After one step all faces are quads. Catmull
/// & Clark 1978; the vertex mask is that of DeRose, Kass & Truong 1998, with e the old neighbours. (The thesis, 2.1.1,
/// adds the new edge points instead, which is not Catmull-Clark; docs/schemes.md.) Boundary: uniform cubic B-spline.
/// C2, at extraordinary vertices C1. Cost: O(corners).
struct catmull_clark {
    boundary_corner corners = boundary_corner::kept;
    boundary_curve boundary = boundary_curve::cubic;
    creases sharpness{}; ///< of this level's edges and vertices; each step computes those of the next level
    friend bool operator==(const catmull_clark&, const catmull_clark&) = default;

    static constexpr auto traits()
    {
        return scheme_traits{.name = "catmull-clark",
                             .trusted = true,
                             .reach = [](const catmull_clark& s, int rings) { return s.sharpness.reach(rings); },
                             .state = &catmull_clark::sharpness,
                             .ignores_numbers = [](const catmull_clark& s) { return s.sharpness.empty(); }};
    }
    static constexpr auto columns() { return quad_split::columns(); }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        const sharp_rules sharp(coarse, sharpness, corners, boundary);

        for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });

        const auto edge_point = [&](auto e) {
            return average(e.org(), e.dst(), assoc(e.lface(), V), assoc(e.rface(), V));
        };
        const auto vertex_point = [&](auto v) {
            const auto ring = v.corners().map([&](auto c) { return c.next().v() + assoc(c.f(), V); });
            return around(v, ring, [](auto n, auto v, auto sum) { return (n - 2) / n * v + 1 / (n * n) * sum; });
        };
        subdivide(quad_split(), r, sharp.at_edges(edge_point), sharp.at_vertices(vertex_point));
    }
};

} // namespace kith
#define KITH_SCHEME catmull_clark
#include <kith/schemes/compiled/in_library.hpp>
