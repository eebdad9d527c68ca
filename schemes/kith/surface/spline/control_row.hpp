// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mask/stencil.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace kith::detail {

/// A weighted sum of control points: the weight of each.
using control_row = std::vector<double>;

/// Returns the row with all weights, including zeros.
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

/// Returns a row over the points that the rows of a matrix make, as a row over the points that the matrix takes.
inline control_row composed(const control_row& row, const subdivision_matrix& rows)
{
    control_row result(rows.columns);
    for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t k = rows.begin_of_row(i); k < rows.begin_of_row(i + 1); ++k)
            result[std::size_t(rows.column[k])] += row[i] * rows.weight[k];
    return result;
}

/// Returns true if two rows are equal up to rounding.
inline bool are_near(const control_row& a, const control_row& b)
{
    constexpr double rounding = 1e-12;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (not(std::abs(a[i] - b[i]) <= rounding))
            return false;
    return true;
}

} // namespace kith::detail
