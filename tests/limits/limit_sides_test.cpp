// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limits/limit_surface.hpp>

#include "support/all_shapes.hpp"
#include "support/native_shape.hpp"

#include <kith/compiled_schemes.hpp>
#include <kith/hierarchy.hpp>
#include <kith/limits/limit_evaluator.hpp>
#include <kith/schemes/crease/vertex_type.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

using kith::boundary_corner;
using kith::boundary_curve;
using kith::catmull_clark;
using kith::hierarchy;
using kith::infinitely_sharp;
using kith::loop;
using kith::normal_vector;
using kith::vertex_type;
namespace targets = kith::targets;

double distance(const normal_vector& a, const normal_vector& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
normal_vector unit(double x, double y, double z)
{
    const double length = std::hypot(x, y, z);
    return {x / length, y / length, z / length};
}

/// Returns the number of the edge between two vertices.
std::size_t edge_between(const mesh3d& mesh, std::size_t a, std::size_t b)
{
    const kith::level_of<mesh3d> level(mesh);
    for (const auto e : level.edges())
        if (std::minmax(e.org().index(), e.dst().index()) == std::minmax(a, b))
            return e.index();
    ADD_FAILURE() << "no edge between " << a << " and " << b;
    return 0;
}

template <class Scheme>
Scheme with_all_edges_sharp(const mesh3d& mesh)
{
    Scheme scheme;
    for (std::size_t e = 0; e < mesh.edge_count(); ++e)
        scheme.sharpness.sharpen_edge(e, infinitely_sharp);
    return scheme;
}

/// Returns the scheme with infinitely sharp creases that cross, and that end inside and at the boundary, and with a
/// sharp vertex. `seed` selects the elements.
template <class Scheme>
Scheme with_creases(const mesh3d& mesh, std::size_t seed, Scheme scheme = {})
{
    const kith::level_of<mesh3d> level(mesh);
    for (const auto e : level.edges())
        if ((e.index() * 7 + seed) % 5 < 2)
            scheme.sharpness.sharpen_edge(e.index(), infinitely_sharp);
    scheme.sharpness.sharpen_vertex(seed % mesh.vertex_count(), infinitely_sharp);
    return scheme;
}

/// Checks that the limits of vertices of level 0 equal those of their descendants on three more levels. The same holds
/// for normals of vertices and of corners; the order of corners around a vertex stays. At a corner of the surface with
/// several faces only the plane is checked. There the faces of a level decide to which side the normal points.
template <class Scheme>
void expect_one_limit_on_all_levels(const mesh3d& mesh, const Scheme& scheme)
{
    constexpr int depth = 3;
    constexpr double tolerance = 1e-9;
    hierarchy levels(mesh, scheme);
    levels.refine(depth);
    std::vector<kith::limit_surface<shapes::point>> limits;
    std::vector<kith::storage<normal_vector>> corners;
    for (int i = 0; i <= depth; ++i) {
        limits.push_back(limit_surface_of(levels, i));
        corners.push_back(normals_of_corners(levels[i], limits.back()));
    }
    const auto& coarse = levels.elements(0);
    for (const auto v : coarse.vertices()) {
        const auto type = kith::type_of(v, scheme.sharpness, scheme.corners);
        const bool is_corner = v.face_count() > 1 and
                               (type == vertex_type::corner or type == vertex_type::boundary_crease);
        std::size_t here = v.index();
        std::vector<std::size_t> fan;
        for (const auto c : v.corners())
            fan.push_back(c.index());
        for (int i = 1; i <= depth; ++i) {
            here = levels.assoc(i - 1, levels.elements(i - 1).vertex_at(here), targets::V).value;
            const auto& fine = limits[std::size_t(i)];
            EXPECT_LT(distance(fine.positions[here], limits[0].positions[v.index()]), 1e-13)
                << "vertex " << v.index() << " on level " << i;
            if (not is_corner) {
                EXPECT_LT(distance(fine.normals[here], limits[0].normals[v.index()]), tolerance)
                    << "vertex " << v.index() << " on level " << i;
            }
            auto corner = fan.begin();
            for (const auto c : levels.elements(i).vertices()[here].corners()) {
                ASSERT_NE(corner, fan.end());
                const auto& normal = corners[std::size_t(i)][c.index()];
                const double away = distance(normal, corners[0][*corner]);
                EXPECT_LT(is_corner ? std::min(away, 2 - away) : away, tolerance)
                    << "corner " << *corner << " of vertex " << v.index() << " on level " << i;
                ++corner;
            }
        }
    }
}

/// Makes the paraboloid z = x^2 + y^2 over n x n quads.
shapes::shape bowl(std::size_t n)
{
    auto result = shapes::grid(n, n);
    for (auto& p : result.points)
        p[2] = p[0] * p[0] + p[1] * p[1];
    return result;
}

} // namespace

TEST(limit_sides, a_smoothed_corner_has_the_plane_of_its_edges_on_all_levels)
{
    const auto check = [](const mesh3d& mesh, const auto& scheme) {
        const auto corner = mesh.point(0), a = mesh.point(1), b = mesh.point(3);
        ASSERT_EQ(kith::level_of<mesh3d>(mesh).vertices()[0].face_count(), 1);
        const std::array<double, 3> u{a[0] - corner[0], a[1] - corner[1], a[2] - corner[2]};
        const std::array<double, 3> w{b[0] - corner[0], b[1] - corner[1], b[2] - corner[2]};
        const auto plane = unit(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]);
        hierarchy levels(mesh, scheme);
        levels.refine(3);
        for (int i = 0; i <= 3; ++i) {
            EXPECT_LT(distance(limit_surface_of(levels, i).normals[0], plane), 1e-12) << "level " << i;
            const auto known = limit_normals(levels.elements(i), levels.scheme(i))[0];
            ASSERT_TRUE(known);
            EXPECT_LT(distance(*known, plane), 1e-12) << "level " << i;
        }
    };
    const auto quads = native(bowl(2));
    check(quads, catmull_clark{.corners = boundary_corner::smoothed, .sharpness = {}});
    check(quads, catmull_clark{});
    shapes::shape triangles = bowl(2); // the diagonals leave vertex 0 a single face
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& f : triangles.faces) {
        faces.push_back({f[0], f[1], f[3]});
        faces.push_back({f[1], f[2], f[3]});
    }
    triangles.faces = faces;
    check(native(triangles), loop{.corners = boundary_corner::smoothed, .sharpness = {}});
    check(native(triangles), loop{});
}

TEST(limit_sides, a_hard_cube_has_the_normals_of_its_faces)
{
    const auto check = [](const mesh3d& mesh, const auto& scheme) {
        hierarchy levels(mesh, scheme);
        levels.refine(2);
        for (int i = 0; i <= 2; ++i) {
            const auto limits = limit_surface_of(levels, i);
            const auto normals = normals_of_corners(levels[i], limits);
            const auto& level = levels.elements(i);
            for (const auto f : level.faces()) {
                // All faces lie in the sides of the cube.
                std::array<double, 3> middle{};
                for (const auto c : f.corners())
                    for (std::size_t k = 0; k < 3; ++k)
                        middle[k] += c.v().point()[k];
                const auto largest = std::ranges::max_element(middle, {}, [](double x) { return std::abs(x); });
                normal_vector upright{};
                upright[std::size_t(largest - middle.begin())] = *largest > 0 ? 1 : -1;
                for (const auto c : f.corners())
                    EXPECT_LT(distance(normals[c.index()], upright), 1e-14)
                        << "corner " << c.index() << ", level " << i;
            }
            for (std::size_t v = 0; v < 8; ++v)
                EXPECT_LT(distance(limits.normals[v], unit(mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2])),
                          1e-14);
        }
    };
    const auto cube = native(shapes::cube());
    check(cube, with_all_edges_sharp<catmull_clark>(cube));
    const auto cut = native(shapes::triangulated(shapes::cube()));
    loop scheme;
    for (std::size_t e = 0; e < cube.edge_count(); ++e) {
        const auto [a, b] = std::pair{kith::level_of<mesh3d>(cube).edges()[e].org().index(),
                                      kith::level_of<mesh3d>(cube).edges()[e].dst().index()};
        scheme.sharpness.sharpen_edge(edge_between(cut, a, b), infinitely_sharp);
    }
    check(cut, scheme);
}

TEST(limit_sides, notches_look_outwards)
{
    // Three cubes in an L, with all edges between different planes sharp. At the ends of the inner edge, the sides of
    // the L have one face per cube and span 270 degrees.
    const auto at = [](std::size_t column, std::size_t layer) { return 2 * column + layer; };
    shapes::shape solid;
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 2}, {1, 2}})
        for (const int z : {0, 1})
            solid.points.push_back({double(x), double(y), double(z)});
    for (const auto& f : {std::array<std::size_t, 4>{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}}) {
        solid.faces.push_back({at(f[0], 1), at(f[1], 1), at(f[2], 1), at(f[3], 1)});
        solid.faces.push_back({at(f[3], 0), at(f[2], 0), at(f[1], 0), at(f[0], 0)});
    }
    constexpr std::array<std::size_t, 8> outline{0, 1, 2, 5, 4, 7, 6, 3};
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t a = outline[i], b = outline[(i + 1) % outline.size()];
        solid.faces.push_back({at(a, 0), at(b, 0), at(b, 1), at(a, 1)});
    }
    const auto l = native(solid);
    const kith::level_of<mesh3d> level(l);
    const auto normal_of = [](const auto& f) {
        normal_vector n{};
        for (const auto c : f.corners()) {
            const auto a = c.v().point(), b = c.next().v().point();
            for (std::size_t i = 0; i < 3; ++i)
                n[i] += (a[(i + 1) % 3] - b[(i + 1) % 3]) * (a[(i + 2) % 3] + b[(i + 2) % 3]);
        }
        return unit(n[0], n[1], n[2]);
    };
    catmull_clark scheme;
    for (const auto e : level.edges())
        if (not e.is_boundary() and distance(normal_of(e.lface()), normal_of(e.rface())) > 1e-6)
            scheme.sharpness.sharpen_edge(e.index(), infinitely_sharp);
    const auto normals = normals_of_corners(l, limit_surface_of(l, scheme));
    for (const auto f : level.faces())
        for (const auto c : f.corners())
            EXPECT_LT(distance(normals[c.index()], normal_of(f)), 1e-9) << "corner " << c.index();
}

/// Shows the values of OpenSubdiv 3.5's limit masks after two steps; OpenSubdiv has only the first side of a crease.
TEST(limit_sides, agrees_with_opensubdiv)
{
    const auto mesh = native(bowl(2));
    const auto at = [](const auto& normals, const mesh3d& of, std::size_t f, std::size_t v) {
        const auto face = of.face(f);
        return normals[4 * f + std::size_t(std::ranges::find(face, v) - face.begin())];
    };
    catmull_clark smoothed{.corners = boundary_corner::smoothed, .sharpness = {}};
    const auto of_corners = limit_surface_of(mesh, smoothed).normals;
    EXPECT_LT(distance(of_corners[0], {-0.57735026919, -0.57735026919, 0.57735026919}), 1e-11);
    EXPECT_LT(distance(of_corners[2], {-0.904534033733, -0.301511344578, 0.301511344578}), 1e-11);
    EXPECT_LT(distance(of_corners[4], {-0.666666666667, -0.666666666667, 0.333333333333}), 1e-11);
    EXPECT_LT(distance(of_corners[6], {-0.301511344578, -0.904534033733, 0.301511344578}), 1e-11);
    EXPECT_LT(distance(of_corners[8], {-0.688247201612, -0.688247201612, 0.229415733871}), 1e-11);
    smoothed.sharpness.sharpen_edge(edge_between(mesh, 1, 4), infinitely_sharp);
    smoothed.sharpness.sharpen_edge(edge_between(mesh, 4, 7), infinitely_sharp);
    const auto limits = limit_surface_of(mesh, smoothed);
    const auto normals = normals_of_corners(mesh, limits);
    for (const std::size_t right : {1, 3})
        EXPECT_LT(distance(at(normals, mesh, right, 4), {-0.801783725737, -0.534522483825, 0.267261241912}), 1e-11);
    for (const std::size_t left : {0, 2})
        EXPECT_LT(distance(at(normals, mesh, left, 4), unit(-1, -2, 1)), 1e-14);
    EXPECT_LT(distance(at(normals, mesh, 1, 1), {-0.904534033733, -0.301511344578, 0.301511344578}), 1e-11);
    EXPECT_LT(distance(at(normals, mesh, 0, 1), unit(-1, -1, 1)), 1e-14);
    EXPECT_LT(distance(limits.positions[4], {1, 1, 2.33333333333}), 1e-11);
}

TEST(limit_sides, all_levels_have_the_same_limits_and_normals)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        const auto mesh = native(shape);
        for (const auto corners : {boundary_corner::kept, boundary_corner::smoothed})
            for (const auto boundary : {boundary_curve::cubic, boundary_curve::thirds})
                for (const std::size_t seed : {0, 3, 11}) {
                    if (mesh.face_count() > 60 and seed != (boundary == boundary_curve::cubic ? 3 : 0))
                        continue;
                    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
                    const catmull_clark plain{.corners = corners, .boundary = boundary, .sharpness = {}};
                    expect_one_limit_on_all_levels(mesh, seed == 0 ? plain : with_creases(mesh, seed, plain));
                    if (mesh.topology().degree == 3 and boundary == boundary_curve::cubic) {
                        const loop triangles{.weights = seed == 3 ? kith::loop_weights::warren
                                                                  : kith::loop_weights::loop,
                                             .corners = corners,
                                             .sharpness = {}};
                        expect_one_limit_on_all_levels(mesh,
                                                       seed == 0 ? triangles : with_creases(mesh, seed, triangles));
                    }
                }
    }
}
