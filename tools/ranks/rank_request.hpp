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

/// What the command line of kith-mpi asks for; all ranks read it alike.
struct rank_request {
    tile_request what; ///< its control mesh is read later, by rank 0; without input all of it
    std::string input; ///< empty: the journal says what is refined
    std::string partitioner, journal, stats;
    std::optional<std::uint64_t> tiles_per_rank{}; ///< nothing: as many as are usual
    std::uint64_t memory_per_rank = 0;             ///< in bytes; 0: whatever it takes
    std::uint64_t threads = 1;
    mpi::sharing sharing = mpi::sharing::spmd;
    bool verify = false;
    bool with_checksum = false;
    bool slices = false; ///< no rank reads the whole control mesh, each its share of the file
};

/// Empty when --help or --version was asked for. Errors: usage_error.
std::optional<rank_request> rank_request_from(const verb& verb, const std::vector<std::string>& arguments);

} // namespace kith::tool
