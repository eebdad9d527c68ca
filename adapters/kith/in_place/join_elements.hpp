// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/for_parts.hpp>
#include <kith/mesh/basic_mesh.hpp>
#include <kith/mesh/foreign_level.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith::in_place {

/// Joins the elements of a mesh that has as many edges and faces as these connectivity arrays and no others, none of
/// them joined yet, by what its `mesh_traits` write: edge i and face i are those with that index, and handle_of(v) is
/// the handle of vertex v. Cost: O(elements).
template <fillable_mesh M, class HandleOf>
void join_elements(M& mesh, const connectivity<std::uint32_t>& t, const HandleOf& handle_of)
{
    using traits = mesh_traits<M>;
    using index = std::uint32_t;
    const auto halfedge = [](std::size_t i) { return traits::template at<typename traits::halfedge>(i); };
    const auto face = [](std::size_t i) { return traits::template at<typename traits::face>(i); };
    detail::for_parts(t.vertices, true, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            traits::set_start(mesh, handle_of(v), halfedge(t.corner_halfedge[t.vertex_corner[v]]));
    });
    detail::for_parts(t.faces, true, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const index first = t.first_corner(f), behind = t.first_corner(f + 1);
            for (index c = first; c < behind; ++c) {
                const index next = c + 1 == behind ? first : c + 1;
                traits::set_side(mesh,
                                 halfedge(t.corner_halfedge[c]),
                                 face(f),
                                 handle_of(t.corner_vertex[next]),
                                 halfedge(t.corner_halfedge[next]));
            }
            traits::set_start(mesh, face(f), halfedge(t.corner_halfedge[first]), behind - first);
        }
    });

    // Along the boundary the sides without a face run the other way.
    std::vector<index> outer; // those sides
    std::vector<index> leaving(t.vertices);
    for (std::size_t e = 0; e < t.edges(); ++e)
        if (const auto side = index(2 * e + 1); t.halfedge_corner[side] == t.none) {
            outer.push_back(side);
            leaving[t.ends(e)[1]] = side;
        }
    for (const index side : outer) {
        const index to = t.ends(side / 2)[0]; // its edge is directed by the inner side
        traits::set_boundary_side(mesh, halfedge(side), handle_of(to), halfedge(leaving[to]));
    }
}

} // namespace kith::in_place
