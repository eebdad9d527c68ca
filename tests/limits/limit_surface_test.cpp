// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limits/limit_surface.hpp>

#include "support/every_scheme.hpp"
#include "support/thread_count.hpp"
#include "support/tiles.hpp"

#include <kith/hierarchy.hpp>
#include <kith/refine_in_tiles.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace {

using kith::hierarchy;
namespace targets = kith::targets;
using point = shapes::point;

double distance(const point& a, const point& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The descendant of a vertex on a later level: a vertex, an edge or a face, as docs/schemes.md describes for each
/// scheme.
struct descendant {
    char kind = 'v';
    std::size_t index = 0;
};

template <class Scheme>
descendant next_of_dual(const hierarchy<mesh3d, Scheme>& levels, int level, descendant d)
{
    const auto& here = levels.elements(level);
    const auto face = [&](const auto& x) { return descendant{'f', levels.assoc(level, x.handle(), targets::F).value}; };
    if (d.kind == 'f')
        return face(here.faces()[d.index]);
    if (d.kind == 'e') { // a boundary edge: it has one face, and stays an edge of that face
        const auto e = here.edges()[d.index];
        return {'e', levels.assoc(level, e.handle(), e.lface().handle(), targets::E).value};
    }
    const auto v = here.vertices()[d.index];
    const std::size_t k = v.face_count();
    if constexpr (std::same_as<Scheme, kith::mid_edge>) {
        return k == 1 ? face(v.first_corner().f()) : face(v);
    } else if constexpr (std::same_as<Scheme, kith::doo_sabin>) {
        if (not v.is_boundary())
            return face(v);
        if (levels.scheme(level).boundary == kith::doo_sabin_boundary::drop) {
            auto c = v.first_corner();
            for (std::size_t i = 1; i < (k + 1) / 2; ++i)
                c = c.prev().across();
            return k % 2 != 0 ? face(c.f()) : face(c.prev_edge());
        }
        if (k == 1)
            return {'v', levels.assoc(level, v.handle(), v.first_corner().f().handle(), targets::V).value};
        if (k == 2)
            return {'e', levels.assoc(level, v.handle(), v.first_corner().prev_edge().handle(), targets::E).value};
        return {'e', levels.assoc(level, v.handle(), targets::E).value};
    } else {
        return face(v);
    }
}
template <class Scheme>
descendant next(const hierarchy<mesh3d, Scheme>& levels, int level, descendant d)
{
    if constexpr (std::same_as<Scheme, kith::mid_edge> or std::same_as<Scheme, kith::doo_sabin>)
        return next_of_dual(levels, level, d);
    else if constexpr (std::same_as<Scheme, kith::unified>)
        if (not levels.scheme(level).is_primal())
            return next_of_dual(levels, level, d);
    if constexpr (not std::same_as<Scheme, kith::mid_edge> and not std::same_as<Scheme, kith::doo_sabin>)
        return {'v', levels.assoc(level, levels.elements(level).vertex_at(d.index), targets::V).value};
}

template <class Scheme>
point place(const hierarchy<mesh3d, Scheme>& levels, int level, descendant d)
{
    std::vector<std::size_t> vertices;
    const auto& here = levels.elements(level);
    if (d.kind == 'v')
        vertices.push_back(d.index);
    else if (d.kind == 'e')
        vertices = {here.edges()[d.index].org().index(), here.edges()[d.index].dst().index()};
    else
        for (const auto v : here.faces()[d.index].vertices())
            vertices.push_back(v.index());
    point result{};
    for (const std::size_t v : vertices)
        for (std::size_t i = 0; i < 3; ++i)
            result[i] += levels[level].point(v)[i] / double(vertices.size());
    return result;
}

/// The number of steps after which the convergence of a scheme can be judged.
template <class Scheme>
struct depth_of {
    static constexpr int value = std::same_as<Scheme, kith::nasri_hasbini> ? 3
                                 : std::same_as<Scheme, kith::four_eight>  ? 8
                                                                           : 4;
};

void expect_unit(const kith::normal_vector& n)
{
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-15);
}

/// Expects for every vertex of levels 0 and 1 that its descendants have the same limit, and that the levels converge to
/// it.
template <class Scheme>
void expect_limits(const mesh3d& control, const Scheme& scheme)
{
    constexpr int depth = depth_of<Scheme>::value;
    hierarchy levels(control, scheme);
    levels.refine(depth);
    std::vector<kith::limit_surface<point>> limits;
    for (int i = 0; i < 3; ++i)
        limits.push_back(limit_surface_of(levels, i));
    double size = 0;
    for (const auto& p : control.points())
        size = std::max(size, distance(p, control.point(0)));
    for (int from = 0; from < 2; ++from) {
        double early = 0, late = 0;
        for (std::size_t v = 0; v < levels[from].vertex_count(); ++v) {
            const point limit = limits[std::size_t(from)].positions[v];
            descendant d{'v', v};
            for (int i = from; i < depth; ++i) {
                d = next(levels, i, d);
                if (i + 1 <= 2 and d.kind == 'v') {
                    ASSERT_LT(distance(limits[std::size_t(i + 1)].positions[d.index], limit), 2e-14 * size)
                        << "vertex " << v << " of level " << from << " on level " << i + 1;
                }
                if (i == from)
                    early = std::max(early, distance(place(levels, i + 1, d), limit));
            }
            late = std::max(late, distance(place(levels, depth, d), limit));
        }
        // Convergence is slowest in a strip along a boundary: 3/4 per step.
        EXPECT_LE(late, early * std::pow(0.78, depth - from - 1) + 1e-4 * size) << "of level " << from;
        for (const auto& n : limits[std::size_t(from)].normals)
            expect_unit(n);
    }
}

} // namespace

TEST(limit_surface, no_vertex_is_left_out_and_all_levels_agree)
{
    for_each_of_all_schemes_and_shape(
        []<class Scheme>(const Scheme& scheme, const mesh3d& mesh) { expect_limits(mesh, scheme); });
}

namespace {

/// Returns the scheme with infinitely sharp and decaying creases, darts, and corners inside, all over the mesh.
template <class Scheme>
Scheme with_creases(const mesh3d& mesh, kith::crease_method method)
{
    Scheme scheme;
    scheme.sharpness.method = method;
    const kith::level_of<mesh3d> level(mesh);
    for (const auto e : level.edges()) {
        if (e.index() % 7 == 0)
            scheme.sharpness.sharpen_edge(e.index(), kith::infinitely_sharp);
        else if (e.index() % 7 == 3)
            scheme.sharpness.sharpen_edge(e.index(), 0.4 + double(e.index() % 5) / 2);
    }
    scheme.sharpness.sharpen_vertex(0, kith::infinitely_sharp);
    scheme.sharpness.sharpen_vertex(mesh.vertex_count() - 1, 1.5);
    return scheme;
}

} // namespace

TEST(limit_surface, of_creases_darts_and_what_decays)
{
    using kith::crease_method;
    for (const auto& [name, shape] : shapes::all_shapes())
        for (const auto method : {crease_method::uniform, crease_method::chaikin}) {
            SCOPED_TRACE(name);
            const auto mesh = native(shape);
            expect_limits(mesh, with_creases<kith::catmull_clark>(mesh, method));
            if (mesh.topology().degree == 3)
                expect_limits(mesh, with_creases<kith::loop>(mesh, method));
        }
}

namespace {

/// Expects no tangents at vertices of the first levels for which the rules say that there are never any. The same holds
/// for their descendants. `told` counts these vertices.
template <class Scheme>
void expect_no_later_tangents(const mesh3d& control, const Scheme& scheme, std::size_t& told)
{
    using rules_of = kith::limit_rules<Scheme>;
    hierarchy levels(control, scheme);
    levels.refine(3);
    const auto has_tangents = [&](int level, std::size_t v) {
        const auto& elements = levels.elements(level);
        bool result = false;
        rules_of::tangents(rules_of::on(levels.scheme(level), elements),
                           elements.vertices()[v],
                           [&](const auto&, const auto&) { result = true; });
        return result;
    };
    for (int level = 0; level < 2; ++level)
        for (const auto v : levels.elements(level).vertices())
            if (rules_of::never_has_tangents(rules_of::on(levels.scheme(level), levels.elements(level)), v)) {
                ++told;
                std::size_t here = v.index();
                for (int finer = level; finer <= 3; ++finer) {
                    EXPECT_FALSE(has_tangents(finer, here)) << level << ' ' << v.index() << ' ' << finer;
                    if (finer < 3)
                        here = levels.assoc(finer, levels.elements(finer).vertices()[here].handle(), targets::V).value;
                }
            }
}

} // namespace

TEST(limit_surface, is_not_asked_for_normals_that_no_later_level_has)
{
    std::size_t told = 0;
    for (const auto& [name, shape] : shapes::all_shapes())
        for (const auto corners : {kith::boundary_corner::kept, kith::boundary_corner::smoothed}) {
            SCOPED_TRACE(name);
            const auto mesh = native(shape);
            auto quads = with_creases<kith::catmull_clark>(mesh, kith::crease_method::uniform);
            quads.corners = corners;
            expect_no_later_tangents(mesh, quads, told);
            expect_no_later_tangents(mesh, kith::catmull_clark{.corners = corners, .sharpness = {}}, told);
            if (mesh.topology().degree == 3) {
                auto triangles = with_creases<kith::loop>(mesh, kith::crease_method::chaikin);
                triangles.corners = corners;
                expect_no_later_tangents(mesh, triangles, told);
            }
        }
    EXPECT_GT(told, 100U);
}

TEST(limit_surface, of_edges_that_are_sharp_for_longer_than_digits_last)
{
    const auto torus = native(shapes::shaken(shapes::torus(5, 7)));
    kith::catmull_clark for_long, for_ever;
    for (const std::size_t e : {0U, 3U, 20U}) {
        for_long.sharpness.sharpen_edge(e, 1e9);
        for_ever.sharpness.sharpen_edge(e, kith::infinitely_sharp);
    }
    const auto a = limit_surface_of(torus, for_long), b = limit_surface_of(torus, for_ever);
    for (std::size_t v = 0; v < torus.vertex_count(); ++v)
        EXPECT_LT(distance(a.positions[v], b.positions[v]), 1e-13) << "vertex " << v;
}

TEST(limit_surface, of_floats_comes_as_near_as_floats_can)
{
    const auto shape = shapes::shaken(shapes::torus(5, 7));
    const auto torus = native(shape);
    const auto floats = kith::make_mesh(std::vector<std::array<float, 3>>(shape.points.size()), shape.faces);
    auto of_floats = kith::basic_mesh(kith::storage<std::array<float, 3>>(floats.points()), floats.topology());
    for (std::size_t v = 0; v < torus.vertex_count(); ++v)
        for (std::size_t i = 0; i < 3; ++i)
            of_floats.points()[v][i] = float(torus.point(v)[i]);
    for (std::size_t e = 0; e < torus.edge_count(); e += 5) { // the ends of the edge are darts
        kith::catmull_clark scheme;
        scheme.sharpness.sharpen_edge(e, kith::infinitely_sharp);
        const auto in_doubles = limit_surface_of(torus, scheme);
        const auto in_floats = limit_surface_of(of_floats, scheme);
        for (std::size_t v = 0; v < torus.vertex_count(); ++v)
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(double(in_floats.positions[v][i]), in_doubles.positions[v][i], 1e-5) << "vertex " << v;
    }
}

/// Shows that vertices of a deep level have limits: 112 vertices of this mesh once had none, on any level.
TEST(limit_surface, of_the_triangulated_cube_on_a_deep_level)
{
    const auto cube = native(shapes::shaken(shapes::triangulated(shapes::cube())));
    const auto expect_all = [&](const mesh3d& control, const auto& scheme, int level, int deeper, double tolerance) {
        hierarchy levels(control, scheme);
        levels.refine(level + deeper);
        const auto limits = limit_surface_of(levels, level);
        ASSERT_EQ(limits.positions.size(), levels[level].vertex_count());
        for (std::size_t v = 0; v < limits.positions.size(); ++v) {
            descendant d{'v', v};
            for (int i = level; i < level + deeper; ++i)
                d = next(levels, i, d);
            EXPECT_LT(distance(place(levels, level + deeper, d), limits.positions[v]), tolerance) << "vertex " << v;
        }
    };
    expect_all(kith::tri_quad(cube), kith::four_eight(), 4, 6, 2e-3);
    expect_all(cube, kith::nasri_hasbini(), 2, 2, 2e-3);
    expect_all(native(shapes::shaken(shapes::triangulated(shapes::grid()))), kith::sqrt3(), 4, 4, 2e-2);
    expect_all(cube, kith::unified{.degree = 8}, 3, 3, 2e-2);
}

/// Checks that coordinates times a power of two scale limits and change no bit of a normal, while they are finite.
TEST(limit_surface, normals_neither_overflow_nor_vanish)
{
    for_each_of_all_schemes_and_shape([]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        const auto limits = limit_surface_of(mesh, scheme);
        for (const int exponent : {-1000, -700, 600, 1000}) {
            kith::storage<point> points(mesh.points());
            for (auto& p : points)
                for (auto& x : p)
                    x = std::scalbn(x, exponent);
            const auto scaled = limit_surface_of(mesh3d(std::move(points), mesh.topology(), mesh.generation()), scheme);
            for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
                for (std::size_t i = 0; i < 3; ++i) {
                    ASSERT_EQ(scaled.positions[v][i], std::scalbn(limits.positions[v][i], exponent));
                    ASSERT_EQ(scaled.normals[v][i], limits.normals[v][i]) << "times 2^" << exponent;
                }
        }
    });
}

TEST(limit_surface, normals_are_those_of_the_sphere_that_the_surface_comes_near_to)
{
    const auto cube = native(shapes::cube());
    for (int degree = 2; degree < 10; ++degree) {
        hierarchy levels(cube, kith::unified{.degree = degree});
        levels.refine(3);
        const auto limits = limit_surface_of(levels, 3);
        for (std::size_t v = 0; v < limits.normals.size(); ++v) {
            const auto& p = limits.positions[v];
            const auto& n = limits.normals[v];
            const double length = std::hypot(p[0], p[1], p[2]);
            EXPECT_GT((p[0] * n[0] + p[1] * n[1] + p[2] * n[2]) / length, 0.9) << degree << ", vertex " << v;
        }
    }
}

TEST(limit_surface, normals_that_cancel_out_are_zero)
{
    const auto pillow = native(
        shapes::shape{{{0, 0, 0}, {1, .25, 0}, {1.5, 1, .5}, {-.25, 1, .125}}, {{0, 1, 2, 3}, {3, 2, 1, 0}}});
    const auto check = [&](const auto& scheme) {
        for (const auto& normal : limit_surface_of(pillow, scheme).normals)
            EXPECT_EQ(normal, kith::normal_vector{});
    };
    check(kith::catmull_clark());
    check(kith::linear());
    check(kith::nasri_hasbini());
}

/// Shows that a tile with rings of ghosts has the same limits of its faces as the whole mesh, bit for bit.
TEST(limit_surface, of_a_tile_is_that_of_the_whole)
{
    std::size_t vertices = 0;
    const auto expect_same = [&]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        if constexpr (kith::reaching_scheme<Scheme>) {
            constexpr int levels = 1;
            hierarchy whole(mesh, scheme);
            whole.refine(levels);
            const auto limits = limit_surface_of(whole, levels);
            const kith::partition parts{partitions::scattered(mesh.face_count(), 3, 1), 3};
            kith::tiled_refinement tiles(mesh, scheme, levels, parts, rings_for_limits(scheme));
            for (std::size_t t = 0; t < tiles.tiles(); ++t) {
                kith::phase_seconds seconds;
                const auto job = tiles.refine_job(t, kith::connect::everything, seconds);
                std::vector<unsigned char> marks(job.part.mesh.vertex_count(), 0);
                for (std::size_t f = 0; f < job.part.mesh.face_count(); ++f)
                    if (job.part.owns_face(f))
                        for (const auto v : job.part.mesh.face(f))
                            marks[v] = 1;
                const auto part = limit_surface_around(
                    job.part.mesh, job.scheme, std::span<const unsigned char>(marks));
                for (std::size_t v = 0; v < marks.size(); ++v)
                    if (marks[v] != 0) {
                        const std::size_t id = job.part.vertex_ids[v];
                        ASSERT_EQ(part.positions[v], limits.positions[id]) << "vertex " << id;
                        ASSERT_EQ(part.normals[v], limits.normals[id]) << "vertex " << id;
                        ++vertices;
                    }
            }
        }
    };
    for_each_of_all_schemes_and_shape(expect_same);
    for (const auto& [name, shape] : shapes::all_shapes())
        for (const auto method : {kith::crease_method::uniform, kith::crease_method::chaikin}) {
            SCOPED_TRACE(name);
            const auto mesh = native(shape);
            expect_same(with_creases<kith::catmull_clark>(mesh, method), mesh);
        }
    EXPECT_GT(vertices, 10000U);
}

TEST(limit_surface, has_the_same_bits_on_any_number_of_threads)
{
    const auto expect_same = [](const mesh3d& mesh, const auto& scheme) {
        const auto limits = [&](int threads) {
            const thread_count count(threads);
            return limit_surface_of(mesh, scheme);
        };
        const auto of_one = limits(1);
        for (const int threads : {2, 3, 7}) {
            const auto of_many = limits(threads);
            EXPECT_TRUE(std::ranges::equal(of_many.positions, of_one.positions)) << threads;
            EXPECT_TRUE(std::ranges::equal(of_many.normals, of_one.normals)) << threads;
        }
    };
    const auto quads = native(shapes::shaken(shapes::grid(70, 70)));
    const auto triangles = native(shapes::shaken(shapes::triangulated(shapes::torus(50, 50))));
    expect_same(quads, with_creases<kith::catmull_clark>(quads, kith::crease_method::uniform));
    expect_same(quads, kith::doo_sabin());
    expect_same(triangles, kith::loop());
    expect_same(triangles, kith::sqrt3());
}
