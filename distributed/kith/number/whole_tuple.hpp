// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/association/columns.hpp>
#include <kith/part/tile_like.hpp>

#include <cstddef>

namespace kith {

/// A tuple of elements of a tile, as it is numbered in the whole mesh of that level.
struct whole_tuple {
    tuple_kind kind = tuple_kind::v;
    global_id id = 0;             ///< among all tuples of the kind
    global_id corners_before = 0; ///< (v), (f): corners at, or of, those before it; of vertices where the tile knows it
    global_id marked_before = 0;  ///< (e), (v,e): marked edges before the edge, if those are not all that come first
};

namespace detail {

template <tile_like Tile, level Level>
whole_tuple in_whole(const Tile& tile, const Level& level, tuple_kind kind, std::size_t tuple)
{
    const auto marked = [&](std::size_t e) {
        return tile.marked_before.empty() ? tile.edge_ids[e] : tile.marked_before[e];
    };
    const auto corner = [&](std::size_t c) {
        const auto f = level.corners()[c].f();
        return tile.corner_id(f.index(), c - f.first_corner().index());
    };
    switch (kind) {
    case tuple_kind::v:
        return {kind, tile.vertex_ids[tuple], tile.corners_before.empty() ? 0 : tile.corners_before[tuple]};
    case tuple_kind::e: return {kind, tile.edge_ids[tuple], 0, marked(tuple)};
    case tuple_kind::f: return {kind, tile.face_ids[tuple], tile.corner_id(tuple, 0)};
    case tuple_kind::ve: return {kind, tile.end_id(tuple / 2, tuple % 2), 0, marked(tuple / 2)};
    case tuple_kind::vfe: return {kind, 2 * corner(tuple / 2) + tuple % 2};
    default: return {kind, corner(tuple)};
    }
}

} // namespace detail

} // namespace kith
