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

/// The first and the last of some tiles.
struct tile_range {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
};

/// --only: "100..199" or "7". Errors: usage_error.
tile_range tile_range_from(const std::string& text);

/// Errors: usage_error for a scheme without reach.
void require_reach(const tile_request& request);

/// How a surface is refined in tiles; its bytes do not depend on it.
struct tiling {
    std::string journal;             ///< a directory, or nothing
    std::optional<tile_range> only;  ///< of the tiles that are missing in the journal
    bool verify = false;             ///< read back what is written, and look after what was finished before
    bool with_checksum = false;      ///< there is one in any case where there is a journal
    std::optional<recipe> kept = {}; ///< when the journal has said what is refined
    std::string partitioner = {};    ///< of new tiles
    memory_limit memory = {};
    std::function<partition()> make_parts;
};

struct tiled_result {
    global_counts counts;
    std::uint64_t tiles = 0;
    std::uint64_t finished_tiles = 0;      ///< if less than all, the output waits in the journal for the others
    std::optional<mesh_checksum> checksum; ///< of what is finished, if known
    phase_seconds seconds;
};

/// Refines in tiles and writes each where it belongs; the whole surface is never in memory. On several threads each has
/// a tile of its own. With a journal, tiles that are finished are left out and, if there is a range, all others outside
/// of it.
/// Errors: usage_error for a scheme without reach and for tiles that do not exist, mesh_error for what needs more
/// memory than there may be, file_error, write_error; no file is left then but the journal.
tiled_result refine_tiles(const tile_request& request, const tiling& how);

} // namespace kith::tool
