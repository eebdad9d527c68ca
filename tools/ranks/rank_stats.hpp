// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/refine_on_ranks.hpp>
#include <kith/tiles/part/phase_seconds.hpp>

#include <string>

namespace kith::tool {

/// Writes the work of each rank, a JSON object per line, in the order of the ranks. The last line has the minimum, mean
/// and maximum of the seconds of all ranks, phase by phase. Collective. Errors: phase_error.
void write_rank_stats(mpi::communicator& comm, const std::string& path, const mpi::work_done& done,
                      const phase_seconds& seconds);

} // namespace kith::tool
