// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "in_library.hpp"

#include <cstdint>

namespace kith {

/// How many elements a level has. `plan` follows them over
/// the levels and finds an overflow before anything is allocated.
struct counts {
    std::uint64_t vertices = 0;
    std::uint64_t edges = 0;
    std::uint64_t faces = 0;
    std::uint64_t boundary_edges = 0;

    // What the counts of a dual scheme depend on at the boundary; other schemes leave these behind as zero.

    /// Boundary vertices with exactly one face, and with three or more; the rest have two.
    std::uint64_t boundary_vertices_of_one_face = 0;
    std::uint64_t boundary_vertices_of_many_faces = 0;
    /// Face corners that lie at boundary vertices.
    std::uint64_t boundary_corners = 0;

    /// Face corners, the sum of all face degrees.
    [[nodiscard]] constexpr std::uint64_t corners() const { return 2 * edges - boundary_edges; }
    /// On a manifold every boundary vertex ends exactly two boundary edges.
    [[nodiscard]] constexpr std::uint64_t boundary_vertices() const { return boundary_edges; }

    /// Counts a boundary vertex with so many faces in the boundary classes.
    constexpr void add_boundary_fan(std::uint64_t fan)
    {
        boundary_corners += fan;
        boundary_vertices_of_one_face += fan == 1;
        boundary_vertices_of_many_faces += fan >= 3;
    }

    friend constexpr bool operator==(const counts&, const counts&) = default;
};

} // namespace kith
