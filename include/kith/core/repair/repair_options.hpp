// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace kith {

/// The ways in which `repair` may change faces that form no manifold. Without any of them it changes nothing.
struct repair_options {
    /// Leaves out repeated corners, then degenerate and repeated faces. Then the faces in most conflicts at edges go,
    /// then all but the largest fan of each vertex, and at last vertices without a face.
    bool drop = false;
    /// Cuts edges that have more than two faces, or two that do not agree, and gives each fan of faces its own vertex.
    bool split = false;
    /// Reverses faces so that neighbours agree: in each part of the surface the smaller number of faces.
    bool orient = false;
    /// Joins boundary vertices, and vertices without a face, that lie within this distance of each other.
    std::optional<double> weld{};
};

} // namespace kith
