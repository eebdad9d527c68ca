// SPDX-License-Identifier: BSD-3-Clause
// Refines some faces only, on the ranks of a job.
#include <kith/catmull_clark.hpp>
#include <kith/refine_on_ranks.hpp>
#include <kith/selected.hpp>

void refine(kith::mpi::communicator& comm, const kith::basic_mesh<>& mesh, const kith::partition& parts)
{
    kith::mpi::rank_refinement refinement(comm, mesh, kith::selected(kith::catmull_clark{}), 1, parts);
    refinement.refine(kith::mpi::sharing::spmd, [](auto&&...) {});
}
