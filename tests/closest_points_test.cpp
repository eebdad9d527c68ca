// SPDX-License-Identifier: BSD-3-Clause
#include <kith/closest_points.hpp>

#include "error_text.hpp"
#include "every_scheme.hpp"

#include <kith/surface.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace {

using point = std::array<double, 3>;

double distance(const point& a, const point& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Expects that no point of a fine tessellation is nearer, and that the results lie where they say.
template <class Scheme>
void expect_nearest(const mesh3d& mesh, const Scheme& scheme)
{
    std::minstd_rand random(1);
    std::vector<point> queries(60);
    for (auto& q : queries)
        for (double& x : q)
            x = 4 * double(random()) / double(std::minstd_rand::max()) - 2;
    const auto found = kith::closest_points(mesh, scheme).of(queries);
    const auto fine = tessellate(mesh, scheme, {.segments = 24});
    kith::surface_locator surface(mesh, scheme);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        double sampled = std::numeric_limits<double>::infinity();
        for (const point& p : fine.mesh.points())
            sampled = std::min(sampled, distance(p, queries[i]));
        EXPECT_LE(found[i].distance, sampled + 1e-12) << "point " << i;
        EXPECT_GT(found[i].distance, sampled - .05) << "point " << i;
        EXPECT_NEAR(distance(found[i].point, queries[i]), found[i].distance, 1e-15);
        const auto there = surface.locate(std::vector{found[i].place}).evaluate(mesh.points());
        EXPECT_LT(distance(there.points[0], found[i].point), 1e-14);
    }
}

TEST(closest_points, are_nearer_than_all_samples)
{
    expect_nearest(native(shapes::cube()), kith::catmull_clark{});
    expect_nearest(native(shapes::shaken(shapes::house())), kith::catmull_clark{});
    expect_nearest(native(shapes::shaken(shapes::grid(3, 3))), kith::catmull_clark{});
    const auto torus = native(shapes::shaken(shapes::triangulated(shapes::torus(5, 6))));
    expect_nearest(torus, kith::loop{});
    kith::loop creased;
    for (std::size_t e = 0; e < torus.edge_count(); e += 4)
        creased.sharpness.sharpen_edge(e, kith::infinitely_sharp);
    expect_nearest(torus, creased);
    expect_nearest(native(shapes::triangulated(shapes::grid(2, 2))), kith::loop{});
}

/// A point that lies off the surface along a normal has its foot there, to many digits.
TEST(closest_points, find_the_foot_of_a_normal)
{
    const auto mesh = native(shapes::shaken(shapes::triangulated(shapes::torus(5, 6))));
    kith::surface_locator surface(mesh, kith::loop{});
    std::vector<kith::surface_place> places;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        places.push_back({f, .1 + .01 * double(f % 7), .3 + .02 * double(f % 11), 0});
    const auto values = surface.locate(places).evaluate(mesh.points(), kith::derivatives::first);
    const auto normals = normals_of(values);
    std::vector<point> queries;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (const double off : {1e-3, -1e-3})
            queries.push_back({values.points[i][0] + off * normals[i][0],
                               values.points[i][1] + off * normals[i][1],
                               values.points[i][2] + off * normals[i][2]});
    const auto found = kith::closest_points(mesh, kith::loop{}).of(queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        EXPECT_LT(distance(found[i].point, values.points[i / 2]), 1e-11) << i;
        EXPECT_NEAR(found[i].distance, 1e-3, 1e-14);
    }
}

TEST(closest_points, refuse_what_is_not_finite)
{
    kith::closest_points surface(native(shapes::cube()), kith::catmull_clark{});
    EXPECT_TRUE(surface.of({}).empty());
    EXPECT_EQ(error_text<kith::mesh_error>([&] {
                  static_cast<void>(
                      surface.of(std::vector<point>{{0, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}}));
              }),
              "point 1 is not finite; correct it");
}

} // namespace
