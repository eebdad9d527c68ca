// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile.hpp"

#include <kith/level_state.hpp>

#include <concepts>
#include <utility>

namespace kith {

/// A tile of level 0 and the scheme for it, whose state (creases) is numbered as the tile is.
template <class Tile, class Scheme>
struct tile_job {
    Tile part;
    Scheme scheme;
};

namespace detail {

/// The scheme of a part of a level: the same, with the state of that part.
template <class Scheme, class Index>
Scheme scheme_of_part(Scheme scheme, const part_numbers<Index>& part)
{
    for_each_state(scheme, [&]<class State>(State& state) {
        constexpr bool parts = requires {
            { std::as_const(state).of_part(part) } -> std::convertible_to<State>;
        };
        static_assert(
            parts,
            "the state that a scheme names in its traits() needs of_part(const part_numbers<Index>&) const, which "
            "returns that of a part of the level, to be refined in tiles");
        if constexpr (parts)
            state = std::as_const(state).of_part(part);
    });
    return scheme;
}

} // namespace detail

} // namespace kith
