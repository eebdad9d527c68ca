// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "schemes.hpp"

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/tiles/part/tile.hpp>

#include <array>
#include <optional>

namespace kith::tool {

/// Returns whether the sides of sharp edges have normals of their own: edges stay sharp for ever.
bool has_sides(const any_scheme& scheme);

/// The words for normals on the sides of sharp edges that an output has no room for.
inline constexpr const char* normals_of_sides =
    "separate normals for the two sides of sharp edges (the mean is written)";

/// The unit normals of a level on the limit surface.
struct surface_normals {
    storage<std::array<double, 3>> of_vertices;
    storage<std::array<double, 3>> of_corners; ///< of the faces, if they are asked for
};

/// Moves the vertices of a level to the limit surface and returns the unit normals there. `scheme` is that of the
/// level. Errors and cost: as limit_surface_of.
surface_normals move_to_limit(basic_mesh<>& mesh, const any_scheme& scheme, bool with_corners);

/// Same as above, but for the faces that a tile owns; the tile gets the normals. Precondition: it has its edges and as
/// many rings of ghosts as rings_for_limit says.
void move_to_limit(tile<std::array<double, 3>>& part, const any_scheme& scheme, bool with_corners);

/// How many rings of faces this looks at around some faces, for the vertices of these.
int rings_for_limit(const any_scheme& scheme);

/// The rings of ghosts that tiles have on the last level; nothing where it needs no edges, which limits and attributes
/// do.
std::optional<int> rings_of_last_level(const any_scheme& scheme, bool limit, bool has_attributes);

} // namespace kith::tool
