// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_like.hpp"

#include <kith/core/mesh/connectivity.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <ranges>

namespace kith::detail {

/// Returns the first fault of the corners, half-edges and fans of a tile, or nullptr if there is none. Walks along
/// faces and around vertices then stay inside the tile and end. Precondition: the arrays have the right sizes and refer
/// to elements that exist. Cost: O(elements).
template <std::unsigned_integral Index>
const char* fault_of_corners(const connectivity<Index>& t)
{
    const std::size_t corners = t.corner_vertex.size(), sides = t.halfedge_corner.size();
    if (t.degree == 0 and t.faces != 0) {
        bool fits = t.face_corner[0] == 0 and t.face_corner[t.faces] == corners;
        for (std::size_t f = 0; f < t.faces; ++f)
            fits = fits and t.face_corner[f + 1] >= t.face_corner[f] + std::size_t(3);
        if (not fits)
            return "has faces whose corners are not contiguous";
        for (std::size_t f = 0; f < t.faces; ++f)
            for (std::size_t c = t.face_corner[f]; c < t.face_corner[f + 1]; ++c)
                if (t.corner_face[c] != f)
                    return "has corners that do not refer to their faces";
    }
    if (t.corner_halfedge.empty())
        return nullptr;

    for (std::size_t c = 0; c < corners; ++c)
        if (t.halfedge_corner[t.corner_halfedge[c]] != c)
            return "has corners and half-edges that do not refer to each other";
    for (std::size_t side = 0; side < sides; ++side)
        if (const auto corner = t.halfedge_corner[side]; corner != t.none and t.corner_halfedge[corner] != side)
            return "has corners and half-edges that do not refer to each other";
    for (std::size_t first = 0; first < sides; first += 2) {
        const auto corner = t.halfedge_corner[first], across = t.halfedge_corner[first + 1];
        if (corner == t.none)
            return "has edges whose first half-edge has no face";
        if (across != t.none and
            (t.corner_vertex[corner] != t.target(across) or t.target(corner) != t.corner_vertex[across]))
            return "has edges whose two half-edges join different vertices";
    }
    for (std::size_t v = 0; v < t.vertices; ++v)
        if (t.corner_vertex[t.vertex_corner[v]] != v)
            return "has vertices whose first corner belongs to another vertex";
    return nullptr;
}

/// Returns the first fault in the arrays of a tile from another source, or nullptr if there is none. The arrays must
/// have the sizes of their elements and refer to elements that exist; corners, half-edges and fans must fit each other.
/// Elements must be in the order of their numbers in the whole mesh, since another order would change the order in
/// which masks are evaluated. Damage that yields a valid tile of another mesh is not found, such as a face that starts
/// at another of its corners. Cost: O(elements).
template <std::unsigned_integral Index, tile_like Tile>
const char* fault_of_tile(const connectivity<Index>& t, std::size_t points, const Tile& part)
{
    const std::size_t vertices = part.vertex_ids.size(), edges = part.edge_ids.size(), faces = part.face_ids.size();
    const std::size_t corners = t.corner_vertex.size();
    const bool faces_only = t.corner_halfedge.empty();
    const auto each = [](const auto& array, std::size_t size) { return array.size() == size; };
    const auto each_or_none = [](const auto& array, std::size_t size) { return array.empty() or array.size() == size; };
    const bool mixed = t.degree == 0;
    if (not(points == vertices and t.vertices == vertices and t.faces == faces and each(part.vertex_marks, vertices) and
            each(part.edge_marks, edges) and each(part.face_marks, faces) and each(part.root_of, faces) and
            each_or_none(part.first_corner_ids, faces) and each_or_none(part.corners_before, vertices) and
            each_or_none(part.marked_before, edges) and each(t.corner_halfedge, faces_only ? 0 : corners) and
            each(t.vertex_corner, faces_only ? 0 : vertices) and each(t.halfedge_corner, 2 * edges) and
            (edges == 0 or not faces_only) and (mixed or t.degree == 3 or t.degree == 4) and
            each(t.face_corner, mixed and faces != 0 ? faces + 1 : t.face_corner.size()) and
            each(t.corner_face, mixed ? corners : 0) and (mixed or corners == faces * std::size_t(t.degree))))
        return "has arrays of the wrong sizes";

    const auto below = [](const auto& array, std::size_t end, bool or_none = false) {
        using value = std::ranges::range_value_t<decltype(array)>;
        return std::ranges::all_of(array, [=](value x) { return x < end or (or_none and x == value(~value(0))); });
    };
    if (not(below(t.corner_vertex, vertices) and below(t.corner_halfedge, 2 * edges) and
            below(t.halfedge_corner, corners, true) and below(t.vertex_corner, corners) and
            below(t.corner_face, faces) and below(t.face_corner, corners + 1) and
            below(part.root_of, part.roots.size())))
        return "refers to elements that it does not have";
    if (const char* fault = fault_of_corners(t); fault != nullptr)
        return fault;

    if (not std::ranges::is_sorted(part.vertex_ids)) // all fans of a vertex have its number
        return "has vertices that are not in the order of their numbers";
    const auto increases = [](const auto& ids) {
        return std::ranges::adjacent_find(ids, std::greater_equal<>()) == ids.end();
    };
    if (not increases(part.edge_ids))
        return "has edges that are not in the order of their numbers";
    if (not increases(part.face_ids) or not increases(part.first_corner_ids))
        return "has faces that are not in the order of their numbers";
    return nullptr;
}

} // namespace kith::detail
