// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Surfaces in tiles, on one machine, and their files.
#include "refine_in_tiles.hpp"
#include "require_reach.hpp"

#include <kith/output/ply_file.hpp>
#include <kith/output/tile_journal.hpp>
#include <kith/output/vtu_pieces.hpp>
#include <kith/part/checksum.hpp>
