// SPDX-License-Identifier: BSD-3-Clause
#include "on_ranks.hpp"

#include <kith/mpi/all_to_all.hpp>
#include <kith/mpi/send_window.hpp>

#include <array>
#include <chrono>
#include <ctime>
#include <functional>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

std::vector<std::byte> some_bytes(std::size_t size, int seed)
{
    std::vector<std::byte> result(size);
    for (std::size_t i = 0; i < size; ++i)
        result[i] = std::byte(i * 7 + std::size_t(seed));
    return result;
}

} // namespace

TEST(communicator, sends_long_messages_in_pieces)
{
    kith::mpi::communicator comm(MPI_COMM_WORLD, 10);
    for (const std::size_t size : {0, 1, 9, 10, 11, 95}) {
        const auto before = comm.sent_and_received();
        if (comm.is_root()) {
            for (int to = 1; to < comm.size(); ++to)
                comm.send(some_bytes(size, to), to);
        } else {
            int from = kith::mpi::communicator::any_rank;
            EXPECT_EQ(comm.receive(from), some_bytes(size, comm.rank())) << size;
            EXPECT_EQ(from, 0);
            const auto& after = comm.sent_and_received();
            EXPECT_EQ(after.messages_received - before.messages_received, 1 + (size + 9) / 10);
            EXPECT_EQ(after.bytes_received - before.bytes_received, 8 + size);
        }
        EXPECT_EQ(comm.broadcast(comm.is_root() ? some_bytes(size, 77) : std::vector<std::byte>()),
                  some_bytes(size, 77));
    }
}

TEST(communicator, waits_without_a_processor)
{
    kith::mpi::communicator comm(MPI_COMM_WORLD);
    const auto processor_seconds = [] {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
    };
    const auto late = std::chrono::milliseconds(400);
    const std::vector<std::function<void()>> calls{[&] { comm.agree(""); },
                                                   [&] { (void)comm.sum(std::array<std::uint64_t, 1>{1}); },
                                                   [&] { (void)comm.broadcast(some_bytes(5, 1)); },
                                                   [&] {
                                                       int from = 0;
                                                       if (not comm.is_root())
                                                           (void)comm.receive(from);
                                                       for (int to = 1; comm.is_root() and to < comm.size(); ++to)
                                                           comm.send(some_bytes(5, 1), to);
                                                   }};
    for (const auto& call : calls) {
        const double before = processor_seconds(), waited = comm.seconds()[kith::phase::wait];
        if (comm.is_root())
            std::this_thread::sleep_for(late);
        call();
        EXPECT_LT(processor_seconds() - before, 0.2);
        if (not comm.is_root()) {
            EXPECT_GT(comm.seconds()[kith::phase::wait] - waited, 0.1);
        }
    }
}

TEST(send_window, holds_a_few_messages_at_a_time)
{
    kith::mpi::communicator comm(MPI_COMM_WORLD, 100'000); // a limit that cuts every message
    constexpr std::size_t size = 250'001, messages = 9;
    if (comm.is_root()) {
        for (const std::size_t width : {1, 3}) {
            kith::mpi::send_window window(comm, width);
            for (std::size_t i = 0; i < messages; ++i)
                for (int to = 1; to < comm.size(); ++to)
                    window.send(some_bytes(size + i, int(i)), to);
            window.finish();
            EXPECT_LE(window.most_bytes(), width * (size + messages));
        }
    } else {
        for (std::size_t i = 0; i < 2 * messages; ++i) {
            int from = 0;
            EXPECT_TRUE(comm.receive(from) == some_bytes(size + i % messages, int(i % messages))) << i;
        }
    }
}

TEST(all_to_all, brings_every_rank_what_is_for_it)
{
    kith::mpi::communicator comm(MPI_COMM_WORLD, 10);
    const auto message = [](int from, int to) { // of many lengths, some of them zero
        std::vector<std::uint32_t> result(std::size_t(from * 3 + to * 5) % 7);
        std::iota(result.begin(), result.end(), std::uint32_t(100 * from + to));
        return result;
    };
    std::vector<std::vector<std::uint32_t>> to;
    for (int rank = 0; rank < comm.size(); ++rank)
        to.push_back(message(comm.rank(), rank));
    const auto came = kith::mpi::all_to_all(comm, to);
    ASSERT_EQ(came.size(), std::size_t(comm.size()));
    for (int rank = 0; rank < comm.size(); ++rank)
        EXPECT_EQ(came[std::size_t(rank)], message(rank, comm.rank())) << "from rank " << rank;
}

TEST(collective_phase, tells_all_ranks_of_the_lowest_problem)
{
    const int last = world().size() - 1;
    try {
        kith::mpi::collective_phase(world(), [&] {
            if (world().rank() == last or world().rank() == last - 1)
                throw std::runtime_error("trouble on " + std::to_string(world().rank()));
        });
        ADD_FAILURE() << "nothing was said";
    } catch (const kith::mpi::phase_error& error) {
        EXPECT_EQ(error.rank, std::max(0, last - 1));
        EXPECT_EQ(std::string(error.what()), "trouble on " + std::to_string(error.rank));
    }
}

TEST(problem_of, is_a_text_unless_the_others_cannot_be_reached)
{
    using kith::mpi::problem_of;
    EXPECT_EQ(problem_of([] {}), "");
    EXPECT_EQ(problem_of([] { throw std::runtime_error("trouble"); }), "trouble");
    EXPECT_EQ(problem_of([] { throw std::runtime_error(""); }), "an exception without a text");
    EXPECT_EQ(problem_of([] { throw std::bad_alloc(); }), "there is not enough memory");
    EXPECT_EQ(problem_of([] { throw std::bad_alloc(); }, "no room"), "no room");
    EXPECT_THROW(problem_of([] { throw kith::mpi::error("no partner"); }), kith::mpi::error);
}
