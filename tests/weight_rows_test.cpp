// SPDX-License-Identifier: BSD-3-Clause
#include <kith/mask/weight_rows.hpp>

#include <gtest/gtest.h>

TEST(weight_rows, gives_the_row_of_every_valence)
{
    const kith::weight_rows<float> rows([](std::size_t n) { return std::vector<double>(n, 1. / double(n)); });
    std::vector<float> spare;
    for (const std::size_t n : {1U, 3U, 16U, 17U, 64U, 1000U})
        EXPECT_EQ(rows(n, spare)[n - 1], float(1. / double(n)));
}

TEST(weight_rows, computes_the_usual_valences_once)
{
    int calls = 0;
    const kith::weight_rows<double> rows([&](std::size_t n) { return ++calls, std::vector<double>(n, 1); });
    const int made = calls;
    std::vector<double> spare;
    for (std::size_t n = 3; n <= 16; ++n)
        EXPECT_EQ(rows(n, spare)[0], 1.);
    EXPECT_EQ(calls, made);
    EXPECT_TRUE(spare.empty());
}
