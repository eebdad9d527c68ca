// SPDX-License-Identifier: BSD-3-Clause
#include <kith/io/text/text_writer.hpp>
#include <kith/matrix_market.hpp>

#include <cstddef>
#include <ostream>

namespace kith::io {

void write_matrix_market(std::ostream& out, const subdivision_matrix& matrix)
{
    text_block header;
    header << "%%MatrixMarket matrix coordinate real general\n"
           << matrix.rows() << ' ' << matrix.columns << ' ' << matrix.weight.size() << '\n';
    out << header.text();
    write_blocks(out, matrix.rows(), [&](text_block& text, std::size_t i) {
        for (std::size_t k = matrix.begin_of_row(i); k < matrix.begin_of_row(i + 1); ++k)
            text << i + 1 << ' ' << matrix.column[k] + 1 << ' ' << matrix.weight[k] << '\n';
    });
}

} // namespace kith::io
