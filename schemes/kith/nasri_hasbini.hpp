// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/nasri_hasbini/vertices.hpp>
#include <kith/schemes/split/ternary_split.hpp>

namespace kith {

/// Nasri-Hasbini: ternary refinement of bicubic B-splines, three times as fine per step, for polygons of any kind. The
/// split and the masks of the regular part are published (thesis 2.1.5). The masks around extraordinary vertices, in
/// faces that are not quads and at irregular boundary vertices are not the original authors'; docs/schemes.md defines
/// them. C2 in the regular part. Extraordinary vertices and faces persist. Cost: O(corners); each corner of a large
/// face costs O(log large faces).
struct nasri_hasbini {
    static constexpr auto traits()
    {
        return scheme_traits{.name = "nasri-hasbini",
                             .trusted = true,
                             .reach = [](int rings) { return (rings + 1) / 3 + 1; },
                             .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return ternary_split::columns(); }

    /// Makes the step. All points (v), (v,e), (v,f) of a vertex are masks over its ring, so one loop over the vertices
    /// makes them all. The masks here are those of inner vertices among quads; docs/schemes.md.
    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        detail::make_ternary_points(r, [&assoc = r.assoc](const auto& v, const auto& weights) {
            const auto first = v.first_corner();
            const auto ring = 304. * average(first.neighbors_from_here()) + 64. * average(first.opposites_from_here());
            assoc(v, V) = (361. * v + ring) / 729;
            for (const auto c : v.corners()) {
                const auto e = c.neighbors_from_here();
                const auto d = c.opposites_from_here();
                assoc(v, c.next_edge(), V) = (304. * v + sum(e, weights.b) + sum(d, weights.c)) / 729;
                assoc(c, V) = (256. * v + sum(e, weights.q) + sum(d, weights.g)) / 729;
            }
        });
        ternary_split::connect(r);
    }
};

} // namespace kith
#define KITH_SCHEME nasri_hasbini
#define KITH_SCHEME_OF_DOUBLES
#include <kith/schemes/compiled/in_library.hpp>
