// SPDX-License-Identifier: BSD-3-Clause
// Tests surfaces of schemes whose steps differ from those of Catmull-Clark and Loop, or which need closed meshes.
#include <kith/surface.hpp>

#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/surface_places.hpp"

#include <kith/closest_points.hpp>
#include <kith/compiled_schemes.hpp>
#include <kith/face_varying.hpp>
#include <kith/hierarchy.hpp>
#include <kith/limits/limit_surface.hpp>
#include <kith/ray_hits.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using kith::derivatives;
using kith::surface_place;
/// Returns a place for each corner of a level of 4-8, by bisecting the first edges.
std::vector<surface_place> places_of_bisection(const mesh3d& control, int level)
{
    struct half {
        std::size_t face;
        std::array<parameters, 3> corners;
    };
    std::vector<half> halves;
    for (std::size_t f = 0; f < control.face_count(); ++f)
        halves.push_back({f, {{{0, 0}, {1, 0}, {0, 1}}}});
    for (int step = 0; step < level; ++step) {
        std::vector<half> next;
        for (const auto& [face, c] : halves) {
            const parameters middle{(c[0][0] + c[1][0]) / 2, (c[0][1] + c[1][1]) / 2};
            next.push_back({face, {c[2], c[0], middle}});
            next.push_back({face, {c[1], c[2], middle}});
        }
        halves = std::move(next);
    }
    std::vector<surface_place> result;
    for (const auto& [face, corners] : halves)
        for (const auto& [u, v] : corners)
            result.push_back({face, u, v, 0});
    return result;
}

/// Expects the corners of a level to have the limits found by refining and, inside, the normals of these limits.
void expect_limits_of_bisection(const mesh3d& control, int level)
{
    kith::hierarchy<mesh3d, kith::four_eight> levels(control, kith::four_eight{});
    levels.refine(level);
    const auto expected = limit_surface_of(levels, level);
    const auto places = places_of_bisection(control, level);
    kith::surface_locator surface(control, kith::four_eight{});
    const auto made = surface.locate(places).evaluate(control.points(), derivatives::first);
    const auto normals = normals_of(made);
    const auto& topology = levels[level].topology();
    ASSERT_EQ(places.size(), topology.corners());
    for (std::size_t c = 0; c < places.size(); ++c) {
        const auto v = topology.corner_vertex[c];
        ASSERT_LT(distance(made.points[c], expected.positions[v]), 1e-12) << "corner " << c;
        if (topology.is_closed()) { // at boundaries limit_surface_of has no tangents
            ASSERT_LT(distance(normals[c], expected.normals[v]), 1e-9) << "corner " << c;
        }
    }
}

TEST(surface_schemes, bisect_triangles)
{
    const auto test = [](const std::string& name, const shapes::shape& shape) {
        SCOPED_TRACE(name);
        const auto mesh = tri_quad(native(shapes::shaken(shape)));
        for (const int level : {0, 4})
            expect_limits_of_bisection(mesh, level);
    };
    test("cube", shapes::cube());
    test("flipped torus", shapes::with_flips(shapes::triangulated(shapes::torus(4, 4)), 3));
    test("grid", shapes::grid(3, 4)); // of generation 0
    test("triangulated L", shapes::triangulated(shapes::l_shape()));
    test("open house", shapes::open_house());
}

/// Shows that 4-8 has first derivatives on the boundary: those along it are the slopes of the cubic B-spline of the
/// boundary vertices, and all are the limits of those nearby.
TEST(surface_schemes, bisect_triangles_with_slopes_on_boundaries)
{
    constexpr std::size_t size = 4;
    const auto mesh = tri_quad(native(shapes::shaken(shapes::grid(size, size))));
    const auto& topology = mesh.topology();
    kith::surface_locator surface(mesh, kith::four_eight{});
    std::size_t compared = 0;
    for (std::uint32_t c = 0; c < mesh.corner_count(); ++c) {
        const std::size_t from = topology.corner_vertex[c], to = topology.corner_vertex[topology.next(c)];
        if (topology.across(c) != topology.none)
            continue;
        for (const double at : {.3, .5, .0625, .9}) {
            const auto off = [&](double y) { return place_off_corner(mesh, c, at, y, 3); };
            const std::vector<surface_place> places{off(0), off(0x1p-14), off(0x1p-15)};
            const auto made = surface.locate(places).evaluate(mesh.points(), derivatives::first);
            const auto along = [&](std::size_t i) { // the side that begins at the corner
                const auto a = place_on_side(mesh, c, 0, 3), z = place_on_side(mesh, topology.next(c), 0, 3);
                point result{};
                for (std::size_t x = 0; x < 3; ++x)
                    result[x] = (z.u - a.u) * made.du[i][x] + (z.v - a.v) * made.dv[i][x];
                return result;
            };
            for (std::size_t x = 0; x < 3; ++x) {
                EXPECT_NEAR(2 * made.du[2][x] - made.du[1][x], made.du[0][x], 3e-7) << "corner " << c << " at " << at;
                EXPECT_NEAR(2 * made.dv[2][x] - made.dv[1][x], made.dv[0][x], 3e-7) << "corner " << c << " at " << at;
            }
            if (std::max(from, to) > size or std::min(from, to) == 0 or std::max(from, to) == size)
                continue; // on the first row, away from its ends
            const double t = from < to ? at : 1 - at, sign = from < to ? 1 : -1;
            const std::size_t first = std::min(from, to) - 1;
            const std::array<double, 4> slopes{
                -(1 - t) * (1 - t) / 2, (3 * t * t - 4 * t) / 2, (1 + 2 * t - 3 * t * t) / 2, t * t / 2};
            point expected{};
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t x = 0; x < 3; ++x)
                    expected[x] += sign * slopes[i] * mesh.point(first + i)[x];
            EXPECT_LT(distance(along(0), expected), 1e-7) << "corner " << c << " at " << at;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 8U);
}

/// Shows that 4-8 has the tangent plane at boundary vertices, to which tangents nearby converge.
TEST(surface_schemes, bisect_triangles_with_tangents_at_boundary_vertices)
{
    for (const auto& shape : {shapes::ring(5), shapes::triangulated(shapes::ring(5))}) {
        const auto mesh = tri_quad(native(shapes::shaken(shape)));
        const auto& topology = mesh.topology();
        kith::surface_locator surface(mesh, kith::four_eight{});
        std::size_t compared = 0;
        for (std::uint32_t c = 0; c < mesh.corner_count(); ++c) {
            if (topology.across(topology.vertex_corner[topology.corner_vertex[c]]) != topology.none)
                continue;
            std::vector<surface_place> places;
            for (const double size : {0., 0x1p-8, 0x1p-24})
                places.push_back(place_off_corner(mesh, c, .6 * size, .3 * size, 3));
            const auto normals = normals_of(surface.locate(places).evaluate(mesh.points(), derivatives::first));
            EXPECT_LT(distance(normals[0], normals[1]), .3) << "corner " << c;
            EXPECT_LT(distance(normals[0], normals[2]), .3 * distance(normals[0], normals[1])) << "corner " << c;
            ++compared;
        }
        EXPECT_GE(compared, 30U); // three corners at each of ten vertices, or more
    }
}

/// Shows that the numbers of faces change nothing. Faces keep their first corners, which mark edges.
TEST(surface_schemes, bisect_triangles_in_any_numbers)
{
    const auto mesh = tri_quad(native(shapes::shaken(shapes::triangulated(shapes::torus(4, 5)))));
    std::vector<std::vector<std::uint32_t>> faces;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> marked;
    for (std::size_t f = mesh.face_count(); f > 0; --f) {
        faces.emplace_back(mesh.face(f - 1).begin(), mesh.face(f - 1).end());
        marked.emplace_back(faces.back()[0], faces.back()[1]);
    }
    const auto reversed = mark_edges(
        kith::make_mesh(std::vector<point>(mesh.points().begin(), mesh.points().end()), faces), marked);
    std::vector<surface_place> places, there;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (const auto& [u, v] : {parameters{.3, .2}, {.01, .98}, {0, 0}, {.5, .25}}) {
            places.push_back({f, u, v, 0});
            there.push_back({mesh.face_count() - 1 - f, u, v, 0});
        }
    const auto made = kith::surface_locator(mesh, kith::four_eight{}).locate(places).evaluate(mesh.points());
    const auto other = kith::surface_locator(reversed, kith::four_eight{}).locate(there).evaluate(reversed.points());
    EXPECT_TRUE(std::ranges::equal(made.points, other.points));
}

/// Returns the place of corner k of a face.
template <class Scheme>
surface_place place_of_corner(const mesh3d& mesh, std::size_t f, std::size_t k)
{
    constexpr std::array<parameters, 4> of_quad{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    constexpr std::array<parameters, 3> of_triangle{{{0, 0}, {1, 0}, {0, 1}}};
    if (not kith::detail::has_quad_parameters<Scheme>)
        return {f, of_triangle[k][0], of_triangle[k][1], 0};
    return mesh.face(f).size() == 4 ? surface_place{f, of_quad[k][0], of_quad[k][1], 0} : surface_place{f, 0, 0, k};
}

/// Expects the given places of the vertices of a level to have the limits of these vertices.
template <class Scheme>
void expect_limits(const mesh3d& control, const Scheme& scheme, int level, const std::vector<surface_place>& places)
{
    kith::hierarchy<mesh3d, Scheme> levels(control, scheme);
    levels.refine(level);
    const auto expected = limit_surface_of(levels, level).positions;
    const auto made = kith::surface_locator(control, scheme).locate(places).evaluate(control.points()).points;
    ASSERT_EQ(places.size(), expected.size());
    for (std::size_t v = 0; v < places.size(); ++v)
        ASSERT_LT(distance(made[v], expected[v]), 5e-12) << "vertex " << v;
}

TEST(surface_schemes, take_closed_meshes_alone)
{
    for (const auto& shape : {shapes::cube(), shapes::house(), shapes::torus(3, 4)})
        for (const int degree : {1, 2, 3, 4, 5}) {
            SCOPED_TRACE(degree);
            const kith::unified scheme{.degree = degree};
            const auto mesh = native(shapes::shaken(shape));
            std::vector<surface_place> at_corners, control_places(mesh.vertex_count()), at_edges(mesh.edge_count()),
                at_faces;
            for (std::size_t f = 0; f < mesh.face_count(); ++f) {
                const std::size_t n = mesh.face(f).size(), first = mesh.topology().first_corner(f);
                at_faces.push_back(n == 4 ? surface_place{f, .5, .5, 0} : surface_place{f, 1, 1, 0});
                for (std::size_t k = 0; k < n; ++k) {
                    const auto here = place_of_corner<kith::unified>(mesh, f, k);
                    const auto next = place_of_corner<kith::unified>(mesh, f, (k + 1) % n);
                    control_places[mesh.topology().corner_vertex[first + k]] = here;
                    at_edges[mesh.topology().corner_halfedge[first + k] / 2] =
                        n == 4 ? surface_place{f, (here.u + next.u) / 2, (here.v + next.v) / 2, 0}
                               : surface_place{f, 1, 0, k};
                    at_corners.push_back(n == 4 ? surface_place{f, .25 + here.u / 2, .25 + here.v / 2, 0}
                                                : surface_place{f, .5, .5, k});
                }
            }
            if (degree % 2 == 0) {
                expect_limits(mesh, scheme, 1, at_corners);
                continue;
            }
            expect_limits(mesh, scheme, 0, control_places);
            auto places = control_places;
            places.insert(places.end(), at_edges.begin(), at_edges.end());
            places.insert(places.end(), at_faces.begin(), at_faces.end());
            expect_limits(mesh, scheme, 1, places);
        }
    for (const auto& shape :
         {shapes::triangulated(shapes::cube()), shapes::with_flips(shapes::triangulated(shapes::torus(4, 5)), 3)}) {
        const auto mesh = native(shapes::shaken(shape));
        std::vector<surface_place> places(mesh.vertex_count());
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (std::size_t k = 0; k < 3; ++k)
                places[mesh.face(f)[k]] = place_of_corner<kith::interpolatory_sqrt3>(mesh, f, k);
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            places.push_back({f, 1. / 3, 1. / 3, 0});
        expect_limits(mesh, kith::interpolatory_sqrt3{}, 1, places);
    }
}

/// Returns the uniform B-spline of a degree, centred at 0, by the recursion of de Boor and Cox.
double spline(int degree, double x)
{
    if (degree == 0)
        return -.5 <= x and x < .5 ? 1 : 0;
    const double end = (degree + 1) / 2.;
    return ((end + x) * spline(degree - 1, x + .5) + (end - x) * spline(degree - 1, x - .5)) / degree;
}

TEST(surface_schemes, are_tensor_splines_among_regular_faces)
{
    constexpr int rows = 7, columns = 8;
    const auto mesh = native(shapes::shaken(shapes::torus(rows, columns)));
    for (const int degree : {1, 2, 3, 4, 5}) {
        SCOPED_TRACE(degree);
        const kith::unified scheme{.degree = degree};
        std::vector<surface_place> places;
        std::vector<point> expected;
        for (std::size_t f = 0; f < mesh.face_count(); f += 5) {
            std::array<std::array<int, 2>, 4> corner{}; // row and column of each corner
            for (std::size_t k = 0; k < 4; ++k)
                corner[k] = {int(mesh.face(f)[k]) / columns, int(mesh.face(f)[k]) % columns};
            const auto step = [&](std::size_t k, std::size_t axis) { // from corner 0, around the torus
                const int size = axis == 0 ? rows : columns;
                const int d = (corner[k][axis] - corner[0][axis] + size) % size;
                return d == size - 1 ? -1 : d;
            };
            for (const auto& [u, v] : {parameters{.3, .1}, {.9, .7}, {.05, .6}}) {
                const double at_row = corner[0][0] + u * step(1, 0) + v * step(3, 0);
                const double at_column = corner[0][1] + u * step(1, 1) + v * step(3, 1);
                point& sum = expected.emplace_back();
                places.push_back({f, u, v, 0});
                for (int r = -3 * rows; r < 3 * rows; ++r)
                    for (int c = -3 * columns; c < 3 * columns; ++c) {
                        const double weight = spline(degree, at_row - r) * spline(degree, at_column - c);
                        const int vertex = (r + 3 * rows) % rows * columns + (c + 3 * columns) % columns;
                        for (std::size_t x = 0; x < 3 and weight != 0; ++x)
                            sum[x] += weight * mesh.point(std::size_t(vertex))[x];
                    }
            }
        }
        const auto made = kith::surface_locator(mesh, scheme).locate(places).evaluate(mesh.points());
        for (std::size_t i = 0; i < places.size(); ++i)
            EXPECT_LT(distance(made.points[i], expected[i]), 1e-13) << i;
    }
}

/// Shows that differences of the seventh order along a line in half of a triangle vanish, and that sixth ones do not.
TEST(surface_schemes, have_a_box_spline_of_degree_six)
{
    const auto mesh = tri_quad(native(shapes::shaken(shapes::torus(7, 8))));
    std::vector<surface_place> places;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (int i = 0; i < 8; ++i)
            places.push_back({f, .03 + .02 * i, .05 + .06 * i, 0});
    const auto made = kith::surface_locator(mesh, kith::four_eight{}).locate(places).evaluate(mesh.points());
    double largest = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t x = 0; x < 3; ++x) {
            std::vector<double> d;
            for (std::size_t i = 0; i < 8; ++i)
                d.push_back(made.points[8 * f + i][x]);
            for (; d.size() > 1; d.pop_back()) {
                if (d.size() == 2)
                    largest = std::max(largest, std::abs(d[0]));
                for (std::size_t i = 0; i + 1 < d.size(); ++i)
                    d[i] = d[i + 1] - d[i];
            }
            EXPECT_NEAR(d[0], 0, 1e-12) << f;
        }
    EXPECT_GT(largest, 1e-8);
}

TEST(surface_schemes, have_the_slopes_of_their_points)
{
    const auto test = [](const mesh3d& mesh, const auto& scheme, bool has_second) {
        SCOPED_TRACE(std::string(kith::scheme_name<std::remove_cvref_t<decltype(scheme)>>()));
        constexpr double step = 1. / 16384;
        std::vector<surface_place> places;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (const auto& [u, v] : {parameters{.3, .1}, {.07, .84}, {.4375, .47}, {.26, .01}})
                for (const auto& [x, y] : {parameters{0, 0}, {step, 0}, {-step, 0}, {0, step}, {0, -step}})
                    places.push_back({f, u + x, v + y, 0});
        kith::surface_locator surface(mesh, scheme);
        const auto made = surface.locate(places).evaluate(mesh.points(), derivatives::second);
        const auto expect_slope = [&](const auto& of, std::size_t i, const auto& slope) {
            for (std::size_t x = 0; x < 3; ++x)
                EXPECT_NEAR((of[i + 1][x] - of[i + 2][x]) / (2 * step), slope[x], 4e-6) << "place " << i;
        };
        for (std::size_t i = 0; i < places.size(); i += 5) {
            expect_slope(made.points, i, made.du[i]);
            expect_slope(made.points, i + 2, made.dv[i]);
            if (not has_second) {
                EXPECT_TRUE(std::isnan(made.duu[i][0]));
                continue;
            }
            expect_slope(made.du, i, made.duu[i]);
            expect_slope(made.du, i + 2, made.duv[i]);
            expect_slope(made.dv, i, made.duv[i]);
            expect_slope(made.dv, i + 2, made.dvv[i]);
        }
    };
    test(tri_quad(native(shapes::shaken(shapes::torus(5, 6)))), kith::four_eight{}, true);
    test(tri_quad(native(shapes::shaken(shapes::triangulated(shapes::cube())))), kith::four_eight{}, true);
    test(tri_quad(native(shapes::shaken(shapes::grid(4, 4)))), kith::four_eight{}, true);
    for (const int degree : {1, 2, 3, 4, 5})
        test(native(shapes::shaken(shapes::house())), kith::unified{.degree = degree}, true);
    test(native(shapes::shaken(shapes::triangulated(shapes::cube()))), kith::interpolatory_sqrt3{}, false);
}

/// Shows that unified has tangents at irregular places. They come from steps, since no mask gives them, and tangents
/// nearby converge to them.
TEST(surface_schemes, have_tangents_at_irregular_places)
{
    for (const auto& shape : {shapes::tetrahedron(), shapes::house()})
        for (const int degree : {2, 3, 4, 5}) {
            SCOPED_TRACE(degree);
            const auto mesh = native(shapes::shaken(shape));
            std::vector<surface_place> places;
            for (std::size_t f = 0; f < mesh.face_count(); ++f)
                for (std::size_t k = 0; k < mesh.face(f).size(); ++k) {
                    places.push_back(place_of_corner<kith::unified>(mesh, f, k));
                    places.push_back(places.back());
                    auto& [face, u, v, corner] = places.back();
                    u += u < .5 ? 0x1p-14 : -0x1p-14;
                    v += v < .5 ? 0x1.5p-15 : -0x1.5p-15;
                }
            const auto normals = normals_of(kith::surface_locator(mesh, kith::unified{.degree = degree})
                                                .locate(places)
                                                .evaluate(mesh.points(), derivatives::first));
            for (std::size_t i = 0; i < places.size(); i += 2)
                EXPECT_LT(distance(normals[i], normals[i + 1]), 6e-3) << i;
        }
}

/// Shows that values at corners are interpolated linearly in faces with the rule `all`, on closed meshes, too.
TEST(surface_schemes, have_values_at_corners)
{
    const auto test = [](const mesh3d& mesh, const auto& scheme) {
        std::vector<double> values;
        std::vector<surface_place> places;
        std::vector<double> expected;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            const std::size_t n = mesh.face(f).size(), first = values.size();
            for (std::size_t k = 0; k < n; ++k)
                values.push_back(std::sin(double(values.size())));
            const auto value = [&](std::size_t k) { return values[first + k]; };
            for (const auto& [u, v] : {parameters{.2, .7}, {.5, .25}, {.01, .1}}) {
                places.push_back({f, u, v, 0});
                expected.push_back(n == 3 ? (1 - u - v) * value(0) + u * value(1) + v * value(2)
                                          : (1 - v) * ((1 - u) * value(0) + u * value(1)) +
                                                v * ((1 - u) * value(3) + u * value(2)));
            }
        }
        const kith::face_varying rule{kith::face_varying_linear::all};
        kith::surface_locator surface(mesh, scheme);
        const auto made = surface.locate(places, kith::on_corners(values, rule)).evaluate(values).points;
        for (std::size_t i = 0; i < places.size(); ++i)
            EXPECT_NEAR(made[i], expected[i], 1e-12) << i;
    };
    test(tri_quad(native(shapes::shaken(shapes::torus(4, 5)))), kith::four_eight{});
    test(native(shapes::shaken(shapes::torus(6, 6))), kith::unified{});
}

/// Shows that no sample of the surface is nearer than the nearest point, and that none lies before a ray's hit.
TEST(surface_schemes, are_searched)
{
    const auto test = [](const mesh3d& mesh, const auto& scheme) {
        SCOPED_TRACE(std::string(kith::scheme_name<std::remove_cvref_t<decltype(scheme)>>()));
        constexpr bool has_quads = kith::detail::has_quad_parameters<std::remove_cvref_t<decltype(scheme)>>;
        constexpr int segments = 12;
        std::vector<surface_place> places;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (std::size_t k = 0; k < (mesh.face(f).size() == (has_quads ? 4 : 3) ? 1 : mesh.face(f).size()); ++k)
                for (int i = 0; i <= segments; ++i)
                    for (int j = 0; j <= (has_quads ? segments : segments - i); ++j)
                        places.push_back({f, double(i) / segments, double(j) / segments, k});
        const auto samples = kith::surface_locator(mesh, scheme).locate(places).evaluate(mesh.points()).points;
        std::vector<point> queries;
        std::vector<kith::surface_ray> rays;
        const point outside{5, 3, 2};
        for (std::size_t i = 0; i < samples.size(); i += samples.size() / 10) {
            const auto& [x, y, z] = samples[i];
            queries.push_back({x * 1.1 + .1, y * .7, z * 1.2 - .1});
            rays.push_back({outside, {x - outside[0], y - outside[1], z - outside[2]}});
        }
        const auto found = kith::closest_points(mesh, scheme).of(queries);
        for (std::size_t q = 0; q < queries.size(); ++q) {
            double nearest = 100;
            for (const point& sample : samples)
                nearest = std::min(nearest, distance(sample, queries[q]));
            EXPECT_LE(found[q].distance, nearest + 1e-12) << q;
            EXPECT_GT(found[q].distance, nearest - .1) << q;
            EXPECT_NEAR(found[q].distance, distance(found[q].point, queries[q]), 1e-15) << q;
        }
        if constexpr (not has_quads) {
            const auto hits = kith::ray_hits(mesh, scheme).of(rays);
            for (std::size_t q = 0; q < rays.size(); ++q) {
                ASSERT_TRUE(hits[q].has_value()) << q;
                EXPECT_LE(hits[q]->distance, 1 + 1e-12) << q;
                point on_ray = outside;
                for (std::size_t x = 0; x < 3; ++x)
                    on_ray[x] += hits[q]->distance * rays[q].direction[x];
                EXPECT_LT(distance(on_ray, hits[q]->point), 1e-11) << q;
            }
        }
    };
    test(native(shapes::shaken(shapes::house())), kith::doo_sabin{});
    test(native(shapes::shaken(shapes::house())), kith::mid_edge{});
    test(tri_quad(native(shapes::shaken(shapes::cube()))), kith::four_eight{});
    test(native(shapes::shaken(shapes::cube())), kith::unified{.degree = 5});
    test(native(shapes::shaken(shapes::cube())), kith::nasri_hasbini{});
}

TEST(surface_schemes, refuse_what_is_not_found)
{
    const auto cube = native(shapes::cube());
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::surface_locator surface(cube, kith::unified{.degree = 6}); }),
              "unified: polynomials of degree 6 are not found between control points; take a degree up to 5");
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::surface_locator surface(cube, kith::unified{.degree = 10}); }),
              "unified: degree 10 was asked for; ask for 1 to 9");
    EXPECT_NE(error_text<kith::mesh_error>([] {
                  kith::surface_locator surface(native(shapes::grid()), kith::unified{});
              }).find("is a boundary edge"),
              std::string::npos);
}

} // namespace
