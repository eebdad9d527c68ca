// SPDX-License-Identifier: BSD-3-Clause
#include <kith/picture/plot.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace kith::picture;

namespace {

std::string drawn(const std::vector<diagram>& diagrams)
{
    std::ostringstream out;
    write_svg(out, diagrams);
    return out.str();
}

/// Returns the places of the points of a curve in the picture, by its number.
std::vector<std::array<double, 2>> places(const std::string& svg, std::size_t curve)
{
    std::size_t at = 0;
    for (std::size_t i = 0; i <= curve; ++i)
        at = svg.find("<polyline", at + 1);
    at = svg.find("points='", at) + 8;
    std::istringstream numbers(svg.substr(at, svg.find('\'', at) - at));
    std::vector<std::array<double, 2>> result;
    char comma = 0;
    for (std::array<double, 2> p{}; numbers >> p[0] >> comma >> p[1];)
        result.push_back(p);
    return result;
}

TEST(plot, axes_are_linear_or_logarithmic)
{
    const plot linear{.curves = {{.points = {{0, 5}, {1, 6}, {4, 9}}}}, .width = 400, .height = 200};
    const auto even = places(drawn({linear}), 0);
    ASSERT_EQ(even.size(), 3U);
    EXPECT_NEAR(even[2][0] - even[0][0], 400, .2); // the last digit that is written
    EXPECT_NEAR(even[1][0] - even[0][0], 100, .2);
    EXPECT_NEAR(even[0][1] - even[2][1], 200, .2);
    EXPECT_NEAR(even[0][1] - even[1][1], 50, .2);

    plot logarithmic = linear;
    logarithmic.x.is_logarithmic = logarithmic.y.is_logarithmic = true;
    logarithmic.curves = {{.points = {{10, .001}, {100, .01}, {10000, 1}}}};
    const auto powers = places(drawn({logarithmic}), 0);
    ASSERT_EQ(powers.size(), 3U);
    EXPECT_NEAR(powers[1][0] - powers[0][0], 400 / 3., .2);
    EXPECT_NEAR(powers[0][1] - powers[1][1], 200 / 3., .2);
}

TEST(plot, curves_share_axes_and_names)
{
    const std::string svg = drawn(
        {plot{.curves = {{"a < b", {{0, 0}, {1, 1}}}, {"a < b", {{0, 2}, {1, 4}}, black, true}, {"c", {{1, 2}}}},
              .height = 100}});
    EXPECT_NEAR(places(svg, 0)[0][1] - places(svg, 1)[1][1], 100, .2);
    EXPECT_EQ(places(svg, 2)[0], (std::array{places(svg, 1)[1][0], places(svg, 1)[0][1]}));
    const std::string name = ">a &lt; b</text>";
    EXPECT_NE(svg.find(name), std::string::npos);
    EXPECT_EQ(svg.find(name), svg.rfind(name));
}

TEST(plot, round_numbers_are_on_the_axes)
{
    const std::string svg = drawn({plot{.x = {"faces", true}, .curves = {{.points = {{900, .3}, {3e6, .9}}}}}});
    for (const char* const tick : {">1000<", ">10 k<", ">100 k<", ">1 M<", ">0.4<", ">0.8<", ">faces<"})
        EXPECT_NE(svg.find(tick), std::string::npos) << tick;
}

TEST(plot, numbers_of_any_size_have_few_lines)
{
    for (const double least : {0., 5e-324, 1e16, -1e300})
        for (const double most : {1e16 + 2, 1e300})
            for (const bool is_logarithmic : {false, true})
                if (not is_logarithmic or least > 0) {
                    const plot sizes{.x = {"", is_logarithmic}, .curves = {{.points = {{least, 0}, {most, 1}}}}};
                    EXPECT_LT(drawn({sizes}).size(), 200'000U) << least << ' ' << most;
                }
}

TEST(plot, a_band_is_as_high_as_its_numbers)
{
    const std::string svg = drawn({plot{.curves = {{.points = {{3, 0}, {6, 10}}}}, .band = {{4, 5}}, .height = 200}});
    EXPECT_NE(svg.find("height='20' fill"), std::string::npos);
    for (const char* const tick : {">3<", ">4<", ">5<", ">6<"})
        EXPECT_NE(svg.find(tick), std::string::npos) << tick;
    EXPECT_EQ(svg.find(">3.5<"), std::string::npos);
}

TEST(plot, bars_are_as_long_as_their_numbers)
{
    const std::string svg = drawn({bar_chart{"Times", " ns", {{"one", 20}, {"two", 5}}}});
    EXPECT_NE(svg.find("width='420'"), std::string::npos);
    EXPECT_NE(svg.find("width='105'"), std::string::npos);
    EXPECT_NE(svg.find(">20 ns<"), std::string::npos);
}

TEST(plot, numbers_without_a_place_are_refused)
{
    const plot negative{.y = {"error", true}, .curves = {{.points = {{0, 1}, {1, 0}}}}};
    EXPECT_THROW(drawn({negative}), std::invalid_argument);
    const plot infinite{.curves = {{.points = {{0, std::numeric_limits<double>::infinity()}}}}};
    EXPECT_THROW(drawn({infinite}), std::invalid_argument);
    EXPECT_THROW(drawn({bar_chart{"", "", {{"none", -1}}}}), std::invalid_argument);
    EXPECT_NE(drawn({plot{}}).find("</svg>"), std::string::npos);
}

} // namespace
