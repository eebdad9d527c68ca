// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shared_connections.hpp"

#include <kith/numbering/step/refinement.hpp>

namespace kith {

/// Returns true for a triangle, and for a corner of one.
template <element Element>
bool is_in_triangle(const Element& x)
{
    if constexpr (face_element<Element>)
        return x.degree() == 3;
    else
        return x.f().degree() == 3;
}

/// The split that keeps triangles and quads: that of triangle_split for triangles and of quad_split for all other
/// polygons. Corners of triangles give birth to faces as sides (e,f), e after the corner, so that the new triangles
/// have the last numbers. On later levels each condition then picks consecutive tuples.
struct quad_triangle_split {
    static constexpr auto columns()
    {
        const auto is_triangle = [](const auto& x) { return is_in_triangle(x); };
        const auto is_other = [](const auto& x) { return not is_in_triangle(x); };
        const auto others = [](const counts& c) { return c.faces - c.triangles; };
        const auto corners_of_triangles = [](const counts& c) { return 3 * c.triangles; };
        const auto corners_of_others = [](const counts& c) { return c.corners() - 3 * c.triangles; };
        return kith::columns(new_vertices(per_vertex, per_edge, per_face.only(is_other, others)),
                             new_edges(per_end, per_corner),
                             new_faces(quads(per_corner.only(is_other, corners_of_others)),
                                       triangles(per_side.only(is_triangle, corners_of_triangles)),
                                       triangles(per_face.only(is_triangle, &counts::triangles))));
    }

    template <step_context R>
    static void connect(const R& r)
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.faces(), [&](auto f) {
            const bool is_triangle = is_in_triangle(f);
            for (const auto c : f.corners()) {
                const auto v = c.v();
                const auto en = c.next_edge();
                const auto ep = c.prev_edge();
                const auto first = assoc(v, V) >> assoc(v, en, E).along(en);
                const auto second = assoc(en, V) >> assoc(c, E).left();
                const auto last = assoc(ep, V) >> assoc(v, ep, E).along(ep);
                if (is_triangle)
                    assoc(en, f, F) = polygon(first, second, last);
                else
                    assoc(c, F) = polygon(first, second, assoc(f, V) >> assoc(c.prev(), E).right(), last);
            }
            if (is_triangle)
                assoc(f, F) = polygon(f.corners(), [&](auto c) { // from the edge before corner c to the edge after it
                    return assoc(c.prev_edge(), V) >> assoc(c, E).right();
                });
        });
        const auto corner_of_child = [&](auto c, std::size_t k) { // of the new face at corner c
            return is_in_triangle(c) ? assoc(c.next_edge(), c.f(), F).corner(k) : assoc(c, F).corner(k);
        };
        for_each_by_number(coarse.vertices(), [&](auto v) {
            const auto c = v.first_corner();
            assoc(v, V).starts_at(corner_of_child(c, 0), assoc(v, c.next_edge(), E).along(c.next_edge()));
        });
        for_each_by_number(coarse.edges(), [&](auto e) {
            const auto c = e.lcorner();
            assoc(e, V).starts_at(corner_of_child(c, 1), assoc(c, E).left());
        });
        for_each_by_number(coarse.faces(), [&](auto f) {
            const auto c = f.first_corner();
            if (not is_in_triangle(f))
                assoc(f, V).starts_at(assoc(c, F).corner(2), assoc(c.prev(), E).right());
        });
    }
};

} // namespace kith
