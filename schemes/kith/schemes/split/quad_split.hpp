// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shared_connections.hpp"

#include <kith/numbering/step/refinement.hpp>

namespace kith {

/// The primal quad split: every vertex, edge and face gives birth to a vertex, every corner to a quad. It takes any
/// polygons and makes quads. Catmull-Clark, Kobbelt, the linear split and unified of odd degree use it.
struct quad_split {
    static constexpr auto columns()
    {
        return kith::columns(
            new_vertices(per_vertex, per_edge, per_face), new_edges(per_end, per_side), new_faces(quads(per_corner)));
    }

    template <step_context R>
    static void connect(const R& r)
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.corners(), [&](auto c) {
            const auto v = c.v();
            const auto f = c.f();
            const auto en = c.next_edge();
            const auto ep = c.prev_edge();
            assoc(c, F) = polygon(assoc(v, V) >> assoc(v, en, E).along(en),
                                  assoc(en, V) >> assoc(en, f, E).left(),
                                  assoc(f, V) >> assoc(ep, f, E).right(),
                                  assoc(ep, V) >> assoc(v, ep, E).along(ep));
        });
        start_fans_along_ends(r);
        for_each_by_number(coarse.edges(), [&](auto e) {
            const auto c = e.lcorner();
            assoc(e, V).starts_at(assoc(c, F).corner(1), assoc(e, c.f(), E).left());
        });
        for_each_by_number(coarse.faces(), [&](auto f) {
            const auto c = f.first_corner();
            assoc(f, V).starts_at(assoc(c, F).corner(2), assoc(c.prev_edge(), f, E).right());
        });
    }
};

} // namespace kith
