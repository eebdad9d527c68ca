// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grow_ghosts.hpp"
#include "require_tiles.hpp"

#include <kith/core/base/error.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/tiles/number/column_facts.hpp>
#include <kith/tiles/number/control_numbers.hpp>
#include <kith/tiles/number/global_counts.hpp>
#include <kith/tiles/part/scheme_members.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>
#include <kith/tiles/refine/plan_tile.hpp>
#include <kith/tiles/refine/tile_job.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::mpi {

namespace detail {

template <class State, class Index>
concept joinable_state = requires(State& state, const State& more, const part_numbers<Index>& part) {
    state.add_part(more, part);
};
template <std::unsigned_integral Index, class... States>
consteval bool can_join(kith::detail::type_list<States...>)
{
    return (joinable_state<States, Index> and ...);
}

} // namespace detail

/// The tiles of level 0 that already lay on their ranks. They are refined there, each once.
template <tile_like Tile, scheme Scheme>
class held_tiles {
public:
    using job_type = tile_job<Tile, Scheme>;

    /// Takes tiles, and requires that all exist, numbered from 0 on, and that `scheme` takes their faces. `counts` are
    /// those of the whole mesh. Collective. Errors: phase_error.
    held_tiles(communicator& comm, std::vector<numbered_tile<Tile>> tiles, const global_counts& counts,
               const Scheme& scheme)
        : tiles_(std::move(tiles))
    {
        require(comm, counts, scheme);
    }
    /// Takes tiles that have a scheme each, with the same requirements. Collective. Errors: phase_error.
    held_tiles(communicator& comm, std::vector<kept_tile<Tile, Scheme>> tiles, const global_counts& counts,
               const Scheme& scheme)
    {
        collective_phase(comm, [&] {
            for (auto& kept : tiles) {
                tiles_.push_back({kept.number, std::move(kept.part)});
                schemes_.push_back(std::move(kept.scheme));
            }
        });
        require(comm, counts, scheme);
    }

    /// Returns the number of tiles on all ranks.
    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] int generation() const { return generation_; }
    /// Returns the runs of the control mesh that the tiles of this rank know.
    [[nodiscard]] const control_runs& runs() const { return runs_; }
    [[nodiscard]] const std::vector<numbered_tile<Tile>>& tiles() const { return tiles_; }
    [[nodiscard]] std::size_t size() const { return tiles_.size(); }

    /// Fetches rings of ghosts, with the state there, until all tiles have `rings` of them. If tiles have no schemes,
    /// the state of `scheme` is that of the whole mesh. Collective.
    /// Errors: phase_error for a tile without a complete ring, and if state cannot be joined. Cost: that of
    /// grow_ghosts, if rings are missing.
    void require_rings(communicator& comm, const Scheme& scheme, int rings)
    {
        const auto [fewest, of_tile] = rings_of_tiles(comm, std::span<const numbered_tile<Tile>>(tiles_), rings);
        if (fewest >= rings)
            return;
        if constexpr (detail::can_join<typename Tile::index_type>(kith::detail::state_types<Scheme>())) {
            collective_phase(comm, [&] {
                if (schemes_.empty())
                    for (const auto& [number, part] : tiles_)
                        schemes_.push_back(kith::detail::scheme_of_tile(scheme, part));
            });
            grow_ghosts(comm, std::span(tiles_), std::span(schemes_), rings);
        } else {
            collective_phase(comm, [&, &of_tile = of_tile] {
                for (std::size_t t = 0; t < tiles_.size(); ++t)
                    if (of_tile[t] < rings)
                        throw mesh_error("tile " + std::to_string(tiles_[t].number) + " has " +
                                         std::to_string(of_tile[t]) + " complete rings of ghosts and needs " +
                                         std::to_string(rings) + "; cut or read tiles with " + std::to_string(rings) +
                                         " rings (ring_schedule), or add add_part to the state of the scheme, so that "
                                         "rings can be fetched");
            });
        }
    }

    /// Returns the indices of the tiles of this rank that have one of these numbers. Local.
    [[nodiscard]] std::vector<std::size_t> among(const std::vector<std::uint64_t>& numbers) const
    {
        std::vector<std::size_t> result;
        for (std::size_t i = 0; i < tiles_.size(); ++i)
            if (std::ranges::find(numbers, tiles_[i].number) != numbers.end())
                result.push_back(i);
        return result;
    }
    /// Throws mesh_error if one of these tiles has been taken. Local.
    void require_there(const std::vector<std::uint64_t>& numbers) const
    {
        for (const std::size_t i : among(numbers))
            if (is_taken_[i] != 0)
                throw mesh_error("tile " + std::to_string(tiles_[i].number) +
                                 " was already used on this rank; give its level 0 to another rank_refinement");
    }
    /// Moves the i-th tile and its scheme out. Local.
    [[nodiscard]] job_type take(std::size_t i, const Scheme& scheme)
    {
        is_taken_[i] = 1;
        auto& part = tiles_[i].part;
        Scheme mine = schemes_.empty() ? kith::detail::scheme_of_tile(scheme, part) : std::move(schemes_[i]);
        return {std::move(part), std::move(mine)};
    }
    /// Returns the size of the tile with the most owned corners, which takes the most memory. Local.
    [[nodiscard]] tile_size largest() const
    {
        tile_size result;
        for (const auto& [number, part] : tiles_) {
            tile_size size;
            for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
                if (part.owns_face(f)) {
                    size.faces += 1;
                    size.corners += double(part.mesh.face(f).size());
                } else {
                    size.ghosts += 1;
                }
            if (size.corners > result.corners)
                result = size;
        }
        return result;
    }

private:
    void require(communicator& comm, const global_counts& counts, const Scheme& scheme)
    {
        count_ = require_all_tiles(comm, tiles_);
        generation_ = generation_of_tiles(comm, tiles_);
        collective_phase(comm, [&] {
            const std::string name(scheme_name<Scheme>());
            if constexpr (marks_edges<Scheme>)
                throw mesh_error(name + ": marked edges can be counted only on a whole mesh; cut it on one rank");
            if (numbers_boundary<Scheme> and counts.corners != 2 * counts.edges)
                throw mesh_error(
                    name + ": its element numbers depend on the boundary, and the mesh has one; cut it on one rank");
            require_tiles(tiles_, scheme);
            if constexpr (not marks_edges<Scheme>)
                for (const auto& [number, part] : tiles_)
                    runs_.append(control_runs_of<Scheme>(part));
            is_taken_.assign(tiles_.size(), 0);
        });
    }

    std::vector<numbered_tile<Tile>> tiles_;
    std::vector<Scheme> schemes_; // of the tiles, if they have one each
    std::vector<unsigned char> is_taken_;
    std::uint64_t count_ = 0; // on all ranks
    int generation_ = 0;
    control_runs runs_;
};

} // namespace kith::mpi
