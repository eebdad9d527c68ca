// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mask/stencil.hpp>

#include <iosfwd>

namespace kith::io {

/// Writes a matrix as Matrix Market text, coordinate real general, which SciPy's mmread, MATLAB's and Eigen's
/// loadMarket read. Rows and columns are counted from 1, and entries are written row by row. Weights have the shortest
/// digits that read back as the same doubles. Errors: those of the stream, in its state. Cost: O(entries), on all
/// threads.
void write_matrix_market(std::ostream& out, const subdivision_matrix& matrix);

} // namespace kith::io
