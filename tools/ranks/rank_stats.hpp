// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/refine_on_ranks.hpp>
#include <kith/tiles/part/phase_seconds.hpp>

#include <string>

namespace kith::tool {

/// Writes what each rank did, a JSON object a line, in the order of the ranks, and last the least, the mean and the
/// most seconds of all ranks, phase by phase. Collective. Errors: phase_error.
void write_rank_stats(mpi::communicator& comm, const std::string& path, const mpi::work_done& done,
                      const phase_seconds& seconds);

} // namespace kith::tool
