// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shared_connections.hpp"

#include <kith/numbering/step/refinement.hpp>

namespace kith {

/// The ternary quad split: every vertex, every end of an edge and every corner gives birth to a vertex; every face to a
/// face of its own degree, every side of a face and every corner to a quad. Thesis 2.1.5. Nasri-Hasbini uses it.
struct ternary_split {
    static constexpr auto columns()
    {
        return kith::columns(new_vertices(per_vertex, per_end, per_corner),
                             new_edges(per_end, per_edge, per_corner_side, per_side),
                             new_faces(per_face.of_degree(same_degree{}), quads(per_side), quads(per_corner)));
    }

    template <step_context R>
    static void connect(const R& r)
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        make_faces_inside(r);
        for_each(coarse.corners(), [&](auto c) {
            const auto v = c.v();
            const auto w = c.next().v();
            const auto f = c.f();
            const auto en = c.next_edge();
            const auto ep = c.prev_edge();
            assoc(en, f, F) = polygon(assoc(v, en, V) >> assoc(en, E).along(en),
                                      assoc(w, en, V) >> assoc(c.next(), en, E).left(),
                                      assoc(c.next(), V) >> assoc(en, f, E).right(),
                                      assoc(c, V) >> assoc(c, en, E).right());
            assoc(c, F) = polygon(assoc(v, V) >> assoc(v, en, E).along(en),
                                  assoc(v, en, V) >> assoc(c, en, E).left(),
                                  assoc(c, V) >> assoc(c, ep, E).right(),
                                  assoc(v, ep, V) >> assoc(v, ep, E).along(ep));
            assoc(c, V).starts_at(assoc(c, F).corner(2), assoc(c, ep, E).right());
        });
        start_fans_along_ends(r);
        for_each(coarse.edges(), [&](auto e) {
            const auto c = e.lcorner();
            assoc(e.org(), e, V).starts_at(assoc(c, F).corner(1), assoc(c, e, E).left());
            assoc(e.dst(), e, V).starts_at(assoc(c.next(), F).corner(3), assoc(e.dst(), e, E).left());
        });
    }
};

} // namespace kith
