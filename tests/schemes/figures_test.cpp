// SPDX-License-Identifier: BSD-3-Clause
#include "support/figure_bodies.hpp"
#include "support/native_shape.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/hierarchy.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

/// Expects a closed manifold with these numbers of elements.
void expect_closed(const figures::shape& shape, std::size_t vertices, std::size_t edges, std::size_t faces)
{
    const auto mesh = native(shape);
    EXPECT_EQ(mesh.vertex_count(), vertices);
    EXPECT_EQ(mesh.edge_count(), edges);
    EXPECT_EQ(mesh.face_count(), faces);
    EXPECT_EQ(count(mesh.topology()).boundary_edges, 0U);
}

/// Returns the volume, which is positive if faces are counter-clockwise seen from outside.
double volume(const figures::shape& shape)
{
    double result = 0;
    const auto triangles = figures::triangulated(shape);
    for (const auto& f : triangles.faces) {
        const auto &a = shape.points[f[0]], &b = shape.points[f[1]], &c = shape.points[f[2]];
        result += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0])) /
                  6;
    }
    return result;
}

} // namespace

TEST(figures, have_the_counts_that_they_tell)
{
    expect_closed(figures::cube(), 8, 12, 6);
    expect_closed(figures::triangulated(figures::cube()), 8, 18, 12);
    expect_closed(figures::pentacube(), 11, 20, 11);
    expect_closed(figures::torus(), 288, 576, 288);
    expect_closed(figures::t_shape(), 20, 36, 18);
    expect_closed(figures::hollow_cube(), 64, 144, 72); // V - E + F = 2 - 2 * 5
    expect_closed(figures::axe(), 28, 54, 30);          // two bodies
    expect_closed(figures::gourd(), 326, 972, 648);
    expect_closed(figures::rook(), 130, 384, 256);
    expect_closed(figures::cupid(), 6713, 14235, 7532); // V - E + F = 2 * 5
}

TEST(figures, face_outwards)
{
    EXPECT_NEAR(volume(figures::cube()), 8, 1e-14);
    EXPECT_NEAR(volume(figures::t_shape()), 4, 1e-14);
    EXPECT_NEAR(volume(figures::hollow_cube()), 20, 1e-13);
    EXPECT_GT(volume(figures::pentacube()), 0);
    EXPECT_GT(volume(figures::torus()), 0);
    EXPECT_NEAR(volume(figures::revolved({{1, 0}, {1, 2}}, 400, 0, 2)), 2 * std::acos(-1.), 1e-3); // a cylinder
    for (const auto& body : {figures::axe(), figures::gourd(), figures::rook(), figures::cupid()})
        EXPECT_GT(volume(body), 0);
}

TEST(figures, cubes_share_their_corners_and_hide_their_common_faces)
{
    const auto two = figures::cubes({{0, 0, 0}, {0, 0, 1}});
    EXPECT_EQ(two.points.size(), 12U);
    EXPECT_EQ(two.faces.size(), 10U);
    EXPECT_NEAR(volume(two), 2, 1e-15);
}

TEST(figures, the_t_stays_flat_within_its_creases)
{
    const auto creases = figures::t_shape_creases();
    ASSERT_EQ(creases.size(), 10U);
    const auto control = native(figures::t_shape());
    const kith::level_of<mesh3d> level(control);
    kith::catmull_clark scheme;
    for (const auto& [a, b] : creases) {
        EXPECT_EQ(control.point(a)[2], 1);
        EXPECT_EQ(control.point(b)[2], 1);
        scheme.sharpness.sharpen_edge(index_tuple(level.vertices()[a], level.vertices()[b]).value,
                                      kith::infinitely_sharp);
    }
    const auto height = [&](const kith::catmull_clark& s) {
        double result = -1;
        const auto fine = kith::refine(control, s, 3);
        for (const auto& p : fine.points())
            result = std::max(result, p[2]);
        return result;
    };
    EXPECT_EQ(height(scheme), 1);
    EXPECT_LT(height(kith::catmull_clark()), 0.99);
}
