// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/level/to_native.hpp>
#include <kith/mpi/communicator.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/numbering/step/scheme.hpp>
#include <kith/tiles/part/checksum.hpp>
#include <kith/tiles/part/scheme_members.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// Throws mesh_error for tiles of a control mesh that require_input would refuse. Their cuts look like boundaries, so a
/// scheme for closed meshes must be refused before.
template <scheme Scheme, tile_like Tile>
void require_tiles(const std::vector<numbered_tile<Tile>>& tiles, const Scheme& scheme)
{
    static_assert(not needs_closed<Scheme>, "a tile has a boundary, so a scheme for closed meshes cannot refine it");
    for (const auto& [number, part] : tiles)
        try {
            if (part.mesh.face_count() != 0 and part.mesh.topology().faces_only())
                throw mesh_error("has no edges; refine it with last_rings, 0 or more");
            require_input(scheme, level_of<std::remove_cvref_t<decltype(part.mesh)>>(part.mesh));
        } catch (const mesh_error& error) {
            throw mesh_error("tile " + std::to_string(number) + ": " + error.what() +
                             " (numbers are those of the tile)");
        }
}

namespace mpi {

/// Returns the number of tiles on all ranks. Their numbers must be those from 0 on, each once, since tiles are
/// requested by number. Collective. Errors: phase_error. Cost: O(tiles) on each rank.
template <tile_like Tile>
std::uint64_t require_all_tiles(communicator& comm, const std::vector<numbered_tile<Tile>>& tiles)
{
    const std::uint64_t count = comm.sum(std::array{std::uint64_t(tiles.size())})[0];
    std::vector<std::uint64_t> held;
    collective_phase(comm, [&] {
        held.resize(count, 0);
        for (const auto& [number, part] : tiles) {
            if (number >= count)
                throw mesh_error("tile " + std::to_string(number) + " does not exist, there are " +
                                 std::to_string(count) + "; number them from 0 to " + std::to_string(count - 1));
            ++held[number];
        }
    });
    held = comm.sum(std::move(held));
    collective_phase(comm, [&] {
        for (std::size_t number = 0; number < held.size(); ++number)
            if (held[number] > 1)
                throw mesh_error("tile " + std::to_string(number) + " is held " + std::to_string(held[number]) +
                                 " times; give each tile a number of its own");
    });
    return count;
}

/// Returns the generation that all tiles of a level have, on ranks without tiles as well. Collective.
/// Errors: mpi::error.
template <tile_like Tile>
int generation_of_tiles(communicator& comm, const std::vector<numbered_tile<Tile>>& tiles)
{
    double generation = 0;
    for (const auto& [number, part] : tiles)
        generation = std::max(generation, double(part.mesh.generation()));
    return int(comm.maximum(std::array{generation})[0]);
}

/// Returns the fewest complete rings of ghosts of all tiles, and the complete rings of each tile of this rank; all are
/// at most `most`. Collective. Errors: phase_error for a tile without edges.
template <tile_like Tile>
std::pair<int, std::vector<int>> rings_of_tiles(communicator& comm, std::span<const numbered_tile<Tile>> tiles,
                                                int most)
{
    auto rings = collective_phase(comm, [&] {
        std::vector<int> result;
        for (const auto& tile : tiles)
            result.push_back(complete_rings(tile.part, most));
        return result;
    });
    const int here = rings.empty() ? most : *std::ranges::min_element(rings);
    return {int(comm.minimum(std::array{double(here)})[0]), std::move(rings)};
}

/// Throws phase_error unless all ranks refine with the same options, number of levels and `last_rings`. Collective.
template <scheme Scheme>
void require_same_refinement(communicator& comm, const Scheme& scheme, std::uint64_t levels,
                             std::optional<int> last_rings)
{
    require_same_on_ranks(comm, levels, "the number of levels");
    require_same_on_ranks(comm, std::uint64_t(last_rings.value_or(-1)), "last_rings");
    require_same_on_ranks(comm, kith::detail::sum_of_options(scheme), "an option of the scheme");
}
/// Throws phase_error unless all ranks ask for the same tiles, in the same way of sharing. Collective.
inline void require_same_tiles(communicator& comm, const std::vector<std::uint64_t>& numbers, std::uint64_t sharing)
{
    kith::detail::word_hash hash(sharing);
    for (const std::uint64_t number : numbers)
        hash.add(number);
    require_same_on_ranks(comm, hash.bits(), "the list of tiles, or the way of sharing them,");
}

} // namespace mpi

} // namespace kith
