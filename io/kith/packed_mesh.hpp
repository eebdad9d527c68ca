// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace kith::io {

namespace detail {

/// Returns true if the arrays of a mesh from outside fit each other, so that walks on them stay inside the arrays and
/// end.
template <std::unsigned_integral Index>
bool is_consistent(const connectivity<Index>& t, std::size_t points)
{
    constexpr Index none = connectivity<Index>::none;
    const std::size_t corners = t.corner_vertex.size(), sides = t.halfedge_corner.size();
    const bool is_mixed = t.degree == 0;
    if (points != t.vertices or t.vertex_corner.size() != t.vertices or t.corner_halfedge.size() != corners or
        sides % 2 != 0 or t.corner_face.size() != (is_mixed ? corners : 0) or
        (is_mixed ? t.face_corner.empty() or t.face_corner.size() - 1 != t.faces
                  : (t.degree != 3 and t.degree != 4) or t.faces != corners / std::size_t(t.degree) or
                        corners % std::size_t(t.degree) != 0))
        return false;
    if (is_mixed) {
        if (t.face_corner[0] != 0 or t.face_corner[t.faces] != corners)
            return false;
        for (std::size_t f = 0; f < t.faces; ++f) {
            if (t.face_corner[f + 1] > corners or t.face_corner[f + 1] < t.face_corner[f] + std::size_t(3))
                return false;
            for (std::size_t c = t.face_corner[f]; c < t.face_corner[f + 1]; ++c)
                if (t.corner_face[c] != f)
                    return false;
        }
    }
    for (std::size_t c = 0; c < corners; ++c)
        if (t.corner_vertex[c] >= t.vertices or t.corner_halfedge[c] >= sides or
            t.halfedge_corner[t.corner_halfedge[c]] != c)
            return false;
    for (std::size_t h = 0; h < sides; h += 2) // side 1 has no face at the boundary, side 0 always has one
        if (t.halfedge_corner[h] == none)
            return false;
    for (std::size_t h = 0; h < sides; ++h)
        if (const Index c = t.halfedge_corner[h]; c != none) {
            if (c >= corners or t.corner_halfedge[c] != h)
                return false;
            if (const Index across = t.halfedge_corner[h ^ 1];
                across != none and (across >= corners or t.corner_vertex[t.next(c)] != t.corner_vertex[across]))
                return false;
        }
    for (std::size_t v = 0; v < t.vertices; ++v)
        if (t.vertex_corner[v] >= corners or t.corner_vertex[t.vertex_corner[v]] != v)
            return false;
    for (std::size_t c = 0; c < corners; ++c) // at the boundary a fan starts where nothing lies clockwise
        if (t.across(Index(c)) == none and t.vertex_corner[t.corner_vertex[c]] != c)
            return false;
    return true;
}

} // namespace detail

/// Adds a mesh to a message. Its elements keep their numbers. Cost: O(corners).
template <class Point, std::unsigned_integral Index>
void pack_mesh(packer& out, const basic_mesh<Point, Index>& mesh)
{
    kith::detail::pack_mesh(out, mesh);
}

/// Reads a mesh that pack_mesh has added to a message. Errors: pack_error for a message that ends too early, for arrays
/// that do not fit each other, and for a generation that no mesh has. Cost: O(corners).
template <class Point, std::unsigned_integral Index>
basic_mesh<Point, Index> unpack_mesh(unpacker& in)
{
    auto told = kith::detail::unpack_mesh<Point, Index>(in);
    if (not detail::is_consistent(told.topology, told.points.size()))
        throw pack_error("the arrays of the control mesh do not fit each other; who wrote them is at fault");
    constexpr int most_generations = 1 << 30; // some are counted on from there
    if (told.generation < 0 or told.generation > most_generations)
        throw pack_error("the control mesh is said to have been refined " + std::to_string(told.generation) +
                         " times; who wrote that is at fault");
    return {std::move(told.points), std::move(told.topology), told.generation};
}

} // namespace kith::io
