// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "in_library.hpp"
#include "platform.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace kith {

namespace detail {

/// The most threads of a loop, for all files of the program; 0 if neither `set_threads` nor a file with OpenMP set it.
constinit inline std::atomic<int> thread_limit = 0;

/// The number of faces below which one thread makes a level: on a busy machine threads wait longer for each other than
/// they work. Tests set a smaller number.
constinit inline std::atomic<std::size_t> faces_worth_threads = 10'000;

} // namespace detail

/// Sets the most threads that a loop of kith uses; 1 switches them off, 0 allows as many as OpenMP has. In a program
/// compiled with OpenMP the limit is 0 at first. In others it is 1, so that the compiled parts of kith, which use
/// OpenMP, start no threads unasked. The results are the same bits. May be called at any time outside of kith's
/// functions. OMP_NUM_THREADS and omp_set_num_threads hold in addition.
inline void set_threads(int most)
{
    detail::thread_limit = most > 0 ? most : std::numeric_limits<int>::max();
}

namespace detail {

/// Returns true if a loop over the elements of a level with `faces` faces is worth more than one thread.
inline bool is_worth_threads(std::size_t faces)
{
    return faces >= faces_worth_threads.load(std::memory_order_relaxed);
}
/// Returns the number of elements from which on a loop with little work per element is worth more than one thread: the
/// corners of `faces_worth_threads` quads.
inline std::size_t elements_worth_threads()
{
    return 4 * faces_worth_threads.load(std::memory_order_relaxed);
}

/// The flag of a thread: true while it runs the body of a loop without a promised order, on several threads or on one.
constinit inline thread_local bool in_loop_body = false;

/// A guard that sets `in_loop_body` and restores its earlier value at the end of its lifetime.
class loop_body {
public:
    explicit loop_body(bool inside) : before_(in_loop_body) { in_loop_body = inside; }
    loop_body(const loop_body&) = delete;
    loop_body& operator=(const loop_body&) = delete;
    ~loop_body() { in_loop_body = before_; }

private:
    bool before_;
};

/// A reference to the body(begin, end) of a loop, called through a pointer: the code for threads is compiled once for
/// all bodies.
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

/// The numbers of the parts of a loop, shared by several threads. All threads begin with ranges of equal size. The data
/// of a range lie together, so that threads rarely wait for each other's cache lines. A thread without work takes the
/// second half of the largest range that is left (work stealing: Blumofe & Leiserson 1999).
class shared_parts {
public:
    /// Divides the parts among the threads. Precondition: fewer than 2^32 parts. Cost: O(threads).
    shared_parts(std::size_t parts, std::size_t threads) : left_(threads)
    {
        for (std::size_t thread = 0; thread < threads; ++thread)
            left_[thread].range = range(parts * thread / threads, parts * (thread + 1) / threads);
    }

    /// Returns a part that no thread has taken yet and that lies before all errors, the next in this thread's range
    /// first; nothing if none is left.
    std::optional<std::size_t> take(std::size_t thread)
    {
        std::atomic<std::uint64_t>& own = left_[thread].range;
        do
            for (std::uint64_t now = own; begin_of(now) < end_of(now);)
                if (own.compare_exchange_weak(now, range(begin_of(now) + 1, end_of(now)))) {
                    if (begin_of(now) < part_of_error_)
                        return begin_of(now);
                    now = own;
                }
        while (take_from_others(own));
        return {};
    }

    /// Keeps the error of a part unless an earlier part has one. All parts before it are still done, so in the end it
    /// is the error that a single thread would meet.
    void keep_error(std::size_t part, std::exception_ptr error)
    {
        const std::lock_guard lock(mutex_);
        if (part < part_of_error_) {
            part_of_error_ = part;
            error_ = std::move(error);
        }
    }
    /// Throws the error that was kept, if any. Precondition: all threads are done.
    void rethrow_error() const
    {
        if (error_)
            std::rethrow_exception(error_);
    }

private:
    /// Returns the number of the first part and of the one behind the last, packed in one value.
    static std::uint64_t range(std::size_t begin, std::size_t end) { return begin | std::uint64_t(end) << 32; }
    static std::size_t begin_of(std::uint64_t range) { return std::uint32_t(range); }
    static std::size_t end_of(std::uint64_t range) { return range >> 32; }

    /// Takes half of the range of another thread. Returns true if any thread had work left.
    bool take_from_others(std::atomic<std::uint64_t>& own)
    {
        for (;;) {
            std::size_t most = 0;
            std::uint64_t of_most = 0;
            std::atomic<std::uint64_t>* who = nullptr;
            for (auto& [other] : left_)
                if (const std::uint64_t now = other; end_of(now) - begin_of(now) > most) {
                    most = end_of(now) - begin_of(now);
                    of_most = now;
                    who = &other;
                }
            if (who == nullptr)
                return false;
            const std::size_t middle = begin_of(of_most) + most / 2;
            if (who->compare_exchange_weak(of_most, range(begin_of(of_most), middle))) {
                own = range(middle, end_of(of_most));
                return true;
            }
        }
    }

    struct alignas(64) alone_in_line {
        std::atomic<std::uint64_t> range = 0;
    };

    std::vector<alone_in_line> left_; // of each thread
    mutex mutex_;
    std::exception_ptr error_;
    std::atomic<std::size_t> part_of_error_ = std::numeric_limits<std::size_t>::max();
};

/// The parts of a range that one thread does: all of them, or those that it takes from shared ones.
class parts_to_do {
public:
    /// Takes all parts of [0, size).
    parts_to_do(std::size_t size, std::size_t size_of_part) : size_(size), size_of_part_(size_of_part) {}
    /// Takes the parts of [0, size) that `shared` gives to this thread.
    parts_to_do(std::size_t size, std::size_t size_of_part, shared_parts& shared, std::size_t thread)
        : size_(size), size_of_part_(size_of_part), shared_(&shared), thread_(thread)
    {
    }

    /// Calls body(begin, end) on each of the parts.
    template <class Body>
    void for_each(const Body& body)
    {
        for (std::optional<std::size_t> part; (part = next());)
            try {
                body(*part * size_of_part_, std::min((*part + 1) * size_of_part_, size_));
            } catch (...) {
                if (shared_ == nullptr)
                    throw;
                shared_->keep_error(*part, std::current_exception());
            }
    }

private:
    std::optional<std::size_t> next()
    {
        if (shared_ != nullptr)
            return shared_->take(thread_);
        return done_ * size_of_part_ < size_ ? std::optional(done_++) : std::nullopt;
    }

    std::size_t size_, size_of_part_;
    shared_parts* shared_ = nullptr;
    std::size_t thread_ = 0;
    std::size_t done_ = 0; // if the parts are not shared
};

// A program may contain files compiled with OpenMP and files compiled without.
#if defined(_OPENMP)
inline namespace on_threads {

#ifndef KITH_COMPILED_PART // one of kith's compiled parts, which is no reason for a program to have threads
/// Sets the limit of a program that is compiled with OpenMP, unless `set_threads` came first.
inline const bool has_threads = [] {
    int unset = 0;
    return thread_limit.compare_exchange_strong(unset, std::numeric_limits<int>::max());
}();
#endif

/// Returns the largest number of threads of a parallel loop.
inline std::size_t most_threads()
{
    return std::size_t(std::min(omp_get_max_threads(), std::max(thread_limit.load(std::memory_order_relaxed), 1)));
}
#else
inline namespace in_turn {

/// Returns one, since this file is not compiled with OpenMP.
inline std::size_t most_threads()
{
    return 1;
}
#endif

/// Calls body(begin, end) on parts of [0, size). It uses the threads of OpenMP if the program has them, `parallel` is
/// true and the loop has at least `smallest` elements. Each value of a level is computed on its own and has its own
/// place, so the division into parts changes no bit. If several parts throw, the error of the first one is rethrown.
inline void for_parts(std::size_t size, [[maybe_unused]] bool parallel, part_body body,
                      [[maybe_unused]] std::size_t smallest = elements_worth_threads())
{
#if defined(_OPENMP)
    if (parallel and size >= smallest and most_threads() > 1) {
        std::exception_ptr error;
        std::size_t part_of_error = std::numeric_limits<std::size_t>::max();
#pragma omp parallel num_threads(int(most_threads()))
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

/// Calls body(parts) once on each thread; the body does its parts of [0, size) by parts.for_each. It suits bodies that
/// keep data for all their parts, and elements of unequal cost. `parallel` says if the work is worth threads. If
/// several parts throw, the error of the first one is rethrown.
template <class Body>
void for_shared_parts(std::size_t size, std::size_t size_of_part, bool parallel, const Body& body)
{
    const std::size_t count = (size + size_of_part - 1) / size_of_part;
    const std::size_t threads = parallel and count > 1 ? std::min(count, most_threads()) : 1;
    if (threads == 1)
        return body(parts_to_do(size, size_of_part));
    shared_parts shared(count, threads);
    for_parts(
        threads,
        true,
        [&](std::size_t thread, std::size_t end) {
            if (thread != end)
                body(parts_to_do(size, size_of_part, shared, thread));
        },
        2);
    shared.rethrow_error();
}

} // namespace

} // namespace detail

} // namespace kith
