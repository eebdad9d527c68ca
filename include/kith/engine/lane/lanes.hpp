// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>

/// Lanes: the numbers that a register of the processor holds, which are added and scaled side by side. The result in
/// each lane has the bits of the same operations on a single number. Vectors are those of g++ and clang. Every
/// processor has registers of 16 bytes, and most x86-64 processors have wider ones. Functions marked
/// KITH_LANES_OF_32_BYTES and KITH_LANES_OF_64_BYTES use these; lane_bytes() tells how wide they are.

namespace kith {

/// True for values that fit into lanes, if there are lanes: numbers, and arrays of a few numbers.
template <class Value>
inline constexpr bool fits_lanes = false;
/// The count of numbers in a value.
template <class Value>
inline constexpr std::size_t lane_numbers = 1;
template <class Scalar, std::size_t N>
inline constexpr std::size_t lane_numbers<std::array<Scalar, N>> = N;
/// Returns a pointer to the first number of a value.
template <class Scalar>
auto* first_number(Scalar& value)
{
    if constexpr (requires { value.data(); })
        return value.data();
    else
        return &value;
}

} // namespace kith

// Patches, which use lanes, take about as long to compile as the rest of a refinement. Headers alone leave them out,
// and a deep refinement then takes two to four times as long. The library kith::compiled_schemes has them. A
// header-only program gets them by defining KITH_PATCHES in all of its files.
#if defined(__GNUC__) and (defined(KITH_COMPILED_SCHEMES) or defined(KITH_PATCHES))
#define KITH_HAS_LANES 1
// Aligned, so that their loops are equally fast in every program.
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

/// Returns the size in bytes of the widest registers that this processor can use at its usual clock. The first
/// processors with 64 bytes slow down for these; processors that do not slow down also have VBMI2. Cost: that of a
/// look.
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
/// The size in bytes of the widest registers of any processor.
inline constexpr std::size_t most_lane_bytes = 64;

template <class Scalar, std::size_t Bytes>
struct lanes {
    static constexpr std::size_t count = Bytes / sizeof(Scalar);
    typedef Scalar type __attribute__((vector_size(Bytes), may_alias));
};

/// Keeps the compiler from fusing a product with the sum that follows, which would round only once. clang fuses only
/// within one expression.
template <class Pack>
[[gnu::always_inline]] inline void keep_rounded([[maybe_unused]] Pack& product)
{
#if defined(__x86_64__) && !defined(__clang__)
    __asm__("" : "+x"(product));
#elif defined(__aarch64__) && !defined(__clang__)
    __asm__("" : "+w"(product));
#endif
}

/// Writes a value without first fetching what was in memory, where the processor can. It suits values that are not read
/// again soon. Other threads see the value after `publish`.
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
