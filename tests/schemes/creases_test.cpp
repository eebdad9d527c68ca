// SPDX-License-Identifier: BSD-3-Clause
#include <kith/schemes/crease/creases.hpp>

#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/hierarchy.hpp>
#include <kith/make_creases.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using kith::creases;
using kith::infinitely_sharp;

namespace {

using level_type = kith::level_of<mesh3d>;

/// A 4 x 4 grid of quads, with vertices numbered row by row.
struct plane {
    mesh3d mesh = native(shapes::grid(4, 4));
    level_type level{mesh};

    std::size_t edge(std::size_t a, std::size_t b) const { return level.index(edge_between(level, a, b)); }
    auto edge_of(std::size_t a, std::size_t b) const { return level.edges()[edge(a, b)]; }
    auto vertex(std::size_t v) const { return level.vertices()[v]; }
};

} // namespace

TEST(creases, nothing_is_sharp_at_first)
{
    const creases none;
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(none.of_edge(3), 0.);
    EXPECT_EQ(none.of_vertex(0), 0.);
}

TEST(creases, sharpness_can_be_set_changed_and_taken_back)
{
    creases sharp;
    sharp.sharpen_edge(7, 2);
    sharp.sharpen_edge(3, infinitely_sharp);
    sharp.sharpen_vertex(3, 1.5);
    sharp.sharpen_edge(7, 1);
    EXPECT_EQ(sharp.of_edge(7), 1.);
    EXPECT_EQ(sharp.of_edge(3), infinitely_sharp);
    EXPECT_EQ(sharp.of_vertex(3), 1.5);
    sharp.sharpen_edge(7, 0);
    EXPECT_EQ(sharp.edges().size(), 1U);
}

TEST(creases, boundary_edges_are_sharp_by_nature)
{
    const plane p;
    EXPECT_EQ(creases().sharpness(p.edge_of(0, 1)), infinitely_sharp);
    EXPECT_EQ(creases().sharpness(p.edge_of(6, 7)), 0.);
}

TEST(creases, uniform_ones_lose_one_per_level)
{
    const plane p;
    creases sharp;
    sharp.sharpen_edge(p.edge(6, 7), 2.5);
    sharp.sharpen_edge(p.edge(7, 8), 0.5);
    sharp.sharpen_edge(p.edge(8, 13), infinitely_sharp);
    EXPECT_EQ(sharp.child_sharpness(p.vertex(7), p.edge_of(6, 7)), 1.5);
    EXPECT_EQ(sharp.child_sharpness(p.vertex(7), p.edge_of(7, 8)), 0.);
    EXPECT_EQ(sharp.child_sharpness(p.vertex(8), p.edge_of(8, 13)), infinitely_sharp);
}

TEST(creases, chaikin_ones_mix_with_their_neighbours)
{
    const plane p;
    creases sharp(kith::crease_method::chaikin);
    sharp.sharpen_edge(p.edge(6, 7), 2);
    sharp.sharpen_edge(p.edge(7, 8), 4);
    EXPECT_EQ(sharp.child_sharpness(p.vertex(7), p.edge_of(6, 7)), 3. / 4 * 2 + 1. / 4 * 4 - 1);
    EXPECT_EQ(sharp.child_sharpness(p.vertex(6), p.edge_of(6, 7)), 1.); // no other sharp edge there
}

TEST(creases, an_infinitely_sharp_line_is_a_cubic_curve)
{
    const plane p;
    kith::catmull_clark scheme;
    for (const std::size_t v : {10U, 11U, 12U, 13U}) // the middle row
        scheme.sharpness.sharpen_edge(p.edge(v, v + 1), infinitely_sharp);
    const auto fine = kith::refine(p.mesh, scheme, 1);
    const auto z = [&](std::size_t v) { return p.mesh.point(v)[2]; };
    EXPECT_DOUBLE_EQ(fine.point(12)[2], (z(11) + 6 * z(12) + z(13)) / 8);
    EXPECT_DOUBLE_EQ(fine.point(25 + p.edge(11, 12))[2], (z(11) + z(12)) / 2);
}

TEST(creases, a_cube_of_sharp_edges_stays_a_cube)
{
    kith::catmull_clark scheme{.corners = {}, .sharpness = creases_by_angle(native(shapes::cube()), 30)};
    const auto fine = kith::refine(native(shapes::cube()), scheme, 3);
    double farthest = 0;
    for (const auto& [x, y, z] : fine.points())
        farthest = std::max(farthest, std::abs(std::max({std::abs(x), std::abs(y), std::abs(z)}) - 1));
    EXPECT_EQ(farthest, 0);
    EXPECT_EQ(fine.point(6), (shapes::point{1, 1, 1}));
}

TEST(creases, a_dart_has_a_smooth_end)
{
    const plane p;
    kith::catmull_clark scheme;
    scheme.sharpness.sharpen_edge(p.edge(10, 11), infinitely_sharp);
    scheme.sharpness.sharpen_edge(p.edge(11, 12), infinitely_sharp);
    const auto smooth = kith::refine(p.mesh, kith::catmull_clark(), 1).point(12);
    const auto dart = kith::refine(p.mesh, scheme, 1).point(12);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_DOUBLE_EQ(dart[i], smooth[i]);
}

TEST(creases, three_sharp_edges_make_a_corner)
{
    const plane p;
    kith::catmull_clark scheme;
    for (const std::size_t v : {11U, 7U, 13U})
        scheme.sharpness.sharpen_edge(p.edge(v, 12), infinitely_sharp);
    EXPECT_EQ(kith::refine(p.mesh, scheme, 1).point(12), p.mesh.point(12));
}

TEST(creases, every_level_of_a_hierarchy_has_its_own)
{
    const plane p;
    kith::catmull_clark scheme;
    scheme.sharpness.sharpen_edge(p.edge(6, 7), 2);
    scheme.sharpness.sharpen_vertex(12, 1.5);
    kith::hierarchy levels(p.mesh, scheme);
    levels.refine(3);
    EXPECT_EQ(levels.scheme(1).sharpness.edges().size(), 2U);
    EXPECT_EQ(levels.scheme(1).sharpness.edges()[0].second, 1.);
    EXPECT_EQ(levels.scheme(1).sharpness.of_vertex(12), 0.5);
    EXPECT_TRUE(levels.scheme(2).sharpness.empty());
}

TEST(creases, those_of_another_mesh_are_refused)
{
    const auto cube = native(shapes::cube());
    const auto refusal = [&](const creases& sharp) {
        return error_text<kith::mesh_error>([&] { kith::refine(cube, kith::catmull_clark{.sharpness = sharp}, 1); });
    };
    creases sharp;
    sharp.sharpen_edge(12, 1);
    EXPECT_EQ(refusal(sharp),
              "creases: edge 12 does not exist, there are 12; make the creases for this mesh and level");
    sharp.sharpen_edge(12, 0);
    sharp.sharpen_vertex(8, infinitely_sharp);
    EXPECT_EQ(refusal(sharp),
              "creases: vertex 8 does not exist, there are 8; make the creases for this mesh and level");
}

TEST(creases, what_is_given_at_the_boundary_passes_like_the_rest)
{
    const plane p;
    for (const auto method : {kith::crease_method::uniform, kith::crease_method::chaikin}) {
        kith::catmull_clark scheme;
        scheme.sharpness.method = method;
        scheme.sharpness.sharpen_edge(p.edge_of(0, 1).index(), 1.5);
        scheme.sharpness.sharpen_edge(p.edge_of(1, 2).index(), infinitely_sharp);
        kith::hierarchy levels(p.mesh, scheme);
        levels.refine(2);
        std::vector<double> after_one, after_two;
        for (const auto& [edge, sharpness] : levels.scheme(1).sharpness.edges())
            after_one.push_back(sharpness);
        for (const auto& [edge, sharpness] : levels.scheme(2).sharpness.edges())
            after_two.push_back(sharpness);
        std::ranges::sort(after_one);
        EXPECT_EQ(after_one, (std::vector{.5, .5, infinitely_sharp, infinitely_sharp}));
        EXPECT_EQ(after_two, std::vector(4, infinitely_sharp));
    }
}
