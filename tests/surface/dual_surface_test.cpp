// SPDX-License-Identifier: BSD-3-Clause
#include <kith/doo_sabin.hpp>
#include <kith/mid_edge.hpp>
#include <kith/surface.hpp>

#include "support/error_text.hpp"
#include "support/surface_places.hpp"

#include <kith/hierarchy.hpp>
#include <kith/limits/limit_surface.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace {

using kith::derivatives;
using kith::surface_place;

std::vector<bool> boundary_vertices(const mesh3d& mesh)
{
    std::vector<bool> result(mesh.vertex_count());
    for (std::uint32_t c = 0; c < mesh.corner_count(); ++c)
        if (mesh.topology().across(c) == mesh.topology().none)
            for (const auto corner : {c, mesh.topology().next(c)})
                result[mesh.topology().corner_vertex[corner]] = true;
    return result;
}

/// Calls test(scheme) for Doo-Sabin with each boundary rule.
template <class Test>
void for_each_boundary_rule(const Test& test)
{
    using enum kith::doo_sabin_boundary;
    for (const auto boundary : {thesis, clamped, drop})
        test(kith::doo_sabin{.boundary = boundary});
}

/// Shows that quarters of faces at inner vertices reach up to the boundary, with the limits of three levels.
TEST(dual_surface, reaches_boundaries_of_dual_splits)
{
    for (const auto& shape : {shapes::l_shape(), shapes::grid(3, 3), shapes::ring(5), shapes::open_house()}) {
        const auto mesh = native(shapes::shaken(shape));
        const auto& topology = mesh.topology();
        const auto on_boundary = boundary_vertices(mesh);
        for_each_boundary_rule([&](const kith::doo_sabin& scheme) {
            std::vector<surface_place> places;
            for (std::size_t c = 0; c < mesh.corner_count(); ++c) {
                const std::size_t f = topology.face_of(std::uint32_t(c)), k = c - topology.first_corner(f);
                if (on_boundary[topology.corner_vertex[c]])
                    continue;
                for (const double s : {.125, .375, .625, .875})
                    for (const double t : {.125, .375, .625, .875})
                        places.push_back(place_in_sub_face(mesh, f, k, {s, t}));
            }
            kith::hierarchy<mesh3d, kith::doo_sabin> levels(mesh, scheme);
            levels.refine(3);
            const auto limits = limit_surface_of(levels, 3).positions;
            const auto made = kith::surface_locator(mesh, scheme).locate(places).evaluate(mesh.points());
            for (std::size_t i = 0; i < places.size(); ++i)
                ASSERT_TRUE(
                    std::ranges::any_of(limits, [&](const point& p) { return distance(p, made.points[i]) < 1e-13; }))
                    << "place " << i;
        });
        std::vector<surface_place> at_edges;
        std::vector<std::size_t> edges;
        for (std::size_t c = 0; c < mesh.corner_count(); ++c)
            if (std::size_t(topology.corner_halfedge[c]) % 2 == 0) {
                at_edges.push_back(place_on_side(mesh, c, .5, 4));
                edges.push_back(topology.corner_halfedge[c] / 2);
            }
        kith::hierarchy<mesh3d, kith::mid_edge> levels(mesh, kith::mid_edge{});
        levels.refine(1);
        const auto limits = limit_surface_of(levels, 1).positions;
        kith::surface_locator surface(mesh, kith::mid_edge{});
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (mesh.face_count() > 3) { // vertices of one face follow each other in the L
                ASSERT_LT(distance(surface.locate(std::span(at_edges).subspan(i, 1)).evaluate(mesh.points()).points[0],
                                   limits[edges[i]]),
                          1e-13)
                    << "edge " << edges[i];
            }
    }
}

/// Returns the clamped quadratic B-splines with knots 0, 1, ..., or their derivatives, at x.
std::vector<double> clamped_splines(std::size_t count, double x, int derivative)
{
    std::vector<double> knots{0, 0};
    for (std::size_t i = 0; i + 1 < count; ++i)
        knots.push_back(double(i));
    knots.insert(knots.end(), 2, knots.back());
    const auto spline = [&](const auto& self, std::size_t i, std::size_t degree, int times) -> double {
        if (degree == 0)
            return knots[i] <= x and (x < knots[i + 1] or (x == knots.back() and knots[i] < x and knots[i + 1] == x));
        const auto share = [&](std::size_t j, double of_left, double of_right) {
            const double length = knots[j + degree] - knots[j];
            if (length == 0)
                return 0.;
            return (times > 0 ? double(degree) : of_left * (x - knots[j]) + of_right * (knots[j + degree] - x)) /
                   length * self(self, j, degree - 1, std::max(times - 1, 0));
        };
        return times > 0 ? share(i, 1, 0) - share(i + 1, 0, 1) : share(i, 1, 0) + share(i + 1, 0, 1);
    };
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i)
        result.push_back(spline(spline, i, 2, derivative));
    return result;
}

TEST(dual_surface, is_a_clamped_spline_with_derivatives_up_to_the_boundary)
{
    const auto mesh = native(shapes::shaken(shapes::grid(4, 5)));
    kith::surface_locator surface(mesh, kith::doo_sabin{.boundary = kith::doo_sabin_boundary::clamped});
    std::vector<surface_place> places;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (const double u : {0., .25, .5, .6, 1.})
            for (const double v : {0., .25, .5, .6, 1.}) {
                const double x = double(f % 5) + u - .5, y = std::floor(double(f) / 5) + v - .5; // knots at centres
                if (x >= 0 and y >= 0 and x <= 4 and y <= 3)
                    places.push_back({f, u, v, 0});
            }
    const auto made = surface.locate(places).evaluate(mesh.points(), derivatives::second);
    const auto expect = [&](const kith::storage<point>& values, int by_u, int by_v) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto [f, u, v, k] = places[i];
            const auto in_u = clamped_splines(6, double(f % 5) + u - .5, by_u);
            const auto in_v = clamped_splines(5, std::floor(double(f) / 5) + v - .5, by_v);
            point expected{};
            for (std::size_t row = 0; row < 5; ++row)
                for (std::size_t column = 0; column < 6; ++column)
                    for (std::size_t x = 0; x < 3; ++x)
                        expected[x] += in_v[row] * in_u[column] * mesh.point(6 * row + column)[x];
            // Second derivatives jump at knots.
            const bool has_jump = (by_u == 2 and u == .5) or (by_v == 2 and v == .5);
            ASSERT_TRUE(distance(values[i], expected) < 1e-12 or (has_jump and std::isfinite(values[i][0]))) << i;
        }
    };
    expect(made.points, 0, 0);
    expect(made.du, 1, 0);
    expect(made.dv, 0, 1);
    expect(made.duu, 2, 0);
    expect(made.duv, 1, 1);
    expect(made.dvv, 0, 2);
}

/// Shows that the thesis's boundary is the quadratic B-spline of the boundary vertices, between quarters of faces.
TEST(dual_surface, ends_at_the_boundary_curve_of_dual_splits)
{
    const auto mesh = native(shapes::shaken(shapes::grid(4, 5)));
    kith::surface_locator surface(mesh, kith::doo_sabin{});
    for (const double x : {0., .5, .875, 1.5, 3., 4.}) {
        const std::size_t face = std::size_t(x + .5);
        const double u = x + .5 - double(face);
        const auto made = surface.locate(std::vector<surface_place>{{face, u, .5, 0}, {face, u, .5 + 0x1p-50, 0}})
                              .evaluate(mesh.points(), derivatives::first);
        point expected{};
        const auto weights = x < 4 ? clamped_splines(8, x + 1, 0) : std::vector<double>{0, 0, 0, 0, 0, .5, .5, 0};
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                expected[k] += (x == 0 ? (i == 0) : x == 4 ? (i == 5) : weights[i + 1]) * mesh.point(i)[k];
        EXPECT_LT(distance(made.points[0], expected), 4e-15) << x;
        EXPECT_LT(distance(made.points[1], expected), 1e-5) << x;
        if (x > 0 and x < 4) { // the other sides end here
            const auto slopes = clamped_splines(8, x + 1, 1);
            point slope{}, across{}; // the spline of the differences to the next row has the direction across
            for (std::size_t i = 0; i < 6; ++i)
                for (std::size_t k = 0; k < 3; ++k) {
                    slope[k] += slopes[i + 1] * mesh.point(i)[k];
                    across[k] += weights[i + 1] * (mesh.point(6 + i)[k] - mesh.point(i)[k]);
                }
            EXPECT_LT(distance(made.du[0], slope), 2e-7) << x;
            EXPECT_LT(distance(*kith::unit_vector(made.dv[0]), *kith::unit_vector(across)), 1e-6) << x;
        }
    }
    const auto text = [](const auto& scheme, const surface_place& place) {
        return error_text<kith::mesh_error>([&] {
            kith::surface_locator one(native(shapes::grid(3, 3)), scheme);
            static_cast<void>(one.locate(std::vector{surface_place{4, .5, .5}, place}));
        });
    };
    const std::string expected =
        "place 1: the boundary cuts off this part of face 3, which has no surface; take places "
        "nearer to inner vertices";
    EXPECT_EQ(text(kith::doo_sabin{}, {3, .25, .5}), expected);
    EXPECT_EQ(text(kith::mid_edge{}, {0, .125, .25}),
              "place 1: the boundary cuts off this part of face 0, which has no surface; take places nearer to inner "
              "vertices");
    EXPECT_EQ(text(kith::doo_sabin{}, {3, .75, .5}), "no error");
}

/// Shows that irregular vertices and faces have normals: of Doo-Sabin by its masks, of mid-edge by its steps. Normals
/// nearby converge to them, slowly beside triangles of mid-edge.
TEST(dual_surface, has_normals_at_irregular_places_of_dual_splits)
{
    const auto mesh = native(shapes::shaken(shapes::pentacube()));
    const auto test = [&](const auto& scheme, bool has_masks) {
        const auto limits = limit_surface_of(mesh, scheme);
        const auto expected = normals_of_corners(mesh, limits);
        kith::surface_locator surface(mesh, scheme);
        for (std::size_t c = 0; c < mesh.corner_count(); ++c) {
            const auto here = place_on_side(mesh, c, 0, 4);
            std::vector<surface_place> places{here};
            for (const double off : {0x1p-9, 0x1p-18})
                places.push_back({here.face,
                                  here.u + (here.u < .5 ? off : -off),
                                  here.v + (here.v < .5 ? .7 : -.7) * off,
                                  here.corner});
            const auto made = surface.locate(places).evaluate(mesh.points(), derivatives::first);
            EXPECT_LT(distance(made.points[0], limits.positions[mesh.topology().corner_vertex[c]]), 1e-14) << c;
            const auto normals = normals_of(made);
            EXPECT_LT(distance(normals[0], normals[2]), std::max(1e-3, .7 * distance(normals[0], normals[1]))) << c;
            if (has_masks) {
                EXPECT_LT(distance(normals[0], expected[c]), 1e-13) << c;
            }
        }
    };
    test(kith::doo_sabin{}, true);
    test(kith::doo_sabin{.weights = kith::doo_sabin_weights::averaging}, true);
    test(kith::mid_edge{}, false);
}

} // namespace
