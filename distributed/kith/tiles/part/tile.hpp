// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/storage.hpp>
#include <kith/core/mesh/basic_mesh.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace kith {

/// The number of an element in the whole mesh of its level, which no rank holds.
using global_id = std::uint64_t;

/// The marks of an element of a tile.
enum tile_mark : unsigned char {
    owned_mark = 1,  ///< the element is owned by this tile, and by no other
    cut_mark = 2,    ///< edges: the second face in the whole mesh is not in the tile; not for boundary edges
    turned_mark = 4, ///< edges: the missing face is at side 0 in the whole mesh, so the sides are exchanged here
};

/// Returns the number of marks of elements that the tile owns.
template <class Marks>
std::uint64_t owned_count(const Marks& marks)
{
    return std::uint64_t(
        std::count_if(marks.begin(), marks.end(), [](unsigned char mark) { return (mark & owned_mark) != 0; }));
}

/// Calls f(first element, its global number, count) for each run of owned elements with consecutive global numbers.
/// Cost: O(elements).
template <class Ids, class Marks, std::invocable<std::size_t, global_id, std::size_t> F>
void for_each_owned_run(const Ids& ids, const Marks& marks, const F& f)
{
    for (std::size_t first = 0, last; first < ids.size(); first = last) {
        last = first + 1;
        if ((marks[first] & owned_mark) == 0)
            continue;
        while (last < ids.size() and (marks[last] & owned_mark) != 0 and ids[last] == ids[last - 1] + 1)
            ++last;
        f(first, ids[first], last - first);
    }
}

/// A part of a mesh that is refined alone: its owned faces, surrounded by as many rings of ghost faces (faces that
/// share a vertex) as the scheme needs on the later levels. Local numbers are in the order of the global ones, and
/// faces and fans start where they start in the whole mesh; so an element with complete surroundings gets the same bits
/// as there. If the faces of the tile at a vertex form several fans, the tile has the vertex once per fan, with the
/// same global number.
template <class Point, std::unsigned_integral Index = std::uint32_t>
struct tile {
    using point_type = Point;
    using index_type = Index;

    basic_mesh<Point, Index> mesh;
    storage<global_id> vertex_ids, edge_ids, face_ids;
    storage<global_id> first_corner_ids; ///< per face; empty if all faces of the whole mesh have one degree
    storage<global_id> corners_before;   ///< per vertex, see numbers_corners_at_vertices; else empty
    storage<global_id> marked_before;    ///< per edge of level 0, see marks_edges; else empty
    storage<unsigned char> vertex_marks, edge_marks, face_marks;
    storage<Index> root_of;                          ///< per face: index in `roots` of its ancestor on level 0
    storage<global_id> roots;                        ///< global numbers of faces of level 0
    storage<std::array<double, 3>> normals{};        ///< per vertex, if requested; else empty
    storage<std::array<double, 3>> corner_normals{}; ///< per corner, if requested; else empty

    [[nodiscard]] bool owns_vertex(std::size_t v) const { return (vertex_marks[v] & owned_mark) != 0; }
    [[nodiscard]] bool owns_edge(std::size_t e) const { return (edge_marks[e] & owned_mark) != 0; }
    [[nodiscard]] bool owns_face(std::size_t f) const { return (face_marks[f] & owned_mark) != 0; }
    [[nodiscard]] bool is_cut(std::size_t e) const { return (edge_marks[e] & cut_mark) != 0; }
    [[nodiscard]] global_id root(std::size_t face) const { return roots[root_of[face]]; }

    /// Returns the number of the k-th corner of a face in the whole mesh.
    [[nodiscard]] global_id corner_id(std::size_t face, std::size_t k) const
    {
        const global_id first = first_corner_ids.empty() ? face_ids[face] * global_id(mesh.topology().degree)
                                                         : first_corner_ids[face];
        return first + k;
    }
    /// Returns the number of an end of an edge in the whole mesh, 2e+s.
    [[nodiscard]] global_id end_id(std::size_t edge, std::size_t side) const
    {
        return 2 * edge_ids[edge] + (side ^ ((edge_marks[edge] & turned_mark) != 0 ? 1U : 0U));
    }
};

} // namespace kith
