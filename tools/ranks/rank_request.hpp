// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/command_line.hpp"
#include "job/tile_request.hpp"

#include <kith/refine_on_ranks.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kith::tool {

/// The request of a command line of kith-mpi; all ranks read the same one.
struct rank_request {
    tile_request what; ///< the surface; rank 0 reads its control mesh later, or all of it if `input` is empty
    std::string input; ///< the value of IN; if empty, the journal determines what is refined
    std::string partitioner, journal, stats;
    std::optional<std::uint64_t> tiles_per_rank{}; ///< if not given, the usual number
    std::uint64_t memory_per_rank = 0;             ///< in bytes; 0 if not given
    std::uint64_t threads = 1;
    mpi::sharing sharing = mpi::sharing::spmd;
    bool verify = false;
    bool with_checksum = false;
    bool slices = false; ///< each rank reads its share of the file, none the whole control mesh
};

/// Returns the request of a command line, or nothing if --help or --version was given. Errors: usage_error, and
/// file_error for an output without a name.
std::optional<rank_request> rank_request_from(const verb& verb, const std::vector<std::string>& arguments);

} // namespace kith::tool
