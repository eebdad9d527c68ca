// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "in_library.hpp"

#include <cstdint>

namespace kith {

/// Returns the cosine of k/n of a full turn, to about one unit in the last place and with the same bits on every
/// machine. The results of libm differ between platforms, and different weights would make ranks disagree. The result
/// is exact if the cosine is 0, 1/2 or 1 in absolute value. Precondition: n > 0. Cost: O(1).
/// The function is not inlined into loops over masks, since they call it for large rings only.
[[gnu::noinline, gnu::const]] constexpr double exact_cos(std::int64_t k, std::int64_t n)
{
    k = (k % n + n) % n;
    if (2 * k > n) // cos(-x) = cos(x)
        k = n - k;
    const double sign = 4 * k > n ? -1 : 1; // cos(pi - x) = -cos(x)
    const std::int64_t q = 2 * n;
    const std::int64_t p = sign < 0 ? n - 2 * k : 2 * k; // now p/q of a turn, at most a quarter
    if (6 * p == q)
        return sign / 2;

    constexpr double turn = 6.283185307179586476925286766559;
    const bool use_sine = 8 * p > q; // cos(x) = sin(pi/2 - x); the series are for angles of up to an eighth turn
    const double x = use_sine ? turn * double(q - 4 * p) / double(4 * q) : turn * double(p) / double(q);
    double series = 1;
    for (int i = 20; i > 0; i -= 2)
        series = 1 - x * x / (use_sine ? i * (i + 1) : i * (i - 1)) * series;
    return sign * (use_sine ? x * series : series);
}

/// Returns the sine of k/n of a full turn, as accurate as exact_cos. Precondition: n > 0.
constexpr double sin_turn(std::int64_t k, std::int64_t n)
{
    return exact_cos(4 * k - n, 4 * n);
}

} // namespace kith
