// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/for_parts.hpp>
#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/numbering/association/columns.hpp>
#include <kith/numbering/association/numbering.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

/// The number of each element of a mesh in another mesh, which differs only in the order of its elements. First corners
/// of faces, sides of edges and starts of fans are the same.
template <std::unsigned_integral Index>
struct element_numbers {
    storage<Index> vertices, edges, faces;
    storage<Index> corners; ///< if faces have several degrees; else they follow from the faces
    std::size_t degree = 0; ///< of all faces if they have one degree; else 0

    /// Returns the numbers of the vertices, edges or faces: v, e, f.
    [[nodiscard]] const storage<Index>& of(tuple_kind kind) const
    {
        return kind == tuple_kind::v ? vertices : kind == tuple_kind::e ? edges : faces;
    }
    /// Returns the index of a tuple in the other mesh.
    template <tuple_kind Kind>
    [[nodiscard]] std::size_t tuple(std::size_t index) const
    {
        constexpr std::size_t each = tuples_per_element(Kind);
        return each * element<Kind>(index / each) + index % each;
    }

private:
    template <tuple_kind Kind>
    [[nodiscard]] std::size_t element(std::size_t i) const
    {
        if constexpr (Kind == tuple_kind::v)
            return vertices[i];
        else if constexpr (Kind == tuple_kind::e or Kind == tuple_kind::ve)
            return edges[i];
        else if constexpr (Kind == tuple_kind::f)
            return faces[i];
        else
            return degree == 0 ? corners[i] : degree * faces[i / degree] + i % degree;
    }
};

/// A mesh whose elements have been put in another order, and their numbers in the given mesh.
template <class Point, std::unsigned_integral Index>
struct ordered_mesh {
    basic_mesh<Point, Index> mesh;
    element_numbers<Index> numbers;
};

/// Returns true if faces that share an edge often lie far apart in the order of the faces, as in many scanned or
/// remeshed meshes. Then most data that a step reads around a vertex comes from outside the caches. A neighbour of a
/// face counts as far if it is more than 1024 faces away. Exempt are neighbours close to a face across from one of the
/// two faces before: faces that follow one another, as where a mesh has been refined, are fetched ahead. The result is
/// true if more than half of the sides have a far neighbour.
/// Precondition: the mesh has its edges. Cost: that of a look at one or two thousand faces.
template <std::unsigned_integral Index>
bool is_scattered(const connectivity<Index>& mesh)
{
    constexpr std::size_t faces_in_cache = 1024; // with what a step reads and writes of them
    constexpr std::size_t faces_ahead = 32, looks = 1024;
    const auto distance = [](std::size_t a, std::size_t b) { return std::max(a, b) - std::min(a, b); };
    const auto for_across = [&](std::size_t face, const auto& f) {
        for (Index c = mesh.first_corner(face); c < mesh.first_corner(face + 1); ++c)
            if (const Index across = mesh.across(c); across != mesh.none)
                f(std::size_t(mesh.face_of(across)));
    };
    const auto follows = [&](std::size_t face, std::size_t before) { // `face` is near one across from `before`
        bool found = false;
        for_across(before, [&](std::size_t other) { found |= distance(face, other) <= faces_ahead; });
        return found;
    };
    const std::size_t step = mesh.faces / looks | 1; // odd: of four children of a face not always the same one
    std::size_t sides = 0, far = 0;
    for (std::size_t f = 2; f < mesh.faces; f += step)
        for_across(f, [&](std::size_t face) {
            ++sides;
            far += distance(f, face) > faces_in_cache and not follows(face, f - 1) and not follows(face, f - 2);
        });
    return far > sides / 2;
}

/// Returns the faces in an order in which faces that lie close together on the surface follow one another. The order
/// goes clump after clump, each breadth first; the next clump starts at the front of those before it. Precondition: the
/// mesh has its edges. Cost: O(corners).
template <std::unsigned_integral Index>
storage<Index> surface_order(const connectivity<Index>& mesh)
{
    constexpr std::size_t faces_of_clump = 256;
    storage<Index> order(mesh.faces);
    std::vector<bool> is_taken(mesh.faces, false);
    std::vector<Index> front; // faces that may have been taken meanwhile
    std::size_t taken = 0, oldest = 0, lowest = 0;
    const auto take = [&](std::size_t face) {
        is_taken[face] = true;
        order[taken++] = Index(face);
    };
    while (taken < mesh.faces) {
        while (oldest < front.size() and is_taken[front[oldest]])
            ++oldest;
        while (is_taken[lowest]) // of a component of the surface that nothing has touched yet
            ++lowest;
        const std::size_t full = taken + faces_of_clump;
        std::size_t next = taken;
        take(oldest < front.size() ? front[oldest] : lowest);
        for (; next < taken; ++next)
            for (Index c = mesh.first_corner(order[next]); c < mesh.first_corner(order[next] + std::size_t(1)); ++c)
                if (const Index across = mesh.across(c); across != mesh.none)
                    if (const Index face = mesh.face_of(across); not is_taken[face]) {
                        if (taken < full)
                            take(face);
                        else
                            front.push_back(face);
                    }
    }
    return order;
}

/// Returns the mesh with its faces in surface_order, and vertices and edges in the order in which the faces meet them.
/// Precondition: the mesh has its edges, and all its vertices are in faces. Cost: O(corners).
template <class Point, std::unsigned_integral Index>
ordered_mesh<Point, Index> in_surface_order(const basic_mesh<Point, Index>& given)
{
    const connectivity<Index>& from = given.topology();
    element_numbers<Index> numbers{
        storage<Index>(from.vertices), storage<Index>(from.edges()), surface_order(from), {}, std::size_t(from.degree)};
    storage<Point> points(from.vertices);
    connectivity<Index> to;
    to.vertices = from.vertices;
    to.allocate_faces(from.faces, from.degree, [&](std::size_t f) { return given.face(numbers.faces[f]).size(); });
    to.allocate_edges(from.edges());
    to.vertex_corner = storage<Index>(from.vertices);
    const bool mixed = from.degree == 0;
    if (mixed)
        numbers.corners = storage<Index>(from.corners());
    storage<Index> new_vertex(from.vertices, from.none), new_edge(from.edges(), from.none);
    Index vertices = 0, edges = 0, corner = 0;
    for (std::size_t f = 0; f < from.faces; ++f) {
        const std::size_t face = numbers.faces[f];
        for (Index c = from.first_corner(face); c < from.first_corner(face + 1); ++c, ++corner) {
            const Index v = from.corner_vertex[c], side = from.corner_halfedge[c] % 2, e = from.corner_halfedge[c] / 2;
            if (new_vertex[v] == from.none) {
                points[vertices] = given.point(v);
                numbers.vertices[vertices] = v;
                new_vertex[v] = vertices++;
            }
            if (new_edge[e] == from.none) {
                numbers.edges[edges] = e;
                new_edge[e] = edges++;
            }
            to.corner_vertex[corner] = new_vertex[v];
            to.set_side(corner, 2 * new_edge[e] + side);
            if (from.vertex_corner[v] == c)
                to.vertex_corner[new_vertex[v]] = corner;
            if (mixed)
                numbers.corners[corner] = c;
        }
    }
    return {{std::move(points), std::move(to), given.generation()}, std::move(numbers)};
}

namespace detail {

/// Returns the numbers of the new elements of one kind.
template <std::unsigned_integral Index, level Level, element_ids Ids, class... Columns>
storage<Index> numbers_of_children(const element_numbers<Index>& numbers, const Level& coarse, const Ids& ids,
                                   const std::tuple<Columns...>& list)
{
    storage<Index> result(ids.total());
    const auto in_column = [&]<tuple_kind K, class W, class D>(const column<K, W, D>&) {
        for_parts(tuple_count(coarse, K), true, [&](std::size_t begin, std::size_t end) {
            for (std::size_t tuple = begin; tuple < end; ++tuple)
                if (const auto id = ids.template id<K>(tuple); id != ids.none)
                    result[id] = ids.template known_id<K>(numbers.template tuple<K>(tuple));
        });
    };
    std::apply([&](const auto&... c) { (in_column(c), ...); }, list);
    return result;
}

} // namespace detail

/// Returns the numbers of the elements of the next level, which a step has just made with these ids. Precondition: no
/// column leaves out single tuples, and all new faces have one degree. Cost: O(elements).
template <std::unsigned_integral Index, level Level, level_numbering Numbering, declared_columns Columns>
element_numbers<Index> after(const element_numbers<Index>& numbers, const Level& coarse, const Numbering& ids,
                             const Columns& columns)
{
    return {detail::numbers_of_children(numbers, coarse, ids.vertices, columns.vertices.list),
            detail::numbers_of_children(numbers, coarse, ids.edges, columns.edges.list),
            detail::numbers_of_children(numbers, coarse, ids.faces, columns.faces.list),
            {},
            Numbering::common_degree};
}

} // namespace kith
