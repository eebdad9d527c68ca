// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/mpi/collective_phase.hpp>
#include <kith/mpi/send_window.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kith::mpi {

/// Sends tile t to rank t modulo ranks. `pack(t)` makes tile t as a message on rank 0. Returns the messages of this
/// rank in the order of the tiles, all at once, since control faces are few. Rank 0 holds at most four messages for
/// others at a time. Collective. Errors: phase_error for an exception of `pack`.
template <class Pack>
std::vector<std::vector<std::byte>> deal_tiles(communicator& comm, std::uint64_t tiles, const Pack& pack)
{
    std::vector<std::vector<std::byte>> mine;
    std::string problem; // the others wait for tiles, so they get empty ones after an error
    const auto packed = [&](std::uint64_t t) {
        std::vector<std::byte> result;
        if (problem.empty())
            problem = problem_of([&] { result = pack(t); }, "there is not enough memory to cut tiles");
        return result;
    };
    send_window outgoing(comm, 4);
    for (std::uint64_t t = 0; t < tiles; ++t) {
        const int to = int(t % std::uint64_t(comm.size()));
        int root = 0;
        if (comm.is_root() and to != 0)
            outgoing.send(packed(t), to);
        else if (to == comm.rank())
            mine.push_back(comm.is_root() ? packed(t) : comm.receive(root));
    }
    outgoing.finish();
    comm.agree(problem);
    return mine;
}

} // namespace kith::mpi
