// SPDX-License-Identifier: BSD-3-Clause
#include <kith/closest_points.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/own_state.hpp"
#include "support/thread_count.hpp"

#include <kith/surface.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using point = std::array<double, 3>;

double distance(const point& a, const point& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Expects that no point of a fine tessellation is nearer, and that the results lie at their places.
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

/// Shows that a point off the surface along a normal finds the start of the normal, to many digits.
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

/// Shows that the nearer of two bumps in one face is found, although the other bump is a local minimum.
TEST(closest_points, tell_apart_minima_in_one_face)
{
    shapes::shape shape = shapes::grid(3, 3);
    for (auto& p : shape.points)
        p = {p[0], p[1], 0};
    auto mesh = native(shape);
    const std::size_t face = mesh.face_count() / 2; // a face in the middle
    const auto corners = mesh.face(face);
    std::vector<point> control(mesh.points().begin(), mesh.points().end());
    control[corners[0]][2] = control[corners[2]][2] = 2.5; // a bump at two opposite corners
    mesh = kith::make_mesh(control, shape.faces);
    kith::surface_locator surface(mesh, kith::catmull_clark{});
    const auto at = surface.locate(std::vector<kith::surface_place>{{face, .1, .1, 0}, {face, .9, .9, 0}})
                        .evaluate(mesh.points());
    std::vector<point> queries;
    for (int i = 0; i <= 20; ++i) {
        const double t = i / 20.;
        queries.push_back({});
        for (std::size_t x = 0; x < 3; ++x)
            queries.back()[x] = (1 - t) * at.points[0][x] + t * at.points[1][x] + (x == 2 ? .1 : 0);
    }
    const auto found = kith::closest_points(mesh, kith::catmull_clark{}).of(queries);
    const auto fine = tessellate(mesh, kith::catmull_clark{}, {.segments = 100});
    std::size_t near_first = 0, near_second = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        double sampled = std::numeric_limits<double>::infinity();
        for (const point& p : fine.mesh.points())
            sampled = std::min(sampled, distance(p, queries[i]));
        EXPECT_LE(found[i].distance, sampled + 1e-14) << i;
        EXPECT_GT(found[i].distance, sampled - 1e-3) << i;
        near_first += found[i].place.face == face and found[i].place.u < .5 and found[i].place.v < .5;
        near_second += found[i].place.face == face and found[i].place.u > .5 and found[i].place.v > .5;
    }
    EXPECT_GE(near_first, 4U);
    EXPECT_GE(near_second, 4U);
}

/// Shows the known distances to a corner and a side of a flat face, to its inside, and to a vertex.
TEST(closest_points, are_exact_on_flat_faces)
{
    const std::vector<point> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<std::array<int, 4>> faces{{0, 1, 2, 3}};
    const auto found = kith::closest_points(kith::make_mesh(corners, faces), kith::linear{})
                           .of(std::vector<point>{{-3, -4, 0}, {.25, .75, 2}, {2, .5, 0}, {1, 1, 0}, {.5, .5, -1e6}});
    const std::array<double, 5> expected{5, 2, 1, 0, 1e6};
    const std::array<point, 5> feet{{{0, 0, 0}, {.25, .75, 0}, {1, .5, 0}, {1, 1, 0}, {.5, .5, 0}}};
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].distance, expected[i], 1e-13) << i;
        EXPECT_LT(distance(found[i].point, feet[i]), i == 4 ? 1e-9 : 1e-14) << i;
    }
}

TEST(closest_points, are_the_same_bits_on_threads)
{
    const auto mesh = native(shapes::shaken(shapes::house()));
    std::minstd_rand random(1);
    std::vector<point> queries(300);
    for (auto& q : queries)
        for (double& x : q)
            x = 4 * double(random()) / double(std::minstd_rand::max()) - 2;
    const auto make = [&](int threads) {
        const thread_count count(threads);
        return kith::closest_points(mesh, kith::catmull_clark{}).of(queries);
    };
    const auto one = make(1), three = make(3);
    for (std::size_t i = 0; i < queries.size(); ++i)
        EXPECT_TRUE(one[i].place == three[i].place and one[i].distance == three[i].distance) << i;
}

TEST(closest_points, refuse_schemes_that_are_no_splines)
{
    const auto mesh = native(shapes::triangulated(shapes::torus(5, 6)));
    const std::string expected = "the control points of this scheme do not bound its surface, which is no spline among "
                                 "regular faces or has negative weights; search a tessellation instead";
    EXPECT_EQ(error_text<kith::mesh_error>([&] { const kith::closest_points surface(mesh, kith::butterfly{}); }),
              expected);
    const auto quads = native(shapes::torus(5, 6));
    EXPECT_EQ(
        error_text<kith::mesh_error>([&] { const kith::closest_points surface(quads, own_state::some_drawn(quads)); }),
        expected);
    const auto grid = native(shapes::grid(3, 3));
    EXPECT_EQ(error_text<kith::mesh_error>([&] { const kith::closest_points surface(grid, kith::doo_sabin{}); }),
              "face 0 touches the boundary, where doo-sabin has no polynomials; close the mesh or search a "
              "tessellation");
    const auto polygon = native(shapes::polygon(5));
    EXPECT_EQ(error_text<kith::mesh_error>([&] {
                  static_cast<void>(kith::closest_points(polygon, kith::nasri_hasbini{}).of(std::vector<point>(1)));
              }),
              "searches of nasri-hasbini take faces of 4 vertices only; search the surface of the next level");
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
