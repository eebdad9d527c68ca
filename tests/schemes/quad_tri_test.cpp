// SPDX-License-Identifier: BSD-3-Clause
#include <kith/quad_tri.hpp>

#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/face_varying.hpp>
#include <kith/hierarchy.hpp>
#include <kith/limits/limit.hpp>
#include <kith/limits/limit_surface.hpp>
#include <kith/plan.hpp>
#include <kith/refine_with_fields.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using point = shapes::point;

point combine(const std::vector<std::pair<double, point>>& terms)
{
    point result{};
    for (const auto& [weight, p] : terms)
        for (std::size_t x = 0; x < 3; ++x)
            result[x] += weight * p[x];
    return result;
}
double distance(const point& a, const point& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A mesh as plain lists, refined by the paper's two stages: the linear split, and an average over the split mesh.
class split_mesh {
public:
    split_mesh(const mesh3d& mesh, const kith::creases& sharp)
    {
        const auto& t = mesh.topology();
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
            points.push_back(mesh.point(v));
            if (sharp.of_vertex(v) > 0)
                fixed_.insert(v);
        }
        const auto edge_vertex = [&](std::size_t c) { return mesh.vertex_count() + t.corner_halfedge[c] / 2; };
        points.resize(mesh.vertex_count() + mesh.edge_count());
        std::vector<int> faces_at(points.size());
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            const auto corners = mesh.face(f);
            const std::size_t n = corners.size(), first = t.first_corner(f), center = points.size();
            std::vector<std::pair<double, point>> all;
            for (std::size_t k = 0; k < n; ++k) {
                const std::size_t v = corners[k], w = corners[(k + 1) % n], e = edge_vertex(first + k);
                points[e] = combine({{.5, mesh.point(v)}, {.5, mesh.point(w)}});
                if (t.is_boundary(t.corner_halfedge[first + k] / 2) or
                    sharp.of_edge(t.corner_halfedge[first + k] / 2) > 0)
                    for (const std::size_t end : {v, w}) {
                        sharp_[end].insert(e);
                        sharp_[e].insert(end);
                    }
                if (t.is_boundary(t.corner_halfedge[first + k] / 2))
                    at_boundary_.insert({v, w});
                all.emplace_back(1. / double(n), mesh.point(v));
                ++faces_at[v];
                const std::size_t before = edge_vertex(first + (k + n - 1) % n);
                if (n == 3)
                    faces.push_back({v, e, before});
                else
                    faces.push_back({v, e, center, before});
            }
            if (n == 3)
                faces.push_back({edge_vertex(first), edge_vertex(first + 1), edge_vertex(first + 2)});
            else
                points.push_back(combine(all));
        }
        for (const std::size_t v : at_boundary_)
            if (faces_at[v] == 1)
                fixed_.insert(v);
    }

    /// Returns the averages of all vertices.
    [[nodiscard]] std::vector<point> averaged() const
    {
        std::vector<point> result;
        for (std::size_t v = 0; v < points.size(); ++v)
            result.push_back(average(v));
        return result;
    }

    std::vector<point> points;
    std::vector<std::vector<std::size_t>> faces;

private:
    [[nodiscard]] point average(std::size_t v) const
    {
        const auto found = sharp_.find(v);
        const std::size_t curves = found == sharp_.end() ? 0 : found->second.size();
        if (fixed_.contains(v) or curves > 2)
            return points[v];
        if (curves == 2)
            return combine(
                {{.5, points[v]}, {.25, points[*found->second.begin()]}, {.25, points[*found->second.rbegin()]}});
        std::set<std::size_t> neighbours;
        std::vector<std::size_t> opposites;
        for (const auto& f : faces)
            if (const auto at = std::ranges::find(f, v); at != f.end()) {
                const auto k = std::size_t(at - f.begin()), n = f.size();
                neighbours.insert(f[(k + 1) % n]);
                neighbours.insert(f[(k + n - 1) % n]);
                if (n == 4)
                    opposites.push_back(f[(k + 2) % n]);
            }
        const double n = double(neighbours.size()), q = double(opposites.size());
        double a = 1 / (1 + n / 2 + q / 4), b = a / 2, c = a / 4;
        if (q == n) { // Catmull & Clark
            a = (n - 3) / n;
            b = 2 / (n * n);
            c = 1 / (n * n);
        } else if (q == 0) { // Loop
            a = 2 * std::pow(3. / 8 + std::cos(2 * std::numbers::pi / n) / 4, 2) - 1. / 4;
            b = (1 - a) / n;
        }
        std::vector<std::pair<double, point>> terms{{a, points[v]}};
        for (const std::size_t other : neighbours)
            terms.emplace_back(b, points[other]);
        for (const std::size_t other : opposites)
            terms.emplace_back(c, points[other]);
        return combine(terms);
    }

    std::map<std::size_t, std::set<std::size_t>> sharp_; // ends of the sharp edges at vertices
    std::set<std::size_t> fixed_, at_boundary_;
};

/// Sharpens some edges, and a vertex, for ever.
kith::creases some_creases(const mesh3d& mesh)
{
    kith::creases result;
    for (std::size_t e = 0; e < mesh.edge_count(); e += 4)
        result.sharpen_edge(e, kith::infinitely_sharp);
    result.sharpen_vertex(mesh.vertex_count() / 2, kith::infinitely_sharp);
    return result;
}

/// Returns a torus of quads, some of which are cut into triangles.
shapes::shape mixed_torus(std::size_t rows = 6, std::size_t columns = 7)
{
    auto result = shapes::shaken(shapes::torus(rows, columns));
    auto faces = std::exchange(result.faces, {});
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto& q = faces[f];
        if (f % columns < columns / 2 or f % 5 == 4) {
            result.faces.push_back({q[0], q[1], q[2]});
            result.faces.push_back({q[2], q[3], q[0]});
        } else {
            result.faces.push_back(q);
        }
    }
    return result;
}

std::vector<shapes::named_shape> mixed_shapes()
{
    return {{"house", shapes::shaken(shapes::house())},
            {"open house", shapes::shaken(shapes::open_house())},
            {"mixed torus", mixed_torus()},
            {"joined grid", shapes::with_joins(shapes::shaken(shapes::triangulated(shapes::grid(6, 6))), 5, 40)}};
}

} // namespace

TEST(quad_tri, is_a_linear_split_and_an_average)
{
    auto all = shapes::all_shapes();
    all.emplace_back("mixed torus", mixed_torus());
    for (const auto& [name, shape] : all)
        for (const bool creased : {false, true}) {
            SCOPED_TRACE(name + (creased ? " with creases" : ""));
            const auto control = native(shape);
            kith::hierarchy levels(control,
                                   kith::quad_tri{.sharpness = creased ? some_creases(control) : kith::creases()});
            levels.refine(2);
            for (const int level : {0, 1}) {
                const split_mesh split(levels[level], levels.scheme(level).sharpness);
                const auto& fine = levels[level + 1];
                const auto expected = split.averaged();
                ASSERT_EQ(fine.vertex_count(), expected.size());
                for (std::size_t v = 0; v < expected.size(); ++v)
                    ASSERT_LT(distance(fine.point(v), expected[v]), 1e-14) << "level " << level << ", vertex " << v;
                std::multiset<std::set<std::size_t>> faces, expected_faces;
                for (std::size_t f = 0; f < fine.face_count(); ++f)
                    faces.insert({fine.face(f).begin(), fine.face(f).end()});
                for (const auto& f : split.faces)
                    expected_faces.insert({f.begin(), f.end()});
                ASSERT_EQ(faces, expected_faces);
            }
        }
}

/// Expects the same mesh of two schemes, up to rounding, with creases of all kinds.
template <class Scheme>
void expect_as(const shapes::shape& shape)
{
    const auto mesh = native(shape);
    kith::creases sharp = some_creases(mesh);
    for (std::size_t e = 1; e < mesh.edge_count(); e += 7)
        sharp.sharpen_edge(e, .4 * double(1 + e % 5));
    for (const auto method : {kith::crease_method::uniform, kith::crease_method::chaikin}) {
        sharp.method = method;
        const auto made = kith::refine(mesh, kith::quad_tri{.sharpness = sharp}, 3);
        Scheme scheme;
        scheme.sharpness = sharp;
        const auto expected = kith::refine(mesh, scheme, 3);
        ASSERT_TRUE(same_arrays(made.topology(), expected.topology()));
        for (std::size_t v = 0; v < made.vertex_count(); ++v)
            ASSERT_LT(distance(made.point(v), expected.point(v)), 1e-14) << v;
    }
}

/// Expects the same values at corners of two schemes, with a seam around every third face.
template <class Scheme>
void expect_seams_as(const shapes::shape& shape)
{
    const auto mesh = native(shape);
    const auto& t = mesh.topology();
    kith::storage<double> values(mesh.corner_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t c = t.first_corner(f); c < t.first_corner(f + 1); ++c)
            values[c] = mesh.point(t.corner_vertex[c])[0] + (f % 3 == 0 ? 5 : 0);
    auto made = kith::on_corners(values, kith::face_varying{});
    auto expected = made;
    kith::refine_with_fields(mesh, kith::quad_tri(), 2, std::tie(made));
    kith::refine_with_fields(mesh, Scheme(), 2, std::tie(expected));
    ASSERT_EQ(made.values().size(), expected.values().size());
    for (std::size_t c = 0; c < made.values().size(); ++c)
        ASSERT_NEAR(made.values()[c], expected.values()[c], 1e-14) << c;
}

TEST(quad_tri, is_catmull_clark_among_quads)
{
    for (const auto& shape :
         {shapes::cube(), shapes::torus(5, 7), shapes::l_shape(), shapes::grid(), shapes::valence_two()}) {
        expect_as<kith::catmull_clark>(shapes::shaken(shape));
        expect_seams_as<kith::catmull_clark>(shapes::shaken(shape));
    }
}

TEST(quad_tri, is_loop_among_triangles)
{
    for (const auto& [name, shape] : shapes::triangle_shapes()) {
        SCOPED_TRACE(name);
        expect_as<kith::loop>(shape);
        expect_seams_as<kith::loop>(shape);
    }
}

TEST(quad_tri, is_affine)
{
    const auto move = [](const point& p) { return point{p[0] - 2 * p[1] + 3, p[1] / 3 + p[2] - 7, p[2] - p[0] + .5}; };
    for (const auto& [name, shape] : mixed_shapes()) {
        SCOPED_TRACE(name);
        auto moved = shape;
        for (auto& p : moved.points)
            p = move(p);
        const auto fine = kith::refine(native(shape), kith::quad_tri(), 3);
        const auto expected = kith::refine(native(moved), kith::quad_tri(), 3);
        for (std::size_t v = 0; v < fine.vertex_count(); ++v)
            ASSERT_LT(distance(move(fine.point(v)), expected.point(v)), 1e-13) << v;
    }
}

TEST(quad_tri, is_counted_ahead)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        const auto mesh = native(shape);
        const auto plan = kith::plan(count(mesh.topology()), kith::quad_tri(), 3);
        const auto made = count(kith::refine(mesh, kith::quad_tri(), 3).topology());
        EXPECT_EQ(plan[3].counts.vertices, made.vertices);
        EXPECT_EQ(plan[3].counts.edges, made.edges);
        EXPECT_EQ(plan[3].counts.faces, made.faces);
        EXPECT_EQ(plan[3].counts.triangles, made.triangles);
        EXPECT_EQ(plan[3].counts.boundary_edges, made.boundary_edges);
    }
}

TEST(quad_tri, has_limits_between_quads_and_triangles)
{
    for (const auto& [name, shape] : mixed_shapes()) {
        SCOPED_TRACE(name);
        kith::hierarchy levels(native(shape), kith::quad_tri());
        levels.refine(4);
        const auto coarse = limit_positions(levels.elements(1), levels.scheme(1));
        const auto normals = limit_normals(levels.elements(1), levels.scheme(1));
        const auto fine = limit_positions(levels.elements(4), levels.scheme(4));
        const auto later = limit_normals(levels.elements(4), levels.scheme(4));
        std::size_t with_normal = 0;
        for (std::size_t v = 0; v < coarse.size(); ++v) { // a vertex keeps its number
            ASSERT_TRUE(coarse[v] and fine[v]) << v;
            EXPECT_LT(distance(*coarse[v], *fine[v]), 1e-13) << v;
            EXPECT_LT(distance(*coarse[v], levels[4].point(v)), .02) << v;
            if (normals[v]) {
                ASSERT_TRUE(later[v]) << v;
                EXPECT_LT(distance(*normals[v], *later[v]), 1e-9) << v;
                ++with_normal;
            }
        }
        EXPECT_GT(with_normal, coarse.size() / 2);
    }
}

/// Shows that masks by iteration lead where refinement leads: to the points and the normals of faces on deep levels.
TEST(quad_tri, has_the_normals_of_its_faces)
{
    for (std::size_t n = 3; n < 9; ++n)
        for (std::size_t pattern = 1; pattern + 1 < std::size_t(1) << n; pattern += n > 5 ? 11 : 1) {
            SCOPED_TRACE(std::to_string(n) + " faces, pattern " + std::to_string(pattern));
            shapes::shape shape{{{0, 0, 0}}, {}};
            for (std::size_t j = 0; j < n; ++j) {
                const double turn = 2 * std::numbers::pi / double(n);
                shape.points.push_back({std::cos(turn * double(j)), std::sin(turn * double(j)), .3 * double(j % 3)});
            }
            for (std::size_t j = 0; j < n; ++j) {
                shape.faces.push_back({0, 1 + j, 1 + (j + 1) % n});
                if ((pattern >> j & 1) != 0) {
                    const auto &a = shape.points[1 + j], &b = shape.points[1 + (j + 1) % n];
                    shape.faces.back().insert(shape.faces.back().begin() + 2, shape.points.size());
                    shape.points.push_back({.8 * (a[0] + b[0]), .8 * (a[1] + b[1]), a[2] - b[2]});
                }
            }
            const auto control = native(shape);
            kith::hierarchy levels(control, kith::quad_tri());
            const auto limits = limit_surface_of(control, kith::quad_tri());
            levels.refine(5);
            EXPECT_LT(distance(limits.positions[0], levels[5].point(0)), 5e-3);
            const auto deviation = [&](int level) { // the largest at the vertex
                double result = 0;
                for (const auto f : levels.elements(level).vertices()[0].faces()) {
                    const auto c = f.first_corner();
                    const point &a = c.v().point(), &b = c.next().v().point(), &d = c.prev().v().point();
                    const point u = combine({{1, b}, {-1, a}}), w = combine({{1, d}, {-1, a}});
                    const point cross{u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
                    result = std::max(result, distance(limits.normals[0], combine({{1 / distance(cross, {}), cross}})));
                }
                return result;
            };
            EXPECT_LT(deviation(5), .95 * deviation(3));
        }
}

TEST(quad_tri, refuses_triangles_back_to_back)
{
    const auto text = error_text<kith::mesh_error>([] {
        static_cast<void>(
            kith::refine(native({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}}), kith::quad_tri(), 1));
    });
    EXPECT_NE(text.find("back to back"), std::string::npos) << text;
}
