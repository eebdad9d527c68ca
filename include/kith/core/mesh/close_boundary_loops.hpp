// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "basic_mesh.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith {

/// Returns the mesh with a cone of triangles over every boundary loop, so that schemes for closed meshes can refine a
/// part of a mesh. Elements out of reach of the cones are refined as in the whole mesh. All elements keep their
/// numbers; those of the cones come after them. Precondition: the mesh has its edges. Cost: O(elements).
template <class Point, std::unsigned_integral Index>
basic_mesh<Point, Index> close_boundary_loops(const basic_mesh<Point, Index>& mesh)
{
    constexpr Index none = connectivity<Index>::none;
    const auto& t = mesh.topology();
    std::vector<Index> boundary; // the corners whose edges have no other side
    for (std::size_t e = 0; e < t.edges(); ++e)
        if (t.is_boundary(e))
            boundary.push_back(t.halfedge_corner[2 * e]);
    std::vector<Index> leaving(mesh.vertex_count(), none); // per vertex: the boundary edge that leaves it
    for (std::size_t i = 0; i < boundary.size(); ++i)
        leaving[t.corner_vertex[boundary[i]]] = Index(i);
    const auto end_of = [&](std::size_t i) { return t.target(boundary[i]); };
    std::vector<Index> apex(boundary.size(), none);
    std::vector<std::size_t> starts; // of the loops
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        if (apex[i] != none)
            continue;
        for (std::size_t j = i; apex[j] == none; j = leaving[end_of(j)])
            apex[j] = Index(mesh.vertex_count() + starts.size());
        starts.push_back(i);
    }

    connectivity<Index> closed;
    closed.vertices = mesh.vertex_count() + starts.size();
    closed.allocate_faces(mesh.face_count() + boundary.size(), t.degree == 3 ? 3 : 0, [&](std::size_t f) {
        return f < mesh.face_count() ? mesh.face(f).size() : 3;
    });
    const std::size_t corners = t.corners(), edges = t.edges();
    closed.allocate_edges(edges + boundary.size());
    closed.vertex_corner = storage<Index>(closed.vertices);
    const auto copy = [](const storage<Index>& from, storage<Index>& to) {
        std::copy(from.begin(), from.end(), to.begin());
    };
    copy(t.corner_vertex, closed.corner_vertex);
    copy(t.corner_halfedge, closed.corner_halfedge);
    copy(t.halfedge_corner, closed.halfedge_corner);
    copy(t.vertex_corner, closed.vertex_corner);
    // Spoke i goes from the start of boundary edge i to the apex.
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        const Index vertices[3] = {end_of(i), t.corner_vertex[boundary[i]], apex[i]};
        const Index halves[3] = {Index(t.corner_halfedge[boundary[i]] ^ 1),
                                 Index(2 * (edges + i)),
                                 Index(2 * (edges + leaving[end_of(i)]) + 1)};
        for (std::size_t k = 0; k < 3; ++k) {
            const Index corner = Index(corners + 3 * i + k);
            closed.corner_vertex[corner] = vertices[k];
            closed.set_side(corner, halves[k]);
        }
    }
    storage<Point> points(closed.vertices);
    std::copy(mesh.points().begin(), mesh.points().end(), points.begin());
    for (std::size_t loop = 0; loop < starts.size(); ++loop) {
        closed.vertex_corner[mesh.vertex_count() + loop] = Index(corners + 3 * starts[loop] + 2);
        points[mesh.vertex_count() + loop] = mesh.point(t.corner_vertex[boundary[starts[loop]]]);
    }
    return {std::move(points), std::move(closed), mesh.generation()};
}

} // namespace kith
