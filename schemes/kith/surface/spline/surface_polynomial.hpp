// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "control_row.hpp"

#include <kith/core/mask/stencil.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace kith::detail {

/// A piece of a limit surface over one face: a polynomial in the parameters s and t of the face. Its coefficients are
/// weighted sums of the control points around the face.
struct surface_polynomial {
    static constexpr std::size_t most_degree = 6;

    std::size_t degree = 0;  ///< in s, and in t
    bool is_tensor = true;   ///< terms s^i t^j have i, j <= degree; else i + j <= degree
    int derivatives = 2;     ///< number of known derivatives; all others are NaN
    subdivision_matrix rows; ///< of the coefficients, that of s^0 t^0 first, then by powers of t

    /// Returns the number of terms that contain s^i.
    [[nodiscard]] std::size_t row_size(std::size_t i) const { return is_tensor ? degree + 1 : degree + 1 - i; }
    /// Returns the index of the first of these terms.
    [[nodiscard]] std::size_t begin_of_row(std::size_t i) const
    {
        return is_tensor ? i * (degree + 1) : i * (2 * degree + 3 - i) / 2;
    }
    [[nodiscard]] std::size_t terms() const { return rows.rows(); }

    /// Returns the weights of the control points at parameters.
    [[nodiscard]] control_row at(double s, double t) const
    {
        control_row result(rows.columns);
        double power_of_s = 1;
        for (std::size_t i = 0; i <= degree; ++i, power_of_s *= s) {
            double power = power_of_s;
            for (std::size_t term = begin_of_row(i); term < begin_of_row(i) + row_size(i); ++term, power *= t)
                for (std::size_t k = rows.begin_of_row(term); k < rows.begin_of_row(term + 1); ++k)
                    result[std::size_t(rows.column[k])] += power * rows.weight[k];
        }
        return result;
    }
};

/// Returns the polynomial with these coefficients.
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

} // namespace kith::detail
