// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/tiles/part/tile.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace kith {

/// Elements that follow one another and have equally much of something: the first, how much those before it have in
/// sum, and how much each of them has.
struct equal_run {
    global_id first, before, each;
};

/// How much of something the elements before an element have in sum, such as corners of faces, kept as runs of elements
/// that have equally much: one run where all faces are quads. The last run goes on for ever.
class prefix_sums {
public:
    prefix_sums() = default;
    /// From runs of all elements, in any order. Cost: O(runs log runs).
    explicit prefix_sums(std::vector<equal_run> runs) : runs_(std::move(runs))
    {
        std::ranges::sort(runs_, {}, &equal_run::first);
        const auto end = std::ranges::unique(runs_, {}, &equal_run::each).begin(); // what follows is the same run
        runs_.erase(end, runs_.end());
    }

    [[nodiscard]] bool empty() const { return runs_.empty(); }
    [[nodiscard]] const std::vector<equal_run>& runs() const { return runs_; }

    /// Precondition: not empty(). Cost: O(log runs).
    [[nodiscard]] global_id before(global_id element) const
    {
        const auto& run = *(std::ranges::upper_bound(runs_, element, {}, &equal_run::first) - 1);
        return run.before + (element - run.first) * run.each;
    }
    /// The inverse: the element that has the n-th of what is counted. Preconditions: there are so many, and element 0
    /// is in a run. Cost: O(log runs).
    [[nodiscard]] global_id holder(global_id n) const
    {
        const auto& run = *(std::ranges::upper_bound(runs_, n, {}, &equal_run::before) - 1);
        return run.first + (n - run.before) / run.each;
    }

private:
    std::vector<equal_run> runs_;
};

/// Runs that are made element by element, in the order of their numbers; some may be left out.
class run_builder {
public:
    void add(global_id element, global_id before, global_id each)
    {
        if (runs_.empty() or element != next_ or each != runs_.back().each)
            runs_.push_back({element, before, each});
        next_ = element + 1;
    }
    [[nodiscard]] std::vector<equal_run> take() { return std::move(runs_); }

private:
    std::vector<equal_run> runs_;
    global_id next_ = 0;
};

} // namespace kith
