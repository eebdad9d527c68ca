// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace kith::picture {

/// A color: red, green, blue and opacity, between 0 and 1.
struct color {
    float red = 0, green = 0, blue = 0, opacity = 1;

    friend bool operator==(const color&, const color&) = default;
};

inline constexpr color white{1, 1, 1, 1}, gray{.72F, .74F, .77F, 1}, black{0, 0, 0, 1}, transparent{0, 0, 0, 0};

/// Returns the color between two colors: `a` for 0, `b` for 1.
constexpr color mix(const color& a, const color& b, float t)
{
    return {a.red + t * (b.red - a.red),
            a.green + t * (b.green - a.green),
            a.blue + t * (b.blue - a.blue),
            a.opacity + t * (b.opacity - a.opacity)};
}

/// Returns one of many colors that are easy to tell apart; consecutive numbers have different hues.
color color_of_number(std::size_t number);

/// Returns the color of a value with a sign: blue for -1, white for 0, red for 1. Values beyond have the color of -1 or
/// 1, and NaN is gray.
color color_of_signed(double value);

/// Returns the color of a value without a sign: dark violet for 0, green for 1/2, yellow for 1. Values beyond have the
/// color of 0 or 1, and NaN is gray.
color color_of_share(double value);

} // namespace kith::picture
