// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "in_library.hpp"

#include <cstdint>

namespace kith {

/// The numbers of elements of a level. `plan` computes them for each level, so that it finds an overflow before
/// anything is allocated.
struct counts {
    std::uint64_t vertices = 0;
    std::uint64_t edges = 0;
    std::uint64_t faces = 0;
    std::uint64_t boundary_edges = 0;
    /// The faces with three corners. Plans of schemes that make other polygons of unknown degree do not count these.
    std::uint64_t triangles = 0;

    // Dual schemes need these numbers at the boundary to compute the counts of the next level. Other schemes leave them
    // zero.

    /// The boundary vertices with exactly one face, and those with three or more; all others have two.
    std::uint64_t boundary_vertices_of_one_face = 0;
    std::uint64_t boundary_vertices_of_many_faces = 0;
    /// The face corners at boundary vertices.
    std::uint64_t boundary_corners = 0;

    /// Returns the number of face corners, which is the sum of all face degrees.
    [[nodiscard]] constexpr std::uint64_t corners() const { return 2 * edges - boundary_edges; }
    /// Returns the number of boundary vertices: as many as boundary edges, since on a manifold each one ends exactly
    /// two boundary edges.
    [[nodiscard]] constexpr std::uint64_t boundary_vertices() const { return boundary_edges; }

    /// Adds a boundary vertex with `fan` faces to the counts of boundary vertices and corners.
    constexpr void add_boundary_fan(std::uint64_t fan)
    {
        boundary_corners += fan;
        boundary_vertices_of_one_face += fan == 1;
        boundary_vertices_of_many_faces += fan >= 3;
    }

    friend constexpr bool operator==(const counts&, const counts&) = default;
};

} // namespace kith
