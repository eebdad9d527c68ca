// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/surface/spline/surface_polynomial.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace kith::detail {

/// Returns the vector from one point to another one.
inline std::array<double, 3> vector_between(const std::array<double, 3>& from, const std::array<double, 3>& to)
{
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

/// A polynomial piece of a surface, given by its Bezier points. It lies in the convex hull of these points. A tensor
/// product has this degree in s and in t over the unit square. Otherwise this is the total degree over the triangle (0,
/// 0), (1, 0), (0, 1).
template <bool IsTensor, std::size_t Degree>
class bezier_patch {
public:
    using vector = std::array<double, 3>;
    static constexpr bool is_tensor = IsTensor;
    static constexpr std::size_t degree = Degree;
    static constexpr std::size_t size = IsTensor ? (degree + 1) * (degree + 1) : (degree + 1) * (degree + 2) / 2;
    static constexpr std::size_t sides = IsTensor ? 2 : 3; ///< number of directions in which a patch can be halved

    /// A point of the patch, and derivatives.
    struct values {
        vector point, s, t, ss, st, tt;
    };

    std::array<vector, size> points{};

    bezier_patch() = default;
    /// Takes a polynomial of at most this degree, by the coefficients of its powers.
    bezier_patch(const surface_polynomial& polynomial, std::span<const vector> coefficients)
    {
        for_each_index<0, 0>([&](std::size_t i, std::size_t j) {
            for (std::size_t k = 0; k <= std::min(i, polynomial.degree); ++k)
                for (std::size_t l = 0; l < std::min(j + 1, polynomial.row_size(k)); ++l)
                    add_to(points[place(i, j)],
                           share_of_power[place(i, j)][k][l],
                           coefficients[polynomial.begin_of_row(k) + l]);
        });
    }

    /// Returns the index of point (i, j) in the list.
    static constexpr std::size_t place(std::size_t i, std::size_t j)
    {
        return IsTensor ? (degree + 1) * i + j : i * (2 * degree + 3 - i) / 2 + j;
    }

    /// Returns the point of the patch at s and t, each 0 or 1.
    [[nodiscard]] const vector& at_corner(bool s, bool t) const
    {
        return points[place(s ? degree : 0, t ? degree : 0)];
    }
    /// Returns the halves of the patch, cut in the middle of a side, by the algorithm of de Casteljau. Side 0 leads
    /// along s, side 1 along t. Side 2 of a triangle leads from (1, 0) to (0, 1).
    [[nodiscard]] std::pair<bezier_patch, bezier_patch> halves(std::size_t side) const
    {
        std::pair<bezier_patch, bezier_patch> result;
        for (std::size_t line = 0; line <= degree; ++line) {
            const std::size_t last = IsTensor ? degree : degree - line;
            std::array<vector, degree + 1> row;
            for (std::size_t k = 0; k <= last; ++k)
                row[k] = points[on_line(side, line, k)];
            for (std::size_t k = 0; k <= last; ++k) {
                result.first.points[on_line(side, line, k)] = row[0];
                result.second.points[on_line(side, line, last - k)] = row[last - k];
                for (std::size_t m = 0; m + k < last; ++m)
                    for (std::size_t x = 0; x < 3; ++x)
                        row[m][x] = (row[m][x] + row[m + 1][x]) / 2;
            }
        }
        return result;
    }
    /// Returns the longest side.
    [[nodiscard]] std::size_t longest_side() const
    {
        std::array<double, sides> length{};
        for (std::size_t side = 0; side < sides; ++side)
            for (const std::size_t line : {std::size_t(0), degree})
                for (std::size_t k = 0; k < (IsTensor ? degree : degree - line); ++k) {
                    const vector &a = points[on_line(side, line, k)], &b = points[on_line(side, line, k + 1)];
                    length[side] += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
                }
        return std::size_t(std::ranges::max_element(length) - length.begin());
    }

    /// Returns the point at s and t, with first and second derivatives.
    [[nodiscard]] values at(double s, double t) const
    {
        values result{};
        evaluate<0, 0>(s, t, result.point);
        evaluate<1, 0>(s, t, result.s);
        evaluate<0, 1>(s, t, result.t);
        evaluate<2, 0>(s, t, result.ss);
        evaluate<1, 1>(s, t, result.st);
        evaluate<0, 2>(s, t, result.tt);
        return result;
    }
    /// Calls f with each Bezier point of the derivative of order S in s and T in t.
    template <std::size_t S, std::size_t T, class F>
    void for_each_point_of_derivative(const F& f) const
    {
        for_each_index<S, T>([&](std::size_t i, std::size_t j) { f(point_of_derivative<S, T>(i, j)); });
    }

private:
    /// Calls f(i, j) for each point of this derivative.
    template <std::size_t S, std::size_t T, class F>
    static constexpr void for_each_index(const F& f)
    {
        for (std::size_t i = 0; i + S <= degree; ++i)
            for (std::size_t j = 0; j + T + (IsTensor ? 0 : i + S) <= degree; ++j)
                f(i, j);
    }
    template <std::size_t S, std::size_t T>
    [[nodiscard]] vector point_of_derivative(std::size_t i, std::size_t j) const
    {
        constexpr double factor = IsTensor ? falling(degree, S) * falling(degree, T) : falling(degree, S + T);
        vector result{};
        for (std::size_t a = 0; a <= S; ++a)
            for (std::size_t b = 0; b <= T; ++b)
                add_to(result,
                       factor * choose(S, a) * choose(T, b) * ((S - a + T - b) % 2 == 0 ? 1 : -1),
                       points[place(i + a, j + b)]);
        return result;
    }
    template <std::size_t S, std::size_t T>
    void evaluate(double s, double t, vector& result) const
    {
        if constexpr (IsTensor) {
            const auto by_s = bernstein<degree - S>(s, 1 - s), by_t = bernstein<degree - T>(t, 1 - t);
            for_each_index<S, T>([&](std::size_t i, std::size_t j) {
                add_to(result, by_s[i] * by_t[j], point_of_derivative<S, T>(i, j));
            });
        } else {
            constexpr std::size_t n = degree - S - T;
            std::array<double, n + 1> of_s, of_t, of_r;
            of_s[0] = of_t[0] = of_r[0] = 1;
            for (std::size_t k = 0; k < n; ++k) {
                of_s[k + 1] = of_s[k] * s;
                of_t[k + 1] = of_t[k] * t;
                of_r[k + 1] = of_r[k] * (1 - s - t);
            }
            for_each_index<S, T>([&](std::size_t i, std::size_t j) {
                add_to(result,
                       choose(n, i) * choose(n - i, j) * of_s[i] * of_t[j] * of_r[n - i - j],
                       point_of_derivative<S, T>(i, j));
            });
        }
    }
    template <std::size_t N>
    static std::array<double, N + 1> bernstein(double s, double r)
    {
        std::array<double, N + 1> result;
        double power = 1;
        for (std::size_t i = 0; i <= N; ++i, power *= s)
            result[i] = choose(N, i) * power;
        power = 1;
        for (std::size_t i = N + 1; i-- > 0; power *= r)
            result[i] *= power;
        return result;
    }

    /// Returns the index of point k on a line of points along a side.
    static constexpr std::size_t on_line(std::size_t side, std::size_t line, std::size_t k)
    {
        return side == 0 ? place(k, line) : side == 1 ? place(line, k) : place(degree - line - k, k);
    }
    static constexpr double choose(std::size_t n, std::size_t k) { return pascals_triangle[n][k]; }
    /// Returns n (n - 1) ... (n - k + 1).
    static constexpr double falling(std::size_t n, std::size_t k)
    {
        return k == 0 ? 1 : double(n) * falling(n - 1, k - 1);
    }
    static constexpr auto pascals_triangle = [] {
        std::array<std::array<double, degree + 1>, degree + 1> result{};
        for (std::size_t n = 0; n <= degree; ++n)
            for (std::size_t k = 0; k <= n; ++k)
                result[n][k] = k == 0 ? 1 : result[n - 1][k - 1] + result[n - 1][k];
        return result;
    }();
    /// The weight of s^k t^l in each point.
    static constexpr auto share_of_power = [] {
        std::array<std::array<std::array<double, degree + 1>, degree + 1>, size> result{};
        for_each_index<0, 0>([&](std::size_t i, std::size_t j) {
            for (std::size_t k = 0; k <= i; ++k)
                for (std::size_t l = 0; l <= j; ++l)
                    result[place(i, j)][k][l] = pascals_triangle[i][k] * pascals_triangle[j][l] /
                                                pascals_triangle[degree][k] /
                                                pascals_triangle[IsTensor ? degree : degree - k][l];
        });
        return result;
    }();
    static constexpr void add_to(vector& total, double weight, const vector& x)
    {
        for (std::size_t i = 0; i < 3; ++i)
            total[i] += weight * x[i];
    }
};

} // namespace kith::detail
