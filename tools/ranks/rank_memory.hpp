// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rank_request.hpp"
#include "job/job_memory.hpp"

#include <kith/mpi/communicator.hpp>

namespace kith::tool {

/// Returns the memory that each rank may use, the same on all ranks: --memory-per-rank, or nine tenths of the available
/// memory of the rank that has least. Ranks on one host share its memory. Collective. Errors: mpi::error.
memory_limit memory_of_ranks(mpi::communicator& comm, const rank_request& request);

} // namespace kith::tool
