// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/for_parts.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace kith {

/// Returns how many of `tiles` tiles to refine at the same time: one on each OpenMP thread, at most `most`. If there
/// are fewer tiles than threads, the result is 1, and all threads run in the loops of one tile. Loops of tiles are
/// short, so threads that synchronize after each of them lose more than they gain. The result is also the number of
/// tiles in memory.
inline std::size_t tiles_at_once(std::size_t tiles, std::size_t most = SIZE_MAX)
{
    const std::size_t threads = std::min(most, detail::most_threads());
    return tiles < threads ? 1 : std::max<std::size_t>(threads, 1);
}

/// Calls f(i) for all i below `size`, up to `at_once` at the same time, each on one thread that runs all loops in it
/// alone. The order is unspecified. After an error no more calls begin, and the first error is rethrown. If `at_once`
/// is at most 1, the calls follow one another with all threads in their loops.
template <class F>
void for_each_at_once(std::size_t size, std::size_t at_once, const F& f)
{
    if (at_once <= 1) { // all threads run in the loops of f
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
