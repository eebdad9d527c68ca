// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <cstddef>
#include <span>

namespace kith {

/// One line of a new face: a vertex and the side by which the boundary of the face leaves it.
template <class Index>
struct face_line {
    Index vertex;
    Index halfedge;
};

template <class T>
concept face_lines = requires(const T& lines) {
    (*lines.begin()).vertex;
    (*lines.begin()).halfedge;
};

/// What a step writes the next level into when that is no native mesh: numbers are those that the elements would have there,
/// and half-edge 2e+s is side s of edge e. The scheme is trusted and declares its edges: each element is written once, and
/// what is written is a manifold.
template <class S>
concept level_sink = requires(S& sink, typename S::index_type i,
                              std::span<const face_line<typename S::index_type>> lines) {
    requires std::unsigned_integral<typename S::index_type>; // as of a native mesh
    // The array of all points, of which each is assigned once; several threads do.
    { sink.points() } -> std::same_as<typename S::point_type*>;
    // Face i has these lines, counter-clockwise from its first corner: any range of face_line. Several threads make
    // different faces.
    sink.set_face(i, lines);
    // The fan of vertex i starts at a half-edge that leaves it. Several threads, and maybe before its faces are there.
    sink.set_start(i, i);
    // Comes last, with the generation of the level: nothing lies on the sides that no face has named.
    sink.finish(0);
};

} // namespace kith
