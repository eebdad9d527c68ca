// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/counts.hpp>
#include <kith/core/base/storage.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace kith {

namespace detail {

/// Returns the condition, and claims that it is rarely true, so that the compiler makes a branch instead of a
/// conditional move. The claim is false, but fans look alike, so the processor predicts the branch. It then loads the
/// data of the next corner without waiting for the remainder.
inline bool is_rare(bool condition)
{
    return __builtin_expect_with_probability(condition, 0, 0.999) != 0;
}

/// Returns the corner after or before c in its face if all faces have `degree` corners. For degree 4 there is no
/// division.
template <std::unsigned_integral Index>
Index next_of_alike(Index c, Index degree)
{
    if (degree == 4)
        return (c & ~Index(3)) | ((c + 1) & 3);
    return is_rare(c % degree == degree - 1) ? c - (degree - 1) : c + 1;
}
template <std::unsigned_integral Index>
Index prev_of_alike(Index c, Index degree)
{
    if (degree == 4)
        return (c & ~Index(3)) | ((c + 3) & 3);
    return is_rare(c % degree == 0) ? c + (degree - 1) : c - 1;
}

} // namespace detail

/// The connectivity of a mesh as flat arrays of indices, corner by corner.
///
/// A *corner* is a vertex in a face; it also stands for the half-edge that leaves the vertex inside the face. The
/// corners of a face are contiguous and counter-clockwise. Half-edge 2e+s is side s of edge e. The side of a boundary
/// edge that has no face is always side 1 and has no corner. Everything else is arithmetic on these arrays.
template <std::unsigned_integral Index>
struct connectivity {
    static constexpr Index none = std::numeric_limits<Index>::max();

    std::size_t vertices = 0;
    std::size_t faces = 0;
    int degree = 0;                 ///< of all faces, if it is 3 or 4; 0: mixed degrees, see face_corner
    storage<Index> corner_vertex;   ///< per corner
    storage<Index> corner_halfedge; ///< per corner: 2e+s
    storage<Index> halfedge_corner; ///< two per edge
    storage<Index> vertex_corner;   ///< per vertex: where its fan starts; at the boundary, no face lies clockwise
    storage<Index> face_corner;     ///< mixed only, faces+1: the first corner of each face
    storage<Index> corner_face;     ///< mixed only: the face of each corner

    [[nodiscard]] std::size_t corners() const { return corner_vertex.size(); }
    [[nodiscard]] std::size_t edges() const { return halfedge_corner.size() / 2; }
    /// Returns true if there are face-vertex lists only, as in the last level of a refinement unless more was
    /// requested.
    [[nodiscard]] bool faces_only() const { return corner_halfedge.empty() and corners() != 0; }

    [[nodiscard]] Index first_corner(std::size_t face) const
    {
        return degree != 0 ? Index(face * degree) : face_corner[face];
    }
    [[nodiscard]] Index face_of(Index corner) const
    {
        return degree != 0 ? Index(corner / Index(degree)) : corner_face[corner];
    }
    // With mixed degrees, corner_face tells if two corners belong to one face. The bounds of the face would be one more
    // read that misses the cache.
    [[nodiscard]] Index next(Index corner) const
    {
        if (degree != 0)
            return detail::next_of_alike(corner, Index(degree));
        const Index after = corner + 1;
        return after < corners() and corner_face[corner] == corner_face[after] ? after
                                                                               : face_corner[corner_face[corner]];
    }
    [[nodiscard]] Index prev(Index corner) const
    {
        if (degree != 0)
            return detail::prev_of_alike(corner, Index(degree));
        const Index before = corner - 1;
        return corner != 0 and corner_face[before] == corner_face[corner]
                   ? before
                   : Index(face_corner[corner_face[corner] + 1] - 1);
    }
    /// Returns the corner of the same edge in the other face; none at the boundary.
    [[nodiscard]] Index across(Index corner) const { return halfedge_corner[corner_halfedge[corner] ^ 1]; }
    /// Returns the corner of the same vertex in the next face of its fan; none at the end of the fan.
    [[nodiscard]] Index next_in_fan(Index corner) const { return across(prev(corner)); }
    /// Returns the vertex that the half-edge of a corner leads to.
    [[nodiscard]] Index target(Index corner) const { return corner_vertex[next(corner)]; }

    /// Returns true if every side of every edge has a face. It is false if there are face-vertex lists only.
    /// Cost: O(1).
    [[nodiscard]] bool is_closed() const { return corners() == 2 * edges(); }
    [[nodiscard]] bool is_boundary(std::size_t edge) const { return halfedge_corner[2 * edge + 1] == none; }
    /// Returns the two vertices of an edge, in its direction.
    [[nodiscard]] std::array<Index, 2> ends(std::size_t edge) const
    {
        const Index corner = halfedge_corner[2 * edge];
        return {corner_vertex[corner], target(corner)};
    }

    /// Allocates the vertices of `count` faces, which all have `alike` corners. If `alike` is 0, degree_of(f) is the
    /// number of corners of face f, and is called in the order of the faces. Then face_corner and corner_face are
    /// filled in, too. Cost: O(faces), with mixed degrees O(corners).
    template <class DegreeOf>
    void allocate_faces(std::size_t count, int alike, DegreeOf degree_of)
    {
        faces = count;
        degree = alike;
        std::size_t size = count * std::size_t(alike);
        if (alike == 0) {
            face_corner = storage<Index>(count + 1);
            for (std::size_t f = 0; f < count; ++f)
                face_corner[f + 1] = Index(degree_of(f));
            size = sum_degrees();
            corner_face = storage<Index>(size);
            for (std::size_t f = 0; f < count; ++f)
                std::fill(corner_face.begin() + face_corner[f], corner_face.begin() + face_corner[f + 1], Index(f));
        }
        corner_vertex = storage<Index>(size);
    }
    /// Computes the first corners of all faces from their degrees in face_corner[f + 1], and returns the number of
    /// corners. Sums larger than `most` are set to `most`.
    std::size_t sum_degrees(std::size_t most = std::numeric_limits<std::size_t>::max())
    {
        std::size_t sum = 0;
        face_corner[0] = 0;
        for (std::size_t f = 0; f < faces; ++f)
            face_corner[f + 1] = Index(sum = std::min(sum + face_corner[f + 1], most));
        return sum;
    }
    /// Allocates `count` edges, whose sides have no corners yet. Precondition: the faces are allocated.
    void allocate_edges(std::size_t count)
    {
        corner_halfedge = storage<Index>(corners());
        halfedge_corner = storage<Index>(2 * count, none);
    }
    /// Joins a corner with a side of an edge.
    void set_side(Index corner, Index halfedge)
    {
        corner_halfedge[corner] = halfedge;
        halfedge_corner[halfedge] = corner;
    }
};

/// Returns the counts of a mesh, including those of boundary vertices. Cost: O(edges), for a closed mesh O(1) if all
/// faces are triangles or all are quads.
template <std::unsigned_integral Index>
counts count(const connectivity<Index>& mesh)
{
    counts result{.vertices = mesh.vertices, .edges = mesh.edges(), .faces = mesh.faces};
    if (mesh.degree == 3)
        result.triangles = mesh.faces;
    for (std::size_t f = 0; mesh.degree == 0 and f < mesh.faces; ++f)
        result.triangles += mesh.first_corner(f + 1) - mesh.first_corner(f) == 3;
    if (mesh.is_closed())
        return result;
    for (std::size_t e = 0; e < mesh.edges(); ++e) {
        if (not mesh.is_boundary(e))
            continue;
        ++result.boundary_edges;
        std::uint64_t fan = 0; // each boundary edge starts the fan of exactly one boundary vertex
        for (Index c = mesh.halfedge_corner[2 * e]; c != mesh.none; c = mesh.next_in_fan(c))
            ++fan;
        result.add_boundary_fan(fan);
    }
    return result;
}

} // namespace kith
