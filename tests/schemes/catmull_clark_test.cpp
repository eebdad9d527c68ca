// SPDX-License-Identifier: BSD-3-Clause
#include <kith/catmull_clark.hpp>

#include "support/exact_mesh.hpp"
#include "support/native_shape.hpp"

#include <kith/refine.hpp>

#include <kith/presets.hpp>

#include <gtest/gtest.h>

namespace {

exact_mesh once(const shapes::shape& s, const kith::catmull_clark& scheme = {})
{
    return kith::refine(exact(s), scheme, 1);
}

} // namespace

TEST(catmull_clark, a_corner_of_the_cube_goes_to_five_ninths)
{
    EXPECT_EQ(once(shapes::cube()).point(6), (exact_point{rational(5, 9), rational(5, 9), rational(5, 9)}));
}

TEST(catmull_clark, an_edge_of_the_cube_goes_to_three_quarters)
{
    const auto edge = edge_number(exact(shapes::cube()), 5, 6);
    EXPECT_EQ(once(shapes::cube()).point(8 + edge), (exact_point{rational(3, 4), 0, rational(3, 4)}));
}

TEST(catmull_clark, a_face_of_the_cube_gets_its_centre)
{
    EXPECT_EQ(once(shapes::cube()).point(8 + 12 + 1), (exact_point{0, 0, 1}));
}

TEST(catmull_clark, two_steps_over_fractions_are_exact)
{
    // 1/3 * 5/9 + 1/9 * (3/4 + 3/4 + 0) + 1/9 * 17/12, where 17/12 is the sum of the centres of the quads around.
    EXPECT_EQ(kith::refine(exact(shapes::cube()), kith::catmull_clark(), 2).point(6),
              (exact_point{rational(55, 108), rational(55, 108), rational(55, 108)}));
}

TEST(catmull_clark, faces_of_any_degree_get_their_centroid)
{
    const shapes::shape pentagon{{{0, 0, 0}, {5, 0, 0}, {6, 3, 0}, {3, 5, 0}, {-1, 2, 5}}, {{0, 1, 2, 3, 4}}};
    EXPECT_EQ(once(pentagon).point(10), (exact_point{rational(13, 5), 2, 1}));
    EXPECT_EQ(once(pentagon).face_count(), 5U);
}

TEST(catmull_clark, the_boundary_is_a_cubic_curve)
{
    const auto grid = exact(shapes::grid(2, 4)); // the lower boundary: x = 0 1 2 3 4, z = 0 1/2 1 1/4 3/4
    const auto fine = once(shapes::grid(2, 4));
    EXPECT_EQ(fine.point(2)[2], (rational(1, 2) + 6 * rational(1) + rational(1, 4)) / 8);
    EXPECT_EQ(fine.point(15 + edge_number(grid, 1, 2))[2], rational(3, 4));
}

TEST(catmull_clark, boundary_corners_are_kept_or_smoothed)
{
    const auto kept = once(shapes::grid(2, 4));
    const auto smoothed = once(shapes::grid(2, 4), {.corners = kith::boundary_corner::smoothed, .sharpness = {}});
    EXPECT_EQ(kept.point(0), (exact_point{0, 0, 0}));
    EXPECT_EQ(smoothed.point(0), (exact_point{rational(1, 8), rational(1, 8), rational(5, 32)}));
}

TEST(catmull_clark, an_inner_vertex_of_valence_two_has_a_place)
{
    EXPECT_EQ(kith::refine(native(shapes::valence_two()), kith::catmull_clark(), 1).point(3),
              (shapes::point{0.46875, 0, 0.475}));
}

TEST(catmull_clark, follows_the_boundary_of_other_libraries)
{
    using kith::boundary_corner;
    using kith::library;
    EXPECT_EQ(kith::like<kith::catmull_clark>(library::opensubdiv).corners, boundary_corner::kept);
    EXPECT_EQ(kith::like<kith::catmull_clark>(library::cgal).corners, boundary_corner::smoothed);
    EXPECT_THROW(kith::like<kith::catmull_clark>(library::libigl), kith::mesh_error);
}

TEST(catmull_clark, the_boundary_of_openmesh_takes_thirds)
{
    const auto scheme = kith::like<kith::catmull_clark>(kith::library::openmesh);
    EXPECT_EQ(scheme.boundary, kith::boundary_curve::thirds);
    auto fine = once(shapes::grid(2, 4), scheme); // the lower boundary: x = 0 1 2 3 4, z = 0 1/2 1 1/4 3/4
    EXPECT_EQ(fine.point(0), (exact_point{rational(1, 6), rational(1, 6), rational(5, 24)}));
    EXPECT_EQ(fine.point(1), (exact_point{1, 0, rational(1, 2)}));
    EXPECT_EQ(fine.point(2), (exact_point{2, 0, rational(19, 24)}));

    auto sharp = scheme; // far from a crease and at its end the rule does not change
    sharp.sharpness.sharpen_vertex(7, kith::infinitely_sharp);
    fine = once(shapes::grid(2, 4), sharp);
    EXPECT_EQ(fine.point(2), (exact_point{2, 0, rational(19, 24)}));
    EXPECT_EQ(fine.point(7), exact(shapes::grid(2, 4)).point(7));
}
