// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/error.hpp>
#include <kith/level/lift.hpp>
#include <kith/step/scheme.hpp>
#include <kith/tile/numbered_tile.hpp>

#include <string>
#include <type_traits>
#include <vector>

namespace kith {

/// What require_input asks of a control mesh, asked of its tiles. Their rims look like boundaries, so a scheme for
/// closed meshes has to be refused before. Errors: mesh_error.
template <scheme Scheme, tile_like Tile>
void require_tiles(const std::vector<numbered_tile<Tile>>& tiles)
{
    static_assert(not needs_closed<Scheme>, "a tile has a rim, so a scheme for closed meshes cannot refine it");
    for (const auto& [number, part] : tiles)
        try {
            require_input<Scheme>(level_of<std::remove_cvref_t<decltype(part.mesh)>>(part.mesh));
        } catch (const mesh_error& error) {
            throw mesh_error("tile " + std::to_string(number) + ": " + error.what() +
                             " (numbers are those of the tile)");
        }
}

} // namespace kith
