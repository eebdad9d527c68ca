// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/for_parts.hpp>

#include <cstddef>

#if defined(_OPENMP)
#include <omp.h>
#endif

/// A guard that sets the number of threads while it is alive, also for loops over a few thousand faces. Without OpenMP
/// there is always one thread.
class thread_count {
public:
    explicit thread_count([[maybe_unused]] int count)
    {
#if defined(_OPENMP)
        omp_set_num_threads(count);
#endif
    }
    thread_count(const thread_count&) = delete;
    thread_count& operator=(const thread_count&) = delete;
    ~thread_count()
    {
        kith::detail::faces_worth_threads = worth_before_;
#if defined(_OPENMP)
        omp_set_num_threads(before_);
#endif
    }

private:
    std::size_t worth_before_ = kith::detail::faces_worth_threads.exchange(1024);
#if defined(_OPENMP)
    int before_ = omp_get_max_threads();
#endif
};
