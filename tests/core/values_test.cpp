// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/level/values.hpp>

#include "support/every_level.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace {

/// A value that can only be concatenated. It stands for types that are not numbers.
struct word {
    std::string text;
};

} // namespace

template <>
struct kith::affine<word> {
    using scalar = double;
    using sum = word;
    static const word& load(const word& w) { return w; }
    static const word& store(const word& w) { return w; }
    static void add(word& total, const word& more) { total.text += more.text; }
    static void scale(word&, double) {}
};

TEST(values, coarse_points_are_those_of_the_mesh)
{
    const auto mesh = native(shapes::cube());
    const level_type level(mesh);
    EXPECT_EQ(kith::point_values<level_type>().coarse(level.vertices()[6]), (shapes::point{1, 1, 1}));
}

TEST(values, coarse_attributes_are_found_by_vertex_number)
{
    const auto mesh = native(shapes::polygon(3));
    const level_type level(mesh);
    const std::vector<double> heights{5, 6, 7};
    EXPECT_EQ(kith::attribute_values<double>(heights).coarse(level.vertices()[2]), 7.);
}

TEST(values, fine_values_are_what_was_assigned)
{
    kith::fine_values<double> values;
    values.allocate(2);
    values.assign(1, 4.5);
    values.assign(0, 2.5);
    EXPECT_EQ(values.fine(0), 2.5);
    const auto all = values.take();
    EXPECT_EQ((std::vector<double>(all.begin(), all.end())), (std::vector{2.5, 4.5}));
}

TEST(values, listed_values_come_after_all_others)
{
    kith::fine_values<double> values;
    values.allocate(1);
    values.append(8);
    values.assign(0, 7);
    values.append(9);
    EXPECT_EQ(values.listed_count(), 2U);
    EXPECT_EQ(values.listed(0), 7.);
    EXPECT_EQ(values.listed(2), 9.);
    const auto all = values.take();
    EXPECT_EQ((std::vector<double>(all.begin(), all.end())), (std::vector{7., 8., 9.}));
}

TEST(values, listed_values_may_refer_to_those_in_an_array_of_somebody_else)
{
    std::vector<double> array{3, 4};
    kith::fine_values<double> values;
    values.allocate_at(array.data(), array.size());
    values.assign(1, 7);
    values.append(8);
    EXPECT_EQ(array[1], 7.);
    EXPECT_EQ(values.listed(1), 7.);
    EXPECT_EQ(values.listed(2), 8.);
}

TEST(values, taking_leaves_nothing)
{
    kith::fine_values<double> values;
    values.allocate(3);
    values.append(1);
    static_cast<void>(values.take());
    EXPECT_EQ(values.listed_count(), 0U);
    EXPECT_EQ(values.take().size(), 0U);
}

TEST(values, may_be_of_any_type)
{
    const std::vector<word> words{{"a"}, {"b"}, {"c"}, {"d"}, {"e"}, {"f"}, {"g"}, {"h"}};
    const auto mesh = native(shapes::cube());
    const level_type level(mesh);
    kith::attribute_values<word> values(words);
    values.allocate(1);
    values.assign(0, kith::sum(level.faces()[1].vertices()).evaluate(values));
    EXPECT_EQ(values.take()[0].text, "efgh");
}
