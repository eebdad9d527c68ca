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

/// What a tile knows of an element beside its number.
enum tile_mark : unsigned char {
    owned_mark = 1,  ///< this tile is the one of all tiles that answers for the element
    cut_mark = 2,    ///< edges: it has a second face in the whole mesh, which is not here; no boundary edge
    turned_mark = 4, ///< edges: side 0 of the whole mesh is what is not here, so the sides have changed places
};

/// Of so many marks those of elements that the tile owns.
template <class Marks>
std::uint64_t owned_count(const Marks& marks)
{
    return std::uint64_t(
        std::count_if(marks.begin(), marks.end(), [](unsigned char mark) { return (mark & owned_mark) != 0; }));
}

/// Calls f(first element, its number, how many) for runs of elements that a tile owns and whose numbers follow one
/// another. Cost: O(elements).
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

/// A part of a mesh that is refined alone: its owned faces, and around them as many rings of ghost faces (faces that
/// share a vertex) as the scheme reaches in the levels to come. Numbers here are in the order of the global ids, faces
/// and fans start where they start in the whole mesh: what is complete here gets the same bits as there.
/// A vertex whose faces here form several fans is there once per fan, with the same global id.
template <class Point, std::unsigned_integral Index = std::uint32_t>
struct tile {
    using point_type = Point;
    using index_type = Index;

    basic_mesh<Point, Index> mesh;
    storage<global_id> vertex_ids, edge_ids, face_ids;
    storage<global_id> first_corner_ids; ///< per face; empty where all faces of the whole mesh have one degree
    storage<global_id> corners_before;   ///< per vertex, see numbers_corners_at_vertices; else empty
    storage<global_id> marked_before;    ///< per edge of level 0, see marks_edges; else empty
    storage<unsigned char> vertex_marks, edge_marks, face_marks;
    storage<Index> root_of;                          ///< per face: which of `roots` it descends from
    storage<global_id> roots;                        ///< faces of level 0
    storage<std::array<double, 3>> normals{};        ///< per vertex, where they are asked for; else empty
    storage<std::array<double, 3>> corner_normals{}; ///< per corner, where they are asked for; else empty

    [[nodiscard]] bool owns_vertex(std::size_t v) const { return (vertex_marks[v] & owned_mark) != 0; }
    [[nodiscard]] bool owns_edge(std::size_t e) const { return (edge_marks[e] & owned_mark) != 0; }
    [[nodiscard]] bool owns_face(std::size_t f) const { return (face_marks[f] & owned_mark) != 0; }
    [[nodiscard]] bool is_cut(std::size_t e) const { return (edge_marks[e] & cut_mark) != 0; }
    [[nodiscard]] global_id root(std::size_t face) const { return roots[root_of[face]]; }

    /// The number of a corner in the whole mesh: of the k-th corner of a face.
    [[nodiscard]] global_id corner_id(std::size_t face, std::size_t k) const
    {
        const global_id first = first_corner_ids.empty() ? face_ids[face] * global_id(mesh.topology().degree)
                                                         : first_corner_ids[face];
        return first + k;
    }
    /// The number of an end of an edge in the whole mesh, 2e+s.
    [[nodiscard]] global_id end_id(std::size_t edge, std::size_t side) const
    {
        return 2 * edge_ids[edge] + (side ^ ((edge_marks[edge] & turned_mark) != 0 ? 1U : 0U));
    }
};

} // namespace kith
