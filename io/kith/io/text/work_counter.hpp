// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace kith::io {

/// A counter of the bytes or elements of a file that have been read or written, for programs that show progress. Any
/// thread may read the counts. If several files are read or written at once, the counts are those of any of them.
struct work_counter {
    std::atomic<std::uint64_t> done = 0, all = 0;

    /// Begins a file with this amount of work.
    void begin(std::uint64_t work)
    {
        done.store(0, std::memory_order_relaxed);
        all.store(work, std::memory_order_relaxed);
    }
    void set(std::uint64_t work) { done.store(work, std::memory_order_relaxed); }
    void add(std::uint64_t work) { done.fetch_add(work, std::memory_order_relaxed); }
    /// Returns the share that is done, 0 to 1.
    [[nodiscard]] double share() const
    {
        const auto whole = double(all.load(std::memory_order_relaxed));
        const auto part = double(done.load(std::memory_order_relaxed));
        return whole == 0 ? 0 : part < whole ? part / whole : 1;
    }
};

/// The counter of this process.
inline constinit work_counter file_work;

} // namespace kith::io
