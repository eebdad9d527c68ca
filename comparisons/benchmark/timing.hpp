// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace kith::comparison {

/// Returns how many seconds a call takes.
template <class F>
double seconds(const F& f)
{
    const auto begin = std::chrono::steady_clock::now();
    f();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Returns the median of one of the times of several runs. Precondition: there is a run.
template <class Times>
double median(const std::vector<Times>& all, double Times::* which)
{
    std::vector<double> values;
    for (const Times& one : all)
        values.push_back(one.*which);
    std::ranges::sort(values);
    return values[values.size() / 2];
}

} // namespace kith::comparison
