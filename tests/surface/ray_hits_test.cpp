// SPDX-License-Identifier: BSD-3-Clause
#include <kith/ray_hits.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/thread_count.hpp"

#include <kith/surface.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace {

using point = std::array<double, 3>;
using kith::surface_ray;

point combined(const point& a, double t, const point& b)
{
    return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
double dot(const point& a, const point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double distance(const point& a, const point& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
point cross(const point& a, const point& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
point random_point(std::minstd_rand& random, double size)
{
    point result{};
    for (double& x : result)
        x = size * (2 * double(random()) / double(std::minstd_rand::max()) - 1);
    return result;
}

/// Returns the parameter of the first hit of a ray on the triangles of a mesh.
template <class Mesh>
std::optional<double> first_hit_of_triangles(const Mesh& mesh, const surface_ray& ray)
{
    std::optional<double> result;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto corners = mesh.face(f);
        const point a = mesh.point(corners[0]);
        const point ab = combined(mesh.point(corners[1]), -1, a), ac = combined(mesh.point(corners[2]), -1, a);
        const point n = cross(ab, ac), off = combined(ray.origin, -1, a);
        const double det = -dot(ray.direction, n);
        const point m = cross(off, ray.direction);
        const double u = dot(ac, m) / det, v = -dot(ab, m) / det, t = dot(off, n) / det;
        if (u >= 0 and v >= 0 and u + v <= 1 and t >= 0 and (not result or t < *result))
            result = t;
    }
    return result;
}

/// Expects random rays to hit where a fine tessellation is hit. Hits must lie on the ray and on the surface.
template <class Scheme>
void expect_hits_of_tessellation(const mesh3d& mesh, const Scheme& scheme)
{
    std::minstd_rand random(1);
    std::vector<surface_ray> rays(150);
    for (auto& ray : rays) {
        ray.origin = random_point(random, 2.5);
        ray.direction = combined(random_point(random, 1), -.5, ray.origin);
    }
    const auto hits = kith::ray_hits(mesh, scheme).of(rays);
    const auto fine = tessellate(mesh, scheme, {.segments = 16}).mesh;
    kith::surface_locator surface(mesh, scheme);
    std::size_t agreeing = 0, common = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto expected = first_hit_of_triangles(fine, rays[i]);
        agreeing += expected.has_value() == hits[i].has_value();
        if (not hits[i])
            continue;
        const auto at = surface.locate(std::vector{hits[i]->place}).evaluate(mesh.points());
        EXPECT_LT(distance(at.points[0], hits[i]->point), 1e-14) << i;
        EXPECT_LT(distance(combined(rays[i].origin, hits[i]->distance, rays[i].direction), hits[i]->point), 1e-12) << i;
        common += expected and std::abs(*expected - hits[i]->distance) < .03;
    }
    const auto hit = std::size_t(std::ranges::count_if(hits, [](const auto& h) { return h.has_value(); }));
    EXPECT_GE(hit, 15U);
    EXPECT_GE(agreeing + 2, rays.size()); // all but rays at the silhouette
    EXPECT_GE(common + 4, hit);
}

TEST(ray_hits, are_those_of_a_fine_tessellation)
{
    expect_hits_of_tessellation(native(shapes::cube()), kith::catmull_clark{});
    expect_hits_of_tessellation(native(shapes::shaken(shapes::house())), kith::catmull_clark{});
    expect_hits_of_tessellation(native(shapes::shaken(shapes::grid(3, 3))), kith::catmull_clark{});
    const auto torus = native(shapes::shaken(shapes::triangulated(shapes::torus(5, 6))));
    expect_hits_of_tessellation(torus, kith::loop{});
    kith::loop creased;
    for (std::size_t e = 0; e < torus.edge_count(); e += 4)
        creased.sharpness.sharpen_edge(e, e % 8 == 0 ? kith::infinitely_sharp : 1.5);
    expect_hits_of_tessellation(torus, creased);
    expect_hits_of_tessellation(native(shapes::shaken(shapes::house())), kith::linear{});
}

/// Expects that rays to points of the surface hit it: inside faces, on edges between faces, at vertices, and on
/// boundaries.
template <class Scheme>
void expect_hits_everywhere(const mesh3d& mesh, const Scheme& scheme)
{
    kith::surface_locator surface(mesh, scheme);
    std::vector<kith::surface_place> places;
    const bool is_triangles = mesh.face(0).size() == 3;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (const auto& [u, v] : {std::array{.3, .4}, {0., 0.}, {1., 0.}, {0., .3}, {.6, 0.}, {1e-9, 2e-9}, {.5, .5}})
            // Near a bend a ray may hit the other face first.
            if (mesh.face(f).size() == (is_triangles ? 3 : 4) and not(std::same_as<Scheme, kith::linear> and u == 1e-9))
                places.push_back({f, u, v});
    const auto values = surface.locate(places).evaluate(mesh.points(), kith::derivatives::first);
    const auto normals = normals_of(values);
    std::minstd_rand random(1);
    std::vector<surface_ray> rays;
    std::vector<std::size_t> place_of_ray;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const point target = values.points[i];
            point direction = random_point(random, 1);
            if (k == 2 and std::isfinite(normals[i][0]))
                direction = normals[i];
            rays.push_back({combined(target, -1e-3, direction), direction}); // from a near point
            place_of_ray.push_back(i);
        }
    const auto hits = kith::ray_hits(mesh, scheme).of(rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_TRUE(hits[i]) << i;
        const std::size_t p = place_of_ray[i];
        EXPECT_LT(hits[i]->distance, 1e-3 + 1e-10) << i;
        if (std::abs(dot(rays[i].direction, normals[p])) > .3) {
            EXPECT_NEAR(hits[i]->distance, 1e-3, 1e-11) << i << " face " << places[p].face;
            EXPECT_LT(distance(hits[i]->point, values.points[p]), 1e-11) << i;
        }
    }
}

TEST(ray_hits, miss_no_edge_and_no_vertex)
{
    expect_hits_everywhere(native(shapes::cube()), kith::catmull_clark{});
    expect_hits_everywhere(native(shapes::shaken(shapes::house())), kith::catmull_clark{});
    expect_hits_everywhere(native(shapes::shaken(shapes::grid(3, 3))), kith::catmull_clark{});
    expect_hits_everywhere(native(shapes::shaken(shapes::triangulated(shapes::torus(5, 6)))), kith::loop{});
    expect_hits_everywhere(native(shapes::triangulated(shapes::grid(2, 2))), kith::loop{});
    expect_hits_everywhere(native(shapes::shaken(shapes::cube())), kith::linear{});
}

/// Makes a tube whose cross-section is a uniform cubic B-spline with 8 control points on the unit circle.
mesh3d tube()
{
    std::vector<point> points;
    std::vector<std::array<int, 4>> faces;
    for (int z = 0; z < 5; ++z)
        for (int k = 0; k < 8; ++k) {
            points.push_back({std::cos(k * std::numbers::pi / 4), std::sin(k * std::numbers::pi / 4), double(z)});
            if (z < 4)
                faces.push_back({8 * z + k, 8 * z + (k + 1) % 8, 8 * z + 8 + (k + 1) % 8, 8 * z + 8 + k});
        }
    return kith::make_mesh(points, faces);
}
const double radius_at_joint = (4 + 2 * std::cos(std::numbers::pi / 4)) / 6;
const double radius_between = (23 * std::cos(std::numbers::pi / 8) + std::cos(3 * std::numbers::pi / 8)) / 24;

TEST(ray_hits, are_exact_on_a_cylinder)
{
    std::vector<surface_ray> rays;
    for (int k = 0; k < 16; ++k) {
        const double angle = k * std::numbers::pi / 8;
        rays.push_back({{0, 0, 1.7}, {2 * std::cos(angle), 2 * std::sin(angle), 0}});
        rays.push_back({{3 * std::cos(angle), 3 * std::sin(angle), 2}, {-std::cos(angle), -std::sin(angle), 0}, 2.5});
    }
    const auto hits = kith::ray_hits(tube(), kith::catmull_clark{}).of(rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double radius = i / 2 % 2 == 0 ? radius_at_joint : radius_between;
        ASSERT_TRUE(hits[i]) << i;
        EXPECT_NEAR(hits[i]->distance, i % 2 == 0 ? radius / 2 : 3 - radius, 1e-14) << i;
        EXPECT_NEAR(hits[i]->point[2], i % 2 == 0 ? 1.7 : 2, 1e-14) << i;
    }
}

TEST(ray_hits, see_where_rays_graze)
{
    std::vector<surface_ray> rays;
    for (const double off : {-1e-4, -1e-7, -1e-10, 1e-10, 1e-7, 1e-4})
        for (const double z : {1., 2.2, 0., 4.}) // on edges, in faces, on the boundary
            rays.push_back({{radius_at_joint + off, -2, z}, {0, 1, 0}});
    const auto hits = kith::ray_hits(tube(), kith::catmull_clark{}).of(rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(hits[i].has_value(), i < 12) << i;
        if (hits[i]) {
            EXPECT_NEAR(hits[i]->point[0], rays[i].origin[0], 1e-12) << i;
            EXPECT_LT(hits[i]->distance, 2) << i; // the first of two hits
        }
    }
}

TEST(ray_hits, begin_at_the_origin_and_end_at_the_furthest_point)
{
    const double r = radius_at_joint;
    const std::vector<surface_ray> rays{{{-3, 0, 2}, {1, 0, 0}, 3 - r - 1e-9},
                                        {{-3, 0, 2}, {1, 0, 0}, 3 - r + 1e-9},
                                        {{-r + 1e-9, 0, 2}, {1, 0, 0}},
                                        {{-r - 1e-9, 0, 2}, {1, 0, 0}},
                                        {{3, 0, 2}, {1, 0, 0}},
                                        {{-1e5, 0, 2}, {1, 0, 0}},
                                        {{0, 0, -1}, {0, 0, 1}}, // through the tube
                                        {{0, 0, 2}, {1e-200, 0, 0}},
                                        {{0, -r, -1}, {0, 0, 1}}}; // along a line of the surface
    const auto hits = kith::ray_hits(tube(), kith::catmull_clark{}).of(rays);
    EXPECT_FALSE(hits[0]);
    EXPECT_NEAR(hits[1].value().distance, 3 - r, 1e-14);
    EXPECT_NEAR(hits[2].value().distance, 2 * r, 2e-9);
    EXPECT_NEAR(hits[3].value().distance, 1e-9, 1e-14);
    EXPECT_FALSE(hits[4]);
    EXPECT_NEAR(hits[5].value().distance, 1e5 - r, 1e-10);
    EXPECT_FALSE(hits[6]);
    EXPECT_NEAR(hits[7].value().distance, r * 1e200, 1e186);
    EXPECT_NEAR(hits[8].value().distance, 1, 1e-12);
}

TEST(ray_hits, are_the_same_bits_on_threads)
{
    const auto mesh = native(shapes::shaken(shapes::house()));
    std::minstd_rand random(1);
    std::vector<surface_ray> rays(300);
    for (auto& ray : rays)
        ray = {random_point(random, 2), random_point(random, 1)};
    const auto make = [&](int threads) {
        const thread_count count(threads);
        return kith::ray_hits(mesh, kith::catmull_clark{}).of(rays);
    };
    const auto one = make(1), three = make(3);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(one[i].has_value(), three[i].has_value());
        EXPECT_TRUE(not one[i] or (one[i]->place == three[i]->place and one[i]->distance == three[i]->distance)) << i;
    }
}

TEST(ray_hits, refuse_what_is_no_ray)
{
    kith::ray_hits surface(native(shapes::cube()), kith::catmull_clark{});
    EXPECT_TRUE(surface.of({}).empty());
    const auto text = [&](const surface_ray& ray) {
        return error_text<kith::mesh_error>(
            [&] { static_cast<void>(surface.of(std::vector<surface_ray>{{{0, 0, 0}, {0, 0, 1}}, ray})); });
    };
    const double no_number = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(text({{0, 0, no_number}, {0, 0, 1}}), "ray 1 is not finite; correct its origin or direction");
    EXPECT_EQ(text({{0, 0, 0}, {0, 0, 0}}), "ray 1 has no direction; give one that is not zero");
    EXPECT_EQ(text({{0, 0, 0}, {0, 0, 1}, -1}), "ray 1 has a negative length; give 0 or more");
}

} // namespace
