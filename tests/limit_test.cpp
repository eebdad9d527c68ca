// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limit.hpp>

#include "golden.hpp"
#include "golden_schemes.hpp"
#include "native_shape.hpp"
#include "same_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using kith::hierarchy;

std::size_t compared = 0;

/// The limit points of a file are those of the vertices at the same places on level 1; without one there, none here.
void expect_limits(const golden::file& f, const auto& control, const auto& scheme)
{
    SCOPED_TRACE(f.name);
    hierarchy levels(control, scheme);
    levels.refine();
    const auto limits = limit_positions(levels.elements(1), levels.scheme(1));
    const auto& golden = f.levels[1];
    for (std::size_t i = 0; i < golden.limit_points.size(); ++i) {
        const auto distance = [&](const auto& p) {
            return std::hypot(p[0] - golden.vertices[i][0], p[1] - golden.vertices[i][1], p[2] - golden.vertices[i][2]);
        };
        const auto points = levels[1].points();
        const auto v = std::size_t(std::ranges::min_element(points, {}, distance) - points.begin());
        ASSERT_EQ(limits[v].has_value(), golden.limit_points[i].has_value()) << "golden vertex " << i;
        for (std::size_t k = 0; limits[v] and k < 3; ++k)
            EXPECT_NEAR((*limits[v])[k], (*golden.limit_points[i])[k], 1e-13) << "golden vertex " << i;
        ++compared;
    }
}

/// Further levels come nearer to the limit of each vertex, and it stays the same.
template <class Scheme>
void expect_convergence(const mesh3d& control, const Scheme& scheme)
{
    hierarchy levels(control, scheme);
    levels.refine(6);
    const auto limits = limit_positions(levels.elements(2), levels.scheme(2));
    const auto again = limit_positions(levels.elements(4), levels.scheme(4));
    std::size_t count = 0;
    for (std::size_t v = 0; v < limits.size(); ++v)
        if (limits[v]) {
            ++count;
            ASSERT_TRUE(again[v]);
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_NEAR((*limits[v])[i], (*again[v])[i], 1e-13);
                EXPECT_NEAR((*limits[v])[i], levels[6].point(v)[i], 2e-2);
            }
        }
    EXPECT_GE(2 * count, limits.size());
}

void expect_normal(const auto& normal, const shapes::point& should_be)
{
    ASSERT_TRUE(normal);
    const double length = std::hypot(should_be[0], should_be[1], should_be[2]);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR((*normal)[i], should_be[i] / length, 1e-14);
}

} // namespace

TEST(limit, positions_of_catmull_clark_are_golden)
{
    compared = 0;
    catmull_clark_on<native_mesh<double>>::for_each([](const auto&... x) { expect_limits(x...); });
    EXPECT_EQ(compared, 26U + 42 + 49 + 14); // of the cube, the mixed polygons, the grid and the tetrahedron
}

TEST(limit, positions_of_loop_are_golden)
{
    compared = 0;
    loop_on<native_mesh<double>>::for_each([](const auto&... x) { expect_limits(x...); });
    EXPECT_EQ(compared, 10U + 26 + 49 + 62);
}

TEST(limit, levels_converge_to_it)
{
    expect_convergence(native(shapes::shaken(shapes::open_house())), kith::catmull_clark());
    expect_convergence(native(shapes::shaken(shapes::umbrella(7))), kith::loop());
    expect_convergence(native(shapes::shaken(shapes::umbrella(5))), kith::sqrt3());
}

TEST(limit, positions_are_known_after_one_step_where_faces_are_no_quads)
{
    hierarchy levels(native(shapes::house()), kith::catmull_clark());
    levels.refine();
    EXPECT_FALSE(limit_positions(levels.elements(0), levels.scheme(0))[0]);
    EXPECT_TRUE(limit_positions(levels.elements(1), levels.scheme(1))[0]);
}

TEST(limit, the_corner_of_the_cube)
{
    const hierarchy levels(native(shapes::cube()), kith::catmull_clark());
    const auto limit = limit_positions(levels.elements(0), levels.scheme(0))[6];
    ASSERT_TRUE(limit);
    // n = 3: (9 v + 4 (e1 + e2 + e3) + d1 + d2 + d3) / 24 = (9 + 4 - 1) / 24 in each coordinate
    for (const double x : *limit)
        EXPECT_DOUBLE_EQ(x, 1. / 2);
}

TEST(limit, normals_of_the_cube_point_outward)
{
    const hierarchy levels(native(shapes::cube()), kith::catmull_clark());
    const auto normals = limit_normals(levels.elements(0), levels.scheme(0));
    for (std::size_t v = 0; v < 8; ++v)
        expect_normal(normals[v], levels[0].point(v));
}

TEST(limit, normals_of_a_plane_are_upright_at_the_boundary_too)
{
    auto plane = shapes::grid(3, 4);
    for (auto& p : plane.points)
        p = {p[0] + p[1] / 4, p[1], 0};
    const hierarchy quads(native(plane), kith::catmull_clark());
    for (const auto& normal : limit_normals(quads.elements(0), quads.scheme(0)))
        expect_normal(normal, {0, 0, 1});
    const hierarchy triangles(native(shapes::triangulated(plane)), kith::loop());
    for (const auto& normal : limit_normals(triangles.elements(0), triangles.scheme(0)))
        expect_normal(normal, {0, 0, 1});
}
