// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/children.hpp>
#include <kith/numbering/step/submesh.hpp>
#include <kith/tiles/number/tuple_facts.hpp>
#include <kith/tiles/part/tile_like.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kith {

/// A tile with its number among all tiles of a level on all ranks.
template <tile_like Tile>
struct numbered_tile {
    std::uint64_t number = 0;
    Tile part;
};

/// Returns the global numbers (ids_of) or the marks (marks_of) of all elements of one kind.
template <tile_like Tile>
std::span<const global_id> ids_of(const Tile& part, element_kind kind)
{
    const auto& ids = kind == element_kind::vertex ? part.vertex_ids
                      : kind == element_kind::edge ? part.edge_ids
                                                   : part.face_ids;
    return {ids.data(), ids.size()};
}
template <tile_like Tile>
std::span<const unsigned char> marks_of(const Tile& part, element_kind kind)
{
    const auto& marks = kind == element_kind::vertex ? part.vertex_marks
                        : kind == element_kind::edge ? part.edge_marks
                                                     : part.face_marks;
    return {marks.data(), marks.size()};
}

namespace detail {

template <tile_like Tile>
std::vector<typename Tile::index_type> owned_faces_of(const Tile& part)
{
    using index = typename Tile::index_type;
    std::vector<index> owned;
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
        if (part.owns_face(f))
            owned.push_back(index(f));
    return owned;
}

/// Returns the face whose patch has the descendants of an element: a vertex, an edge, a face or a corner (v, e, f, vf).
template <std::unsigned_integral Index>
Index face_of_patch(const connectivity<Index>& mesh, tuple_kind kind, std::size_t element)
{
    switch (kind) {
    case tuple_kind::v: return mesh.face_of(mesh.vertex_corner[element]);
    case tuple_kind::e: return mesh.face_of(mesh.halfedge_corner[2 * element]);
    case tuple_kind::f: return Index(element);
    default: return mesh.face_of(Index(element));
    }
}

/// Returns 3 or 4 if degree_of(i) has this value for all i below `faces`, else 0. Cost: O(faces).
template <std::invocable<std::size_t> F>
int degree_if_alike(std::size_t faces, const F& degree_of)
{
    const std::size_t first = faces == 0 ? 0 : degree_of(0);
    if (first != 3 and first != 4)
        return 0;
    for (std::size_t i = 1; i < faces; ++i)
        if (degree_of(i) != first)
            return 0;
    return int(first);
}

} // namespace detail

/// Returns the number of rings from the owned faces of a tile to its outermost ghost; the last rings may have gaps.
/// Precondition: the tile has its edges. Cost: O(elements) per ring.
template <tile_like Tile>
int rings_of_ghosts(const Tile& part)
{
    const auto owned = detail::owned_faces_of(part);
    submesh_cutter cutter(part.mesh);
    int rings = 0;
    for (std::size_t reached = owned.size(), before = 0; reached != part.mesh.face_count() and reached != before;
         ++rings) {
        before = reached;
        reached = cutter.faces_around(owned, rings + 1).size();
    }
    return rings;
}

/// Returns the number of rings of ghosts without gaps, at most `most`. A tile that holds the whole mesh, or owns
/// nothing, has `most` rings. Precondition: the tile has its edges. Cost: O(elements) per ring.
template <tile_like Tile>
int complete_rings(const Tile& part, int most)
{
    const auto owned = detail::owned_faces_of(part);
    const auto is_incomplete = incomplete_vertices(part);
    const auto is_at_cut = [&](auto f) {
        return std::ranges::any_of(part.mesh.face(f), [&](auto v) { return is_incomplete[v] != 0; });
    };
    submesh_cutter cutter(part.mesh);
    int rings = 0;
    while (rings < most and std::ranges::none_of(cutter.faces_around(owned, rings), is_at_cut))
        ++rings;
    return rings;
}

/// Returns the faces that another tile may have: the ghosts, and the faces at a vertex that has faces outside the tile.
/// Precondition: the tile has its edges.
template <tile_like Tile>
std::vector<typename Tile::index_type> faces_at_cuts(const Tile& part)
{
    using index = typename Tile::index_type;
    const auto incomplete = incomplete_vertices(part);
    std::vector<index> result;
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
        if (not part.owns_face(f) or
            std::ranges::any_of(part.mesh.face(f), [&](index v) { return incomplete[v] != 0; }))
            result.push_back(index(f));
    return result;
}

} // namespace kith
