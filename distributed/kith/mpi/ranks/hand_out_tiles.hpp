// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/mpi/communicator.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace kith::mpi {

/// A tile by its number, as a message.
using packed_tile = std::pair<std::uint64_t, std::vector<std::byte>>;

/// Hands out tiles from rank 0 in this order to ranks that ask, while all others are in ask_for_tiles. `cut(t)` makes
/// tile t as a message. Errors: std::runtime_error for an exception of `cut`; the others are then told that no tiles
/// are left.
template <std::invocable<std::uint64_t> Cut>
void hand_out_tiles(communicator& comm, const std::vector<std::uint64_t>& order, const Cut& cut)
{
    std::size_t next = 0;
    std::string problem;
    for (int working = comm.size() - 1; working > 0;) {
        int worker = communicator::any_rank;
        const auto question = comm.receive(worker);
        const auto wanted = unpacker(question).get<std::uint64_t>();
        if (wanted == 0)
            next = order.size(); // the rank has failed, so the remaining tiles are not needed
        std::vector<std::byte> answer;
        if (next < order.size() and problem.empty()) {
            const std::uint64_t left = order.size() - next; // the last tiles are shared among all working ranks
            const auto count = std::clamp<std::uint64_t>(left / std::uint64_t(working), 1, wanted);
            problem = problem_of(
                [&] {
                    packer out;
                    out.add(count);
                    for (std::uint64_t i = 0; i < count; ++i)
                        out.add(order[next + i]).add_array(cut(order[next + i]));
                    answer = out.take();
                },
                "there is not enough memory to cut tiles");
            next += count;
        }
        working -= answer.empty();
        comm.send(answer, worker);
    }
    if (not problem.empty())
        throw std::runtime_error(problem);
}

/// Asks rank 0 for up to `wanted` tiles at a time and calls refine(std::vector<packed_tile>) until none are left. All
/// ranks but 0 call this.
/// Errors: std::runtime_error for an exception of `refine`, with the text `no_memory` for lack of memory; the rank then
/// asks for no more tiles.
template <std::invocable<std::vector<packed_tile>> Refine>
void ask_for_tiles(communicator& comm, std::uint64_t wanted, const char* no_memory, const Refine& refine)
{
    std::string problem;
    for (;;) {
        comm.send(packer().add(problem.empty() ? wanted : 0).take(), 0);
        int root = 0;
        const auto answer = comm.receive(root);
        if (answer.empty())
            break;
        problem = problem_of(
            [&] {
                unpacker in(answer);
                std::vector<packed_tile> tiles(in.get<std::uint64_t>());
                for (auto& [number, packed] : tiles) {
                    number = in.get<std::uint64_t>();
                    packed = in.get_array<std::vector<std::byte>>();
                }
                refine(std::move(tiles));
            },
            no_memory);
    }
    if (not problem.empty())
        throw std::runtime_error(problem);
}

} // namespace kith::mpi
