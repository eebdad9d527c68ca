// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace kith {

/// The ways in which `repair` may change faces that form no manifold; without any it changes nothing.
struct repair_options {
    /// Leaves out repeated corners, degenerate and repeated faces, then the faces that take part in most conflicts at
    /// edges, then all but the largest fan of a vertex, and in the end the vertices without a face.
    bool drop = false;
    /// Cuts edges that have more than two faces, or two that do not agree, and gives each fan of faces a vertex.
    bool split = false;
    /// Turns faces round so that neighbours agree: in each part of the surface the fewer ones.
    bool orient = false;
    /// Joins vertices at the boundary, and those without a face, that lie within this distance of each other.
    std::optional<double> weld{};
};

} // namespace kith
