// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "schemes.hpp"

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/tiles/part/tile.hpp>

#include <array>
#include <optional>

namespace kith::tool {

/// Returns true if the two sides of sharp edges have normals of their own: some edges stay sharp forever.
bool has_sides(const any_scheme& scheme);

/// The text for normals on the sides of sharp edges that an output cannot hold.
inline constexpr const char* normals_of_sides =
    "separate normals for the two sides of sharp edges (the mean is written)";

/// The unit normals of a level on the limit surface.
struct surface_normals {
    storage<std::array<double, 3>> of_vertices;
    storage<std::array<double, 3>> of_corners; ///< normals of corners, if they are requested
};

/// Moves the vertices of a level to the limit surface and returns the unit normals there. `scheme` is the scheme of the
/// level. Errors and cost: as limit_surface_of.
surface_normals move_to_limit(basic_mesh<>& mesh, const any_scheme& scheme, bool with_corners);

/// Moves the vertices of the faces that a tile owns to the limit surface, and stores the normals in the tile.
/// Precondition: the tile has its edges and as many rings of ghosts as rings_for_limit returns.
void move_to_limit(tile<std::array<double, 3>>& part, const any_scheme& scheme, bool with_corners);

/// Returns the number of rings around some faces that move_to_limit reads to place the vertices of these faces.
int rings_for_limit(const any_scheme& scheme);

/// Returns the number of rings of ghosts of tiles on the last level, or nothing if that level needs no edges. Limits
/// and attributes need edges.
std::optional<int> rings_of_last_level(const any_scheme& scheme, bool limit, bool has_attributes);

} // namespace kith::tool
