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

/// Makes a branch of a choice, which it is not: fans look alike, so that the processor guesses right and does not wait
/// for the remainder before it asks for what the corner leads to.
inline bool is_rare(bool condition)
{
    return __builtin_expect_with_probability(condition, 0, 0.999) != 0;
}

/// The corner after c and the one before it in a face, where all faces have `degree` corners. 4 spares a division.
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
/// A *corner* is a vertex in a face; it stands for the half-edge that leaves the vertex inside the face, too. The
/// corners of a face are contiguous and counter-clockwise. Half-edge 2e+s is side s of edge e; the side of a boundary
/// edge that has no face is always side 1 and has no corner. Everything else is arithmetic on these arrays.
template <std::unsigned_integral Index>
struct connectivity {
    static constexpr Index none = std::numeric_limits<Index>::max();

    std::size_t vertices = 0;
    std::size_t faces = 0;
    int degree = 0;                 ///< of all faces alike, 3 or 4; 0: mixed, see face_corner
    storage<Index> corner_vertex;   ///< per corner
    storage<Index> corner_halfedge; ///< per corner: 2e+s
    storage<Index> halfedge_corner; ///< two per edge
    storage<Index> vertex_corner;   ///< per vertex: where its fan starts; at the boundary the side without neighbour
    storage<Index> face_corner;     ///< mixed only, faces+1: the first corner of each face
    storage<Index> corner_face;     ///< mixed only

    [[nodiscard]] std::size_t corners() const { return corner_vertex.size(); }
    [[nodiscard]] std::size_t edges() const { return halfedge_corner.size() / 2; }
    /// Face-vertex lists only: the last level of a refinement, unless more was asked for.
    [[nodiscard]] bool faces_only() const { return corner_halfedge.empty() and corners() != 0; }

    [[nodiscard]] Index first_corner(std::size_t face) const
    {
        return degree != 0 ? Index(face * degree) : face_corner[face];
    }
    [[nodiscard]] Index face_of(Index corner) const
    {
        return degree != 0 ? Index(corner / Index(degree)) : corner_face[corner];
    }
    // Where faces have several degrees it is seen at the corners whether two are of one face: its bounds would be one
    // more read that misses the cache.
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
    /// The corner of the same edge in the other face; none at the boundary.
    [[nodiscard]] Index across(Index corner) const { return halfedge_corner[corner_halfedge[corner] ^ 1]; }
    /// The corner of the same vertex in the next face of its fan; none at its end.
    [[nodiscard]] Index next_in_fan(Index corner) const { return across(prev(corner)); }
    /// The vertex that a corner's half-edge leads to.
    [[nodiscard]] Index target(Index corner) const { return corner_vertex[next(corner)]; }

    /// No edge has a side without a face, nor are there faces without edges. Cost: O(1).
    [[nodiscard]] bool is_closed() const { return corners() == 2 * edges(); }
    [[nodiscard]] bool is_boundary(std::size_t edge) const { return halfedge_corner[2 * edge + 1] == none; }
    /// The vertices of an edge, as it is directed.
    [[nodiscard]] std::array<Index, 2> ends(std::size_t edge) const
    {
        const Index corner = halfedge_corner[2 * edge];
        return {corner_vertex[corner], target(corner)};
    }

    /// Room for the vertices of so many faces: all have `alike` corners or, where that is 0, each degree_of(f), asked
    /// in their order, and then where each lies is filled in. Cost: O(faces), with several degrees O(corners).
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
    /// Makes the first corners of all faces, when face_corner[f + 1] is the degree of f; how many corners they have.
    /// What comes to more than `most` is cut off there.
    std::size_t sum_degrees(std::size_t most = std::numeric_limits<std::size_t>::max())
    {
        std::size_t sum = 0;
        face_corner[0] = 0;
        for (std::size_t f = 0; f < faces; ++f)
            face_corner[f + 1] = Index(sum = std::min(sum + face_corner[f + 1], most));
        return sum;
    }
    /// Room for so many edges, whose sides have no corners yet. Precondition: the faces are allocated.
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

/// Counts of a mesh, with the boundary classes. Cost: O(edges), of a closed mesh O(1).
template <std::unsigned_integral Index>
counts count(const connectivity<Index>& mesh)
{
    counts result{.vertices = mesh.vertices, .edges = mesh.edges(), .faces = mesh.faces};
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
