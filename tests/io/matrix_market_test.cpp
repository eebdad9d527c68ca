// SPDX-License-Identifier: BSD-3-Clause
#include "files.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/hierarchy.hpp>
#include <kith/matrix_market.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

using namespace kith;

TEST(matrix_market, is_written_from_one_on_and_without_what_is_not_there)
{
    const subdivision_matrix matrix{
        .columns = 3, .row_start = {0, 1, 1, 3}, .column = {1, 0, 2}, .weight = {1, 0.1, -1. / 3}};
    std::ostringstream out;
    io::write_matrix_market(out, matrix);
    EXPECT_EQ(out.str(),
              "%%MatrixMarket matrix coordinate real general\n"
              "3 3 3\n"
              "1 2 1\n"
              "3 1 0.1\n"
              "3 3 -0.3333333333333333\n");
}

TEST(matrix_market, reads_back_as_the_same_doubles)
{
    hierarchy levels(make_mesh(files::corners, files::triangles), catmull_clark{});
    levels.refine(3);
    const auto matrix = levels.matrix(0, 3);
    std::stringstream text;
    io::write_matrix_market(text, matrix);
    std::string banner;
    std::getline(text, banner);
    std::size_t rows = 0, columns = 0, entries = 0;
    text >> rows >> columns >> entries;
    EXPECT_EQ(rows, matrix.rows());
    EXPECT_EQ(columns, matrix.columns);
    std::vector<matrix_entry> read(entries);
    for (auto& [row, column, weight] : read) {
        text >> row >> column >> weight;
        --row, --column;
    }
    EXPECT_TRUE(text);
    EXPECT_EQ(read, matrix.triplets());
    EXPECT_FALSE(text >> banner);
}
