// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Surfaces in tiles, on one machine, and their files.
#include "refine_in_tiles.hpp"
#include "require_reach.hpp"

#include <kith/tiles/output/ply_file.hpp>
#include <kith/tiles/output/tile_journal.hpp>
#include <kith/tiles/output/vtu_pieces.hpp>
#include <kith/tiles/part/checksum.hpp>
#include <kith/tiles/part/tile_places.hpp>
