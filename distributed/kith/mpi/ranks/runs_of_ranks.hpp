// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/mpi/all_to_all.hpp>
#include <kith/tiles/number/control_numbers.hpp>

namespace kith::mpi {

/// Returns the runs of a control mesh that the ranks know, joined, on all ranks. Collective. Errors: mpi::error. Cost:
/// a message of 24 bytes per run from each rank to rank 0, and all runs from there to all ranks.
inline control_runs runs_of_ranks(communicator& comm, const control_runs& mine)
{
    return {all_of_ranks(comm, mine.corners_of_faces),
            all_of_ranks(comm, mine.faces_at_vertices),
            all_of_ranks(comm, mine.marked_edges)};
}

} // namespace kith::mpi
