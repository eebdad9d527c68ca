// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limits_of_tile.hpp"

#include <kith/surface/surface_locator.hpp>

#include <cstddef>
#include <span>
#include <string>

namespace kith {

/// Locates places in faces that a tile owns, given in the numbers of the tile. The result evaluates values at the
/// vertices of the tile. Points and derivatives have the bits of the whole level. `scheme` is the scheme of the tile.
/// Errors: mesh_error, with the number of the place, for a face that the tile does not own; for a face with too few
/// rings of ghosts around it; and as `surface_locator`. Cost: that of a `surface_locator` of the tile; O(corners) per
/// ring.
template <tile_like Tile, parametric_scheme Scheme>
located_places locate_in_tile(const Tile& part, const Scheme& scheme, std::span<const surface_place> places)
{
    require_edges(part.mesh);
    const int rings = detail::rings_of_surface(scheme);
    const auto has_rings = vertices_with_rings(part, rings - 1); // the first ring is at the vertex
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t face = places[i].face;
        if (face >= part.mesh.face_count())
            continue; // the locator refuses it
        const auto which = [&] {
            return "place " + std::to_string(i) + ": face " + std::to_string(face) + " of the tile ";
        };
        if (not part.owns_face(face))
            throw mesh_error(which() + "is a ghost; ask the tile that owns face " +
                             std::to_string(part.face_ids[face]));
        for (const auto v : part.mesh.face(face))
            if (has_rings[v] == 0)
                throw mesh_error(which() + "lacks neighbours that its surface depends on; refine or keep tiles with " +
                                 std::to_string(rings) + (rings == 1 ? " ring" : " rings") + " of ghosts");
    }
    return surface_locator(part.mesh, scheme).locate(places);
}

} // namespace kith
