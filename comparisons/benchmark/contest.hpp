// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace kith::comparison {

/// Refines, and is timed. What it returns is freed after the clock has stopped.
using work = std::function<std::shared_ptr<const void>()>;

struct measurement {
    double seconds;
    double seconds_again;     ///< of the same work once more in the same process, when all of the first is gone
    double processor_seconds; ///< less than the seconds where the machine had other things to do
    std::uint64_t bytes;      ///< that the process grew by at most, beyond what it had when the clock started
};

/// One of those that do the same work.
struct contestant {
    std::string name;
    std::function<work()> prepare; ///< makes the control mesh, untimed
    std::vector<measurement> runs;
    int threads = 0; ///< 0: as many as all others
};

/// The same refinement done by several; the first one is the peer that the others are compared with.
struct contest {
    std::string scheme;
    std::string mesh;
    int levels;
    std::uint64_t faces; ///< of the last level
    std::vector<contestant> contestants;
};

/// Lets the contestants run in turn, a b c a b c ..., each run in a process of its own: none finds memory that another
/// one has touched, and the peak of its memory is its own. Errors: std::runtime_error when a run fails.
void run(contest& contest, int repeats, int threads);

/// The middle one of the runs' values, or the mean of the two in the middle.
double median(const std::vector<measurement>& runs, const std::function<double(const measurement&)>& value);

} // namespace kith::comparison
