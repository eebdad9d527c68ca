// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "info/class_faces.hpp"
#include "info/coinciding_vertices.hpp"
#include "info/vertex_classes.hpp"

#include <kith/core/mesh/basic_mesh.hpp>

#include <cstddef>
#include <span>

namespace kith::tool {

/// How two meshes differ, whatever the numbering of their vertices and faces and wherever their faces begin.
struct comparison {
    /// Between vertices that belong together; where some have no partner, from any vertex to the nearest of the other
    /// mesh.
    double largest_distance = 0;
    std::size_t unmatched_vertices = 0; ///< of both meshes
    std::size_t unmatched_faces = 0;    ///< of both meshes; counted only when all vertices are matched
    bool same_faces = false;            ///< as cycles of matched vertices, with their orientation

    [[nodiscard]] bool equal() const { return unmatched_vertices == 0 and same_faces; }
};

/// Equal: there is a one-to-one assignment of the vertices, no two of them farther apart than the tolerance, under
/// which the faces are the same. Vertices that coincide are told apart by the faces around them.
/// Preconditions: finite points, indices in range, tolerance >= 0. Errors: std::invalid_argument when the tolerance
/// reaches over so many vertices that it says nothing. Cost: O(n log n).
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

/// The faces of a native mesh in the form that compare_meshes takes.
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
