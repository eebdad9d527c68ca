// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/part/tile.hpp>
#include <kith/step/level_state.hpp>
#include <kith/step/step.hpp>

#include <concepts>
#include <span>
#include <utility>

namespace kith {

/// A tile of level 0 and the scheme for it, whose state (creases) is numbered as the tile is.
template <class Tile, class Scheme>
struct tile_job {
    Tile part;
    Scheme scheme;
};

namespace detail {

/// The scheme of a tile of level 0: the same, with its state, which is that of the whole mesh, for the part.
template <class Scheme, class Tile>
Scheme scheme_of_tile(const Scheme& scheme, const Tile& part)
{
    const auto numbers = [](const auto& ids) { return std::span<const global_id>(ids.data(), ids.size()); };
    return scheme_of_part(
        scheme, part_numbers<global_id>{numbers(part.vertex_ids), numbers(part.edge_ids), numbers(part.face_ids)});
}

/// Makes a scheme that refines no element here the scheme of the next level: its state may count levels.
template <class Mesh, class Scheme>
void advance_without_elements(Scheme& scheme, int generation)
{
    if constexpr (has_state<Scheme>) {
        const Mesh nothing;
        const level_of<Mesh> level(nothing);
        advance(scheme,
                level,
                numbering_of<Scheme, typename level_of<Mesh>::index_type>(level, columns_of(scheme, generation)));
    }
}

} // namespace detail

} // namespace kith
