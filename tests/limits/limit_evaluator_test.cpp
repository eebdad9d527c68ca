// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limits/limit_evaluator.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/thread_count.hpp"

#include <kith/hierarchy.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

template <class Point>
kith::basic_mesh<Point> moved(const kith::basic_mesh<Point>& mesh, double by)
{
    kith::storage<Point> points(mesh.points());
    for (std::size_t v = 0; v < points.size(); ++v)
        points[v][v % 3] += typename Point::value_type(by * std::sin(double(v + 1)));
    return {std::move(points), mesh.topology(), mesh.generation()};
}
template <class Point>
kith::basic_mesh<Point> scaled(const kith::basic_mesh<Point>& mesh, double by)
{
    kith::storage<Point> points(mesh.points());
    for (auto& p : points)
        for (auto& x : p)
            x *= typename Point::value_type(by);
    return {std::move(points), mesh.topology(), mesh.generation()};
}

template <class Point, class Scheme>
kith::limit_surface<Point> limits_of_refined(const kith::basic_mesh<Point>& control, const Scheme& scheme, int levels)
{
    kith::hierarchy<kith::basic_mesh<Point>, Scheme> all(control, scheme);
    all.refine(levels);
    return limit_surface_of(all, levels);
}

/// Expects that the limits for moved control points, and for the original ones again, are the limits found by refining.
template <class Point, class Scheme>
void expect_limits_of_refined(const kith::basic_mesh<Point>& mesh, const Scheme& scheme, int levels)
{
    kith::limit_evaluator surface(mesh, scheme, levels);
    for (const double by : {.1, .7, 0.}) {
        const auto control = moved(mesh, by);
        const auto expected = limits_of_refined(control, scheme, levels);
        const auto made = surface.evaluate(control.points());
        EXPECT_TRUE(std::ranges::equal(made.positions, expected.positions)) << levels << ' ' << by;
        EXPECT_TRUE(std::ranges::equal(made.normals, expected.normals)) << levels << ' ' << by;
    }
}

/// Returns true if the evaluator has patch templates for the limits of this refinement.
template <class Scheme>
bool has_patches(const mesh3d& mesh, const Scheme& scheme, int levels)
{
    using patched = kith::detail::patched_limits<std::array<double, 3>, std::uint32_t, Scheme>;
    const int last_rings = kith::limit_rules<Scheme>::rings(scheme) + 1;
    return typename patched::type(mesh, scheme, levels, patched::kinds(), last_rings, {}).has_patches();
}

const auto torus = native(shapes::shaken(shapes::torus(12, 24)));
const auto large_torus = native(shapes::shaken(shapes::torus(24, 48)));
const auto triangles = native(shapes::shaken(shapes::triangulated(shapes::torus(24, 48))));
const auto plate = native(shapes::shaken(shapes::grid(16, 17)));
const auto cut_plate = native(shapes::shaken(shapes::triangulated(shapes::grid(15, 16))));

TEST(limit_evaluator, makes_the_limits_of_all_shapes)
{
    const auto test = [](const auto& scheme, const mesh3d& mesh) {
        for (const int levels : {0, 1, 2}) {
            using patched = kith::detail::
                patched_limits<std::array<double, 3>, std::uint32_t, std::remove_cvref_t<decltype(scheme)>>;
            if constexpr (patched::have_positions)
                expect_limits_of_refined(mesh, scheme, levels);
        }
    };
    for_each_scheme_and_shape(test);
    for_each_other_scheme_and_shape(test);
}

TEST(limit_evaluator, makes_them_by_templates_of_many_schemes)
{
    const int levels = 4;
    for (const int threads : {1, 3}) {
        const thread_count count(threads);
        const auto test = [levels](const mesh3d& mesh, const auto& scheme) {
            SCOPED_TRACE(name_of(scheme));
            EXPECT_TRUE(has_patches(mesh, scheme, levels));
            expect_limits_of_refined(mesh, scheme, levels);
        };
        test(torus, kith::catmull_clark{});
        test(large_torus, kith::kobbelt{});
        test(large_torus, kith::doo_sabin{});
        test(plate, kith::catmull_clark{.corners = kith::boundary_corner::smoothed, .sharpness = {}});
        test(triangles, kith::loop{});
        test(triangles, kith::butterfly{});
        test(triangles, kith::sqrt3{});
        test(cut_plate, kith::loop{});
    }
}

TEST(limit_evaluator, makes_them_where_faces_are_unlike)
{
    const auto mesh = native(shapes::shaken(shapes::shuffled(shapes::both(shapes::house(), shapes::torus(7, 9)), 3)));
    const int levels = 5;
    EXPECT_TRUE(has_patches(mesh, kith::catmull_clark{}, levels));
    expect_limits_of_refined(mesh, kith::catmull_clark{}, levels);
}

TEST(limit_evaluator, searches_at_creases)
{
    kith::catmull_clark creased;
    creased.sharpness.sharpen_edge(5, kith::infinitely_sharp);
    creased.sharpness.sharpen_edge(6, 5.5); // still sharp on the last level
    creased.sharpness.sharpen_edge(100, 1.5);
    creased.sharpness.sharpen_vertex(7, 2.);
    EXPECT_TRUE(has_patches(torus, creased, 4));
    expect_limits_of_refined(torus, creased, 4);
}

TEST(limit_evaluator, makes_those_of_floats_and_of_large_and_small_coordinates)
{
    const auto source = torus.points();
    kith::storage<std::array<float, 3>> points(source.size());
    for (std::size_t v = 0; v < points.size(); ++v)
        points[v] = {float(source[v][0]), float(source[v][1]), float(source[v][2])};
    expect_limits_of_refined(
        kith::basic_mesh<std::array<float, 3>>(std::move(points), torus.topology()), kith::catmull_clark{}, 4);

    kith::limit_evaluator surface(torus, kith::catmull_clark{}, 4);
    for (const double by : {1e-290, 1e307, 0., 1.}) { // tangents overflow, lose digits, or vanish
        const auto control = scaled(torus, by);
        const auto expected = limits_of_refined(control, kith::catmull_clark{}, 4);
        const auto made = surface.evaluate(control.points());
        EXPECT_TRUE(std::ranges::equal(made.positions, expected.positions)) << by;
        EXPECT_TRUE(std::ranges::equal(made.normals, expected.normals)) << by;
    }
}

TEST(limit_evaluator, refuses_other_numbers_of_points_and_infinite_ones)
{
    for (const int levels : {1, 4}) {
        kith::limit_evaluator surface(torus, kith::catmull_clark{}, levels);
        std::vector<std::array<double, 3>> control(torus.points().begin(), torus.points().end());
        control[3][1] = std::numeric_limits<double>::infinity();
        EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(surface.evaluate(control)); }),
                  "level 0: the new point of vertex 3 is not finite; give all vertices finite coordinates");
        control.pop_back();
        control[3][1] = 0;
        EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(surface.evaluate(control)); }),
                  "level 0 has 288 vertices, 287 values were given; give one per vertex");
    }
}

} // namespace
