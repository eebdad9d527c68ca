// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job_memory.hpp"
#include "journal.hpp"
#include "tile_request.hpp"

#include <kith/tiles/number/global_numbering.hpp>
#include <kith/tiles/part/checksum.hpp>
#include <kith/tiles/part/partition.hpp>
#include <kith/tiles/part/phase_seconds.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace kith::tool {

/// The numbers of the first and the last tile of a range.
struct tile_range {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
};

/// Returns the range of tiles that a value of --only names: "100..199" or "7". Errors: usage_error.
tile_range tile_range_from(const std::string& text);

/// Throws usage_error for a scheme without reach.
void require_reach(const tile_request& request);

/// The options of a refinement in tiles that do not change the bytes of the surface.
struct tiling {
    std::string journal;             ///< a directory, or empty
    std::optional<tile_range> only;  ///< range of the missing tiles to refine
    bool verify = false;             ///< read back what is written, and check tiles that were finished before
    bool with_checksum = false;      ///< compute a checksum; a journal always needs one
    std::optional<recipe> kept = {}; ///< the recipe, if the journal determines what is refined
    std::string partitioner = {};    ///< how new tiles are cut
    memory_limit memory = {};
    std::function<partition()> make_parts;
};

struct tiled_result {
    global_counts counts;
    std::uint64_t tiles = 0;
    std::uint64_t finished_tiles = 0;      ///< if less than all, the output stays in the journal
    std::optional<mesh_checksum> checksum; ///< checksum of the finished tiles, if known
    phase_seconds seconds;
};

/// Refines in tiles and writes each tile to its place; the whole surface is never in memory. With several threads, each
/// thread has a tile of its own. With a journal, finished tiles are left out and, if there is a range, all other tiles
/// outside it.
/// Errors: usage_error for a scheme without reach and for tiles that do not exist; mesh_error for a job that needs more
/// memory than it may have; file_error; write_error. After an error no file is left but the journal.
tiled_result refine_tiles(const tile_request& request, const tiling& how);

} // namespace kith::tool
