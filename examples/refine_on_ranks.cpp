// SPDX-License-Identifier: BSD-3-Clause
// Refines a mesh on a cluster in about twenty lines. Rank 0 has the control mesh. All ranks refine its surface tile by
// tile; no rank holds all of it. The bounding box and the checksum are the same on any number of ranks.
// Sample run: mpirun -n 4 refine_on_ranks

#include "../tests/support/figures.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/metis_partition.hpp>
#include <kith/refine_on_ranks.hpp>
#include <kith/tiles/part/checksum.hpp>

#include <algorithm>
#include <array>
#include <iostream>

int main(int count, char** words)
{
    kith::mpi::session session(count, words);
    kith::mpi::communicator comm(MPI_COMM_WORLD);

    kith::basic_mesh<> cage; // stays empty on all other ranks
    kith::partition parts;
    if (comm.is_root()) {
        const auto torus = figures::torus();
        cage = kith::make_mesh(torus.points, torus.faces);
        parts = kith::metis_partition(cage, 4 * std::size_t(comm.size()));
    }

    const int levels = 4;
    kith::mpi::rank_refinement refinement(comm, cage, kith::catmull_clark{}, levels, parts);
    std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    kith::mesh_checksum mine;
    const auto done = refinement.refine(kith::mpi::sharing::spmd, [&](std::uint64_t, const auto& tile) {
        mine += kith::checksum(tile);
        for (const auto& point : tile.mesh.points())
            for (int i = 0; i < 3; ++i)
                low[i] = std::min(low[i], point[i]), high[i] = std::max(high[i], point[i]);
    });

    low = comm.minimum(low);
    high = comm.maximum(high);
    const auto [faces, checksum] = comm.sum(std::array{done.owned_faces, mine.bits});
    if (comm.is_root())
        std::cout << faces << " faces from " << low[0] << ' ' << low[1] << ' ' << low[2] << " to " << high[0] << ' '
                  << high[1] << ' ' << high[2] << ", checksum " << std::hex << checksum << '\n';
    return faces == refinement.whole().counts(levels).faces ? 0 : 1;
}
