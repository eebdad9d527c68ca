// SPDX-License-Identifier: BSD-3-Clause
#include <kith/base/cos_turn.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

using kith::cos_turn;

namespace {

double error(std::int64_t k, std::int64_t n)
{
    const long double angle = 2 * std::acos(-1.L) * (static_cast<long double>(k) / static_cast<long double>(n));
    return std::abs(double(cos_turn(k, n) - std::cos(angle)));
}

} // namespace

TEST(cos_turn, is_right_to_the_last_place)
{
    for (std::int64_t n = 1; n <= 400; ++n)
        for (std::int64_t k = 0; k <= n; ++k)
            ASSERT_LT(error(k, n), 2.3e-16) << k << " of " << n;
}

TEST(cos_turn, is_right_for_valences_that_nobody_has)
{
    for (const std::int64_t n : {1'000'003, 1'000'000'007})
        for (const std::int64_t k : {std::int64_t(1), n / 8, n / 8 + 1, n / 4, n / 3, n / 2, n - 1})
            EXPECT_LT(error(k, n), 2.3e-16) << k << " of " << n;
}

TEST(cos_turn, is_exact_where_the_cosine_is)
{
    for (const std::int64_t m : {1, 2, 5, 1000}) {
        EXPECT_EQ(cos_turn(0, 12 * m), 1.);
        EXPECT_EQ(cos_turn(2 * m, 12 * m), 1. / 2);
        EXPECT_EQ(cos_turn(3 * m, 12 * m), 0.);
        EXPECT_EQ(cos_turn(4 * m, 12 * m), -1. / 2);
        EXPECT_EQ(cos_turn(6 * m, 12 * m), -1.);
        EXPECT_EQ(cos_turn(9 * m, 12 * m), 0.);
        EXPECT_EQ(cos_turn(12 * m, 12 * m), 1.);
    }
}

TEST(cos_turn, is_even_and_periodic_to_the_bit)
{
    for (std::int64_t n = 1; n <= 60; ++n)
        for (std::int64_t k = 0; k <= n; ++k) {
            EXPECT_EQ(cos_turn(-k, n), cos_turn(k, n));
            EXPECT_EQ(cos_turn(n + k, n), cos_turn(k, n));
            EXPECT_EQ(cos_turn(k - 7 * n, n), cos_turn(k, n));
        }
}

TEST(cos_turn, half_a_turn_further_is_the_opposite_to_the_bit)
{
    for (std::int64_t n = 2; n <= 60; n += 2)
        for (std::int64_t k = 0; k <= n; ++k)
            EXPECT_EQ(cos_turn(k + n / 2, n), -cos_turn(k, n)) << k << " of " << n;
}

TEST(cos_turn, the_sine_is_right_to_the_last_place_too)
{
    const long double turn = 2 * std::acos(-1.L);
    for (std::int64_t n = 1; n <= 200; ++n)
        for (std::int64_t k = -n; k <= n; ++k) {
            const long double sine = std::sin(turn * (static_cast<long double>(k) / static_cast<long double>(n)));
            ASSERT_LT(std::abs(double(kith::sin_turn(k, n) - sine)), 2.3e-16) << k << " of " << n;
        }
    EXPECT_EQ(kith::sin_turn(1, 4), 1.);
    EXPECT_EQ(kith::sin_turn(5, 10), 0.);
    EXPECT_EQ(kith::sin_turn(1, 12), 1. / 2);
}

TEST(cos_turn, can_be_computed_while_compiling)
{
    constexpr double cosine = cos_turn(1, 5);
    static_assert(cosine > 0.30901699437494734 and cosine < 0.30901699437494756);
    EXPECT_EQ(cosine, cos_turn(1, 5));
}
