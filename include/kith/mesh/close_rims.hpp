// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "basic_mesh.hpp"
#include "match.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith {

/// The mesh with a cone of triangles over every boundary loop, so that schemes for closed meshes can refine a part of one:
/// what does not reach as far as the cones is as in the whole. All elements keep their numbers, those of the cones come
/// after them. Precondition: it has its edges. Cost: O(elements).
template <class Point, std::unsigned_integral Index>
basic_mesh<Point, Index> close_rims(const basic_mesh<Point, Index>& mesh)
{
    constexpr Index none = connectivity<Index>::none;
    const auto& t = mesh.topology();
    std::vector<Index> rim; // the corners whose edges have no other side
    for (std::size_t e = 0; e < t.edges(); ++e)
        if (t.halfedge_corner[2 * e + 1] == none)
            rim.push_back(t.halfedge_corner[2 * e]);
    std::vector<Index> leaving(mesh.vertex_count(), none); // per vertex: which edge of the rim leaves it
    for (std::size_t i = 0; i < rim.size(); ++i)
        leaving[t.corner_vertex[rim[i]]] = Index(i);
    const auto end_of = [&](std::size_t i) { return t.corner_vertex[detail::next_corner(t, rim[i])]; };
    std::vector<Index> apex(rim.size(), none);
    std::vector<std::size_t> starts; // of the loops
    for (std::size_t i = 0; i < rim.size(); ++i) {
        if (apex[i] != none)
            continue;
        for (std::size_t j = i; apex[j] == none; j = leaving[end_of(j)])
            apex[j] = Index(mesh.vertex_count() + starts.size());
        starts.push_back(i);
    }

    connectivity<Index> closed;
    closed.vertices = mesh.vertex_count() + starts.size();
    closed.faces = mesh.face_count() + rim.size();
    closed.degree = t.degree == 3 ? 3 : 0;
    const auto grown = [](const storage<Index>& array, std::size_t size) {
        storage<Index> result(size);
        std::copy(array.begin(), array.end(), result.begin());
        return result;
    };
    const std::size_t corners = t.corners(), edges = t.edges();
    closed.corner_vertex = grown(t.corner_vertex, corners + 3 * rim.size());
    closed.corner_halfedge = grown(t.corner_halfedge, corners + 3 * rim.size());
    closed.halfedge_corner = grown(t.halfedge_corner, 2 * (edges + rim.size()));
    closed.vertex_corner = grown(t.vertex_corner, closed.vertices);
    // Spoke i goes from the start of edge i of the rim to the apex.
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const Index vertices[3] = {end_of(i), t.corner_vertex[rim[i]], apex[i]};
        const Index halves[3] = {
            Index(t.corner_halfedge[rim[i]] ^ 1), Index(2 * (edges + i)), Index(2 * (edges + leaving[end_of(i)]) + 1)};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t corner = corners + 3 * i + k;
            closed.corner_vertex[corner] = vertices[k];
            closed.corner_halfedge[corner] = halves[k];
            closed.halfedge_corner[halves[k]] = Index(corner);
        }
    }
    storage<Point> points(closed.vertices);
    std::copy(mesh.points().begin(), mesh.points().end(), points.begin());
    for (std::size_t loop = 0; loop < starts.size(); ++loop) {
        closed.vertex_corner[mesh.vertex_count() + loop] = Index(corners + 3 * starts[loop] + 2);
        points[mesh.vertex_count() + loop] = mesh.point(t.corner_vertex[rim[starts[loop]]]);
    }
    if (closed.degree == 0) {
        closed.face_corner = storage<Index>(closed.faces + 1);
        closed.corner_face = storage<Index>(closed.corners());
        for (std::size_t f = 0; f <= closed.faces; ++f)
            closed.face_corner[f] = f <= mesh.face_count() ? t.first_corner(f)
                                                           : Index(corners + 3 * (f - mesh.face_count()));
        for (std::size_t f = 0; f < closed.faces; ++f)
            for (Index c = closed.face_corner[f]; c < closed.face_corner[f + 1]; ++c)
                closed.corner_face[c] = Index(f);
    }
    return {std::move(points), std::move(closed), mesh.generation()};
}

} // namespace kith
