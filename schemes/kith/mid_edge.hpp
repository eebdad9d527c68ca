// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/split/mid_edge_split.hpp>
#include <kith/schemes/split/require_faces.hpp>

namespace kith {

/// The mid-edge scheme, the simplest one: the new vertices are the midpoints of all edges. Peters & Reif 1997. C1
/// (quadratic box spline in the regular part; triangles that stay are the weak spot). It is meant for closed meshes: a
/// boundary loop keeps its number of edges and contracts. Cost: O(corners).
struct mid_edge {
    /// Returns the rings before `steps` steps. Two steps are one of the dual split, in which a point needs its face
    /// only, docs/distributed.md.
    static constexpr int rings_before(int steps, int rings)
    {
        rings += steps % 2;
        for (; steps > 1; steps -= 2)
            rings = rings / 2 + 1;
        return rings;
    }
    static constexpr auto traits()
    {
        return scheme_traits{.name = "mid-edge",
                             .trusted = true,
                             .valence = 4,
                             .require = three_faces_at_vertices,
                             .reach = [](int rings, int steps) { return rings_before(steps, rings); },
                             .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return mid_edge_split::columns(); }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
        mid_edge_split::connect(r);
    }
};

} // namespace kith
#define KITH_SCHEME mid_edge
#include <kith/schemes/compiled/in_library.hpp>
