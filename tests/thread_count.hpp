// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(_OPENMP)
#include <omp.h>
#endif

/// So many threads while it lives; without OpenMP there is always one.
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
#if defined(_OPENMP)
        omp_set_num_threads(before_);
#endif
    }

private:
#if defined(_OPENMP)
    int before_ = omp_get_max_threads();
#endif
};
