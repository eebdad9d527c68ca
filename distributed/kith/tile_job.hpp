// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile.hpp"

#include <span>

namespace kith {

/// A tile of level 0 and the scheme for it, whose creases are numbered as the tile is.
template <class Tile, class Scheme>
struct tile_job {
    Tile part;
    Scheme scheme;
};

namespace detail {

/// The part of a scheme's state (creases) that belongs to a submesh.
template <class Scheme, class Index>
Scheme scheme_of_part(const Scheme& scheme, std::span<const Index> vertex_from, std::span<const Index> edge_from)
{
    if constexpr (requires { scheme.of_part(vertex_from, edge_from); })
        return scheme.of_part(vertex_from, edge_from);
    else
        return scheme;
}

} // namespace detail

} // namespace kith
