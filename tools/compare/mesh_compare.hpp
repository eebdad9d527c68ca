// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "info/class_faces.hpp"
#include "info/coinciding_vertices.hpp"
#include "info/vertex_classes.hpp"

#include <kith/core/mesh/basic_mesh.hpp>

#include <cstddef>
#include <span>

namespace kith::tool {

/// The difference of two meshes, independent of the numbering of vertices and faces and of the vertex where a face
/// begins.
struct comparison {
    /// The largest distance between partners. If some vertices have no partner: the largest distance from a vertex to
    /// the nearest vertex of the other mesh.
    double largest_distance = 0;
    std::size_t unmatched_vertices = 0; ///< vertices of both without a partner
    std::size_t unmatched_faces = 0;    ///< faces of both without a partner; counted only if all vertices are matched
    bool same_faces = false;            ///< the faces are the same cycles of matched vertices, with their orientation

    [[nodiscard]] bool equal() const { return unmatched_vertices == 0 and same_faces; }
};

/// Compares two meshes. They are equal if their vertices can be assigned one to one, within the tolerance, such that
/// the faces are the same. Vertices that coincide are distinguished by the faces around them.
/// Preconditions: finite points, indices in range, tolerance >= 0. Errors: std::invalid_argument for a tolerance that
/// covers too many vertices to mean anything. Cost: O(n log n).
inline comparison compare_meshes(std::span<const point3> points_a, const face_list& faces_a,
                                 std::span<const point3> points_b, const face_list& faces_b, double tolerance)
{
    const vertex_classes classes = classify(points_a, points_b, tolerance);
    comparison result{.largest_distance = classes.largest_distance, .unmatched_vertices = classes.unmatched};
    if (result.unmatched_vertices != 0)
        return result;
    result.unmatched_faces = count_unmatched(class_faces(faces_a, classes.of_a, classes.count),
                                             class_faces(faces_b, classes.of_b, classes.count));
    result.same_faces = result.unmatched_faces == 0;
    if (result.same_faces and not classes.one_to_one) {
        const auto distance = coinciding_vertices(points_a, faces_a, points_b, faces_b, classes, tolerance).match();
        result.same_faces = distance.has_value();
        result.largest_distance = distance.value_or(result.largest_distance);
    }
    return result;
}

/// Returns the faces of a native mesh in the form that compare_meshes takes.
inline face_list faces_of(const basic_mesh<>& mesh)
{
    face_list result;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        result.push_back(mesh.face(f));
    return result;
}

inline comparison compare_meshes(const basic_mesh<>& a, const basic_mesh<>& b, double tolerance)
{
    return compare_meshes(a.points(), faces_of(a), b.points(), faces_of(b), tolerance);
}

} // namespace kith::tool
