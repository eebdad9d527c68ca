// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/refinement.hpp>

#include <cstddef>

namespace kith {

/// The sqrt(3) split of triangles: every vertex and face gives birth to a vertex, every half-edge to a triangle.
/// Half-edge x -> y makes (x, centre of its right face, centre of its left face). Boundary edges are left alone in even
/// steps and trisected in odd ones. A boundary face then has no centre. The new point on its boundary edge near the
/// corner that it shares with a half-edge replaces the centre. Kobbelt 2000, section 5.
struct sqrt3_split {
    static constexpr bool is_odd(int generation) { return generation % 2 != 0; }

    template <face_element Face>
    static std::size_t boundary_edges(const Face& f)
    {
        std::size_t count = 0;
        for (const auto& c : f.corners())
            count += c.is_boundary();
        return count;
    }
    /// Returns true for the faces that odd steps cut. A face with more boundary edges is left uncut: `sqrt3` refuses
    /// meshes with such a face, but a part of a mesh may have it at its border.
    template <face_element Face>
    static bool has_one_boundary_edge(const Face& f)
    {
        return boundary_edges(f) == 1;
    }

    static constexpr auto columns(int generation)
    {
        const auto cuts = [odd = is_odd(generation)](const counts& c) { return odd ? c.boundary_edges : 0; };
        const auto ends = [cuts](const counts& c) { return 2 * cuts(c); };
        const auto uncut = [even = not is_odd(generation)](const auto& f) {
            return even or not has_one_boundary_edge(f);
        };
        const auto at_uncut = [uncut](const auto& c) { return uncut(c.f()); };
        const auto cut = [uncut](const auto& e) { return not uncut(e.lface()); };
        // The edges per corner lead to the centre of the face. A boundary face has only two in an odd step, from its
        // apex to the two points on the boundary; the corner before the boundary edge is the one left out.
        return kith::columns(new_vertices(per_vertex, per_face.inside_or(uncut, cuts), per_end.on_boundary(cut, ends)),
                             new_edges(per_edge, per_corner.inside_or(at_uncut, cuts), per_end.on_boundary(cut, ends)),
                             new_faces(triangles(per_side)));
    }

    template <step_context R>
    static void connect(const R& r)
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        const bool odd = is_odd(generation) and not coarse.is_closed();

        // The new elements on the side of half-edge c: the point that stands for its face, the edge from its first
        // vertex to that point and the edge from its last vertex to it.
        const auto cut = [odd](auto c) { return odd and has_one_boundary_edge(c.f()); };
        const auto boundary_edge = [](auto c) { return c.prev().is_boundary() ? c.prev_edge() : c.next().next_edge(); };
        const auto centre = [&](auto c) {
            return cut(c) ? assoc(c.prev().is_boundary() ? c.v() : c.next().v(), boundary_edge(c), V).vertex()
                          : assoc(c.f(), V).vertex();
        };
        const auto from_start = [&](auto c) { // towards the first vertex, on the left of c
            if (not cut(c))
                return assoc(c, E).right();
            return c.prev().is_boundary() ? assoc(c.v(), boundary_edge(c), E).left() : assoc(c, E).right();
        };
        const auto to_end = [&](auto c) { // away from the last vertex
            if (not cut(c))
                return assoc(c.next(), E).left();
            return c.prev().is_boundary() ? assoc(c, E).left() : assoc(c.next().v(), boundary_edge(c), E).left();
        };

        for_each(coarse.corners(), [&](auto c) {
            const auto e = c.next_edge();
            const auto x = assoc(c.v(), V).vertex();
            if (not c.is_boundary()) {
                const auto o = c.across();
                assoc(c.next_edge(), c.f(), F) = polygon(
                    x >> to_end(o), centre(o) >> assoc(e, E).along(e), centre(c) >> from_start(c));
            } else if (not cut(c)) {
                assoc(e, c.f(), F) = polygon(x >> assoc(e, E).left(),
                                             assoc(c.next().v(), V) >> assoc(c.next(), E).left(),
                                             assoc(c.f(), V) >> assoc(c, E).right());
            } else {
                const auto y = c.next().v();
                assoc(e, c.f(), F) = polygon(assoc(c.v(), e, V) >> assoc(e, E).left(),
                                             assoc(y, e, V) >> assoc(c.next(), E).right(),
                                             assoc(c.prev().v(), V) >> assoc(c.prev(), E).left());
            }
        });
        for_each(coarse.vertices(), [&](auto v) {
            const auto c = v.first_corner();
            if (not c.is_boundary())
                assoc(v, V).starts_at(assoc(c.next_edge(), c.f(), F).corner(0), to_end(c.across()));
        });
        for_each(coarse.faces(), [&](auto f) {
            const auto c = f.first_corner();
            if (not cut(c))
                assoc(f, V).starts_at(assoc(c.next_edge(), c.f(), F).corner(2), from_start(c));
        });
    }
};

} // namespace kith
