// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/association/columns.hpp>
#include <kith/tiles/part/tile_like.hpp>

#include <cstddef>

namespace kith {

/// A tuple of elements of a tile with its number in the whole mesh of the level.
struct global_tuple {
    tuple_kind kind = tuple_kind::v;
    global_id id = 0;             ///< among all tuples of the kind
    global_id corners_before = 0; ///< (v), (f): corners at, or of, those before it; for (v) only if the tile has them
    global_id marked_before = 0;  ///< (e), (v,e): marked edges before the edge, if the marked ones do not come first
};

namespace detail {

/// Returns the global tuple of a tuple of a tile; `parent` is the element of the tile to which it belongs
/// (`parent_kind`).
template <tuple_kind Kind, tile_like Tile>
global_tuple in_whole(const Tile& tile, std::size_t parent, std::size_t tuple)
{
    const auto marked = [&] { return tile.marked_before.empty() ? tile.edge_ids[parent] : tile.marked_before[parent]; };
    const auto corner = [&](std::size_t c) {
        return tile.corner_id(parent, c - tile.mesh.topology().first_corner(parent));
    };
    if constexpr (Kind == tuple_kind::v)
        return {Kind, tile.vertex_ids[tuple], tile.corners_before.empty() ? 0 : tile.corners_before[tuple]};
    else if constexpr (Kind == tuple_kind::e)
        return {Kind, tile.edge_ids[tuple], 0, marked()};
    else if constexpr (Kind == tuple_kind::f)
        return {Kind, tile.face_ids[tuple], tile.corner_id(tuple, 0)};
    else if constexpr (Kind == tuple_kind::ve)
        return {Kind, tile.end_id(parent, tuple % 2), 0, marked()};
    else if constexpr (Kind == tuple_kind::vfe)
        return {Kind, 2 * corner(tuple / 2) + tuple % 2};
    else
        return {Kind, corner(tuple)};
}

} // namespace detail

} // namespace kith
