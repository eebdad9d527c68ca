// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/base/counts.hpp>

#include <gtest/gtest.h>

TEST(counts, corners_are_the_sides_of_edges_that_have_a_face)
{
    EXPECT_EQ((kith::counts{.vertices = 8, .edges = 12, .faces = 6}.corners()), 24U);
    EXPECT_EQ((kith::counts{.vertices = 3, .edges = 3, .faces = 1, .boundary_edges = 3}.corners()), 3U);
}

TEST(counts, there_are_as_many_boundary_vertices_as_boundary_edges)
{
    EXPECT_EQ((kith::counts{.vertices = 9, .edges = 12, .faces = 4, .boundary_edges = 8}.boundary_vertices()), 8U);
}
