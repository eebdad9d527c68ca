// SPDX-License-Identifier: BSD-3-Clause
#include <kith/surface.hpp>

#include "support/error_text.hpp"
#include "support/native_shape.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/loop.hpp>
#include <kith/refine.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace {

using point = std::array<double, 3>;

double power(double x, int n)
{
    return n == 0 ? 1 : x * power(x, n - 1);
}
double factorial(int n)
{
    return n < 2 ? 1 : n * factorial(n - 1);
}
/// Returns the integral of u^i v^j over a face.
double by_rule(const kith::surface_quadrature& rule, int i, int j)
{
    double sum = 0;
    for (std::size_t k = 0; k < rule.places.size(); ++k)
        sum += rule.weights[k] * power(rule.places[k].u, i) * power(rule.places[k].v, j);
    return sum;
}

point cross(const point& a, const point& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const point& a)
{
    return std::hypot(a[0], a[1], a[2]);
}
template <class Scheme>
double area_of(const mesh3d& control, int points_per_direction, const Scheme& scheme = Scheme())
{
    kith::surface_locator surface(control, scheme);
    const auto quadrature = kith::quadrature_places(control, scheme, points_per_direction);
    const auto at = surface.locate(quadrature.places).evaluate(control.points(), kith::derivatives::first);
    double result = 0;
    for (std::size_t i = 0; i < quadrature.weights.size(); ++i)
        result += quadrature.weights[i] * length(cross(at.du[i], at.dv[i]));
    return result;
}

/// Returns a flat shape whose inner vertices are moved within the plane.
shapes::shape flattened(shapes::shape s, double width, double height)
{
    for (auto& [x, y, z] : s.points) {
        const bool is_inside = 0 < x and x < width and 0 < y and y < height;
        x += is_inside ? .1 * std::sin(3 * x + 5 * y) : 0;
        y += is_inside ? .1 * std::cos(4 * x + y) : 0;
        z = 0;
    }
    return s;
}

/// Returns quads around the z axis, over a regular polygon, with a boundary at both ends.
shapes::shape pipe(std::size_t around, std::size_t along)
{
    shapes::shape result;
    for (std::size_t j = 0; j <= along; ++j)
        for (std::size_t i = 0; i < around; ++i) {
            const double a = 2 * std::numbers::pi * double(i) / double(around);
            result.points.push_back({std::cos(a), std::sin(a), double(j)});
            const std::size_t next = (i + 1) % around;
            if (j < along)
                result.faces.push_back(
                    {j * around + i, j * around + next, (j + 1) * around + next, (j + 1) * around + i});
        }
    return result;
}

/// Returns the length of the uniform cubic B-spline over a regular polygon of radius 1, by Simpson's rule.
double spline_length(std::size_t corners)
{
    const double step = 2 * std::numbers::pi / double(corners);
    const auto speed = [&](double t) {
        const std::array<double, 4> slopes{
            -(1 - t) * (1 - t) / 2, (3 * t * t - 4 * t) / 2, (-3 * t * t + 2 * t + 1) / 2, t * t / 2};
        double x = 0, y = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            x += slopes[k] * std::cos(double(k) * step);
            y += slopes[k] * std::sin(double(k) * step);
        }
        return std::hypot(x, y);
    };
    constexpr int parts = 200;
    double sum = 0;
    for (int i = 0; i <= 2 * parts; ++i)
        sum += speed(i / (2. * parts)) * (i == 0 or i == 2 * parts ? 1 : i % 2 == 1 ? 4 : 2);
    return double(corners) * sum / (6 * parts);
}

} // namespace

TEST(quadrature, is_exact_for_polynomials_in_a_quad)
{
    const auto mesh = native(shapes::grid(1, 1));
    for (int n = 1; n <= 4; ++n) {
        const auto rule = kith::quadrature_places(mesh, kith::catmull_clark(), n);
        ASSERT_EQ(rule.places.size(), std::size_t(n * n));
        for (int i = 0; i < 2 * n; ++i)
            for (int j = 0; j < 2 * n; ++j)
                EXPECT_NEAR(by_rule(rule, i, j), 1. / (i + 1) / (j + 1), 1e-15) << n << ' ' << i << ' ' << j;
        EXPECT_GT(std::abs(by_rule(rule, 2 * n, 0) - 1. / (2 * n + 1)), 1e-5);
    }
}

TEST(quadrature, is_exact_for_polynomials_in_a_triangle)
{
    const auto mesh = native({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    constexpr std::array<int, 4> degrees{1, 2, 4, 6};
    constexpr std::array<std::size_t, 4> points{1, 3, 6, 12};
    for (int n = 1; n <= 4; ++n) {
        const auto rule = kith::quadrature_places(mesh, kith::loop(), n);
        ASSERT_EQ(rule.places.size(), points[std::size_t(n - 1)]);
        const auto exact = [](int i, int j) { return factorial(i) * factorial(j) / factorial(i + j + 2); };
        const int degree = degrees[std::size_t(n - 1)];
        for (int i = 0; i <= degree; ++i)
            for (int j = 0; i + j <= degree; ++j)
                EXPECT_NEAR(by_rule(rule, i, j), exact(i, j), 1e-15) << n << ' ' << i << ' ' << j;
        EXPECT_GT(std::abs(by_rule(rule, degree + 1, 0) - exact(degree + 1, 0)), 1e-6);
        for (const auto& [face, u, v, corner] : rule.places)
            EXPECT_TRUE(u > 0 and v > 0 and u + v < 1);
    }
}

TEST(quadrature, gives_every_sub_face_of_a_polygon_its_own_parameters)
{
    const auto mesh = native(shapes::house());
    const auto rule = kith::quadrature_places(mesh, kith::catmull_clark(), 2);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t degree = mesh.face(f).size(), parts = degree == 4 ? 1 : degree;
        for (std::size_t part = 0; part <= parts; ++part) {
            double sum = 0;
            for (std::size_t i = 0; i < rule.places.size(); ++i)
                sum += rule.places[i].face == f and rule.places[i].corner == part ? rule.weights[i] : 0;
            EXPECT_DOUBLE_EQ(sum, part < parts ? 1 : 0);
        }
    }
    EXPECT_TRUE(std::ranges::is_sorted(rule.places, {}, &kith::surface_place::face));
}

TEST(quadrature, measures_flat_surfaces)
{
    // The integrand has degree 5 in u and in v.
    const auto quads = native(flattened(shapes::grid(5, 6), 6, 5));
    EXPECT_NEAR(area_of<kith::catmull_clark>(quads, 3), 30, 1e-12);
    EXPECT_GT(std::abs(area_of<kith::catmull_clark>(quads, 1) - 30), 1e-4);
    // Loop's scheme keeps corners with one face. At the two other corners the spline cuts off 1/12 of a face.
    const auto triangles = native(shapes::triangulated(flattened(shapes::grid(5, 6), 6, 5)));
    std::array<double, 3> errors;
    for (int level = 0; level < 3; ++level)
        errors[std::size_t(level)] = std::abs(area_of<kith::loop>(kith::refine(triangles, kith::loop(), level), 4) -
                                              (30 - 1. / 6));
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_LT(errors[i + 1], errors[i] / 4);
    EXPECT_LT(errors[2], 3e-5);
}

TEST(quadrature, measures_a_cylinder_of_splines)
{
    const auto cylinder = native(pipe(8, 3));
    const double area = spline_length(8) * 3;
    EXPECT_NEAR(area_of<kith::catmull_clark>(cylinder, 4), area, 1e-6);
    EXPECT_NEAR(area_of<kith::catmull_clark>(kith::refine(cylinder, kith::catmull_clark(), 1), 4), area, 1e-8);
    EXPECT_GT(std::abs(area_of<kith::catmull_clark>(cylinder, 1) - area), 1e-3);
}

TEST(quadrature, converges_beside_irregular_vertices)
{
    const auto cube = native(shapes::cube());
    std::array<double, 4> areas;
    for (int level = 0; level < 4; ++level)
        areas[std::size_t(level)] = area_of<kith::catmull_clark>(kith::refine(cube, kith::catmull_clark(), level), 4);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_LT(std::abs(areas[i + 2] - areas[i + 1]), std::abs(areas[i + 1] - areas[i]) / 3);

    const auto fine = kith::refine(cube, kith::catmull_clark(), 6); // its faces are nearly the surface
    double area = 0;
    for (std::size_t f = 0; f < fine.face_count(); ++f) {
        const auto v = fine.face(f);
        const auto between = [&](std::size_t from, std::size_t to) {
            const point a = fine.point(v[from]), b = fine.point(v[to]);
            return point{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        };
        area += length(cross(between(0, 2), between(1, 3))) / 2;
    }
    EXPECT_NEAR(areas[3], area, 1e-3 * area);
}

TEST(quadrature, refuses_rules_that_it_does_not_have)
{
    const auto mesh = native(shapes::grid(1, 1));
    for (const int n : {-1, 0, 5})
        EXPECT_NE(error_text<kith::mesh_error>([&] {
                      kith::quadrature_places(mesh, kith::catmull_clark(), n);
                  }).find("give 1 to 4"),
                  std::string::npos);
}
