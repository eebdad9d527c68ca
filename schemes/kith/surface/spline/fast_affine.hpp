// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>

#include <array>
#include <concepts>
#include <cstddef>

namespace kith {

namespace detail {

/// The `affine` of T, for sums of many terms.
template <class T>
struct fast_affine : affine<T> {};
#if defined(__GNUC__)
/// Three coordinates in registers of the processor, with a fourth one that is not used.
template <std::floating_point Scalar>
    requires(sizeof(Scalar) <= sizeof(double))
struct fast_affine<std::array<Scalar, 3>> {
    using scalar = Scalar;
    struct sum {
        using part [[gnu::vector_size(16)]] = Scalar;
        static constexpr std::size_t size = 16 / sizeof(Scalar);

        part parts[4 / size]; // NOLINT: attributes of the type of an element of std::array are ignored
    };

    static sum load(const std::array<Scalar, 3>& value)
    {
        sum result{};
        for (std::size_t i = 0; i < 3; ++i)
            result.parts[i / sum::size][i % sum::size] = value[i];
        return result;
    }
    static std::array<Scalar, 3> store(const sum& total)
    {
        std::array<Scalar, 3> result;
        for (std::size_t i = 0; i < 3; ++i)
            result[i] = total.parts[i / sum::size][i % sum::size];
        return result;
    }
    static void add(sum& total, const sum& more)
    {
        for (std::size_t i = 0; i < 4 / sum::size; ++i)
            total.parts[i] += more.parts[i];
    }
    static void scale(sum& total, Scalar weight)
    {
        for (auto& part : total.parts)
            part *= weight;
    }
};
#endif

} // namespace detail

} // namespace kith
