// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shared_connections.hpp"

#include <kith/numbering/step/refinement.hpp>

namespace kith {

/// The dual split: every corner gives birth to a vertex; every face, inner edge and inner vertex to a face. If
/// `cap_boundary` is set, a boundary vertex with three or more faces gets a face, too. The new boundary is then the
/// corner-cut polygon of the old one, two points per vertex. Doo-Sabin and unified of even degree use it.
struct dual_split {
    bool cap_boundary = true;

    [[nodiscard]] constexpr auto columns() const
    {
        const auto capped = [cap = cap_boundary](const auto& v) { return cap and v.face_count() >= 3; };
        const auto caps = [cap = cap_boundary](const counts& c) { return cap ? c.boundary_vertices_of_many_faces : 0; };
        const auto not_capped = [caps](const counts& c) { return c.boundary_vertices() - caps(c); };
        const auto faces_around = [](const auto& v) { return v.face_count(); };
        return kith::columns(new_vertices(per_corner),
                             new_edges(per_side, per_end.inside(), per_vertex.on_boundary(capped, caps)),
                             new_faces(per_face.of_degree(same_degree{}),
                                       quads(per_edge).inside(),
                                       per_vertex.inside_or(capped, not_capped).of_degree(faces_around)))
            .with_boundary([cap = cap_boundary](const counts& c) { return next_boundary(c, cap); });
    }

    template <step_context R>
    void connect(const R& r) const
    {
        connect(r, [cap = cap_boundary](const auto& v) { return cap and v.face_count() >= 3; });
    }
    /// Connects the next level for columns that give other boundary vertices a face: those for which `is_capped(v)` is
    /// true.
    template <step_context R, class IsCapped>
    static void connect(const R& r, const IsCapped& is_capped)
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        make_faces_inside(r);
        for_each_by_number(coarse.edges(), [&](auto e) {
            if (e.is_boundary())
                return;
            const auto xl = e.lcorner(); // corners of the edge x -> y with faces L and R
            const auto yr = e.rcorner();
            assoc(e, F) = polygon(assoc(xl.next(), V) >> assoc(e, xl.f(), E).right(),
                                  assoc(xl, V) >> assoc(xl.v(), e, E).left(),
                                  assoc(yr.next(), V) >> assoc(e, yr.f(), E).right(),
                                  assoc(yr, V) >> assoc(yr.v(), e, E).left());
        });
        for_each_by_number(coarse.vertices(), [&](auto v) {
            if (v.is_boundary() and not is_capped(v))
                return;
            assoc(v, F) = polygon(v.corners(), [&](auto c) {
                const auto ep = c.prev_edge();
                return assoc(c, V) >> (ep.is_boundary() ? assoc(v, E).left() : assoc(v, ep, E).right());
            });
        });
        for_each(coarse.corners(), [&](auto c) {
            const auto f = c.f();
            assoc(c, V).starts_at(assoc(f, F).corner(c.index() - f.first_corner().index()),
                                  assoc(c.next_edge(), f, E).left());
        });
    }

private:
    static constexpr counts next_boundary(const counts& c, bool capped)
    {
        const auto one = c.boundary_vertices_of_one_face;
        const auto many = c.boundary_vertices_of_many_faces;
        const auto several = c.boundary_vertices() - one; // with two faces or more
        if (capped)                                       // two vertices per old one, with 2 faces, or 3 beside a cap
            return {.boundary_edges = c.boundary_edges + several,
                    .boundary_vertices_of_one_face = one,
                    .boundary_vertices_of_many_faces = 2 * many,
                    .boundary_corners = one + 2 * (2 * (several - many) + 3 * many)};
        // Every corner at the boundary stays there; all new vertices but the outer two of a fan have 3 faces.
        const auto corners_of_several = c.boundary_corners - one;
        return {.boundary_edges = c.boundary_edges + corners_of_several - several,
                .boundary_vertices_of_one_face = one,
                .boundary_vertices_of_many_faces = corners_of_several - 2 * several,
                .boundary_corners = one + 2 * 2 * several + 3 * (corners_of_several - 2 * several)};
    }
};

} // namespace kith
