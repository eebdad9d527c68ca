// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/tiles/part/tile.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace kith {

/// A run of consecutive elements with equal counts of something, such as corners: the first element, the sum of the
/// counts before it, and the count of each element.
struct equal_run {
    global_id first, before, each;
};

/// The prefix sums of a count per element, such as the corners of faces, stored as runs of elements with equal counts.
/// A mesh of quads has one run. The last run has no end.
class prefix_sums {
public:
    prefix_sums() = default;
    /// Takes runs of all elements, in any order. Cost: O(runs log runs).
    explicit prefix_sums(std::vector<equal_run> runs) : runs_(std::move(runs))
    {
        std::ranges::sort(runs_, {}, &equal_run::first);
        const auto end = std::ranges::unique(runs_, {}, &equal_run::each).begin(); // runs of equal counts are joined
        runs_.erase(end, runs_.end());
    }

    [[nodiscard]] bool empty() const { return runs_.empty(); }
    [[nodiscard]] const std::vector<equal_run>& runs() const { return runs_; }

    /// Returns the sum of the counts of the elements before an element. Precondition: not empty(). Cost: O(log runs).
    [[nodiscard]] global_id before(global_id element) const
    {
        const auto& run = *(std::ranges::upper_bound(runs_, element, {}, &equal_run::first) - 1);
        return run.before + (element - run.first) * run.each;
    }
    /// Returns the element that has the n-th of the counted items. It is the inverse of `before`. Preconditions: there
    /// are more than n items, and element 0 is in a run. Cost: O(log runs).
    [[nodiscard]] global_id holder(global_id n) const
    {
        const auto& run = *(std::ranges::upper_bound(runs_, n, {}, &equal_run::before) - 1);
        return run.first + (n - run.before) / run.each;
    }

private:
    std::vector<equal_run> runs_;
};

/// The runs of elements that are added in the order of their numbers; some may be left out.
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
