// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/base/exact_cos.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

using kith::exact_cos;

namespace {

double error(std::int64_t k, std::int64_t n)
{
    const long double angle = 2 * std::acos(-1.L) * (static_cast<long double>(k) / static_cast<long double>(n));
    return std::abs(double(exact_cos(k, n) - std::cos(angle)));
}

} // namespace

TEST(exact_cos, is_right_to_the_last_place)
{
    for (std::int64_t n = 1; n <= 400; ++n)
        for (std::int64_t k = 0; k <= n; ++k)
            ASSERT_LT(error(k, n), 2.3e-16) << k << " of " << n;
}

TEST(exact_cos, is_right_for_valences_that_nobody_has)
{
    for (const std::int64_t n : {1'000'003, 1'000'000'007})
        for (const std::int64_t k : {std::int64_t(1), n / 8, n / 8 + 1, n / 4, n / 3, n / 2, n - 1})
            EXPECT_LT(error(k, n), 2.3e-16) << k << " of " << n;
}

TEST(exact_cos, is_exact_where_the_cosine_is)
{
    for (const std::int64_t m : {1, 2, 5, 1000}) {
        EXPECT_EQ(exact_cos(0, 12 * m), 1.);
        EXPECT_EQ(exact_cos(2 * m, 12 * m), 1. / 2);
        EXPECT_EQ(exact_cos(3 * m, 12 * m), 0.);
        EXPECT_EQ(exact_cos(4 * m, 12 * m), -1. / 2);
        EXPECT_EQ(exact_cos(6 * m, 12 * m), -1.);
        EXPECT_EQ(exact_cos(9 * m, 12 * m), 0.);
        EXPECT_EQ(exact_cos(12 * m, 12 * m), 1.);
    }
}

TEST(exact_cos, is_even_and_periodic_to_the_bit)
{
    for (std::int64_t n = 1; n <= 60; ++n)
        for (std::int64_t k = 0; k <= n; ++k) {
            EXPECT_EQ(exact_cos(-k, n), exact_cos(k, n));
            EXPECT_EQ(exact_cos(n + k, n), exact_cos(k, n));
            EXPECT_EQ(exact_cos(k - 7 * n, n), exact_cos(k, n));
        }
}

TEST(exact_cos, half_a_turn_further_is_the_opposite_to_the_bit)
{
    for (std::int64_t n = 2; n <= 60; n += 2)
        for (std::int64_t k = 0; k <= n; ++k)
            EXPECT_EQ(exact_cos(k + n / 2, n), -exact_cos(k, n)) << k << " of " << n;
}

TEST(exact_cos, the_sine_is_right_to_the_last_place_too)
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

TEST(exact_cos, can_be_computed_while_compiling)
{
    constexpr double cosine = exact_cos(1, 5);
    static_assert(cosine > 0.30901699437494734 and cosine < 0.30901699437494756);
    EXPECT_EQ(cosine, exact_cos(1, 5));
}
