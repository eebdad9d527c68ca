// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>

#include <array>
#include <concepts>
#include <cstddef>

namespace kith {

/// The conversion of values that can be averaged to up to four coordinates, and back. If T() is uninitialized, it also
/// has nothing(), which returns zero.
template <class T>
struct averaged_value;

namespace detail {

template <class Number>
using four_numbers = std::array<Number, 4>;

/// Converts a number to a coordinate. Integers, such as the channels of a colour, are rounded, and kept in range if
/// masks have negative weights.
template <class T, class Number>
T as_coordinate(const Number& x)
{
    if constexpr (std::same_as<T, Number>)
        return x;
    else if constexpr (not std::constructible_from<double, const Number&>)
        return as_coordinate<T>(to_double(x)); // to_double of the exact number's own library
    else if constexpr (std::integral<T>)
        return rounded<T>(double(x));
    else
        return T(x);
}

} // namespace detail

template <std::floating_point T>
struct averaged_value<T> {
    template <class Number>
    static detail::four_numbers<Number> load(const T& value)
    {
        return {Number(value)};
    }
    template <class Number>
    static T store(const detail::four_numbers<Number>& x)
    {
        return detail::as_coordinate<T>(x[0]);
    }
};

/// The conversion of types with N coordinates, which are read and written by [i].
template <class T, class Coordinate, std::size_t N>
    requires(N <= 4)
struct averaged_coordinates {
    template <class Number>
    static detail::four_numbers<Number> load(const T& value)
    {
        detail::four_numbers<Number> x{};
        for (std::size_t i = 0; i < N; ++i)
            x[i] = Number(value[i]);
        return x;
    }
    template <class Number>
    static T store(const detail::four_numbers<Number>& x)
    {
        T value;
        for (std::size_t i = 0; i < N; ++i)
            value[i] = detail::as_coordinate<Coordinate>(x[i]);
        return value;
    }
};
template <class T, std::size_t N>
    requires(N <= 4 and (std::floating_point<T> or std::same_as<T, unsigned char>))
struct averaged_value<std::array<T, N>> : averaged_coordinates<std::array<T, N>, T, N> {};

/// The conversion of the vectors of Eigen and glm.
template <is_fixed_vector T>
    requires(fixed_vector<T>::size <= 4)
struct averaged_value<T> : averaged_coordinates<T, typename fixed_vector<T>::scalar, fixed_vector<T>::size> {
    static T nothing() { return averaged_value::template store<double>({}); } // T() leaves those of Eigen uninitialized
};

namespace detail {

template <class T>
concept can_be_averaged = requires(const T& value) { averaged_value<T>::template load<double>(value); };

} // namespace detail

} // namespace kith
