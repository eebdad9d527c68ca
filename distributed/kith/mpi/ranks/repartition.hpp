// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/mpi/all_to_all.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <ranges>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::mpi {

namespace detail {

/// Returns the number of owned faces of each tile, on all ranks. `tiles` have a number and a part; `is_meant(tile)`
/// returns true for the tiles of the level. Collective.
template <std::ranges::input_range Tiles, std::predicate<const std::ranges::range_value_t<Tiles>&> IsMeant>
std::vector<std::uint64_t> owned_faces(communicator& comm, const Tiles& tiles, std::uint64_t all_tiles,
                                       const IsMeant& is_meant)
{
    std::vector<std::uint64_t> faces, seen;
    collective_phase(comm, [&] {
        faces.resize(all_tiles), seen.resize(all_tiles);
        for (const auto& tile : tiles) {
            if (not is_meant(tile))
                continue;
            if (tile.number >= all_tiles)
                throw mesh_error("tile " + std::to_string(tile.number) + " does not exist, there are " +
                                 std::to_string(all_tiles) + "; give the number of all tiles");
            ++seen[tile.number];
            faces[tile.number] += owned_count(tile.part.face_marks);
        }
    });
    seen = comm.sum(std::move(seen));
    collective_phase(comm, [&] {
        for (std::uint64_t t = 0; t < all_tiles; ++t)
            if (seen[t] != 1)
                throw mesh_error("tile " + std::to_string(t) + " is given " + std::to_string(seen[t]) +
                                 " times; give all tiles of the level, each once");
    });
    return comm.sum(std::move(faces));
}

} // namespace detail

/// Returns the number of faces that each tile owns, by the number of the tile, on all ranks. Collective. Errors:
/// phase_error for a tile that is missing, or given twice.
template <tile_like Tile>
std::vector<std::uint64_t> owned_faces(communicator& comm, std::span<const numbered_tile<Tile>> tiles,
                                       std::uint64_t all_tiles)
{
    return detail::owned_faces(comm, tiles, all_tiles, [](const auto&) { return true; });
}
/// Returns the number of owned faces for the tiles of `level` among `tiles`. Collective.
template <tile_like Tile, scheme Scheme>
std::vector<std::uint64_t> owned_faces(communicator& comm, const std::vector<kept_tile<Tile, Scheme>>& tiles, int level,
                                       std::uint64_t all_tiles)
{
    return detail::owned_faces(comm, tiles, all_tiles, [&](const auto& kept) { return kept.level == level; });
}

namespace detail {

/// Returns `all` stably sorted by a key. The elements, such as tiles with schemes, need not be assignable.
template <class T, class Key>
std::vector<T> in_order(std::vector<T>&& all, const Key& key)
{
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return key(all[i]); });
    std::vector<T> result;
    result.reserve(all.size());
    for (const std::size_t i : order)
        result.push_back(std::move(all[i]));
    return result;
}

} // namespace detail

/// Returns a rank for each tile, so that all ranks get about as many faces. The largest tile comes first; each goes to
/// the rank with the fewest faces (Graham 1969: at most 4/3 of the optimum). Equal tiles are taken in the order of
/// their numbers, so all ranks compute the same result. Local.
inline std::vector<int> balanced_ranks(std::span<const std::uint64_t> faces_of_tile, int ranks)
{
    std::vector<std::size_t> order(faces_of_tile.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t t) { return faces_of_tile[t]; });
    std::vector<std::uint64_t> load(std::size_t(ranks), 0);
    std::vector<int> rank_of(faces_of_tile.size());
    for (const std::size_t t : order) {
        const auto least = std::ranges::min_element(load);
        rank_of[t] = int(least - load.begin());
        *least += faces_of_tile[t];
    }
    return rank_of;
}

namespace detail {

/// Moves objects that have the number of a tile. `write(packer, moving)` empties one, `read(unpacker, number)` makes it
/// again. The result is sorted by order(object).
template <class Moving, std::invocable<packer&, Moving&> Write, std::invocable<unpacker&, std::uint64_t> Read,
          std::invocable<const Moving&> Order>
std::vector<Moving> move_to_ranks(communicator& comm, std::vector<Moving> tiles, std::span<const int> rank_of,
                                  const Write& write, const Read& read, const Order& order)
{
    collective_phase(comm, [&] {
        for (const auto& moving : tiles) {
            if (moving.number >= rank_of.size())
                throw mesh_error("tile " + std::to_string(moving.number) + " has no new rank; the list has " +
                                 std::to_string(rank_of.size()) + " ranks, give one per tile");
            if (const int rank = rank_of[moving.number]; rank < 0 or rank >= comm.size())
                throw mesh_error("tile " + std::to_string(moving.number) + " is to go to rank " + std::to_string(rank) +
                                 "; there are ranks 0 to " + std::to_string(comm.size() - 1));
        }
    });
    const auto came = all_to_all(comm, [&] {
        std::vector<std::vector<std::byte>> to(std::size_t(comm.size()));
        for (auto& moving : tiles) {
            packer out;
            out.add(moving.number);
            write(out, moving);
            const auto message = out.take();
            auto& bytes = to[std::size_t(rank_of[moving.number])];
            bytes.insert(bytes.end(), message.begin(), message.end());
        }
        return to;
    });
    return collective_phase(comm, [&] {
        std::vector<Moving> here;
        for (const auto& bytes : came)
            for (unpacker in(bytes); not in.is_at_end();) {
                const auto number = in.template get<std::uint64_t>();
                here.push_back(read(in, number));
            }
        return in_order(std::move(here), order);
    });
}

} // namespace detail

/// Moves tiles of any level to other ranks: tile t goes to rank `rank_of[t]`, which is the same list on all ranks.
/// Returns the tiles that are now on this rank, in the order of their numbers, with all their data. Their roots on
/// level 0 move with them. The origin of an element follows from its number, on any rank (global_numbering::origin,
/// global_lineage). Collective.
/// Errors: phase_error for a tile or a rank that does not exist, before anything is moved, and for lack of memory;
/// mpi::error.
/// Cost: a message per pair of ranks; the tiles of this rank are in memory twice meanwhile.
template <class Point, std::unsigned_integral Index>
std::vector<numbered_tile<tile<Point, Index>>>
repartition(communicator& comm, std::vector<numbered_tile<tile<Point, Index>>> tiles, std::span<const int> rank_of)
{
    using kith::detail::no_scheme;
    using moving = numbered_tile<tile<Point, Index>>;
    return detail::move_to_ranks(
        comm,
        std::move(tiles),
        rank_of,
        [](packer& out, moving& tile) {
            out.add_array(pack(tile_job<decltype(tile.part), no_scheme>{std::exchange(tile.part, {}), {}}));
        },
        [](unpacker& in, std::uint64_t number) {
            const auto packed = in.get_array<std::vector<std::byte>>();
            return moving{number, unpack<Point, Index>(packed, no_scheme()).part};
        },
        [](const moving& tile) { return tile.number; });
}

/// Moves tiles with their schemes, of one or several levels. Their state (creases, fields) moves with them. The levels
/// of a tile stay together, in their order. `scheme` gives the options, on all ranks; its state is not used.
/// Collective.
template <class Point, std::unsigned_integral Index, scheme Scheme>
std::vector<kept_tile<tile<Point, Index>, Scheme>> repartition(communicator& comm,
                                                               std::vector<kept_tile<tile<Point, Index>, Scheme>> tiles,
                                                               std::span<const int> rank_of, const Scheme& scheme)
{
    using moving = kept_tile<tile<Point, Index>, Scheme>;
    return detail::move_to_ranks(
        comm,
        std::move(tiles),
        rank_of,
        [](packer& out, moving& kept) {
            out.add(kept.level);
            out.add_array(pack(tile_job<decltype(kept.part), Scheme>{std::exchange(kept.part, {}), kept.scheme}));
        },
        [&](unpacker& in, std::uint64_t number) {
            const int level = in.get<int>();
            const auto packed = in.get_array<std::vector<std::byte>>();
            auto [part, its_scheme] = unpack<Point, Index>(packed, scheme);
            return moving{number, level, std::move(part), std::move(its_scheme)};
        },
        [](const moving& kept) { return std::pair(kept.number, kept.level); });
}

} // namespace kith::mpi
