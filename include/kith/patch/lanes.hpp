// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

/// As many numbers as a register of the processor holds, added and scaled side by side: each lane is what one number would
/// be, to the bit. Vectors are those of g++ and clang. On x86-64 functions marked KITH_LANES use registers that most, not all
/// processors have; has_lanes() looks.

namespace kith {

/// Points that are arrays of numbers, which fit into lanes where there are any.
template <class Point>
inline constexpr bool fits_lanes = false;

} // namespace kith

#if defined(__GNUC__)
#define KITH_HAS_LANES 1
#if defined(__x86_64__)
#define KITH_LANES [[gnu::target("avx2,prfchw"), gnu::noinline]]
#else
#define KITH_LANES
#endif

namespace kith {

template <std::floating_point Scalar, std::size_t N>
    requires(N > 0 and N <= 4)
inline constexpr bool fits_lanes<std::array<Scalar, N>> = true;

#if defined(__x86_64__)
inline constexpr std::size_t lane_bytes = 32;

/// Whether this processor can run what is marked KITH_LANES. Cost: that of a look.
inline bool has_lanes()
{
    static const bool has = __builtin_cpu_supports("avx2");
    return has;
}
#else
inline constexpr std::size_t lane_bytes = 16;

inline bool has_lanes()
{
    return true;
}
#endif

template <class Scalar>
struct lanes {
    static constexpr std::size_t count = lane_bytes / sizeof(Scalar);
    typedef Scalar type __attribute__((vector_size(lane_bytes), may_alias));
};

/// Keeps the compiler from making a product and the sum that follows one operation, which would round once; clang does so
/// within one expression only.
template <class Pack>
[[gnu::always_inline]] inline void keep_rounded([[maybe_unused]] Pack& product)
{
#if defined(__x86_64__) && !defined(__clang__)
    __asm__("" : "+x"(product));
#elif defined(__aarch64__) && !defined(__clang__)
    __asm__("" : "+w"(product));
#endif
}

} // namespace kith

#else

namespace kith {

inline bool has_lanes()
{
    return false;
}

} // namespace kith

#endif
