// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tri_quad.hpp"

#include <kith/numbering/step/rules.hpp>
#include <kith/schemes/split/bisection_split.hpp>

#include <algorithm>

namespace kith {

/// 4-8: the four-directional box spline by bisection, twice the triangles per step. Velho & Zorin 2001; the masks are
/// those of the box spline of degree six (docs/schemes.md). C4, at extraordinary vertices C1. The scheme takes a
/// tri-quad mesh, which `tri_quad` makes from any mesh. Cost: O(corners).
struct four_eight {
    /// Returns the traits. Reach: one step makes no ring thinner along unmarked edges; two steps halve all edges,
    /// docs/distributed.md.
    static constexpr auto traits()
    {
        return scheme_traits{.name = "4-8",
                             .faces = face_shape::triangles,
                             .trusted = true,
                             .require = [](const auto& level, int) { bisection_split::require_marks(level); },
                             .reach = [](int rings, int steps) -> int {
                                 const bool is_counted = rings == 0 and steps <= 6;
                                 return is_counted ? std::min(steps, (steps + 3) / 2) : rings + steps;
                             },
                             .is_marked = [](const auto& e) { return bisection_split::is_marked(e); },
                             .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return bisection_split::columns(); }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& assoc = r.assoc;
        const auto midpoints = at_edges([&](auto e) {
            if (not bisection_split::is_marked(e))
                return;
            if (e.is_boundary())
                assoc(e, V) = average(e.org(), e.dst());
            else
                assoc(e, V) = average(e.org(), e.dst(), e.lcorner().prev().v(), e.rcorner().prev().v());
        });
        const auto vertices = at_vertices([&](auto v) {
            if (not v.is_boundary()) {
                const auto ends = sides(v).map([](const auto& c) { return c.next().v(); });
                assoc(v, V) = 1. / 2 * v + 1. / 2 * average(ends);
            } else if (bisection_split::is_marked(v.first_corner().next_edge()) and
                       bisection_split::is_marked(v.last_corner().prev_edge())) {
                assoc(v, V) = 3. / 4 * v + 1. / 8 * (v.first_rim() + v.last_rim());
            } else {
                assoc(v, V) = v;
            }
        });
        subdivide(bisection_split(), r, midpoints, vertices);
    }

    /// Returns the edges at v that are sides of the quads made of pairs of triangles. Each is given as the corner of v
    /// in the quad to its left.
    template <vertex_element Vertex>
    static auto sides(const Vertex& v)
    {
        return v.corners().only([](const auto& c) { return not bisection_split::is_first(c); });
    }
};

} // namespace kith
#define KITH_SCHEME four_eight
#include <kith/schemes/compiled/in_library.hpp>
