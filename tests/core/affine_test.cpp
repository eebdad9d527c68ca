// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/base/affine.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>

using point = std::array<double, 3>;
using kith::affine;

TEST(affine, coordinates_are_added_one_by_one)
{
    point total{1, 2, 3};
    affine<point>::add(total, {10, 20, 30});
    EXPECT_EQ(total, (point{11, 22, 33}));
}

TEST(affine, coordinates_are_scaled_one_by_one)
{
    point total{1, 2, 3};
    affine<point>::scale(total, -2);
    EXPECT_EQ(total, (point{-2, -4, -6}));
}

TEST(affine, a_stored_sum_loads_as_itself)
{
    const point p{0.1, -0., 1e300};
    EXPECT_EQ(affine<point>::load(affine<point>::store(p)), p);
}

TEST(affine, numbers_are_values_too)
{
    float total = affine<float>::load(1.5F);
    affine<float>::add(total, 2);
    affine<float>::scale(total, 4);
    EXPECT_EQ(affine<float>::store(total), 14.F);
}

TEST(affine, weights_have_the_type_of_the_coordinates)
{
    EXPECT_TRUE((std::same_as<kith::scalar_of<std::array<float, 2>>, float>));
    EXPECT_TRUE((std::same_as<kith::scalar_of<long double>, long double>));
}

TEST(affine, channels_of_colours_are_rounded_at_the_end_and_kept_in_range)
{
    using colour = std::array<unsigned char, 3>;
    auto total = affine<colour>::load({10, 0, 255});
    affine<colour>::scale(total, .75);
    auto more = affine<colour>::load({1, 255, 255});
    affine<colour>::scale(more, .25);
    affine<colour>::add(total, more);
    EXPECT_EQ(affine<colour>::store(total), (colour{8, 64, 255})); // 7.75, 63.75
    EXPECT_EQ(affine<colour>::store({-3, 255.5, 1e9}), (colour{0, 255, 255}));
    EXPECT_TRUE((std::same_as<kith::scalar_of<colour>, double>));
}

TEST(affine, integers_of_64_bits_are_kept_in_range)
{
    using values = std::array<std::int64_t, 3>;
    using limits = std::numeric_limits<std::int64_t>;
    EXPECT_EQ(affine<values>::store({1e300, -1e300, -2.5}), (values{limits::max(), limits::min(), -3}));
    EXPECT_EQ(affine<values>::store({std::ldexp(1., 62), -std::ldexp(1., 63), std::nan("")}),
              (values{std::int64_t(1) << 62, limits::min(), limits::min()}));
    using natural = std::array<std::uint64_t, 2>;
    EXPECT_EQ(affine<natural>::store({std::ldexp(3., 62), -1}), (natural{std::uint64_t(3) << 62, 0}));
}

TEST(affine, points_and_numbers_are_affine_values)
{
    EXPECT_TRUE(kith::affine_value<point>);
    EXPECT_TRUE(kith::affine_value<double>);
}

TEST(affine, types_without_a_specialisation_are_not)
{
    EXPECT_FALSE(kith::affine_value<int>); // averages of integers are not integers
    EXPECT_FALSE(kith::affine_value<std::string>);
}

namespace {

/// A vector type with the interface of glm's vectors.
template <class T>
struct three {
    using value_type = T;
    using length_type = int;
    static constexpr int length() { return 3; }
    T& operator[](int i) { return x[std::size_t(i)]; }
    const T& operator[](int i) const { return x[std::size_t(i)]; }
    std::array<T, 3> x;
};

} // namespace

TEST(affine, vectors_of_other_libraries_are_known_by_their_shape)
{
    auto total = affine<three<float>>::load({{8, 16, 24}});
    affine<three<float>>::scale(total, .25F);
    EXPECT_EQ(affine<three<float>>::store(total).x, (std::array<float, 3>{2, 4, 6}));
    EXPECT_TRUE((std::same_as<kith::scalar_of<three<float>>, float>));
    EXPECT_EQ(affine<three<unsigned char>>::store({-3, 255.5, 7.75}).x, (std::array<unsigned char, 3>{0, 255, 8}));
    EXPECT_FALSE(kith::affine_value<three<std::string>>);
}
