// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>

/// As many numbers as a register of the processor holds, added and scaled side by side: each lane is what one number
/// would be, to the bit. Vectors are those of g++ and clang. Every processor has registers of 16 bytes; on x86-64 most
/// have wider ones, which functions marked KITH_LANES_OF_32_BYTES and KITH_LANES_OF_64_BYTES use: lane_bytes() looks.

namespace kith {

/// Values that are numbers, or arrays of a few numbers, which fit into lanes where there are any.
template <class Value>
inline constexpr bool fits_lanes = false;
/// The count of numbers that such a value has.
template <class Value>
inline constexpr std::size_t lane_numbers = 1;
template <class Scalar, std::size_t N>
inline constexpr std::size_t lane_numbers<std::array<Scalar, N>> = N;
/// Returns the first of its numbers.
template <class Scalar>
auto* first_number(Scalar& value)
{
    if constexpr (requires { value.data(); })
        return value.data();
    else
        return &value;
}

} // namespace kith

// Patches, which use lanes, take about as long to compile as all else of a refinement. So headers alone leave them out,
// and a deep refinement takes two to four times as long; kith::compiled_schemes has them. A program from headers alone
// defines KITH_PATCHES in all of its files to have them.
#if defined(__GNUC__) and (defined(KITH_COMPILED_SCHEMES) or defined(KITH_PATCHES))
#define KITH_HAS_LANES 1
// Aligned, so that their loops are as fast in every program.
#if defined(__x86_64__)
// prfchw needs no check at run time: a processor without it ignores the instruction.
#define KITH_LANES_OF_16_BYTES [[gnu::target("prfchw"), gnu::noinline, gnu::aligned(64)]]
#define KITH_LANES_OF_32_BYTES [[gnu::target("avx2,prfchw"), gnu::noinline, gnu::aligned(64)]]
#define KITH_LANES_OF_64_BYTES [[gnu::target("avx512f,avx512vl,prfchw"), gnu::noinline, gnu::aligned(64)]]
#else
#define KITH_LANES_OF_16_BYTES [[gnu::noinline, gnu::aligned(64)]]
#endif

namespace kith {

template <std::floating_point Scalar, std::size_t N>
    requires(N > 0 and N <= 4 and sizeof(Scalar) <= sizeof(double))
inline constexpr bool fits_lanes<std::array<Scalar, N>> = true;
template <std::floating_point Scalar>
    requires(sizeof(Scalar) <= sizeof(double))
inline constexpr bool fits_lanes<Scalar> = true;

/// The bytes of the widest registers that this processor can use at its usual clock: the first ones that had 64 slow
/// down for them; VBMI2 came with those that do not. Cost: that of a look.
inline std::size_t lane_bytes()
{
#if defined(__x86_64__)
    static const bool has_64 = __builtin_cpu_supports("avx512f") and __builtin_cpu_supports("avx512vl") and
                               __builtin_cpu_supports("avx512vbmi2");
    static const bool has_32 = __builtin_cpu_supports("avx2");
    return has_64 ? 64 : has_32 ? 32 : 16;
#else
    return 16;
#endif
}
/// No registers have more.
inline constexpr std::size_t most_lane_bytes = 64;

template <class Scalar, std::size_t Bytes>
struct lanes {
    static constexpr std::size_t count = Bytes / sizeof(Scalar);
    typedef Scalar type __attribute__((vector_size(Bytes), may_alias));
};

/// Keeps the compiler from making a product and the sum that follows one operation, which would round once; clang does
/// so within one expression only.
template <class Pack>
[[gnu::always_inline]] inline void keep_rounded([[maybe_unused]] Pack& product)
{
#if defined(__x86_64__) && !defined(__clang__)
    __asm__("" : "+x"(product));
#elif defined(__aarch64__) && !defined(__clang__)
    __asm__("" : "+w"(product));
#endif
}

/// Writes to memory without fetching what was there, where the processor can: for what is not read again soon. Other
/// threads see it after `publish`.
template <class T>
[[gnu::always_inline]] inline void store_past_caches(T* to, T value)
{
#if defined(__clang__)
    __builtin_nontemporal_store(value, to);
#elif defined(__x86_64__)
    if constexpr (sizeof(T) == 16)
        __builtin_ia32_movntdq(reinterpret_cast<long long __attribute__((vector_size(16)))*>(to),
                               reinterpret_cast<long long __attribute__((vector_size(16)))>(value));
    else if constexpr (sizeof(T) == 8)
        __builtin_ia32_movnti64(reinterpret_cast<long long*>(to), std::bit_cast<long long>(value));
    else if constexpr (sizeof(T) == 4)
        __builtin_ia32_movnti(reinterpret_cast<int*>(to), std::bit_cast<int>(value));
    else
        *to = value;
#else
    *to = value;
#endif
}
[[gnu::always_inline]] inline void publish()
{
#if defined(__x86_64__)
    __builtin_ia32_sfence();
#endif
}

} // namespace kith

#endif
