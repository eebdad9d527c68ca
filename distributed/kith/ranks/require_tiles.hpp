// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/error.hpp>
#include <kith/level/lift.hpp>
#include <kith/mpi/communicator.hpp>
#include <kith/mpi/in_agreement.hpp>
#include <kith/step/scheme.hpp>
#include <kith/tile/numbered_tile.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace kith {

/// What require_input asks of a control mesh, asked of its tiles. Their rims look like boundaries, so a scheme for
/// closed meshes has to be refused before. Errors: mesh_error.
template <scheme Scheme, tile_like Tile>
void require_tiles(const std::vector<numbered_tile<Tile>>& tiles, const Scheme& scheme)
{
    static_assert(not needs_closed<Scheme>, "a tile has a rim, so a scheme for closed meshes cannot refine it");
    for (const auto& [number, part] : tiles)
        try {
            require_input(scheme, level_of<std::remove_cvref_t<decltype(part.mesh)>>(part.mesh));
        } catch (const mesh_error& error) {
            throw mesh_error("tile " + std::to_string(number) + ": " + error.what() +
                             " (numbers are those of the tile)");
        }
}

namespace mpi {

/// Collective. How many tiles all ranks hold; their numbers have to be those from 0 on, each once, since tiles are
/// asked for by them. Errors: phase_error. Cost: O(tiles) on each rank.
template <tile_like Tile>
std::uint64_t require_all_tiles(communicator& comm, const std::vector<numbered_tile<Tile>>& tiles)
{
    const std::uint64_t count = comm.sum(std::array{std::uint64_t(tiles.size())})[0];
    std::vector<std::uint64_t> held;
    in_agreement(comm, [&] {
        held.resize(count, 0);
        for (const auto& [number, part] : tiles) {
            if (number >= count)
                throw mesh_error("tile " + std::to_string(number) + " is one of " + std::to_string(count) +
                                 "; number them from 0 to " + std::to_string(count - 1));
            ++held[number];
        }
    });
    held = comm.sum(std::move(held));
    in_agreement(comm, [&] {
        for (std::size_t number = 0; number < held.size(); ++number)
            if (held[number] > 1)
                throw mesh_error("tile " + std::to_string(number) + " is held " + std::to_string(held[number]) +
                                 " times; give each tile a number of its own");
    });
    return count;
}

} // namespace mpi

} // namespace kith
