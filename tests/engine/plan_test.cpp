// SPDX-License-Identifier: BSD-3-Clause
#include <kith/plan.hpp>

#include "support/error_text.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/loop.hpp>
#include <kith/sqrt3.hpp>
#include <kith/unified.hpp>

#include <gtest/gtest.h>

#include <array>
#include <vector>

using kith::counts;
using kith::plan;

namespace {

constexpr counts cube{.vertices = 8, .edges = 12, .faces = 6};
constexpr counts triangulated_cube{.vertices = 8, .edges = 18, .faces = 12};
constexpr counts pentacube{.vertices = 11, .edges = 20, .faces = 11};
constexpr counts torus{.vertices = 288, .edges = 576, .faces = 288};
constexpr counts triangulated_torus{.vertices = 288, .edges = 864, .faces = 576};

using table = std::vector<std::array<std::uint64_t, 3>>;

table levels(const counts& control, const auto& scheme, int n)
{
    table result;
    for (const auto& level : plan(control, scheme, n))
        result.push_back({level.counts.vertices, level.counts.edges, level.counts.faces});
    return result;
}

} // namespace

TEST(plan, catmull_clark_of_the_cube_is_table_1_1_of_the_thesis)
{
    EXPECT_EQ(levels(cube, kith::catmull_clark(), 9),
              (table{{8, 12, 6},
                     {26, 48, 24},
                     {98, 192, 96},
                     {386, 768, 384},
                     {1538, 3072, 1536},
                     {6146, 12288, 6144},
                     {24578, 49152, 24576},
                     {98306, 196608, 98304},
                     {393218, 786432, 393216},
                     {1572866, 3145728, 1572864}}));
}

TEST(plan, doo_sabin_of_the_pentacube_is_that_of_the_thesis)
{
    EXPECT_EQ(levels(pentacube, kith::doo_sabin(), 1), (table{{11, 20, 11}, {40, 80, 42}}));
}

TEST(plan, doo_sabin_of_the_cube)
{
    EXPECT_EQ(levels(cube, kith::doo_sabin(), 2), (table{{8, 12, 6}, {24, 48, 26}, {96, 192, 98}}));
}

TEST(plan, loop_of_the_triangulated_cube_is_that_of_the_thesis)
{
    EXPECT_EQ(levels(triangulated_cube, kith::loop(), 2), (table{{8, 18, 12}, {26, 72, 48}, {98, 288, 192}}));
}

TEST(plan, sqrt3_of_the_triangulated_cube_is_that_of_the_thesis)
{
    EXPECT_EQ(levels(triangulated_cube, kith::sqrt3(), 2), (table{{8, 18, 12}, {20, 54, 36}, {56, 162, 108}}));
}

TEST(plan, the_unified_scheme_counts_as_catmull_clark_or_as_doo_sabin)
{
    EXPECT_EQ(levels(cube, kith::unified{.degree = 5}, 9), levels(cube, kith::catmull_clark(), 9));
    EXPECT_EQ(levels(cube, kith::unified{.degree = 4}, 9), levels(cube, kith::doo_sabin(), 9));
}

TEST(plan, refuses_a_boundary_for_schemes_that_take_none)
{
    const counts grid{.vertices = 20, .edges = 31, .faces = 12, .boundary_edges = 14};
    EXPECT_EQ(error_text<kith::mesh_error>([&] { plan(grid, kith::unified(), 1); }),
              "unified: the mesh has 14 boundary edges; close it first, or take a scheme with a boundary rule");
}

TEST(plan, the_torus_by_each_scheme)
{
    EXPECT_EQ(levels(torus, kith::catmull_clark(), 1)[1], (table{{1152, 2304, 1152}}[0]));
    EXPECT_EQ(levels(torus, kith::doo_sabin(), 1)[1], (table{{1152, 2304, 1152}}[0]));
    EXPECT_EQ(levels(triangulated_torus, kith::loop(), 1)[1], (table{{1152, 3456, 2304}}[0]));
    EXPECT_EQ(levels(triangulated_torus, kith::sqrt3(), 1)[1], (table{{864, 2592, 1728}}[0]));
}

TEST(plan, sqrt3_splits_the_boundary_in_every_second_step)
{
    const counts triangle{.vertices = 3, .edges = 3, .faces = 1, .boundary_edges = 3};
    const auto from_even = plan(triangle, kith::sqrt3(), 2);
    EXPECT_EQ(from_even[1].counts.boundary_edges, 3U);
    EXPECT_EQ(from_even[2].counts.boundary_edges, 9U);
    EXPECT_EQ(plan(triangle, kith::sqrt3(), 1, 1)[1].counts.boundary_edges, 9U);
}

TEST(plan, no_level_is_a_plan_too)
{
    EXPECT_EQ(plan(cube, kith::catmull_clark(), 0).size(), 1U);
}

TEST(plan, refuses_negative_levels)
{
    EXPECT_EQ(error_text<kith::mesh_error>([] { plan(cube, kith::loop(), -2); }),
              "loop: -2 levels were asked for; ask for 0 or more");
}

TEST(plan, refuses_what_the_index_cannot_number_and_says_what_it_can)
{
    const std::string text = error_text<kith::mesh_error>([] { plan(cube, kith::catmull_clark(), 20); });
    EXPECT_EQ(text,
              "catmull-clark: level 14 has 1610612738 vertices and 3221225472 edges, more than a 32-bit index "
              "can number; refine at most 13 times, in tiles, or on a native mesh with a 64-bit index");
    EXPECT_NO_THROW(plan(cube, kith::catmull_clark(), 13));
    EXPECT_NO_THROW(plan(cube, kith::catmull_clark(), 20, 0, 24, 8));
}

TEST(plan, what_fits_is_planned_and_what_does_not_is_told)
{
    const auto fits = kith::plan_what_fits(cube, kith::catmull_clark(), 20);
    EXPECT_EQ(fits.levels.size(), 14U);
    EXPECT_EQ(fits.levels.back().counts.faces, 6U << 26);
    EXPECT_EQ(fits.problem,
              "level 14 has 1610612738 vertices and 3221225472 edges, more than a 32-bit index can number");
    EXPECT_EQ(kith::plan_what_fits(cube, kith::catmull_clark(), 3).problem, "");
}

TEST(plan, tells_the_shares_of_work_of_levels_that_32_bits_cannot_number)
{
    const auto shares = kith::shares_of_work(cube, kith::catmull_clark{}, 16);
    ASSERT_EQ(shares.size(), 17U);
    EXPECT_EQ(shares.front(), 0);
    EXPECT_EQ(shares.back(), 1);
    EXPECT_NEAR(shares[15], .25, 1e-9);
}

TEST(plan, refuses_what_64_bits_cannot_count)
{
    const auto by = [](int n) {
        return error_text<kith::mesh_error>([n] { plan(cube, kith::doo_sabin(), n, 0, 24, 8); });
    };
    const std::string text = by(1000);
    const std::string most = text.substr(text.find("refine at most ") + 15);
    EXPECT_NE(text.find("whose size in bytes exceeds 64 bits"), std::string::npos);
    EXPECT_EQ(by(std::stoi(most)), "no error");
}

TEST(plan, tells_bytes_of_points_and_of_all_arrays)
{
    const auto level = plan(cube, kith::catmull_clark(), 1)[1]; // 26 points, 24 quads, 96 corners, 96 half-edges
    EXPECT_EQ(level.least_bytes, 26U * 24 + 96 * 4);
    EXPECT_EQ(level.bytes, 26U * 24 + (96 + 96 + 96 + 26) * 4);
}

TEST(plan, the_peak_is_all_levels_or_the_last_two)
{
    const std::vector<kith::planned_level> levels{{{}, 10, 1}, {{}, 40, 5}, {{}, 160, 20}};
    EXPECT_EQ(kith::peak_bytes(levels, true), 210U);
    EXPECT_EQ(kith::peak_bytes(levels, false), 200U);
    EXPECT_EQ(kith::peak_bytes(levels, true, true), 70U);
    EXPECT_EQ(kith::peak_bytes(levels, false, true), 60U);
}

TEST(plan, the_peak_may_be_before_the_last_level)
{
    EXPECT_EQ(kith::peak_bytes({{{}, 100, 10}, {{}, 100, 10}, {{}, 400, 5}}, false, true), 200U);
}

TEST(plan, its_bytes_do_not_wrap)
{
    for (int n = 1; n < 26; ++n) {
        const auto levels = plan(cube, kith::catmull_clark(), n - 1, 0, 24, 8);
        if (n > 1) {
            EXPECT_GT(levels.back().bytes, 2 * levels[levels.size() - 2].bytes) << n;
        }
    }
}
