// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace kith::comparison {

/// Returns the seconds that a call takes.
template <class F>
double seconds(const F& f)
{
    const auto begin = std::chrono::steady_clock::now();
    f();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Returns the median over several runs of one of their times. Precondition: there is at least one run.
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
