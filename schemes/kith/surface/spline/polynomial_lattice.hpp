// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_polynomial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace kith::detail {

/// Returns the points of a lattice in a quad, or in a triangle, with `segments` segments on a side.
inline std::vector<std::array<double, 2>> lattice_points(std::size_t segments, bool is_tensor)
{
    if (segments == 0)
        return {{0, 0}};
    std::vector<std::array<double, 2>> result;
    for (std::size_t i = 0; i <= segments; ++i)
        for (std::size_t j = 0; j <= (is_tensor ? segments : segments - i); ++j)
            result.push_back({double(i) / double(segments), double(j) / double(segments)});
    return result;
}

/// The polynomials of a degree that are 1 at one point of a lattice and 0 at all others. The lattice has as many
/// segments on a side as the degree.
class polynomial_lattice {
public:
    polynomial_lattice(std::size_t degree, bool is_tensor) : degree_(degree), is_tensor_(is_tensor)
    {
        for (std::size_t i = 0; i <= degree; ++i)
            for (std::size_t j = 0; j <= (is_tensor ? degree : degree - i); ++j)
                basis_.push_back(coefficients_of(i, j));
    }

    [[nodiscard]] std::vector<std::array<double, 2>> points() const { return lattice_points(degree_, is_tensor_); }

    /// Returns the polynomial with these values at the points.
    [[nodiscard]] surface_polynomial through(std::span<const control_row> values) const
    {
        std::vector<control_row> coefficients = coefficients_through(values);
        round_to_fractions(coefficients);
        return polynomial_of(degree_, is_tensor_, coefficients);
    }
    /// Returns the degree of that polynomial, without rounding errors.
    [[nodiscard]] std::size_t degree_through(std::span<const control_row> values) const
    {
        const auto coefficients = coefficients_through(values);
        const control_row zero(values.front().size());
        std::size_t degree = 0;
        for_terms([&](std::size_t i, std::size_t j, std::size_t term) {
            if (not are_near(coefficients[term], zero))
                degree = std::max(degree, is_tensor_ ? std::max(i, j) : i + j);
        });
        return degree;
    }

private:
    [[nodiscard]] std::vector<control_row> coefficients_through(std::span<const control_row> values) const
    {
        std::vector<control_row> coefficients(basis_.size(), control_row(values.front().size()));
        for (std::size_t term = 0; term < basis_.size(); ++term)
            for (std::size_t p = 0; p < basis_.size(); ++p)
                add(coefficients[term], basis_[p][term], values[p]);
        return coefficients;
    }
    /// Removes rounding errors from the coefficients of splines, which are fractions. If all weights are multiples of
    /// the same fraction up to rounding, they become such multiples.
    void round_to_fractions(std::vector<control_row>& coefficients) const
    {
        constexpr double denominator = 3686400;                     // 2^14 3^2 5^2
        const double rounding = basis_.size() <= 16 ? 1e-11 : 1e-9; // larger sums have larger errors
        const auto rounded = [=](double weight) { return std::round(weight * denominator) / denominator; };
        for (const control_row& row : coefficients)
            for (const double weight : row)
                if (std::abs(weight - rounded(weight)) > rounding)
                    return;
        for (control_row& row : coefficients)
            for (double& weight : row)
                weight = rounded(weight);
    }
    /// Calls f(i, j, number) for all terms s^i t^j.
    template <class F>
    void for_terms(const F& f) const
    {
        std::size_t number = 0;
        for (std::size_t i = 0; i <= degree_; ++i)
            for (std::size_t j = 0; j <= (is_tensor_ ? degree_ : degree_ - i); ++j)
                f(i, j, number++);
    }
    /// Returns the coefficients of the polynomial of point (i, j): a product of linear factors that are 0 on lines.
    [[nodiscard]] std::vector<double> coefficients_of(std::size_t i, std::size_t j) const
    {
        const double n = double(degree_);
        std::vector<std::vector<double>> product(2 * degree_ + 1, std::vector<double>(2 * degree_ + 1)); // by powers
        product[0][0] = 1;
        const auto multiply = [&](double constant, double by_s, double by_t) {
            for (std::size_t a = product.size(); a-- > 0;)
                for (std::size_t b = product.size(); b-- > 0;)
                    product[a][b] = constant * product[a][b] + (a > 0 ? by_s * product[a - 1][b] : 0) +
                                    (b > 0 ? by_t * product[a][b - 1] : 0);
        };
        if (is_tensor_) {
            for (std::size_t k = 0; k <= degree_; ++k) {
                if (const double off = double(i) - double(k); off != 0)
                    multiply(-double(k) / off, n / off, 0);
                if (const double off = double(j) - double(k); off != 0)
                    multiply(-double(k) / off, 0, n / off);
            }
        } else {
            for (std::size_t k = 0; k < i; ++k)
                multiply(-double(k) / double(i - k), n / double(i - k), 0);
            for (std::size_t k = 0; k < j; ++k)
                multiply(-double(k) / double(j - k), 0, n / double(j - k));
            const std::size_t third = degree_ - i - j;
            for (std::size_t k = 0; k < third; ++k)
                multiply((n - double(k)) / double(third - k), -n / double(third - k), -n / double(third - k));
        }
        std::vector<double> result;
        for_terms([&](std::size_t a, std::size_t b, std::size_t) { result.push_back(product[a][b]); });
        return result;
    }

    std::size_t degree_;
    bool is_tensor_;
    std::vector<std::vector<double>> basis_; // the coefficients of each
};

} // namespace kith::detail
