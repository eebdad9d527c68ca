// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Replaces the global operator new, and aligned_alloc, which provides large blocks. Include it in one file of a
// program.

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

/// Functions that let allocations fail on purpose, in all threads.
namespace failing_allocations {

inline std::atomic<long> counted{0}, first_to_fail{-1};
inline std::atomic<bool> counts{false}, fails_forever{false}, has_failed{false};

/// Counts one allocation and returns true if it is to fail.
inline bool fails()
{
    if (not counts)
        return false;
    const long n = counted++, first = first_to_fail;
    const bool result = first >= 0 and (n == first or (n > first and fails_forever));
    has_failed = has_failed or result;
    return result;
}

/// Starts counting allocations from 0. Allocation n fails, and all later ones if `forever`; if n < 0, none fails.
inline void fail_at(long n, bool forever = false)
{
    first_to_fail = n;
    fails_forever = forever;
    has_failed = false;
    counted = 0;
    counts = true;
}
/// Stops counting and failing. Returns the number of allocations since fail_at().
inline long stop()
{
    counts = false;
    return counted;
}

/// The outcome of one call under failing allocations.
struct trial {
    long allocation;   ///< number of the allocation that was to fail
    bool forever;      ///< true if all later allocations failed, too
    bool has_thrown;   ///< true if std::bad_alloc was thrown
    std::string other; ///< text of another exception; tests expect it to be empty
    bool has_failed;   ///< true if an allocation failed; if not, later trials would change nothing

    /// Returns a description of the trial, for SCOPED_TRACE.
    [[nodiscard]] std::string text() const
    {
        return "allocation " + std::to_string(allocation) + (forever ? " and all later ones fail" : " fails");
    }
};

/// Lets every allocation of run() fail: first each one alone, then each one and all later ones. Calls prepare() before
/// each trial and check(trial) after it; in these, no allocation fails. Tries every `step`-th allocation.
template <class Prepare, class Run, class Check>
void try_all(const Prepare& prepare, const Run& run, const Check& check, long step = 1)
{
    prepare();
    run(); // makes the allocations that happen once per process
    for (const bool forever : {false, true}) {
        bool has_failed = true;
        for (long n = 0; has_failed; n += step) {
            prepare();
            trial result{n, forever, false, {}, false};
            fail_at(n, forever);
            try {
                run();
                stop();
            } catch (const std::bad_alloc&) {
                stop();
                result.has_thrown = true;
            } catch (const std::exception& e) {
                stop();
                result.other = e.what();
            }
            has_failed = result.has_failed = failing_allocations::has_failed;
            check(result);
        }
    }
}

} // namespace failing_allocations

// NOLINTBEGIN(misc-definitions-in-headers): only one file of a program includes this header
extern "C" void* aligned_alloc(std::size_t alignment, std::size_t bytes) noexcept
{
    void* result = nullptr; // the sanitizers know posix_memalign, too
    return failing_allocations::fails() or posix_memalign(&result, alignment, bytes) != 0 ? nullptr : result;
}
void* operator new(std::size_t bytes)
{
    void* const result = failing_allocations::fails() ? nullptr : std::malloc(bytes == 0 ? 1 : bytes);
    if (result == nullptr)
        throw std::bad_alloc();
    return result;
}
void* operator new[](std::size_t bytes)
{
    return operator new(bytes);
}
void* operator new(std::size_t bytes, std::align_val_t alignment)
{
    void* const result = aligned_alloc(std::size_t(alignment), bytes);
    if (result == nullptr)
        throw std::bad_alloc();
    return result;
}
void* operator new[](std::size_t bytes, std::align_val_t alignment)
{
    return operator new(bytes, alignment);
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept
{
    return failing_allocations::fails() ? nullptr : std::malloc(bytes == 0 ? 1 : bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t& tag) noexcept
{
    return operator new(bytes, tag);
}
void operator delete(void* p) noexcept
{
    std::free(p);
}
void operator delete[](void* p) noexcept
{
    std::free(p);
}
void operator delete(void* p, std::size_t) noexcept
{
    std::free(p);
}
void operator delete[](void* p, std::size_t) noexcept
{
    std::free(p);
}
void operator delete(void* p, std::align_val_t) noexcept
{
    std::free(p);
}
void operator delete[](void* p, std::align_val_t) noexcept
{
    std::free(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept
{
    std::free(p);
}
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept
{
    std::free(p);
}
// NOLINTEND(misc-definitions-in-headers)
