// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace kith::detail {

/// From so many elements on a loop is worth more than one thread.
inline constexpr std::size_t worth_threads = 4096;

/// Calls body(begin, end) on parts of [0, size), on the threads of OpenMP where a program is compiled with it. Every
/// value of a level is a gather into its own place, so how the range is cut changes no bit. The first error is rethrown.
template <class Body>
void for_parts(std::size_t size, [[maybe_unused]] bool parallel, const Body& body,
               [[maybe_unused]] std::size_t smallest = worth_threads)
{
#if defined(_OPENMP)
    if (parallel and size >= smallest and omp_get_max_threads() > 1) {
        std::exception_ptr error;
        std::atomic_flag failed = ATOMIC_FLAG_INIT;
#pragma omp parallel
        {
            const std::size_t threads = std::size_t(omp_get_num_threads());
            const std::size_t thread = std::size_t(omp_get_thread_num());
            try {
                body(size * thread / threads, size * (thread + 1) / threads);
            } catch (...) {
                if (not failed.test_and_set())
                    error = std::current_exception();
            }
        }
        if (error)
            std::rethrow_exception(error);
        return;
    }
#endif
    body(std::size_t(0), size);
}

} // namespace kith::detail
