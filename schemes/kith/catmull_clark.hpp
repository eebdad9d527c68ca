// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/crease/sharp_rules.hpp>
#include <kith/split/quad_split.hpp>
#include <kith/step/blocks.hpp>

#include <cstddef>

namespace kith {

/// Catmull-Clark: uniform bicubic B-splines for polygon meshes of any kind. After one step all faces are quads.
/// Catmull & Clark 1978; v-mask as DeRose, Kass & Truong 1998 write it, with e the old neighbours (the thesis, 2.1.1, adds
/// the new e-points instead, which is not Catmull-Clark; docs/schemes.md). Boundary: uniform cubic B-spline.
/// C2, at extraordinary vertices C1. Cost: O(corners).
struct catmull_clark {
    boundary_corner corners = boundary_corner::kept;
    creases sharpness{}; ///< of this level's edges and vertices; handed on to the next level

    static constexpr auto traits()
    {
        return scheme_traits{.name = "catmull-clark",
                             .trusted = true,
                             .reach = [](const catmull_clark& s, int rings) { return s.sharpness.reach(rings); },
                             .state = &catmull_clark::sharpness,
                             .ignores_numbers = [](const catmull_clark& s) { return s.sharpness.empty(); }};
    }
    static constexpr auto columns() { return quad_split::columns(); }

    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        const auto& [coarse, assoc, generation] = r;
        const sharp_rules sharp(coarse, sharpness, corners);

        for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });

        in_blocks(r, [&](const auto& block) {
            sharp.make_edges(
                block, [&](auto e) { return average(e.org(), e.dst(), assoc(e.lface(), V), assoc(e.rface(), V)); });

            sharp.make_vertices(block, [&](auto v) {
                const auto ring = v.corners().map([&](auto c) { return c.next().v() + assoc(c.f(), V); });
                return around(v, ring, [](std::size_t valence) {
                    const auto n = real(double(valence));
                    return ring_weights<real>{(n - 2) / n, 1 / (n * n)};
                });
            });

            quad_split::connect(block);
        });
    }
};

} // namespace kith
