// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rank_request.hpp"
#include "job/job_memory.hpp"

#include <kith/mpi/communicator.hpp>

namespace kith::tool {

/// Collective: what each rank may use, the same on all: --memory-per-rank, or nine tenths of what is available where it
/// is least; ranks on one host share its memory. Errors: mpi::error.
memory_limit memory_of_ranks(mpi::communicator& comm, const rank_request& request);

} // namespace kith::tool
