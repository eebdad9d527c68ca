// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/refinement.hpp>

namespace kith {

/// The mid-edge split: every edge gives birth to a vertex, every face and every vertex to a face. At the boundary a new
/// edge closes the face of a vertex; vertices with a single face there get none.
struct mid_edge_split {
    /// Returns the columns. Counts are exact for one step and for closed meshes. For further steps at a boundary they
    /// are an upper bound: they ignore runs of boundary vertices with a single face, which get no face of their own.
    static constexpr auto columns()
    {
        const auto capped = [](const auto& v) { return v.face_count() >= 2; };
        const auto caps = [](const counts& c) { return c.boundary_vertices() - c.boundary_vertices_of_one_face; };
        const auto valence = [](const auto& v) { return v.valence(); };
        return kith::columns(
                   new_vertices(per_edge),
                   new_edges(per_corner, per_vertex.on_boundary(capped, caps)),
                   new_faces(per_face.of_degree(same_degree{}),
                             per_vertex.inside_or(capped, &counts::boundary_vertices_of_one_face).of_degree(valence)))
            .with_boundary([](const counts& c) { return counts{.boundary_edges = c.boundary_edges}; });
    }

    template <step_context R>
    static void connect(const R& r)
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.faces(), [&](auto f) {
            assoc(f, F) = polygon(f.corners(),
                                  [&](auto c) { return assoc(c.next_edge(), V) >> assoc(c.next(), E).left(); });
        });
        for_each_by_number(coarse.vertices(), [&](auto v) {
            const auto beside = [&](auto c) { return assoc(c.next_edge(), V) >> assoc(c, E).right(); };
            if (coarse.is_closed() or not v.is_boundary())
                assoc(v, F) = polygon(v.corners(), beside);
            else if (v.face_count() >= 2)
                assoc(v, F) = polygon(v.edges(), [&](auto e) {
                    const auto c = e.seen_from(); // of v, except for the last edge
                    return c.v() == v ? beside(c) : assoc(e, V) >> assoc(v, E).left();
                });
        });
        for_each_by_number(coarse.edges(), [&](auto e) {
            const auto c = e.lcorner();
            assoc(e, V).starts_at(assoc(c.f(), F).corner(c.index() - c.f().first_corner().index()),
                                  assoc(c.next(), E).left());
        });
    }
};

} // namespace kith
