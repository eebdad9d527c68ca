// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/mpi/communicator.hpp>
#include <kith/tile/numbered_tile.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace kith::mpi {

/// Collective. The generation that all tiles of a level have, on ranks without tiles, too. Errors: mpi::error.
template <tile_like Tile>
int generation_of_tiles(communicator& comm, const std::vector<numbered_tile<Tile>>& tiles)
{
    double generation = 0;
    for (const auto& [number, part] : tiles)
        generation = std::max(generation, double(part.mesh.generation()));
    return int(comm.maximum(std::array{generation})[0]);
}

} // namespace kith::mpi
