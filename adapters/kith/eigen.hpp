// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCore>

#include <kith/core/mask/stencil.hpp>

namespace kith {

/// Returns a view of a subdivision matrix for Eigen, on the same arrays. The matrix must outlive the view. Cost: O(1).
inline Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor, subdivision_matrix::index_type>>
as_eigen(const subdivision_matrix& matrix)
{
    using index = Eigen::Index;
    return {index(matrix.rows()),
            index(matrix.columns),
            index(matrix.weight.size()),
            matrix.row_start.data(),
            matrix.column.data(),
            matrix.weight.data()};
}
void as_eigen(const subdivision_matrix&&) = delete;

} // namespace kith
