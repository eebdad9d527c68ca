// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <exception>
#include <limits>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace kith::detail {

/// Whether this thread runs the body of a loop whose order is not promised, on several threads or on one.
constinit inline thread_local bool in_loop_body = false;

/// Says so, or the opposite, while it lives.
class loop_body {
public:
    explicit loop_body(bool inside) : before_(in_loop_body) { in_loop_body = inside; }
    loop_body(const loop_body&) = delete;
    loop_body& operator=(const loop_body&) = delete;
    ~loop_body() { in_loop_body = before_; }

private:
    bool before_;
};

/// From so many elements on a loop is worth more than one thread.
inline constexpr std::size_t worth_threads = 4096;

/// A body(begin, end) of a loop, called through a pointer: the threads are compiled once for all bodies. Refers to the
/// body.
class part_body {
public:
    template <class Body>
    part_body(const Body& body)
        : body_(&body)
        , call_([](const void* of, std::size_t begin, std::size_t end) { (*static_cast<const Body*>(of))(begin, end); })
    {
    }
    void operator()(std::size_t begin, std::size_t end) const { call_(body_, begin, end); }

private:
    const void* body_;
    void (*call_)(const void*, std::size_t, std::size_t);
};

// A program may have files with OpenMP and files without.
#if defined(_OPENMP)
inline namespace on_threads {
#else
inline namespace in_turn {
#endif

/// Calls body(begin, end) on parts of [0, size), on the threads of OpenMP where a program is compiled with it. Every
/// value of a level is a gather into its own place, so how the range is cut changes no bit. Of several errors that of
/// the first part is rethrown.
inline void for_parts(std::size_t size, [[maybe_unused]] bool parallel, part_body body,
                      [[maybe_unused]] std::size_t smallest = worth_threads)
{
#if defined(_OPENMP)
    if (parallel and size >= smallest and omp_get_max_threads() > 1) {
        std::exception_ptr error;
        std::size_t part_of_error = std::numeric_limits<std::size_t>::max();
#pragma omp parallel
        {
            const std::size_t threads = std::size_t(omp_get_num_threads());
            const std::size_t thread = std::size_t(omp_get_thread_num());
            try {
                body(size * thread / threads, size * (thread + 1) / threads);
            } catch (...) {
#pragma omp critical(kith_for_parts)
                if (thread < part_of_error) {
                    part_of_error = thread;
                    error = std::current_exception();
                }
            }
        }
        if (error)
            std::rethrow_exception(error);
        return;
    }
#endif
    body(std::size_t(0), size);
}

} // namespace

} // namespace kith::detail
