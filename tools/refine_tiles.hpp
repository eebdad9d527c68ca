// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_request.hpp"

#include <kith/checksum.hpp>
#include <kith/partition.hpp>
#include <kith/whole_numbering.hpp>

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

struct tiled_result {
    whole_counts counts;
    std::uint64_t tiles = 0;
    std::uint64_t finished_tiles = 0; ///< if less than all, the output waits in the journal for the others
    mesh_checksum checksum;           ///< of what is finished
};

/// Refines in tiles, one after the other, and writes each where it belongs; the whole surface is never in memory. With a
/// journal, tiles that are finished are left out and, if there is a range, all others outside of it.
/// Errors: usage_error for a scheme without reach and for tiles that do not exist, file_error, mesh_error, write_error; no
/// file is left then but the journal.
tiled_result refine_tiles(const tile_request& request, const std::string& journal,
                          const std::optional<tile_range>& only, const std::function<partition()>& make_parts);

} // namespace kith::tool
