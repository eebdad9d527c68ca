// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/mesh/mesh_report.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

using kith::mesh_report;
using kith::problem;

namespace {

void add(mesh_report& report, problem kind, const std::string& text)
{
    report.add(kind, [&] { return text; });
}

} // namespace

TEST(mesh_report, is_ok_until_something_is_added)
{
    mesh_report report;
    EXPECT_TRUE(report.ok());
    EXPECT_NO_THROW(report.require_ok());
    add(report, problem::turned_face, "face 3");
    EXPECT_FALSE(report);
}

TEST(mesh_report, counts_each_kind)
{
    mesh_report report;
    add(report, problem::turned_face, "face 3");
    add(report, problem::turned_face, "face 4");
    EXPECT_EQ(report.count(problem::turned_face), 2U);
    EXPECT_TRUE(report.has(problem::turned_face));
    EXPECT_FALSE(report.has(problem::bad_index));
}

TEST(mesh_report, tells_problems_in_the_order_they_were_found)
{
    mesh_report report;
    add(report, problem::isolated_vertex, "vertex 7");
    add(report, problem::bad_index, "face 0");
    EXPECT_EQ(report.text(), "vertex 7\nface 0");
}

TEST(mesh_report, tells_the_first_of_each_kind_and_how_many_more_there_are)
{
    mesh_report report;
    for (int i = 0; i < 11; ++i)
        add(report, problem::isolated_vertex, std::to_string(i));
    add(report, problem::turned_face, "face 3");
    EXPECT_EQ(
        report.lines(),
        (std::vector<std::string>{"0", "1", "2", "3", "4", "5", "6", "7", "face 3", "and 3 more: isolated vertices"}));
}

TEST(mesh_report, does_not_describe_what_it_will_not_tell)
{
    mesh_report report;
    int described = 0;
    for (int i = 0; i < 1000; ++i)
        report.add(problem::not_finite, [&] { return std::to_string(++described); });
    EXPECT_EQ(described, int(mesh_report::told_of_each_kind));
    EXPECT_EQ(report.count(problem::not_finite), 1000U);
}

TEST(mesh_report, throws_what_it_tells)
{
    mesh_report report;
    add(report, problem::empty_mesh, "nothing here");
    try {
        report.require_ok();
        FAIL();
    } catch (const kith::mesh_error& error) {
        EXPECT_STREQ(error.what(), "nothing here");
    }
}
