// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/for_parts.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace kith {

/// How many of so many tiles to refine at the same time: one on each thread of OpenMP or, where there are fewer tiles
/// than threads, one after the other with all threads in its loops. Loops of tiles are short, and threads that meet
/// after each of them lose more than they gain. So many tiles are then in memory, `most` of them at most.
inline std::size_t tiles_at_once(std::size_t tiles, std::size_t most = SIZE_MAX)
{
    const std::size_t threads = std::min(most, detail::most_threads());
    return tiles < threads ? 1 : std::max<std::size_t>(threads, 1);
}

/// Calls f(i) for the numbers below `size`, `at_once` of them at the same time, each on a thread of its own, which then
/// runs all loops in it. In no order; after an error no more are begun, and the first one is rethrown.
template <class F>
void for_each_at_once(std::size_t size, std::size_t at_once, const F& f)
{
    if (at_once <= 1) { // with all threads in its loops
        for (std::size_t i = 0; i < size; ++i)
            f(i);
        return;
    }
    std::atomic<std::size_t> next = 0;
    const auto work = [&](std::size_t begin, std::size_t end) {
        try {
            for (; begin < end; ++begin)
                for (std::size_t i = next++; i < size; i = next++)
                    f(i);
        } catch (...) {
            next = size;
            throw;
        }
    };
    detail::for_parts(at_once, true, work, 1);
}

} // namespace kith
