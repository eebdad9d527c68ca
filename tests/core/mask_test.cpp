// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/mask/choose.hpp>
#include <kith/core/mask/mask.hpp>

#include "support/rational.hpp"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

/// An operand: the number i, which each type of values converts to its own value.
struct operand : kith::mask_base {
    int i;
    explicit operand(int i) : i(i) {}

    template <class Values>
    typename Values::sum evaluate(const Values& values) const
    {
        return values.value(i);
    }
};

/// Values that write down the operations of a mask in their order.
struct written {
    using scalar = double;
    using sum = std::string;
    static std::string value(int i) { return std::string(1, char('a' + i)); }
    static void add(std::string& total, const std::string& more) { total = "(" + total + "+" + more + ")"; }
    static void scale(std::string& total, double weight)
    {
        std::ostringstream text;
        text << weight << "*" << total;
        total = text.str();
    }
};

struct exact {
    using scalar = rational;
    using sum = rational;
    static rational value(int i) { return i; }
    static void add(rational& total, rational more) { total += more; }
    static void scale(rational& total, rational weight) { total *= weight; }
};

/// A mask that counts its evaluations.
struct counted : kith::mask_base {
    static inline int evaluations = 0;
    template <class Values>
    double evaluate(const Values&) const
    {
        return ++evaluations;
    }
};
struct numbers {
    using scalar = double;
    using sum = double;
    static void add(double& total, double more) { total += more; }
    static void scale(double& total, double weight) { total *= weight; }
};

const operand a(0), b(1), c(2), d(3);
const std::vector<operand> abcd{a, b, c, d};

std::string text(const auto& mask)
{
    return mask.evaluate(written());
}

} // namespace

TEST(mask, operations_happen_in_the_order_of_the_text)
{
    EXPECT_EQ(text(3. / 8 * (a + b) + 1. / 8 * (c + d)), "(0.375*(a+b)+0.125*(c+d))");
}

TEST(mask, sums_go_from_left_to_right)
{
    EXPECT_EQ(text(a + b + c), "((a+b)+c)");
    EXPECT_EQ(text(a + (b + c)), "(a+(b+c))");
    EXPECT_EQ(text(sum(a, b, c, d)), "(((a+b)+c)+d)");
}

TEST(mask, a_sum_over_a_range_is_the_sum_of_its_elements)
{
    EXPECT_EQ(text(kith::sum(abcd)), text(a + b + c + d));
}

TEST(mask, a_weighted_sum_scales_each_operand_before_it_is_added)
{
    const std::array<double, 4> weights{8, 4, 2, 1};
    EXPECT_EQ(text(kith::sum(abcd, weights.data())), "(((8*a+4*b)+2*c)+1*d)");
}

TEST(mask, weights_may_be_a_function_of_the_position)
{
    EXPECT_EQ(text(kith::sum(abcd, [](std::size_t i) { return double(10 * i); })), "(((0*a+10*b)+20*c)+30*d)");
}

TEST(mask, operands_may_be_listed_with_their_weights)
{
    const std::vector<std::pair<operand, double>> list{{c, 3}, {a, 5}};
    EXPECT_EQ(text(kith::weighted(list)), "(3*c+5*a)");
}

TEST(mask, a_choice_evaluates_only_what_it_takes)
{
    const auto pick = [](bool first) { return text(kith::choose(first, [] { return a + b; }, [] { return 2. * c; })); };
    EXPECT_EQ(pick(true), "(a+b)");
    EXPECT_EQ(pick(false), "2*c");
    const auto unused = []() -> operand { throw std::logic_error("the other one was made"); };
    EXPECT_EQ(text(kith::choose(false, unused, [] { return d; })), "d");
}

TEST(mask, an_average_is_the_sum_times_one_weight)
{
    EXPECT_EQ(text(kith::average(abcd)), "0.25*(((a+b)+c)+d)");
    EXPECT_EQ(text(average(a, b)), "0.5*(a+b)");
}

TEST(mask, an_average_of_one_is_its_operand)
{
    EXPECT_EQ(text(kith::average(std::vector{b})), "1*b");
}

TEST(mask, a_difference_adds_the_opposite)
{
    EXPECT_EQ(text(a - b), "(a+-1*b)");
}

TEST(mask, division_is_one_weight)
{
    EXPECT_EQ(text((a + b) / 8), "0.125*(a+b)");
}

TEST(mask, thirds_are_exact_over_exact_numbers)
{
    EXPECT_EQ(kith::average(std::vector{operand(1), operand(2), operand(4)}).evaluate(exact()), rational(7, 3));
    EXPECT_EQ((b / 3).evaluate(exact()), rational(1, 3));
    EXPECT_EQ(average(b, b, c).evaluate(exact()), rational(4, 3));
}

TEST(mask, weights_may_be_of_the_scalar_type)
{
    EXPECT_EQ((rational(2, 3) * b).evaluate(exact()), rational(2, 3));
}

TEST(mask, nothing_is_computed_before_it_is_asked_for)
{
    const auto mask = 1. / 2 * (counted() + counted());
    EXPECT_EQ(counted::evaluations, 0);
    EXPECT_EQ(mask.evaluate(numbers()), 1.5);
    EXPECT_EQ(counted::evaluations, 2);
}

TEST(mask, a_mask_outlives_the_operands_it_was_made_of)
{
    const auto make = [] {
        const operand x(5), y(6);
        return 2. * (x + y);
    };
    EXPECT_EQ(text(make()), "2*(f+g)");
}

TEST(mask, only_masks_are_masks)
{
    EXPECT_TRUE(kith::mask<operand>);
    EXPECT_TRUE(kith::mask<decltype(a + b)>);
    EXPECT_FALSE(kith::mask<double>);
    EXPECT_TRUE(kith::mask_range<std::vector<operand>>);
    EXPECT_FALSE(kith::mask_range<std::vector<double>>);
}
