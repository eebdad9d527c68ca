// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace kith::io {

/// Returns the unit normal of a triangle of finite points, or (1, 0, 0) if it has none, because STL requires a
/// direction. Scaling by powers of two keeps all products within the range of doubles; it changes no bit of the result.
inline std::array<double, 3> facet_normal(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                          const std::array<double, 3>& r)
{
    using vector = std::array<double, 3>;
    const auto largest = [](const vector& a, const vector& b) {
        double result = 0;
        for (std::size_t i = 0; i < 3; ++i)
            result = std::max({result, std::abs(a[i]), std::abs(b[i])});
        return result;
    };
    const auto difference = [](const vector& a, const vector& b, double scale) {
        return vector{a[0] * scale - b[0] * scale, a[1] * scale - b[1] * scale, a[2] * scale - b[2] * scale};
    };
    constexpr double huge = 0x1p1000;
    const double half = std::max(largest(p, q), largest(r, r)) > huge ? 0.25 : 1; // a difference may be twice as large
    vector a = difference(q, p, half), b = difference(r, p, half);
    const double size = largest(a, b);
    if (size == 0)
        return {1, 0, 0};
    if (size > 0x1p200 or size < 0x1p-200) {
        const int exponent = std::ilogb(size);
        for (std::size_t i = 0; i < 3; ++i) {
            a[i] = std::scalbn(a[i], -exponent);
            b[i] = std::scalbn(b[i], -exponent);
        }
    }
    const vector n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (not(length > 0))
        return {1, 0, 0};
    return {n[0] / length, n[1] / length, n[2] / length};
}

} // namespace kith::io
