// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/level/level_elements.hpp>

#include "support/every_level.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using indices = std::vector<std::size_t>;

indices numbers(const auto& range)
{
    indices result;
    for (const auto& x : range)
        result.push_back(x.index());
    return result;
}

/// A grid of 3 x 3 vertices, numbered row by row. Faces 0 and 1 are below, faces 2 and 3 above.
struct small_grid {
    mesh3d mesh = native(shapes::grid(2, 2));
    level_type level{mesh};

    auto v(std::size_t i) const { return level.vertices()[i]; }
};

} // namespace

TEST(elements, a_face_lists_its_vertices_counter_clockwise)
{
    const small_grid g;
    EXPECT_EQ(numbers(g.level.faces()[2].vertices()), (indices{3, 4, 7, 6}));
    EXPECT_EQ(g.level.faces()[2].degree(), 4U);
}

TEST(elements, an_inner_vertex_lists_its_neighbours_counter_clockwise)
{
    const small_grid g;
    EXPECT_EQ(numbers(g.v(4).neighbors()), (indices{1, 5, 7, 3}));
    EXPECT_EQ(numbers(g.v(4).faces()), (indices{1, 3, 2, 0}));
    EXPECT_EQ(g.v(4).valence(), 4U);
    for (std::size_t n = 0; n < 8; ++n)
        EXPECT_EQ(g.v(4).has_valence(n), n == 4);
    EXPECT_FALSE(g.v(4).is_boundary());
}

TEST(elements, a_boundary_vertex_lists_its_neighbours_from_rim_to_rim)
{
    const small_grid g;
    EXPECT_EQ(numbers(g.v(1).neighbors()), (indices{2, 4, 0}));
    EXPECT_EQ(numbers(g.v(1).faces()), (indices{1, 0}));
    EXPECT_EQ(g.v(1).valence(), 3U);
    for (std::size_t n = 0; n < 8; ++n)
        EXPECT_EQ(g.v(1).has_valence(n), n == 3);
    EXPECT_EQ(g.v(1).face_count(), 2U);
    EXPECT_TRUE(g.v(1).is_boundary());
    EXPECT_EQ(g.v(1).first_rim().index(), 2U);
    EXPECT_EQ(g.v(1).last_rim().index(), 0U);
}

TEST(elements, a_vertex_knows_those_opposite_in_its_faces)
{
    const small_grid g;
    EXPECT_EQ(numbers(g.v(4).opposites()), (indices{2, 8, 6, 0}));
    EXPECT_EQ(numbers(g.v(1).opposites()), (indices{5, 3}));
}

TEST(elements, a_fan_can_start_at_any_corner)
{
    const small_grid g;
    const auto second = g.v(4).first_corner().prev().across();
    EXPECT_EQ(numbers(second.fan_from_here().map([](const auto& c) { return c.f(); })), (indices{3, 2, 0, 1}));
}

TEST(elements, a_walk_can_leave_some_out)
{
    const small_grid g;
    const auto odd = [](const auto& v) { return v.index() % 2 == 1; };
    EXPECT_EQ(numbers(g.v(1).neighbors().only(odd)), (indices{}));
    EXPECT_EQ(numbers(g.level.faces()[3].vertices().only(odd)), (indices{5, 7}));
    EXPECT_EQ(numbers(g.v(4).neighbors().only([](const auto& v) { return v.index() > 1; })), (indices{5, 7, 3}));
}

TEST(elements, a_corner_of_the_surface_has_two_edges_and_one_face)
{
    const small_grid g;
    EXPECT_EQ(numbers(g.v(0).neighbors()), (indices{1, 3}));
    EXPECT_EQ(g.v(0).valence(), 2U);
    EXPECT_EQ(g.v(0).last_corner(), g.v(0).first_corner());
}

TEST(elements, a_face_is_at_the_boundary_when_one_of_its_edges_is)
{
    const auto mesh = native(shapes::grid(3, 3));
    const level_type level(mesh);
    for (const auto f : level.faces())
        EXPECT_EQ(f.is_boundary(), f.index() != 4);
}

TEST(elements, a_vertex_of_valence_two_has_two_faces_that_share_two_edges)
{
    const auto mesh = native(shapes::valence_two());
    const level_type level(mesh);
    const auto v = level.vertices()[3];
    EXPECT_FALSE(v.is_boundary());
    EXPECT_EQ(numbers(v.neighbors()), (indices{0, 2}));
    EXPECT_EQ(numbers(v.faces()), (indices{0, 1}));
}

TEST(elements, ranges_of_all_elements_know_their_size)
{
    const small_grid g;
    EXPECT_EQ(g.level.vertices().size(), 9U);
    EXPECT_EQ(g.level.edges().size(), 12U);
    EXPECT_EQ(g.level.faces().size(), 4U);
    EXPECT_EQ(g.level.corners().size(), 16U);
    EXPECT_EQ(numbers(g.level.faces()), (indices{0, 1, 2, 3}));
}
