// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/refine_on_ranks.hpp>

#include <string>

namespace kith::tool {

/// Writes what each rank did, a JSON object a line, in the order of the ranks. Collective. Errors: phase_error.
void write_stats(mpi::communicator& comm, const std::string& path, const mpi::work_done& done);

} // namespace kith::tool
