// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/mask/stencil.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace kith::detail {

/// A weighted sum of control points: the weight of each.
using control_row = std::vector<double>;

/// Returns a row with all weights.
inline control_row dense(const stencil_row& sparse, std::size_t inputs)
{
    control_row row(inputs);
    for (const auto& [input, weight] : sparse.entries)
        row[input] = weight;
    return row;
}

/// Adds a multiple of a row.
inline void add(control_row& total, double weight, const control_row& row)
{
    for (std::size_t i = 0; i < total.size(); ++i)
        total[i] += weight * row[i];
}

/// A piece of a limit surface over one face: a polynomial in the parameters s and t of the face. Its coefficients are
/// weighted sums of the control points around the face.
struct surface_polynomial {
    std::size_t degree = 0;  ///< in s, and in t; at most 4
    bool is_tensor = true;   ///< all terms s^i t^j have i, j <= degree; else i + j <= degree
    int derivatives = 2;     ///< so many are known; all others are no numbers
    subdivision_matrix rows; ///< of the coefficients, that of s^0 t^0 first, then by powers of t

    /// Returns the number of terms that have s^i.
    [[nodiscard]] std::size_t row_size(std::size_t i) const { return is_tensor ? degree + 1 : degree + 1 - i; }
    /// Returns the first of them.
    [[nodiscard]] std::size_t begin_of_row(std::size_t i) const
    {
        return is_tensor ? i * (degree + 1) : i * (2 * degree + 3 - i) / 2;
    }
    [[nodiscard]] std::size_t terms() const { return rows.rows(); }
};

/// Returns the polynomial of these coefficients.
inline surface_polynomial polynomial_of(std::size_t degree, bool is_tensor, std::span<const control_row> coefficients)
{
    std::vector<stencil_row> rows;
    for (const control_row& row : coefficients) {
        stencil_row& sparse = rows.emplace_back();
        for (std::size_t i = 0; i < row.size(); ++i)
            if (row[i] != 0 or (sparse.entries.empty() and i + 1 == row.size())) // at least one
                sparse.entries.emplace_back(i, row[i]);
    }
    return {degree, is_tensor, 2, make_matrix(rows, coefficients.front().size())};
}

/// Returns the polynomial of a uniform cubic B-spline between its second and third control point: for each power of the
/// parameter the weights of the four points.
inline constexpr std::array<std::array<double, 4>, 4> cubic_spline_powers{{{1. / 6, 4. / 6, 1. / 6, 0},
                                                                           {-1. / 2, 0, 1. / 2, 0},
                                                                           {1. / 2, -1, 1. / 2, 0},
                                                                           {-1. / 6, 1. / 2, -1. / 2, 1. / 6}}};

/// A polynomial of degree 4 in s and t, the 15 coefficients by powers of s, then of t.
class quartic {
public:
    static constexpr std::size_t terms = 15;

    /// Adds weight * r^a s^b t^c, where r = 1 - s - t and a + b + c = 4.
    void add(double weight, std::size_t a, std::size_t b, std::size_t c)
    {
        // (1 - s - t)^a = sum over i, j of (-1)^(i+j) a! / (i! j! (a-i-j)!) s^i t^j
        for (std::size_t i = 0; i <= a; ++i)
            for (std::size_t j = 0; i + j <= a; ++j)
                coefficients_[place(b + i, c + j)] += weight * double(choose(a, i) * choose(a - i, j)) *
                                                      ((i + j) % 2 == 0 ? 1 : -1);
    }
    [[nodiscard]] const std::array<double, terms>& coefficients() const { return coefficients_; }

private:
    static std::size_t place(std::size_t i, std::size_t j) { return i * 5 - i * (i - 1) / 2 + j; }
    static std::size_t choose(std::size_t n, std::size_t k) { return k == 0 ? 1 : choose(n - 1, k - 1) * n / k; }

    std::array<double, terms> coefficients_{};
};

/// The three kinds of basis functions of the quartic box spline over a triangle, by the barycentric coordinate of the
/// corner that each belongs to. Stam 1998, "Evaluation of Loop subdivision surfaces".
enum class box_spline_kind : unsigned char { corner, across, beyond };

/// Returns the basis function of a control point: `first` and `second` are corners of the triangle. The point is
/// `first`; or it lies across the edge of both; or it lies beyond `first`, next to the point across that edge.
inline std::array<double, quartic::terms> box_spline_of(box_spline_kind kind, std::size_t first, std::size_t second)
{
    struct term {
        double weight;
        std::size_t x, y, z; // the exponents at the first corner, the second, and the third
    };
    static const std::array<std::vector<term>, 3> kinds{{{{6, 4, 0, 0},
                                                          {24, 3, 0, 1},
                                                          {24, 2, 0, 2},
                                                          {8, 1, 0, 3},
                                                          {1, 0, 0, 4},
                                                          {24, 3, 1, 0},
                                                          {60, 2, 1, 1},
                                                          {36, 1, 1, 2},
                                                          {6, 0, 1, 3},
                                                          {24, 2, 2, 0},
                                                          {36, 1, 2, 1},
                                                          {12, 0, 2, 2},
                                                          {8, 1, 3, 0},
                                                          {6, 0, 3, 1},
                                                          {1, 0, 4, 0}},
                                                         {{1, 4, 0, 0},
                                                          {2, 3, 0, 1},
                                                          {6, 3, 1, 0},
                                                          {6, 2, 1, 1},
                                                          {12, 2, 2, 0},
                                                          {6, 1, 2, 1},
                                                          {6, 1, 3, 0},
                                                          {2, 0, 3, 1},
                                                          {1, 0, 4, 0}},
                                                         {{1, 4, 0, 0}, {2, 3, 1, 0}}}};
    const std::size_t third = 3 - first - second;
    quartic result;
    for (const auto& [weight, x, y, z] : kinds[std::size_t(kind)]) {
        std::array<std::size_t, 3> exponent{};
        exponent[first] = x;
        exponent[second] = y;
        exponent[third] = z;
        result.add(weight / 12, exponent[0], exponent[1], exponent[2]);
    }
    return result.coefficients();
}

} // namespace kith::detail
