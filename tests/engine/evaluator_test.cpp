// SPDX-License-Identifier: BSD-3-Clause
#include <kith/evaluator.hpp>

#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"
#include "support/thread_count.hpp"
#include "support/under_sanitizers.hpp"

#include <kith/compiled_schemes.hpp>
#include <kith/fields/property_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace {

using point = std::array<double, 3>;

/// Returns the mesh with its points moved.
mesh3d moved(const mesh3d& mesh, double by)
{
    kith::storage<point> points(mesh.points());
    for (std::size_t v = 0; v < points.size(); ++v)
        points[v][v % 3] += by * std::sin(double(v + 1));
    return {std::move(points), mesh.topology(), mesh.generation()};
}

template <class T>
T value_at(double x)
{
    if constexpr (std::floating_point<T>) {
        return std::sin(x);
    } else {
        T result;
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = typename T::value_type(std::sin(x + double(i)));
        return result;
    }
}

template <class Points>
bool same_points(const Points& a, std::span<const point> b)
{
    return std::ranges::equal(a, b);
}

/// Expects the points of `refine` from an evaluator whose control points move, and move back.
template <class Scheme>
void expect_points_of_refine(const mesh3d& mesh, const Scheme& scheme, int levels)
{
    kith::evaluator surface(mesh, scheme, levels);
    for (const double by : {.1, .7, 0.}) {
        const auto control = moved(mesh, by);
        EXPECT_TRUE(same_points(surface.evaluate(control.points()), refine(control, scheme, levels).points()))
            << levels << ' ' << by;
    }
}

TEST(evaluator, makes_the_points_of_refine)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        const auto mesh = native(shape);
        for (const int levels : {0, 1, under_sanitizers ? 2 : 3}) {
            expect_points_of_refine(mesh, kith::catmull_clark{}, levels);
            expect_points_of_refine(mesh, kith::nasri_hasbini{}, levels); // makes no patches
        }
    }
    for (const auto& [name, shape] : shapes::triangle_shapes()) {
        SCOPED_TRACE(name);
        expect_points_of_refine(native(shape), kith::sqrt3{}, 3);
    }
}

TEST(evaluator, makes_them_by_templates_and_without)
{
    const auto torus = native(shapes::shaken(shapes::torus(12, 24))); // few classes
    const auto irregular = native(
        shapes::shaken(shapes::shuffled(shapes::both(shapes::house(), shapes::torus(7, 9)), 3)));
    const auto triangles = native(shapes::shaken(shapes::shuffled(shapes::triangulated(shapes::grid(15, 16)), 7)));
    const int levels = under_sanitizers ? 3 : 4;
    for (const int threads : {1, 3}) {
        const thread_count count(threads);
        expect_points_of_refine(torus, kith::catmull_clark{}, levels);
        expect_points_of_refine(irregular, kith::catmull_clark{}, levels);
        expect_points_of_refine(triangles, kith::loop{}, levels);
    }
}

TEST(evaluator, keeps_creases)
{
    const auto torus = native(shapes::shaken(shapes::torus(12, 24)));
    kith::catmull_clark creased;
    creased.sharpness.sharpen_edge(5, 1.5);
    creased.sharpness.sharpen_vertex(7, 2.);
    expect_points_of_refine(torus, creased, 4);
}

/// Expects the values of `carry` from an evaluator that is used several times.
template <class T, class Levels>
void expect_values_of_carry(const Levels& levels, int from, int to)
{
    auto carried = kith::evaluator_of<T>(levels, from, to);
    std::vector<T> values(levels.elements(from).vertex_count());
    for (const double by : {.3, 1.}) {
        for (std::size_t v = 0; v < values.size(); ++v)
            values[v] = value_at<T>(by * double(v));
        const auto expected = levels.carry(from, to, std::span<const T>(values));
        EXPECT_TRUE(std::ranges::equal(carried.evaluate(values), expected)) << from << ' ' << to << ' ' << by;
    }
}

TEST(evaluator, carries_values_of_a_level)
{
    kith::catmull_clark creased;
    creased.sharpness.sharpen_edge(5, 1.5);
    kith::hierarchy levels(native(shapes::shaken(shapes::torus(12, 24))), creased);
    levels.refine(4);
    for (const auto& [from, to] : {std::pair(0, 4), std::pair(1, 4), std::pair(2, 3), std::pair(3, 3)}) {
        expect_values_of_carry<std::array<float, 2>>(levels, from, to);
        expect_values_of_carry<std::array<double, 4>>(levels, from, to);
        expect_values_of_carry<double>(levels, from, to); // makes no patches
    }
    EXPECT_NE(error_text<kith::mesh_error>([&] { kith::evaluator_of<double>(levels, 3, 2); }), "");
    EXPECT_NE(error_text<kith::mesh_error>([&] { kith::evaluator_of<double>(levels, 5, 6); }), "");

    kith::hierarchy plates(kith::property_mesh<>(native(shapes::grid(15, 16))), kith::catmull_clark{});
    plates.refine(3);
    expect_values_of_carry<std::array<float, 2>>(plates, 0, 3);
}

TEST(evaluator, refuses_other_numbers_of_points_and_infinite_ones)
{
    const auto torus = native(shapes::torus(12, 24));
    for (const int levels : {1, 4}) {
        kith::evaluator surface(torus, kith::catmull_clark{}, levels);
        std::vector<point> control(torus.points().begin(), torus.points().end());
        control[3][1] = std::numeric_limits<double>::infinity();
        EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(surface.evaluate(control)); }),
                  "level 0: the new point of vertex 3 is not finite; give all vertices finite coordinates");
        control.pop_back();
        control[3][1] = 0;
        EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(surface.evaluate(control)); }),
                  "level 0 has 288 vertices, 287 values were given; give one per vertex");
        EXPECT_TRUE(
            same_points(surface.evaluate(torus.points()), refine(torus, kith::catmull_clark{}, levels).points()));
    }
    EXPECT_NE(error_text<kith::mesh_error>([&] { kith::evaluator(torus, kith::catmull_clark{}, -1); }), "");
}

} // namespace
