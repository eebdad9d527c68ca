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

} // namespace kith
