// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace kith::comparison {

/// The timed work of a contestant: it refines. Its result is freed after the clock has stopped.
using work = std::function<std::shared_ptr<const void>()>;

struct measurement {
    double seconds;
    double seconds_again;     ///< for the same work once more in the same process, after the first result is freed
    double processor_seconds; ///< less than `seconds` if the machine was busy otherwise
    std::uint64_t bytes;      ///< the peak growth of the process since the clock started
};

/// A program or mesh type that takes part in a contest.
struct contestant {
    std::string name;
    std::function<work()> prepare; ///< makes the control mesh, untimed
    std::vector<measurement> runs;
    int threads = 0; ///< 0: the number of --threads, or 1
};

/// A refinement that several contestants do. The first contestant is the peer that the others are compared with.
struct contest {
    std::string scheme;
    std::string mesh;
    int levels;
    std::uint64_t faces; ///< on the last level
    std::vector<contestant> contestants;
};

/// Runs the contestants in turn, a b c a b c ..., each run in a process of its own. So no contestant finds memory that
/// another one has touched, and each has its own memory peak. Errors: std::runtime_error if a run fails.
void run(contest& contest, int repeats);

/// Returns the median of a value over the runs, or the mean of the two middle values.
double median(const std::vector<measurement>& runs, const std::function<double(const measurement&)>& value);

} // namespace kith::comparison
