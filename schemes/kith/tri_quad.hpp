// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/fields/field.hpp>
#include <kith/refine_with_fields.hpp>
#include <kith/schemes/split/bisection_split.hpp>
#include <kith/schemes/split/choose_diagonals.hpp>
#include <kith/schemes/split/tri_quad_splits.hpp>

#include <algorithm>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

/// Returns the tri-quad mesh from which 4-8 subdivision starts. Quads are cut along a diagonal; the choice makes no
/// difference to the next levels. Meshes with other faces get a vertex in the middle of every face. Quads cut along a
/// diagonal are generation 0. One step marks all their edges, which is how the other meshes start, so these are
/// generation 1. A quad is cut along the diagonal with its smallest vertex or, if another edge would join the same two
/// vertices, along the other one. Diagonals, directions and starts of fans depend on the numbers of vertices, not on
/// the order of faces. Fields of the mesh become those of the returned mesh: tri_quad(mesh, std::tie(material, uv)).
/// Errors: as `refine_with_fields`, and mesh_error for quads that have no diagonals without such edges. Cost: O(corners
/// log valence).
template <class Point, std::unsigned_integral Index, class... Fields>
basic_mesh<Point, Index> tri_quad(const basic_mesh<Point, Index>& mesh, std::tuple<Fields&...> fields = {})
{
    require_edges(mesh);
    if (mesh.topology().degree != 4) {
        const auto made = refine_with_fields(mesh, detail::centroid_split{}, 1, fields);
        return {storage<Point>(made.points()), made.topology(), 1};
    }
    const auto is_odd = detail::choose_diagonals(level_elements<native_level<Point, Index, 4>>(mesh));
    const auto made = refine_with_fields(mesh, detail::diagonal_split{&is_odd}, 1, fields);
    return {storage<Point>(made.points()), made.topology(), 0};
}

/// Returns the same for a mesh of another library. Errors: also those that `validate` finds.
template <refinable_mesh M>
M tri_quad(const M& mesh)
{
    return build_like(mesh, tri_quad(to_native_valid(mesh)));
}

/// Returns the triangle mesh with the given edges as the marked ones. Edges are given by their vertices. Errors:
/// mesh_error for other faces than triangles, for a mesh without edges, and for a face with no or several marked edges;
/// the message names the face. Cost: O(corners log edges).
template <class Point, std::unsigned_integral Index>
basic_mesh<Point, Index> mark_edges(const basic_mesh<Point, Index>& mesh, std::vector<std::pair<Index, Index>> marked)
{
    for (auto& [a, b] : marked)
        if (b < a)
            std::swap(a, b);
    std::ranges::sort(marked);
    require_edges(mesh);
    auto t = mesh.topology();
    if (t.degree != 3)
        throw mesh_error("4-8: only triangles have a marked edge each; triangulate the mesh first");
    std::vector<Index> new_corner(t.corners());
    for (std::size_t f = 0; f < t.faces; ++f) {
        const Index begin = t.first_corner(f);
        Index first = begin;
        int count = 0;
        for (Index c = begin; c < begin + 3; ++c)
            if (std::ranges::binary_search(marked, std::minmax({t.corner_vertex[c], t.target(c)})))
                first = c, ++count;
        if (count != 1)
            throw mesh_error("4-8: face " + std::to_string(f) + " has " + std::to_string(count) +
                             " marked edges; mark exactly one");
        for (Index c = begin; c < begin + 3; ++c, first = t.next(first))
            new_corner[first] = c;
    }
    const auto& old = mesh.topology();
    for (std::size_t c = 0; c < old.corners(); ++c) {
        t.corner_vertex[new_corner[c]] = old.corner_vertex[c];
        t.corner_halfedge[new_corner[c]] = old.corner_halfedge[c];
    }
    for (auto* list : {&t.halfedge_corner, &t.vertex_corner})
        for (Index& c : *list)
            c = c == t.none ? t.none : new_corner[c];
    return {storage<Point>(mesh.points()), std::move(t), mesh.generation()};
}

/// Returns the marks of a tri-quad mesh as a field on its edges. The rule is that of the scheme: an unmarked edge
/// becomes marked; the halves of marked edges and the edges inside faces are unmarked. So a field refined with
/// `four_eight` has the marks of each level, in tiles and in files of levels, too. Cost: O(edges).
template <mesh M>
auto marked_edges(const M& mesh)
{
    const level_of<M> level(mesh);
    storage<bool> marked(level.edge_count());
    for (const auto e : level.edges())
        marked[e.index()] = bisection_split::is_marked(e);
    return on_edges(marked, along_edges<std::logical_not<>>{});
}

} // namespace kith
#define KITH_SCHEME detail::centroid_split
#include <kith/schemes/compiled/in_library.hpp>
#define KITH_SCHEME detail::diagonal_split
#include <kith/schemes/compiled/in_library.hpp>
