// SPDX-License-Identifier: BSD-3-Clause
#include <kith/unified.hpp>

#include "support/error_text.hpp"
#include "support/regular_masks.hpp"
#include "support/same_mesh.hpp"

#include <kith/doo_sabin.hpp>
#include <kith/linear.hpp>

#include <kith/presets.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

using kith::unified;

namespace {

/// Returns every second coefficient of 2 ((1+z)/2)^(degree+1), which is one of the two rules of the uniform B-spline.
std::vector<double> b_spline(int degree, int first)
{
    std::vector<double> row{std::ldexp(1., -degree)}; // of Pascal's triangle
    for (int i = 0; i <= degree; ++i)
        row.push_back(row.back() * (degree + 1 - i) / (i + 1));
    std::vector<double> result;
    for (std::size_t i = std::size_t(first); i < row.size(); i += 2)
        result.push_back(row[i]);
    return result;
}
std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> result;
    for (const double x : a)
        for (const double y : b)
            result.push_back(x * y);
    std::ranges::sort(result, std::greater());
    return result;
}

/// Returns a closed mesh of 2n quads. Vertices 0 and 1 have valence n, all others valence three.
shapes::shape trapezohedron(std::size_t n)
{
    const double turn = std::acos(-1.) / double(n);
    shapes::shape result{{{0, 0, 1}, {0, 0, -1}}, {}};
    const auto rim = [n](std::size_t k) { return 2 + k % (2 * n); };
    for (std::size_t k = 0; k < 2 * n; ++k) {
        result.points.push_back({std::cos(turn * double(k)), std::sin(turn * double(k)), 0});
        if (k % 2 == 0) {
            result.faces.push_back({0, rim(k), rim(k + 1), rim(k + 2)});
            result.faces.push_back({1, rim(k + 3), rim(k + 2), rim(k + 1)});
        }
    }
    return result;
}

using level_type = kith::level_of<mesh3d>;
using corner_type = kith::corner<level_type>;

/// Returns a map of the vertices in `rings` rings around corners of one level. It maps each vertex to the one at the
/// same place around the corresponding corners of the next level.
std::map<std::size_t, std::size_t> same_places(std::vector<std::pair<corner_type, corner_type>> ring, int rings)
{
    std::map<std::size_t, std::size_t> result;
    for (const auto& [coarse, fine] : ring)
        result.emplace(coarse.v().index(), fine.v().index());
    for (int i = 0; i < rings; ++i) {
        std::vector<std::pair<corner_type, corner_type>> next;
        for (auto [coarse, fine] : ring)
            for (std::size_t faces = coarse.v().face_count(); faces > 0; --faces) {
                const std::size_t degree = coarse.f().degree();
                for (std::size_t k = 0; k < degree; ++k, coarse = coarse.next(), fine = fine.next())
                    if (result.emplace(coarse.v().index(), fine.v().index()).second)
                        next.emplace_back(coarse, fine);
                coarse = coarse.prev().across();
                fine = fine.prev().across();
            }
        ring = next;
    }
    return result;
}

/// Returns the subdominant eigenvalue at an extraordinary vertex or face of valence n, by power iteration. It refines
/// antisymmetric values around the element, and then replaces the coarse values by the fine ones at the same places.
double subdominant_eigenvalue(int degree, std::size_t n)
{
    constexpr int level = 3;
    kith::hierarchy levels(native(trapezohedron(n)), unified{.degree = degree});
    levels.refine(level + 1);

    const auto corners = [&, face = levels.elements(0).vertex_at(0)](int at) {
        std::vector<corner_type> result;
        if (degree % 2 != 0) {
            result.push_back(levels.elements(at).vertices()[0].first_corner());
        } else {
            auto f = levels.assoc(0, face, kith::targets::F);
            for (int i = 1; i < at; ++i)
                f = levels.assoc(i, f, kith::targets::F);
            for (const auto c : kith::face<level_type>(levels.elements(at), f).corners())
                result.push_back(c);
        }
        return result;
    };
    const auto coarse = corners(level), fine = corners(level + 1);
    std::vector<std::pair<corner_type, corner_type>> center;
    for (std::size_t i = 0; i < coarse.size(); ++i)
        center.emplace_back(coarse[i], fine[i]);
    const auto place = same_places(center, degree / 2 + 3);

    std::vector<double> values;
    for (const auto& p : levels[level].points())
        values.push_back(p[0]);
    double eigenvalue = 0;
    for (int i = 0; i < 20; ++i) {
        const auto refined = levels.carry(level, level + 1, std::span<const double>(values));
        double product = 0, square = 0;
        for (const auto& [here, there] : place) {
            product += values[here] * refined[there];
            square += values[here] * values[here];
        }
        eigenvalue = product / square;
        for (const auto& [here, there] : place)
            values[here] = refined[there] / eigenvalue;
    }
    return eigenvalue;
}

} // namespace

TEST(unified, is_the_tensor_b_spline_of_every_odd_degree_on_regular_quads)
{
    for (int degree = 1; degree <= 9; degree += 2) {
        SCOPED_TRACE(degree);
        const unified scheme{.degree = degree};
        const auto at_knots = b_spline(degree, (degree + 1) / 2 % 2);
        const auto between = b_spline(degree, (degree + 3) / 2 % 2);
        expect_weights(weights_of(regular_quads, scheme, vertex_handle{0}), product(at_knots, at_knots));
        expect_weights(weights_of(regular_quads, scheme, edge_handle{0}), product(at_knots, between));
        expect_weights(weights_of(regular_quads, scheme, face_handle{0}), product(between, between));
    }
}

TEST(unified, is_the_tensor_b_spline_of_every_even_degree_on_regular_quads)
{
    for (int degree = 2; degree <= 8; degree += 2) {
        SCOPED_TRACE(degree);
        const auto mask = b_spline(degree, 0);
        expect_weights(weights_of(regular_quads, unified{.degree = degree}, vertex_handle{0}, face_handle{0}),
                       product(mask, mask));
    }
}

TEST(unified, of_degree_1_is_the_linear_split)
{
    const auto house = native(shapes::shaken(shapes::house()));
    const auto fine = kith::refine(house, unified{.degree = 1}, 1);
    const auto linear = kith::refine(house, kith::linear(), 1);
    EXPECT_TRUE(std::ranges::equal(fine.points(), linear.points()));
    EXPECT_EQ(faces_of(fine), faces_of(linear));
}

TEST(unified, of_degree_2_is_doo_sabin_by_averaging)
{
    const auto house = native(shapes::shaken(shapes::house()));
    const auto fine = kith::refine(house, unified{.degree = 2}, 1);
    const auto other = kith::refine(house, kith::doo_sabin{.weights = kith::doo_sabin_weights::averaging}, 1);
    EXPECT_EQ(faces_of(fine), faces_of(other));
    for (std::size_t v = 0; v < fine.vertex_count(); ++v)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(fine.point(v)[i], other.point(v)[i], 1e-15);
}

TEST(unified, of_degree_3_weighs_a_vertex_its_neighbours_and_its_faces_by_a_half_and_two_quarters)
{
    const auto house = native(shapes::shaken(shapes::house()));
    const auto fine = kith::refine(house, unified{.degree = 3}, 1);
    const level_type level(house);
    for (const auto v : level.vertices()) { // of valence 3 and 5
        shapes::point expected{};
        const auto add = [&expected](const shapes::point& p, double weight) {
            for (std::size_t i = 0; i < 3; ++i)
                expected[i] += weight * p[i];
        };
        add(v.point(), 1. / 2);
        const auto n = double(v.valence());
        for (const auto u : v.neighbors())
            add(u.point(), 1. / 4 / n);
        for (const auto f : v.faces())
            for (const auto u : f.vertices())
                add(u.point(), 1. / 4 / n / double(f.degree()));
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(fine.point(v.index())[i], expected[i], 1e-15);
    }
}

TEST(unified, has_the_subdominant_eigenvalues_of_its_degrees)
{
    const std::map<int, std::map<std::size_t, double>> expected{
        {2, {{3, .37500}, {5, .57725}, {6, .62500}, {8, .67678}}},
        {3, {{3, .41010}, {5, .54999}, {6, .57968}, {8, .61112}}}, // those of Catmull-Clark
        {4, {{3, .39660}, {5, .56824}, {6, .61296}, {8, .66393}}},
        {5, {{3, .40165}, {5, .56025}, {6, .59807}, {8, .63982}}},
        {6, {{3, .39758}, {5, .56823}, {6, .61365}, {8, .66629}}},
        {7, {{3, .39943}, {5, .56440}, {6, .60609}, {8, .65331}}},
        {8, {{3, .39761}, {5, .56885}, {6, .61518}, {8, .66950}}},
        {9, {{3, .39852}, {5, .56659}, {6, .61054}, {8, .66120}}}};
    for (const auto& [degree, by_valence] : expected)
        for (const auto& [valence, eigenvalue] : by_valence)
            EXPECT_NEAR(subdominant_eigenvalue(degree, valence), eigenvalue, 1e-5)
                << "degree " << degree << ", valence " << valence;
}

TEST(unified, refuses_a_boundary)
{
    EXPECT_EQ(
        error_text<kith::mesh_error>([] { kith::refine(native(shapes::grid()), unified(), 1); }),
        "unified: edge 0 between vertices 0 and 1 is a boundary edge; close the mesh first, or take a scheme with "
        "a boundary rule");
}

TEST(unified, refuses_degrees_for_which_nothing_is_proved)
{
    for (const int degree : {-1, 0, 10})
        EXPECT_EQ(
            error_text<kith::mesh_error>([&] { kith::refine(native(shapes::cube()), unified{.degree = degree}, 1); }),
            "unified: degree " + std::to_string(degree) + " was asked for; ask for 1 to 9");
}

TEST(unified, refuses_to_make_a_face_of_two_corners)
{
    const shapes::shape pillow{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {3, 2, 1, 0}}};
    EXPECT_EQ(
        error_text<kith::mesh_error>([&] { kith::refine(native(pillow), unified{.degree = 2}, 1); }),
        "unified: vertex 0 lies between 2 faces only, the scheme needs three; merge its two edges into one first");
    EXPECT_EQ(kith::refine(native(pillow), unified{.degree = 3}, 1).point(0), (shapes::point{0.25, 0.25, 0}));
}

TEST(unified, is_in_no_other_library)
{
    EXPECT_EQ(kith::like<unified>(kith::library::kith).degree, 3);
    EXPECT_THROW(kith::like<unified>(kith::library::openmesh), kith::mesh_error);
}
