// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rank_request.hpp"

namespace kith::tool {

/// Refines in tiles on all ranks, into one file or, for .pvtu, a file per tile, and prints the counts of the surface.
/// With a journal, finished tiles are left out. Collective. Errors: usage_error for a scheme without reach;
/// phase_error, after which no file is left but the journal.
void refine_ranks(mpi::communicator& comm, rank_request& request);

} // namespace kith::tool
