// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "schemes.hpp"

#include <kith/mesh/basic_mesh.hpp>
#include <kith/part/tile.hpp>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace kith::tool {

/// Moves the vertices of a level to the limit surface and gives the unit normals there; with marks, those of the marked
/// vertices, of a mesh that may be a part. `scheme` is that of the level. Errors and cost: as limit_surface_of.
storage<std::array<double, 3>> move_to_limit(basic_mesh<>& mesh, const any_scheme& scheme,
                                             std::span<const unsigned char> marks = {});

/// The same of the faces that a tile owns; it gets its normals. Precondition: it has its edges and as many rings of
/// shadows as rings_for_limit says.
void move_to_limit(tile<std::array<double, 3>>& part, const any_scheme& scheme);

/// How many rings of faces this looks at around some faces, for the vertices of these.
int rings_for_limit(const any_scheme& scheme);

/// The rings of shadows that tiles have on the last level; nothing where it needs no edges, which limits and attributes
/// do.
std::optional<int> rings_of_last_level(const any_scheme& scheme, bool limit, bool has_attributes);

} // namespace kith::tool
