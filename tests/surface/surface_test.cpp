// SPDX-License-Identifier: BSD-3-Clause
#include <kith/surface.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/own_state.hpp"
#include "support/surface_places.hpp"
#include "support/thread_count.hpp"

#include <kith/face_varying.hpp>
#include <kith/hierarchy.hpp>
#include <kith/limits/limit_surface.hpp>
#include <kith/numbering/step/submesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace {

using kith::derivatives;
using kith::surface_place;

/// A face of a level as a part of a face of the control mesh.
struct part_of_face {
    std::size_t face, corner;
    std::vector<parameters> corners;
};

parameters middle(const parameters& a, const parameters& b)
{
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
}

/// A scheme that splits faces into four, or polygons into quads.
template <class Scheme>
concept splits_in_four = kith::parametric_scheme<Scheme> and kith::detail::domain_of<Scheme>::splits_in_four;

/// Returns the faces of the next level. Their numbers follow from those of the corners.
template <class Scheme>
std::vector<part_of_face> next_parts(const std::vector<part_of_face>& parts)
{
    std::vector<part_of_face> result;
    constexpr bool has_quads = kith::detail::has_quad_parameters<Scheme>;
    for (const auto& [face, corner, p] : parts) {
        const std::size_t n = p.size();
        for (std::size_t k = 0; k < n; ++k) {
            const auto after = middle(p[k], p[(k + 1) % n]), before = middle(p[k], p[(k + n - 1) % n]);
            if (not has_quads)
                result.push_back({face, corner, {p[k], after, before}});
            else if (n == 4)
                result.push_back({face, corner, {p[k], after, middle(p[0], p[2]), before}});
            else
                result.push_back({face, k, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
        }
    }
    if (not has_quads)
        for (const auto& [face, corner, p] : parts)
            result.push_back({face, corner, {middle(p[2], p[0]), middle(p[0], p[1]), middle(p[1], p[2])}});
    return result;
}

/// Returns a place for each corner of a level.
template <class Scheme>
std::vector<surface_place> places_of_level(const mesh3d& control, int level)
{
    constexpr std::size_t degree = kith::detail::has_quad_parameters<Scheme> ? 4 : 3;
    const std::array<parameters, 4> of_quad{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    const std::array<parameters, 3> of_triangle{{{0, 0}, {1, 0}, {0, 1}}};
    std::vector<part_of_face> parts;
    for (std::size_t f = 0; f < control.face_count(); ++f) {
        parts.push_back({f, 0, std::vector<parameters>(control.face(f).size())});
        if (control.face(f).size() == degree)
            for (std::size_t k = 0; k < degree; ++k)
                parts.back().corners[k] = degree == 4 ? of_quad[k] : of_triangle[k];
    }
    for (int step = 0; step < level; ++step)
        parts = next_parts<Scheme>(parts);
    std::vector<surface_place> result;
    for (const auto& [face, corner, corners] : parts)
        for (const auto& [u, v] : corners)
            result.push_back({face, u, v, corner});
    return result;
}

/// Expects the places of the vertices of a level to have the limits and normals that are found by refining.
template <class Scheme>
void expect_limits_of_level(const mesh3d& control, const Scheme& scheme, int level)
{
    constexpr bool is_smooth = not kith::detail::is_linear<Scheme>;
    kith::hierarchy<mesh3d, Scheme> levels(control, scheme);
    levels.refine(level);
    const auto expected = limit_surface_of(levels, level);
    const auto normals = normals_of_corners(levels[level], expected);
    kith::surface_locator surface(control, scheme);
    const auto made = surface.locate(places_of_level<Scheme>(control, level))
                          .evaluate(control.points(), derivatives::first);
    const auto made_normals = normals_of(made);
    const auto& corner_vertex = levels[level].topology().corner_vertex;
    ASSERT_EQ(made.points.size(), corner_vertex.size());
    for (std::size_t c = 0; c < corner_vertex.size(); ++c) {
        ASSERT_LT(distance(made.points[c], expected.positions[corner_vertex[c]]), 2e-13) << "corner " << c;
        if (is_smooth and made_normals[c] != kith::normal_vector{} and normals[c] != kith::normal_vector{}) {
            ASSERT_LT(distance(made_normals[c], normals[c]), 1e-6) << "corner " << c;
        }
    }
}

template <class Scheme>
Scheme with_creases(Scheme scheme, const mesh3d& mesh, double sharpness)
{
    for (std::size_t e = 0; e < mesh.edge_count(); e += 3)
        scheme.sharpness.sharpen_edge(e, sharpness);
    scheme.sharpness.sharpen_vertex(0, sharpness);
    return scheme;
}

TEST(surface, goes_through_the_limits_of_all_levels)
{
    const auto test = [](const auto& scheme, const mesh3d& mesh) {
        if constexpr (splits_in_four<std::remove_cvref_t<decltype(scheme)>>)
            for (const int level : {1, 3})
                expect_limits_of_level(mesh, scheme, level);
    };
    for_each_scheme_and_shape(test);
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE("linear of " + name);
        expect_limits_of_level(native(shape), kith::linear{}, 2);
    }
    for (const auto& [name, shape] : shapes::triangle_shapes()) {
        SCOPED_TRACE("linear triangles of " + name);
        expect_limits_of_level(native(shape), kith::linear_triangles{}, 2);
    }
}

/// Expects the given places, at which the vertices of the first level are made, to have the limits of these vertices.
template <class Scheme>
void expect_limits_of_first_level(const mesh3d& control, const Scheme& scheme, const std::vector<surface_place>& places)
{
    kith::hierarchy<mesh3d, Scheme> levels(control, scheme);
    levels.refine(1);
    const auto expected = limit_surface_of(levels, 1);
    const auto made = kith::surface_locator(control, scheme).locate(places).evaluate(control.points());
    ASSERT_EQ(places.size(), expected.positions.size());
    for (std::size_t v = 0; v < places.size(); ++v)
        ASSERT_LT(distance(made.points[v], expected.positions[v]), 1e-12) << "vertex " << v;
}

TEST(surface, has_a_ternary_split)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        const auto mesh = native(shape);
        const auto& topology = mesh.topology();
        std::vector<surface_place> places(mesh.vertex_count() + 2 * mesh.edge_count());
        for (std::size_t c = 0; c < mesh.corner_count(); ++c) {
            const std::size_t half = topology.corner_halfedge[c];
            const bool is_first = half % 2 == 0;
            places[topology.corner_vertex[c]] = place_on_side(mesh, c, 0, 4);
            places[mesh.vertex_count() + half - half % 2 + (is_first ? 0 : 1)] = place_on_side(mesh, c, 1. / 3, 4);
            places[mesh.vertex_count() + half - half % 2 + (is_first ? 1 : 0)] = place_on_side(mesh, c, 2. / 3, 4);
        }
        const std::array<parameters, 4> inner{{{1. / 3, 1. / 3}, {2. / 3, 1. / 3}, {2. / 3, 2. / 3}, {1. / 3, 2. / 3}}};
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (std::size_t k = 0; k < mesh.face(f).size(); ++k)
                places.push_back(mesh.face(f).size() == 4 ? surface_place{f, inner[k][0], inner[k][1], 0}
                                                          : surface_place{f, 2. / 3, 2. / 3, k});
        expect_limits_of_first_level(mesh, kith::nasri_hasbini{}, places);
    }
}

/// Shows that vertices of the first level have their limits inside faces, as vertices of the control mesh do.
TEST(surface, has_dual_splits)
{
    constexpr std::array<parameters, 4> quarters{{{.25, .25}, {.75, .25}, {.75, .75}, {.25, .75}}};
    for (const auto& shape : {shapes::cube(), shapes::pentacube(), shapes::torus(4, 5), shapes::tetrahedron()}) {
        const auto mesh = native(shapes::shaken(shape));
        std::vector<surface_place> at_corners, at_edges(mesh.edge_count());
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (std::size_t k = 0; k < mesh.face(f).size(); ++k) {
                const std::size_t corner = mesh.topology().first_corner(f) + k;
                at_corners.push_back(mesh.face(f).size() == 4 ? surface_place{f, quarters[k][0], quarters[k][1], 0}
                                                              : surface_place{f, .5, .5, k});
                at_edges[mesh.topology().corner_halfedge[corner] / 2] = place_on_side(mesh, corner, .5, 4);
            }
        expect_limits_of_first_level(mesh, kith::doo_sabin{}, at_corners);
        expect_limits_of_first_level(mesh, kith::doo_sabin{.weights = kith::doo_sabin_weights::averaging}, at_corners);
        expect_limits_of_first_level(mesh, kith::mid_edge{}, at_edges);
    }
}

TEST(surface, has_a_sqrt3_split)
{
    for (const auto& shape : {shapes::triangulated(shapes::cube()),
                              shapes::triangulated(shapes::grid(3, 4)),
                              shapes::with_flips(shapes::triangulated(shapes::torus(4, 5)), 3)}) {
        const auto mesh = native(shapes::shaken(shape));
        std::vector<surface_place> places(mesh.vertex_count());
        for (std::size_t c = 0; c < mesh.corner_count(); ++c)
            places[mesh.topology().corner_vertex[c]] = place_on_side(mesh, c, 0, 3);
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            places.push_back({f, 1. / 3, 1. / 3, 0});
        expect_limits_of_first_level(mesh, kith::sqrt3{}, places);
        // Vertices of the second level lie on the thirds of all edges.
        places.clear();
        for (std::size_t c = 0; c < mesh.corner_count(); ++c)
            for (const double t : {1. / 3, 2. / 3})
                places.push_back(place_on_side(mesh, c, t, 3));
        kith::hierarchy<mesh3d, kith::sqrt3> levels(mesh, kith::sqrt3{});
        levels.refine(2);
        const auto limits = limit_surface_of(levels, 2).positions;
        const auto made = kith::surface_locator(mesh, kith::sqrt3{}).locate(places).evaluate(mesh.points());
        for (std::size_t i = 0; i < places.size(); ++i)
            EXPECT_TRUE(
                std::ranges::any_of(limits, [&](const point& p) { return distance(p, made.points[i]) < 1e-12; }))
                << "place " << i;
    }
}

TEST(surface, keeps_creases_and_corners)
{
    for (const double sharpness : {.5, 1.75, kith::infinitely_sharp})
        for (const auto method : {kith::crease_method::uniform, kith::crease_method::chaikin}) {
            const auto quads = native(shapes::shaken(shapes::torus(5, 6)));
            kith::catmull_clark catmull_clark;
            catmull_clark.sharpness.method = method;
            expect_limits_of_level(quads, with_creases(catmull_clark, quads, sharpness), 3);
            const auto triangles = native(shapes::shaken(shapes::triangulated(shapes::torus(4, 5))));
            kith::loop loop;
            loop.sharpness.method = method;
            expect_limits_of_level(triangles, with_creases(loop, triangles, sharpness), 3);
        }
}

/// Shows that at vertices of creases each face has the tangents of its side, to which tangents nearby converge. Some
/// corners have none: those between creases of Catmull-Clark with two faces or more.
TEST(surface, has_tangents_on_each_side_of_creases)
{
    const auto test = [](const mesh3d& mesh, auto scheme, std::size_t every, double nearby, std::size_t without) {
        constexpr std::size_t sides = kith::detail::has_quad_parameters<decltype(scheme)> ? 4 : 3;
        for (std::size_t e = 0; e < mesh.edge_count(); e += every)
            scheme.sharpness.sharpen_edge(e, kith::infinitely_sharp);
        const auto expected = normals_of_corners(mesh, limit_surface_of(mesh, scheme));
        kith::surface_locator surface(mesh, scheme);
        for (std::uint32_t c = 0; c < mesh.corner_count(); ++c) {
            std::vector<surface_place> places{place_on_side(mesh, c, 0, sides)};
            for (const auto& [x, y] : {parameters{.5, .3}, {.9, .02}, {.02, .9}})
                places.push_back(place_off_corner(mesh, c, 0x1p-11 * x, 0x1p-11 * y, sides));
            const auto normals = normals_of(surface.locate(places).evaluate(mesh.points(), derivatives::first));
            if (normals[0] == kith::normal_vector{}) {
                --without;
                continue;
            }
            EXPECT_LT(distance(normals[0], expected[c]), 1e-13) << "corner " << c;
            for (std::size_t i = 1; i < places.size(); ++i)
                EXPECT_LT(distance(normals[0], normals[i]), nearby) << "corner " << c;
        }
        EXPECT_EQ(without, 0U);
    };
    test(native(shapes::shaken(shapes::torus(5, 6))), kith::catmull_clark{}, 7, .02, 0);
    test(native(shapes::shaken(shapes::torus(5, 6))), kith::catmull_clark{}, 3, .3, 6);
    test(native(shapes::shaken(shapes::triangulated(shapes::grid(4, 5)))), kith::loop{}, 7, .02, 0);
}

/// Shows that between creases that meet at a corner the surface has the plane of their tangents, in sectors of few
/// faces. In sectors of one face more, normals nearby turn into that of this plane with the logarithm of the distance.
/// In larger sectors there is no plane: normals beside the two creases stay apart.
TEST(surface, has_tangents_where_creases_meet)
{
    const auto test = [](const mesh3d& mesh, const auto& smooth, std::size_t valence, std::size_t most_faces) {
        const auto& topology = mesh.topology();
        const std::uint32_t vertex = mesh.face(0)[0];
        std::vector<std::uint32_t> fan{topology.vertex_corner[vertex]};
        while (fan.size() < valence)
            fan.push_back(topology.across(topology.prev(fan.back())));
        for (std::size_t faces = 1; faces < valence; ++faces) {
            SCOPED_TRACE(faces);
            auto scheme = smooth;
            scheme.sharpness.sharpen_vertex(vertex, kith::infinitely_sharp);
            for (const std::size_t k : {std::size_t(0), faces})
                scheme.sharpness.sharpen_edge(topology.corner_halfedge[fan[k]] / 2, kith::infinitely_sharp);
            kith::surface_locator surface(mesh, scheme);
            const auto along_edge = [&](std::size_t k) {
                auto result = mesh.point(topology.corner_vertex[topology.next(fan[k])]);
                for (std::size_t x = 0; x < 3; ++x)
                    result[x] -= mesh.point(vertex)[x];
                return result;
            };
            const auto plane = *kith::unit_normal(along_edge(0), along_edge(faces));
            std::vector<kith::normal_vector> beside_creases;
            for (std::size_t k = 0; k < faces; ++k) {
                const auto off = [&, here = fan[k]](double size, double x, double y) {
                    return place_off_corner(mesh, here, size * x, size * y, valence == 4 ? 4 : 3);
                };
                std::vector<surface_place> places{off(0, 0, 0)};
                for (const double size : {0x1p-10, 0x1p-20, 0x1p-40})
                    for (const auto& [x, y] : {parameters{.5, .3}, {.8, .02}, {.02, .8}})
                        places.push_back(off(size, x, y));
                const auto normals = normals_of(surface.locate(places).evaluate(mesh.points(), derivatives::first));
                EXPECT_LT(distance(normals[0], faces > most_faces ? kith::normal_vector{} : plane), 1e-14) << k;
                if (faces > most_faces + 1) {
                    if (k == 0 or k + 1 == faces)
                        beside_creases.push_back(normals[k == 0 ? 8 : 9]);
                    continue;
                }
                for (std::size_t i = 1; i < 4; ++i) {
                    EXPECT_LT(distance(normals[i], plane), .5) << k;
                    EXPECT_LT(distance(normals[i + 3], plane), .6 * distance(normals[i], plane)) << k;
                    EXPECT_LT(distance(normals[i + 6], plane), .6 * distance(normals[i + 3], plane)) << k;
                }
            }
            if (faces > most_faces + 1) {
                EXPECT_GT(distance(beside_creases.front(), beside_creases.back()), .1);
            }
        }
    };
    test(native(shapes::shaken(shapes::torus(8, 8))), kith::catmull_clark{}, 4, 1);
    test(native(shapes::shaken(shapes::triangulated(shapes::torus(8, 8)))), kith::loop{}, 6, 2);
}

/// Catmull-Clark with creases, under a name for which the library has no masks.
struct without_masks {
    kith::creases sharpness{};

    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "without-masks",
                                   .reach = [](const without_masks& s, int rings) { return s.sharpness.reach(rings); },
                                   .state = &without_masks::sharpness};
    }
    static constexpr auto columns() { return kith::catmull_clark::columns(); }
    template <class R>
    void operator()(const R& r) const
    {
        kith::catmull_clark{.corners = kith::boundary_corner::kept, .sharpness = sharpness}(r);
    }
};

/// Shows that steps alone give a user's scheme the normals of masks: inside, at boundaries, on both sides of creases,
/// at darts and at corners. Where normals nearby turn with the logarithm of the distance, steps give none.
TEST(surface, has_tangents_without_masks)
{
    std::size_t known = 0;
    for (const auto& shape : {shapes::grid(5, 5), shapes::l_shape(), shapes::torus(5, 6), shapes::cube()}) {
        const auto mesh = native(shapes::shaken(shape));
        without_masks scheme;
        for (std::size_t e = 0; e < mesh.edge_count(); e += 5)
            scheme.sharpness.sharpen_edge(e, e % 2 == 0 ? kith::infinitely_sharp : 1.5);
        const kith::catmull_clark with_masks{.corners = kith::boundary_corner::kept, .sharpness = scheme.sharpness};
        std::vector<surface_place> places;
        for (std::size_t c = 0; c < mesh.corner_count(); ++c)
            places.push_back(place_on_side(mesh, c, 0, 4));
        const auto expected =
            kith::surface_locator(mesh, with_masks).locate(places).evaluate(mesh.points(), derivatives::first);
        const auto made =
            kith::surface_locator(mesh, scheme).locate(places).evaluate(mesh.points(), derivatives::first);
        const auto expected_normals = normals_of(expected), normals = normals_of(made);
        for (std::size_t i = 0; i < places.size(); ++i) {
            EXPECT_LT(distance(made.points[i], expected.points[i]), 1e-13) << i;
            if (normals[i] == kith::normal_vector{})
                continue;
            ++known;
            EXPECT_LT(distance(normals[i], expected_normals[i]), 1e-11) << i;
        }
    }
    EXPECT_GT(known, 250U); // of 256 corners
}

TEST(surface, has_the_slopes_of_its_points)
{
    const auto test = [](const mesh3d& mesh, const auto& scheme) {
        constexpr double step = 1. / 16384;
        kith::surface_locator surface(mesh, scheme);
        std::vector<surface_place> places;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (const auto& [u, v] : {parameters{.3, .1}, {.07, .84}, {.4375, .47}, {.26, .01}})
                for (const auto& [x, y] : {parameters{0, 0}, {step, 0}, {-step, 0}, {0, step}, {0, -step}})
                    places.push_back({f, u + x, v + y, 0});
        const auto made = surface.locate(places).evaluate(mesh.points(), derivatives::second);
        const auto expect_slope = [&](const auto& of, std::size_t i, const auto& slope) {
            std::array<double, 3> difference{};
            for (std::size_t k = 0; k < 3; ++k)
                difference[k] = (of[i + 1][k] - of[i + 2][k]) / (2 * step);
            EXPECT_LT(distance(difference, slope), 4e-6) << "place " << i;
        };
        for (std::size_t i = 0; i < places.size(); i += 5) {
            expect_slope(made.points, i, made.du[i]);
            expect_slope(made.points, i + 2, made.dv[i]);
            expect_slope(made.du, i, made.duu[i]);
            expect_slope(made.du, i + 2, made.duv[i]);
            expect_slope(made.dv, i, made.duv[i]);
            expect_slope(made.dv, i + 2, made.dvv[i]);
        }
    };
    test(native(shapes::shaken(shapes::torus(5, 6))), kith::catmull_clark{});
    test(native(shapes::shaken(shapes::pentacube())), kith::catmull_clark{});
    test(native(shapes::shaken(shapes::torus(5, 6))), kith::nasri_hasbini{});
    test(native(shapes::shaken(shapes::torus(5, 6))), kith::doo_sabin{});
    test(native(shapes::shaken(shapes::torus(5, 6))), kith::mid_edge{});
    test(native(shapes::shaken(shapes::triangulated(shapes::torus(5, 6)))), kith::loop{});
    test(native(shapes::shaken(shapes::with_flips(shapes::triangulated(shapes::torus(6, 6)), 3))), kith::loop{});
    test(native(shapes::shaken(shapes::grid(3, 3))), kith::linear{});
}

/// Shows that schemes that are no splines have first derivatives of about seven digits.
TEST(surface, has_slopes_without_polynomials)
{
    const auto test = [](const mesh3d& mesh, const auto& scheme) {
        constexpr double step = 1. / 65536;
        kith::surface_locator surface(mesh, scheme);
        std::vector<surface_place> places;
        for (std::size_t f = 0; f < mesh.face_count(); f += 5)
            for (const auto& [u, v] : {parameters{.3, .1}, {.0625, .84}, {.4375, .47}})
                for (const auto& [x, y] : {parameters{0, 0}, {step, 0}, {-step, 0}, {0, step}, {0, -step}})
                    places.push_back({f, u + x, v + y, 0});
        const auto made = surface.locate(places).evaluate(mesh.points(), derivatives::second);
        for (std::size_t i = 0; i < places.size(); i += 5)
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR((made.points[i + 1][k] - made.points[i + 2][k]) / (2 * step), made.du[i][k], 1e-3);
                EXPECT_NEAR((made.points[i + 3][k] - made.points[i + 4][k]) / (2 * step), made.dv[i][k], 1e-3);
                EXPECT_TRUE(std::isnan(made.duu[i][k]));
            }
    };
    const auto triangles = native(shapes::shaken(shapes::with_flips(shapes::triangulated(shapes::torus(6, 6)), 3)));
    test(triangles, kith::butterfly{});
    test(triangles, kith::sqrt3{});
    test(native(shapes::shaken(shapes::torus(5, 6))), kith::kobbelt{});
}

/// Shows that points of the surface lie at their parameters if the control points do, up to corners of the boundary.
TEST(surface, keeps_planes_and_their_parameters)
{
    const auto test = [](shapes::shape shape, const auto& scheme, double from_boundary) {
        SCOPED_TRACE(std::string(kith::scheme_name<std::remove_cvref_t<decltype(scheme)>>()));
        constexpr double length = 11;
        for (auto& p : shape.points)
            p[2] = 0;
        const auto mesh = native(shape);
        kith::surface_locator surface(mesh, scheme);
        std::vector<surface_place> places;
        std::vector<point> expected;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            const auto face = mesh.face(f);
            const auto corner = [&](std::size_t k) { return mesh.point(face[k]); };
            const auto x = (corner(0)[0] + corner(2)[0]) / 2, y = (corner(0)[1] + corner(2)[1]) / 2;
            const double to_side = std::min(x, length - x), to_other = std::min(y, length - y);
            constexpr double beyond_corners = 4;
            if (std::max(to_side, to_other) < beyond_corners or std::min(to_side, to_other) < from_boundary)
                continue;
            for (const auto& [u, v] : {parameters{.3, .1}, {.05, .03}, {.6, .35}, {.1, .84}, {1. / 3, 1. / 3}}) {
                places.push_back({f, u, v, 0});
                const auto a = corner(0), b = corner(1), c = corner(face.size() - 1);
                expected.push_back(
                    {a[0] + u * (b[0] - a[0]) + v * (c[0] - a[0]), a[1] + u * (b[1] - a[1]) + v * (c[1] - a[1]), 0});
            }
        }
        const auto made = surface.locate(places).evaluate(mesh.points());
        ASSERT_GT(places.size(), 100U);
        for (std::size_t i = 0; i < places.size(); ++i)
            ASSERT_LT(distance(made.points[i], expected[i]), 1e-12) << "face " << places[i].face;
    };
    test(shapes::grid(11, 11), kith::catmull_clark{}, 0);
    test(shapes::grid(11, 11), kith::nasri_hasbini{}, 0);
    test(shapes::triangulated(shapes::grid(11, 11)), kith::loop{}, 0);
    test(shapes::triangulated(shapes::grid(11, 11)), kith::sqrt3{}, 3.5); // irregular along the boundary
}

/// Shows that splines reproduce quadratic polynomials, up to a constant, from their values at control points.
TEST(surface, reproduces_quadratic_surfaces)
{
    const auto height = [](double x, double y) { return (.5 * x * x - .25 * x * y + .125 * y * y) / 9; };
    const auto test = [&](shapes::shape shape, const auto& scheme) {
        for (auto& p : shape.points)
            p[2] = height(p[0], p[1]);
        const auto mesh = native(shape);
        const std::size_t face = mesh.face_count() / 2;
        const std::vector<surface_place> places{{face, .25, .375, 0}, {face, 0, 0, 0}, {face, 1. / 3, .6, 0}};
        kith::surface_locator surface(mesh, scheme);
        const auto made = surface.locate(places).evaluate(mesh.points(), derivatives::second);
        const auto curvatures = curvatures_of(made);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto [x, y, z] = made.points[i];
            const double by_x = (x - .25 * y) / 9, by_y = (-.25 * x + .25 * y) / 9;
            const double xx = 1. / 9, xy = -.25 / 9, yy = .25 / 9, w = 1 + by_x * by_x + by_y * by_y;
            EXPECT_NEAR(curvatures[i].gaussian, (xx * yy - xy * xy) / (w * w), 1e-13);
            EXPECT_NEAR(curvatures[i].mean,
                        ((1 + by_x * by_x) * yy - 2 * by_x * by_y * xy + (1 + by_y * by_y) * xx) /
                            (2 * std::pow(w, 1.5)),
                        1e-13);
            EXPECT_NEAR(curvatures[i].least * curvatures[i].most, curvatures[i].gaussian, 1e-13);
            EXPECT_NEAR(curvatures[i].least + curvatures[i].most, 2 * curvatures[i].mean, 1e-13);
        }
    };
    test(shapes::grid(7, 7), kith::catmull_clark{});
    test(shapes::triangulated(shapes::grid(7, 7)), kith::loop{});
}

TEST(surface, says_what_is_known_at_irregular_vertices)
{
    const auto mesh = native(shapes::shaken(shapes::cube()));
    kith::surface_locator surface(mesh, kith::catmull_clark{});
    const std::vector<surface_place> corners{{0, 0, 0, 0}, {0, 1, 0, 0}, {0, 1, 1, 0}, {0, 0, 1, 0}, {0, .5, .5, 0}};
    const auto at = surface.locate(corners);
    const auto made = at.evaluate(mesh.points(), derivatives::second);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_TRUE(std::isfinite(made.du[i][0]) and std::isfinite(made.dv[i][2]));
        EXPECT_TRUE(std::isnan(made.duu[i][0]) and std::isnan(made.dvv[i][2]));
        EXPECT_TRUE(std::isnan(curvatures_of(made)[i].mean));
    }
    EXPECT_TRUE(std::isfinite(curvatures_of(made)[4].mean));
    EXPECT_EQ(
        error_text<kith::mesh_error>([&] { static_cast<void>(at.weights(derivatives::second)); }),
        "place 0 is an irregular vertex or lies on a boundary, where such derivatives have no finite value; ask for "
        "fewer derivatives or move the place");
}

/// Shows that points converge to the limit of an irregular vertex, down to the smallest parameters of doubles.
TEST(surface, is_continuous_at_irregular_vertices)
{
    const auto mesh = native(shapes::shaken(shapes::triangulated(shapes::cube())));
    kith::surface_locator surface(mesh, kith::loop{});
    std::vector<surface_place> places{{2, 0, 0, 0}};
    for (const int exponent : {-10, -20, -52, -200, -1074})
        places.push_back({2, std::ldexp(1., exponent), std::ldexp(1., exponent), 0});
    const auto made = surface.locate(places).evaluate(mesh.points());
    for (std::size_t i = 1; i < places.size(); ++i)
        EXPECT_LT(distance(made.points[i], made.points[0]), i == 1 ? 1e-2 : i == 2 ? 1e-5 : 1e-13) << i;
}

TEST(surface, evaluates_any_values_and_weights)
{
    const auto mesh = native(shapes::shaken(shapes::pentacube()));
    kith::surface_locator surface(mesh, kith::catmull_clark{});
    const std::vector<surface_place> places{{0, .2, .7, 0}, {3, .99, .01, 0}, {5, 0, 0, 0}, {7, .5, .5, 0}};
    const auto at = surface.locate(places);
    const auto points = at.evaluate(mesh.points(), derivatives::first);
    const auto weights = at.weights(derivatives::first);
    const auto expect_rows = [&](const kith::storage<kith::stencil_row>& rows, const auto& values, double sum) {
        const auto matrix = kith::make_matrix(std::span(rows.data(), rows.size()), mesh.vertex_count());
        const auto made = matrix.apply(mesh.points());
        for (std::size_t i = 0; i < made.size(); ++i) {
            EXPECT_LT(distance(made[i], values[i]), 1e-13);
            double total = 0;
            for (const auto& [vertex, weight] : rows[i].entries)
                total += weight;
            EXPECT_NEAR(total, sum, 1e-13);
        }
    };
    expect_rows(weights.points, points.points, 1);
    expect_rows(weights.du, points.du, 0);
    expect_rows(weights.dv, points.dv, 0);
    std::vector<double> heights;
    for (const auto& p : mesh.points())
        heights.push_back(p[2]);
    const auto made = at.evaluate(heights, derivatives::first);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_EQ(made.points[i], points.points[i][2]);
        EXPECT_EQ(made.du[i], points.du[i][2]);
    }
    EXPECT_TRUE(made.duu.empty());
}

TEST(surface, has_the_same_bits_in_any_order_on_any_threads_and_for_moved_points)
{
    auto mesh = native(shapes::shaken(shapes::with_flips(shapes::triangulated(shapes::torus(12, 12)), 5)));
    std::vector<surface_place> places;
    for (std::size_t i = 0; i < 5000; ++i) {
        const double u = double(i * 37 % 1000 + 1) / 1002, v = (1 - u) * double(i * 71 % 997 + 1) / 999;
        places.push_back({i * 13 % mesh.face_count(), u, v, 0});
    }
    kith::surface_locator surface(mesh, kith::loop{});
    const auto at = surface.locate(places);
    const auto made = at.evaluate(mesh.points(), derivatives::second);
    {
        const thread_count threads(3);
        const auto on_threads = at.evaluate(mesh.points(), derivatives::second);
        EXPECT_TRUE(std::ranges::equal(on_threads.points, made.points));
        EXPECT_TRUE(std::ranges::equal(on_threads.duv, made.duv));
    }
    kith::surface_locator again(mesh, kith::loop{});
    for (std::size_t i = places.size(); i > 0; i -= 50) {
        const auto one = again.locate(std::span(places).subspan(i - 1, 1)).evaluate(mesh.points(), derivatives::second);
        EXPECT_EQ(one.points[0], made.points[i - 1]);
        EXPECT_EQ(one.dvv[0], made.dvv[i - 1]);
    }
    for (auto& p : mesh.points())
        p[0] *= 1.5;
    const auto moved = at.evaluate(mesh.points());
    EXPECT_TRUE(std::ranges::equal(
        moved.points, kith::surface_locator(mesh, kith::loop{}).locate(places).evaluate(mesh.points()).points));
    EXPECT_NE(moved.points[0], made.points[0]);
}

/// Shows that the numbers of faces and edges change nothing, and that a part of the mesh such as a tile is enough.
TEST(surface, has_the_same_bits_in_any_numbers_and_in_parts)
{
    auto shape = shapes::shaken(shapes::with_flips(shapes::triangulated(shapes::torus(8, 9)), 7));
    const auto mesh = native(shape);
    std::ranges::reverse(shape.faces);
    const auto reversed = native(shape);
    kith::surface_locator surface(mesh, kith::loop{}), of_reversed(reversed, kith::loop{});
    kith::submesh_cutter<point, std::uint32_t> cutter(mesh);
    for (std::uint32_t f = 0; f < mesh.face_count(); f += 5) {
        const std::vector<surface_place> places{{f, .3, .2, 0}, {f, .01, .98, 0}, {f, 0, 0, 0}, {f, .5, .25, 0}};
        const auto made = surface.locate(places).evaluate(mesh.points(), derivatives::first);
        const auto part = cutter.cut(cutter.faces_around(std::array{f}, 1));
        const auto here = std::size_t(std::ranges::find(part.face_from, f) - part.face_from.begin());
        auto there = places, in_part = places;
        for (std::size_t i = 0; i < places.size(); ++i) {
            there[i].face = mesh.face_count() - 1 - f;
            in_part[i].face = here;
        }
        const auto by_reversed = of_reversed.locate(there).evaluate(reversed.points(), derivatives::first);
        const auto by_part =
            kith::surface_locator(part.mesh, kith::loop{}).locate(in_part).evaluate(part.mesh.points());
        EXPECT_TRUE(std::ranges::equal(made.points, by_reversed.points));
        EXPECT_TRUE(std::ranges::equal(made.dv, by_reversed.dv));
        EXPECT_TRUE(std::ranges::equal(made.points, by_part.points));
    }
}

TEST(surface, locates_the_same_on_threads)
{
    const auto mesh = native(shapes::shaken(shapes::torus(40, 30)));
    const auto scheme = with_creases(kith::catmull_clark{}, mesh, 1.5);
    const auto places = places_of_level<kith::catmull_clark>(mesh, 1);
    const auto make = [&](int threads) {
        const thread_count count(threads);
        return kith::surface_locator(mesh, scheme).locate(places).evaluate(mesh.points(), derivatives::first);
    };
    const auto one = make(1), three = make(3);
    EXPECT_TRUE(std::ranges::equal(one.points, three.points));
    EXPECT_TRUE(std::ranges::equal(one.dv, three.dv));
}

/// Shows that a torus whose corner values have two seams is the grid that results from cutting it along the seams.
TEST(surface, has_values_with_seams)
{
    constexpr std::size_t n = 6;
    const auto joined = [](std::size_t v) { return v / (n + 1) % n * n + v % (n + 1) % n; };
    const auto test = [joined](shapes::shape grid, auto scheme) {
        auto torus = grid; // opposite sides are joined
        for (auto& face : torus.faces)
            for (auto& v : face)
                v = joined(v);
        torus.points.resize(n * n);
        const auto mesh = native(torus), cut = native(shapes::shaken(grid));
        ASSERT_EQ(mesh.face_count(), cut.face_count());
        std::vector<point> values;
        std::vector<surface_place> places, of_places; // in the torus and in the grid
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            const auto face = mesh.face(f), cut_face = cut.face(f);
            std::size_t turns = 0; // a face may begin at another corner
            while (joined(cut_face[turns]) != face[0])
                ++turns;
            for (std::size_t k = 0; k < face.size(); ++k)
                values.push_back(cut.point(cut_face[(k + turns) % face.size()]));
            for (auto [u, v] : {parameters{0, 0}, {.3, .1}, {1, 0}, {.05, .03}, {.6, .35}, {.01, .98}}) {
                of_places.push_back({f, u, v, 0});
                for (std::size_t turn = 0; turn < turns; ++turn)
                    std::tie(u, v) = std::tuple(v, face.size() == 4 ? 1 - u : 1 - u - v);
                places.push_back({f, u, v, 0});
            }
        }
        for (const auto linear : {kith::face_varying_linear::none, kith::face_varying_linear::corners_plus1}) {
            scheme.corners = kith::boundary_corner::smoothed;
            auto of_cut = scheme;
            if (linear != kith::face_varying_linear::none) // where the seams cross
                for (const std::size_t corner : {0, 6, 42, 48})
                    of_cut.sharpness.sharpen_vertex(corner, kith::infinitely_sharp);
            const auto expected =
                kith::surface_locator(cut, of_cut).locate(of_places).evaluate(cut.points(), derivatives::first);
            kith::surface_locator surface(mesh, scheme);
            const auto at = surface.locate(places, kith::on_corners(values, kith::face_varying{linear}));
            const auto made = at.evaluate(values, derivatives::first);
            const auto normals = normals_of(made), expected_normals = normals_of(expected);
            for (std::size_t i = 0; i < places.size(); ++i) {
                ASSERT_LT(distance(made.points[i], expected.points[i]), 1e-13) << i;
                if (i % 6 % 2 != 0) { // places that are not at a vertex
                    ASSERT_LT(distance(normals[i], expected_normals[i]), 1e-12) << i;
                }
            }
            EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(at.evaluate(mesh.points())); }),
                      "places on a surface with " + std::to_string(values.size()) + " control corners were given " +
                          std::to_string(mesh.vertex_count()) + " values; give one for each of these corners");
        }
    };
    test(shapes::grid(n, n), kith::catmull_clark{});
    test(shapes::triangulated(shapes::grid(n, n)), kith::loop{});
    kith::surface_locator surface(native(shapes::cube()), kith::catmull_clark{});
    EXPECT_EQ(error_text<kith::mesh_error>([&] {
                  static_cast<void>(surface.locate(std::vector{surface_place{}},
                                                   kith::on_corners(std::vector<double>(7), kith::face_varying{})));
              }),
              "a field on corners has 7 values, the mesh has 24 corners; give it one for each");
}

/// Shows that a user's scheme with state is refined by its own code.
TEST(surface, takes_a_scheme_that_carries_state)
{
    const auto mesh = native(shapes::shaken(shapes::torus(5, 6)));
    const auto inner = with_creases(kith::catmull_clark{}, mesh, 1.5);
    const std::vector<surface_place> places{{0, .2, .7, 0}, {3, .99, .01, 0}, {5, 0, 0, 0}, {7, .5, .5, 0}};
    const auto expected =
        kith::surface_locator(mesh, inner).locate(places).evaluate(mesh.points(), derivatives::second);
    const auto made = kith::surface_locator(mesh, own_state::wrapped{inner})
                          .locate(places)
                          .evaluate(mesh.points(), derivatives::second);
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_LT(distance(made.points[i], expected.points[i]), 1e-13);
}

/// Shows that state without the place of its elements may differ between faces that look alike.
TEST(surface, tells_apart_faces_by_state_without_places)
{
    const auto mesh = native(shapes::shaken(shapes::torus(5, 6)));
    auto scheme = own_state::some_drawn(mesh);
    scheme.sharp = {};
    const auto limits = limit_surface_of(mesh, scheme);
    std::vector<surface_place> places;
    for (std::size_t f = 0; f < mesh.face_count(); f += 7)
        places.push_back({f, 0, 0, 0});
    const auto made = kith::surface_locator(mesh, scheme).locate(places).evaluate(mesh.points());
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_LT(distance(made.points[i], limits.positions[mesh.face(places[i].face)[0]]), 1e-9) << i;
}

TEST(surface, refuses_what_is_no_place)
{
    const auto quads = native(shapes::cube());
    const auto triangles = native(shapes::tetrahedron());
    const auto polygons = native(shapes::polygon(5));
    const auto text = [](const mesh3d& mesh, const auto& scheme, const surface_place& place) {
        return error_text<kith::mesh_error>([&] {
            kith::surface_locator surface(mesh, scheme);
            static_cast<void>(surface.locate(std::vector{surface_place{0, .25, .25, 0}, place}));
        });
    };
    const double no_number = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(text(quads, kith::catmull_clark{}, {6, 0, 0, 0}),
              "place 1: face 6 does not exist, there are 6; give the number of a face of the control mesh");
    EXPECT_EQ(text(quads, kith::catmull_clark{}, {5, 0, 1.5, 0}),
              "place 1: u is 0.000000 and v is 1.500000; give numbers from 0 to 1");
    EXPECT_EQ(text(quads, kith::catmull_clark{}, {5, no_number, 0, 0}),
              "place 1: u is nan and v is 0.000000; give numbers from 0 to 1");
    EXPECT_EQ(text(quads, kith::catmull_clark{}, {5, 0, 0, 1}),
              "place 1: face 5 has no sub-face 1, there are 1; give 0 to 0");
    EXPECT_EQ(text(polygons, kith::catmull_clark{}, {0, 0, 0, 5}),
              "place 1: face 0 has no sub-face 5, there are 5; give 0 to 4");
    EXPECT_EQ(text(triangles, kith::loop{}, {0, .75, .5, 0}),
              "place 1: u + v is 1.250000 in a triangle; give at most 1");
    EXPECT_EQ(text(quads, kith::loop{}, {0, 0, 0, 0}).find("loop"), 0U);
    kith::surface_locator surface(quads, kith::catmull_clark{});
    EXPECT_EQ(error_text<kith::mesh_error>([&] {
                  static_cast<void>(surface.locate(std::vector{surface_place{}}).evaluate(std::vector<double>(7)));
              }),
              "places on a surface with 8 control vertices were given 7 values; give one for each of these vertices");
}

} // namespace
