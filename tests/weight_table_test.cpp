// SPDX-License-Identifier: BSD-3-Clause
#include <kith/mask/weight_table.hpp>

#include <gtest/gtest.h>

TEST(weight_table, gives_the_weight_of_every_valence)
{
    const kith::weight_table<float> table([](std::size_t n) { return 1. / double(n); });
    for (const std::size_t n : {1U, 3U, 64U, 65U, 1000U})
        EXPECT_EQ(table[n], float(1. / double(n)));
}

TEST(weight_table, computes_the_usual_valences_once)
{
    int calls = 0;
    const kith::weight_table<double> table([&](std::size_t n) { return ++calls, double(n); });
    const int made = calls;
    for (std::size_t n = 3; n <= 64; ++n)
        EXPECT_EQ(table[n], double(n));
    EXPECT_EQ(calls, made);
}
