// SPDX-License-Identifier: BSD-3-Clause
// Runs the same tests on all ranks of a job. Rank 0 prints the results, and failures on any other rank, too.
#include "on_ranks.hpp"

#include <iostream>
#include <sstream>
#include <string>

namespace {

kith::mpi::communicator* all_ranks = nullptr;

class failures_of_ranks : public testing::EmptyTestEventListener {
public:
    void OnTestStart(const testing::TestInfo& test) override // NOLINT(readability-identifier-naming)
    {
        test_ = test.name();
    }
    void OnTestPartResult(const testing::TestPartResult& result) override // NOLINT(readability-identifier-naming)
    {
        if (result.failed())
            text_ << test_ << " on rank " << world().rank() << ", " << result.file_name() << ':' << result.line_number()
                  << '\n'
                  << result.message() << '\n';
    }
    [[nodiscard]] std::string text() const { return text_.str(); }

private:
    std::string test_;
    std::ostringstream text_;
};

} // namespace

kith::mpi::communicator& world()
{
    return *all_ranks;
}

int main(int count, char** words)
{
    kith::mpi::session session(count, words);
    kith::mpi::communicator comm(MPI_COMM_WORLD);
    all_ranks = &comm;
    testing::InitGoogleTest(&count, words);
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    failures_of_ranks failures; // of the ranks that do not print
    if (not comm.is_root()) {
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(&failures);
    }
    const bool failed = RUN_ALL_TESTS() != 0;
    if (comm.is_root()) {
        for (int rank = 1; rank < comm.size(); ++rank) {
            int from = rank;
            const auto text = comm.receive(from);
            std::cout.write(reinterpret_cast<const char*>(text.data()), std::streamsize(text.size()));
        }
    } else {
        const std::string text = failures.text();
        comm.send(std::as_bytes(std::span(text)), 0);
        listeners.Release(&failures);
    }
    return comm.sum(std::array{std::uint64_t(failed)})[0] == 0 ? 0 : 1;
}
