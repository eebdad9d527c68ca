// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/mpi/all_to_all.hpp>
#include <kith/tiles/number/control_numbers.hpp>

namespace kith::mpi {

/// Collective: what the ranks know of a control mesh, together, on all of them. Errors: mpi::error. Cost: a message of
/// 24 bytes per run from each rank to rank 0, and all of them from there to all.
inline control_runs runs_of_ranks(communicator& comm, const control_runs& mine)
{
    return {all_of_ranks(comm, mine.corners_of_faces),
            all_of_ranks(comm, mine.faces_at_vertices),
            all_of_ranks(comm, mine.marked_edges)};
}

} // namespace kith::mpi
