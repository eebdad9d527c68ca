// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shared_connections.hpp"

#include <kith/numbering/step/refinement.hpp>

namespace kith {

/// The primal triangle split: every vertex and edge gives birth to a vertex, every corner to a triangle, every face to
/// the triangle in its middle. Loop, Butterfly and the linear split of triangles use it.
struct triangle_split {
    static constexpr auto columns()
    {
        return kith::columns(new_vertices(per_vertex, per_edge),
                             new_edges(per_end, per_corner),
                             new_faces(triangles(per_corner), triangles(per_face)));
    }

    template <step_context R>
    static void connect(const R& r)
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.faces(), [&](auto f) {
            for (const auto c : f.corners()) {
                const auto v = c.v();
                const auto en = c.next_edge();
                const auto ep = c.prev_edge();
                assoc(c, F) = polygon(assoc(v, V) >> assoc(v, en, E).along(en),
                                      assoc(en, V) >> assoc(c, E).left(),
                                      assoc(ep, V) >> assoc(v, ep, E).along(ep));
            }
            assoc(f, F) = polygon(f.corners(), [&](auto c) { // from the edge before corner c to the edge after it
                return assoc(c.prev_edge(), V) >> assoc(c, E).right();
            });
        });
        start_fans_along_ends(r);
        for_each_by_number(coarse.edges(), [&](auto e) {
            const auto c = e.lcorner();
            assoc(e, V).starts_at(assoc(c, F).corner(1), assoc(c, E).left());
        });
    }
};

} // namespace kith
