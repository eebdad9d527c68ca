// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "averaged_value.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace kith::detail {

/// Returns true if two values are equal, or if both are not a number.
template <class T>
bool same_number(const T& a, const T& b)
{
    return a == b or (a != a and b != b);
}

template <class Coordinates>
bool same_numbers(const Coordinates& a, const Coordinates& b)
{
    return std::equal(
        std::begin(a), std::end(a), std::begin(b), [](const auto& x, const auto& y) { return same_number(x, y); });
}

/// Values of one type, each as up to four numbers, and the rounding that numbers undergo as values of that type.
template <class Number>
struct numbers_of_values {
    using numbers = four_numbers<Number>;
    using rounding = numbers (*)(const numbers&);

    template <class T>
    static numbers rounded(const numbers& x)
    {
        return averaged_value<T>::template load<Number>(averaged_value<T>::template store<Number>(x));
    }

    std::vector<numbers> values;
    rounding round;
};

/// The conversion of the numbers of one type to those of another.
template <class Number>
struct number_conversion {
    using numbers = four_numbers<Number>;
    using rounding = typename numbers_of_values<Number>::rounding;

    bool are_colors;
    rounding from, to;

    [[nodiscard]] numbers convert(const numbers& x) const { return are_colors ? color(x, from, to) : x; }
    [[nodiscard]] bool is_exact(const numbers& x) const
    {
        const numbers kept = to(convert(x));
        return are_colors ? same_numbers(opaque(x, from), opaque(from(color(kept, to, from)), from))
                          : same_numbers(x, from(kept));
    }

private:
    /// Returns a colour in the range of another type. The channels of integer types are from 0 to 255, those of others
    /// from 0 to 1. A colour without a fourth channel is opaque.
    static numbers color(const numbers& x, rounding from, rounding to)
    {
        numbers result = opaque(x, from);
        for (Number& channel : result)
            channel = channel * full(to) / full(from);
        return result;
    }
    static numbers opaque(numbers x, rounding type)
    {
        const numbers alpha{0, 0, 0, 1};
        if (not(type(alpha) == alpha))
            x[3] = full(type);
        return x;
    }
    static Number full(rounding type)
    {
        const numbers half{0.5, 0, 0, 0};
        return type(half) == half ? 1 : 255;
    }
};

} // namespace kith::detail
