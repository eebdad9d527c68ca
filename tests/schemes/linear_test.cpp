// SPDX-License-Identifier: BSD-3-Clause
#include <kith/linear.hpp>

#include "support/exact_mesh.hpp"

#include <kith/refine.hpp>

#include <gtest/gtest.h>

TEST(linear, moves_nothing)
{
    const auto fine = kith::refine(exact(shapes::cube()), kith::linear(), 2);
    for (std::size_t v = 0; v < 8; ++v)
        EXPECT_EQ(fine.point(v), exact(shapes::cube()).point(v));
}

TEST(linear, adds_midpoints_and_centroids)
{
    const auto cube = exact(shapes::cube());
    const auto fine = kith::refine(cube, kith::linear(), 1);
    EXPECT_EQ(fine.point(8 + edge_number(cube, 5, 6)), (exact_point{1, 0, 1}));
    EXPECT_EQ(fine.point(8 + 12 + 1), (exact_point{0, 0, 1}));
}

TEST(linear, splits_triangles_into_four_triangles)
{
    const auto fine = kith::refine(exact(shapes::tetrahedron()), kith::linear_triangles(), 1);
    EXPECT_EQ(fine.face_count(), 16U);
    EXPECT_EQ(fine.topology().degree, 3);
    EXPECT_EQ(fine.point(4 + edge_number(exact(shapes::tetrahedron()), 0, 1)), (exact_point{1, 0, 0}));
}
