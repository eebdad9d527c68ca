// SPDX-License-Identifier: BSD-3-Clause
#include <kith/butterfly.hpp>

#include "support/all_shapes.hpp"
#include "support/regular_masks.hpp"

#include <kith/presets.hpp>

#include <gtest/gtest.h>

#include <numeric>

TEST(butterfly, keeps_all_points)
{
    for (const auto& [name, shape] : shapes::triangle_shapes()) {
        const auto fine = kith::refine(native(shape), kith::butterfly(), 2);
        for (std::size_t v = 0; v < shape.points.size(); ++v)
            EXPECT_EQ(fine.point(v), shape.points[v]) << name;
    }
}

TEST(butterfly, has_eight_weights_between_regular_vertices)
{
    expect_weights(weights_of(regular_triangles, kith::butterfly(), edge_handle{0}),
                   {1. / 2, 1. / 2, 1. / 8, 1. / 8, -1. / 16, -1. / 16, -1. / 16, -1. / 16});
}

TEST(butterfly, is_the_four_point_curve_on_the_boundary)
{
    const auto grid = shapes::triangulated(shapes::grid(2, 4));
    const auto mesh = native(grid);
    const kith::level_of<mesh3d> level(mesh);
    const edge_handle edge = level.edge_at(index_tuple(level.vertices()[1], level.vertices()[2]).value);
    expect_weights(weights_of(grid, kith::butterfly(), edge), {9. / 16, 9. / 16, -1. / 16, -1. / 16});
}

TEST(butterfly, weights_of_a_ring_sum_to_a_quarter)
{
    for (std::size_t n = 3; n < 30; ++n) {
        const auto row = kith::butterfly::ring_weights(n);
        EXPECT_EQ(row.size(), n);
        EXPECT_NEAR(std::accumulate(row.begin(), row.end(), 0.), 1. / 4, 1e-15);
    }
}

TEST(butterfly, is_in_openmesh_too)
{
    EXPECT_NO_THROW(kith::like<kith::butterfly>(kith::library::openmesh));
    EXPECT_THROW(kith::like<kith::butterfly>(kith::library::cgal), kith::mesh_error);
}
