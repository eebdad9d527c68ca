// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limits/limit.hpp>

#include "support/error_text.hpp"
#include "support/native_shape.hpp"

#include <kith/compiled_schemes.hpp>
#include <kith/core/base/exact_cos.hpp>
#include <kith/fields/with_fields.hpp>
#include <kith/hierarchy.hpp>
#include <kith/limits/limit_surface.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace {

/// A scheme of midpoints of faces and edges. It has no limit rules.
struct own_split : kith::linear {};

/// A scheme with the same steps and with a limit mask, which is wrong on purpose.
struct own_split_with_limits : kith::linear {};

} // namespace

template <>
struct kith::limit_rules<own_split_with_limits> : kith::limit_defaults {
    template <class Level>
    static void position(const own_split_with_limits&, const kith::vertex<Level>& v, const auto& use)
    {
        use(2. * sum(v.neighbors()));
    }
};

namespace {

using kith::hierarchy;
namespace targets = kith::targets;

/// Expects that further levels converge to the limit of each vertex, and that the limit stays the same.
template <class Scheme>
void expect_convergence(const mesh3d& control, const Scheme& scheme, int depth = 6)
{
    hierarchy levels(control, scheme);
    levels.refine(depth);
    const auto limits = limit_positions(levels.elements(2), levels.scheme(2));
    const auto again = limit_positions(levels.elements(4), levels.scheme(4));
    std::size_t count = 0;
    for (std::size_t v = 0; v < limits.size(); ++v)
        if (limits[v]) {
            ++count;
            ASSERT_TRUE(again[v]);
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_NEAR((*limits[v])[i], (*again[v])[i], 1e-13);
                EXPECT_NEAR((*limits[v])[i], levels[depth].point(v)[i], 2e-2);
            }
        }
    EXPECT_GE(3 * count, limits.size());
}

void expect_normal(const auto& normal, const shapes::point& should_be)
{
    ASSERT_TRUE(normal);
    const double length = std::hypot(should_be[0], should_be[1], should_be[2]);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR((*normal)[i], should_be[i] / length, 1e-14);
}

} // namespace

TEST(limit, levels_converge_to_it)
{
    expect_convergence(native(shapes::shaken(shapes::open_house())), kith::catmull_clark());
    expect_convergence(native(shapes::shaken(shapes::umbrella(7))), kith::loop());
    expect_convergence(native(shapes::shaken(shapes::umbrella(5))), kith::sqrt3());
    expect_convergence(native(shapes::shaken(shapes::l_shape())), kith::nasri_hasbini(), 4);
    expect_convergence(kith::tri_quad(native(shapes::shaken(shapes::house()))), kith::four_eight(), 12);
}

TEST(limit, of_doo_sabin_is_on_the_quadratic_b_spline_at_the_boundary)
{
    const hierarchy levels(native(shapes::grid()), kith::doo_sabin());
    const auto limits = limit_positions(levels.elements(0), levels.scheme(0));
    ASSERT_TRUE(limits[0] and limits[1]);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ((*limits[0])[i], levels[0].point(0)[i]); // at a corner
        EXPECT_NEAR(
            (*limits[1])[i], (levels[0].point(0)[i] + 6 * levels[0].point(1)[i] + levels[0].point(2)[i]) / 8, 1e-15);
    }
}

TEST(limit, interpolating_schemes_stay)
{
    const auto expect_stay = [](const mesh3d& mesh, const auto& scheme) {
        const hierarchy levels(mesh, scheme);
        const auto limits = limit_positions(levels.elements(0), levels.scheme(0));
        for (std::size_t v = 0; v < limits.size(); ++v)
            EXPECT_EQ(limits[v], levels[0].point(v));
    };
    expect_stay(native(shapes::shaken(shapes::umbrella(9))), kith::butterfly());
    expect_stay(native(shapes::shaken(shapes::l_shape())), kith::kobbelt());
    expect_stay(native(shapes::shaken(shapes::house())), kith::linear());
    expect_stay(native(shapes::shaken(shapes::umbrella(9))), kith::linear_triangles());
}

namespace {

/// The functions from which limit rules compute the weights of rings.
struct weights_of_rings : kith::limit_defaults {
    using limit_defaults::cosine_wave;
    using limit_defaults::sine_wave;
};

} // namespace

TEST(limit, weights_that_are_kept_are_those_that_are_computed)
{
    for (const std::int64_t n : {1, 3, 4, 7, 64, 65, 300}) {
        const auto cosine = weights_of_rings::cosine_wave(n);
        const auto sine = weights_of_rings::sine_wave(n);
        for (std::int64_t j = 0; j <= n; ++j) {
            EXPECT_EQ(cosine(std::size_t(j)), kith::exact_cos(j, n)) << j << '/' << n;
            EXPECT_EQ(sine(std::size_t(j)), kith::sin_turn(j, n)) << j << '/' << n;
        }
    }
}

TEST(limit, exponents_are_read_and_shifted_as_the_library_does)
{
    constexpr double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
    for (const double x : {1., -1.5, 0.1, 1e300, -1e-300, 3e-310, least, largest, 0x1p-1022, 0x1.fffffffffffffp-1023}) {
        EXPECT_EQ(kith::detail::exponent_of(x), std::ilogb(x)) << x;
        for (const int exponent : {0, 1, -1, 52, -53, 1022, 1023, 1024, -1021, -1022, -1023, -1074, 2000, -2000})
            EXPECT_EQ(kith::detail::times_power_of_two(x, exponent), std::scalbn(x, exponent)) << x << ' ' << exponent;
    }
}

TEST(limit, faces_that_the_scheme_does_not_take_are_refused)
{
    EXPECT_EQ(error_text<kith::mesh_error>([] { limit_surface_of(native(shapes::cube()), kith::loop()); }),
              "loop: face 0 has 4 vertices; triangulate the mesh first");
}

TEST(limit, tangents_of_kobbelt_are_refused_with_the_tension_that_steps_refuse)
{
    const auto torus = native(shapes::torus(6, 6)); // a regular mesh, so no step is made
    EXPECT_EQ(error_text<kith::mesh_error>([&] { limit_surface_around(torus, kith::kobbelt{.tension = 9}, {}); }),
              "kobbelt: a tension of 9.000000 was asked for; ask for one between 0 and 2.472");
}

TEST(limit, values_are_carried_by_the_masks_of_the_points)
{
    const hierarchy levels(native(shapes::shaken(shapes::cube())), kith::catmull_clark());
    const auto& level = levels.elements(0);
    std::vector<double> heights;
    for (const auto& p : levels[0].points())
        heights.push_back(p[2]);
    const auto carried = limit_values(level, levels.scheme(0), std::span<const double>(heights));
    const auto limits = limit_positions(level, levels.scheme(0));
    for (std::size_t v = 0; v < 8; ++v) {
        ASSERT_TRUE(carried[v] and limits[v]);
        EXPECT_EQ(*carried[v], (*limits[v])[2]);
    }
}

TEST(limit, fields_beside_a_scheme_change_nothing)
{
    kith::catmull_clark scheme;
    scheme.sharpness.sharpen_edge(0, 1.5);
    const mesh3d control = native(shapes::shaken(shapes::house()));
    const kith::with_fields beside(scheme, kith::on_faces(std::vector<int>(control.face_count(), 7)));
    hierarchy with(control, beside);
    hierarchy without(control, scheme);
    with.refine(1);
    without.refine(1);
    EXPECT_EQ(limit_positions(with.elements(1), with.scheme(1)),
              limit_positions(without.elements(1), without.scheme(1)));
    EXPECT_EQ(limit_normals(with.elements(1), with.scheme(1)), limit_normals(without.elements(1), without.scheme(1)));
    const auto one = limit_surface_of(with, 1), other = limit_surface_of(without, 1);
    EXPECT_TRUE(std::ranges::equal(one.positions, other.positions));
    EXPECT_TRUE(std::ranges::equal(one.normals, other.normals));
}

TEST(limit, has_masks_at_darts_and_none_while_creases_decay)
{
    kith::catmull_clark scheme;
    const auto torus = native(shapes::shaken(shapes::torus(5, 7)));
    const kith::level_of<mesh3d> level(torus);
    const auto sharp = level.edges()[0], decaying = level.edges()[20];
    scheme.sharpness.sharpen_edge(sharp.index(), kith::infinitely_sharp);
    scheme.sharpness.sharpen_edge(decaying.index(), 2);
    hierarchy levels(torus, scheme);
    levels.refine(4);
    const auto limits = [&](int i) { return limit_positions(levels.elements(i), levels.scheme(i)); };
    std::size_t unknown = 0;
    for (const auto& limit : limits(0))
        unknown += not limit;
    EXPECT_EQ(unknown, 2U);
    ASSERT_TRUE(limits(0)[sharp.org().index()] and limits(4)[sharp.org().index()]); // a dart that stays sharp
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR((*limits(0)[sharp.org().index()])[i], (*limits(4)[sharp.org().index()])[i], 1e-14);
    EXPECT_FALSE(limits(1)[decaying.org().index()]);
    EXPECT_TRUE(limits(2)[decaying.org().index()]); // its sharpness is 2, 1, 0
    const auto middle = levels.assoc(0, sharp.handle(), targets::V).value;
    ASSERT_TRUE(limits(1)[middle]); // inside the crease the limit is a curve, though it ends in darts
    const auto normals = limit_normals(levels.elements(1), levels.scheme(1));
    EXPECT_FALSE(normals[middle]);
    const auto of_dart = [&](int i) {
        return limit_normals(levels.elements(i), levels.scheme(i))[sharp.org().index()];
    };
    ASSERT_TRUE(of_dart(0) and of_dart(4));
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR((*of_dart(0))[i], (*of_dart(4))[i], 1e-9);
    EXPECT_TRUE(limit_normals(levels.elements(2), levels.scheme(2))[decaying.org().index()]);
}

TEST(limit, positions_are_known_after_one_step_where_faces_are_no_quads)
{
    hierarchy levels(native(shapes::house()), kith::catmull_clark());
    levels.refine();
    EXPECT_FALSE(limit_positions(levels.elements(0), levels.scheme(0))[0]);
    EXPECT_TRUE(limit_positions(levels.elements(1), levels.scheme(1))[0]);
}

TEST(limit, the_corner_of_the_cube)
{
    const hierarchy levels(native(shapes::cube()), kith::catmull_clark());
    const auto limit = limit_positions(levels.elements(0), levels.scheme(0))[6];
    ASSERT_TRUE(limit);
    // The limit for n = 3 is (9 v + 4 (e1 + e2 + e3) + d1 + d2 + d3) / 24 = (9 + 4 - 1) / 24 in each coordinate.
    for (const double x : *limit)
        EXPECT_DOUBLE_EQ(x, 1. / 2);
}

TEST(limit, normals_of_the_cube_point_outward)
{
    const hierarchy levels(native(shapes::cube()), kith::catmull_clark());
    const auto normals = limit_normals(levels.elements(0), levels.scheme(0));
    for (std::size_t v = 0; v < 8; ++v)
        expect_normal(normals[v], levels[0].point(v));
}

TEST(limit, normals_of_a_plane_are_upright_at_the_boundary_too)
{
    auto plane = shapes::grid(3, 4);
    for (auto& p : plane.points)
        p = {p[0] + p[1] / 4, p[1], 0};
    const hierarchy quads(native(plane), kith::catmull_clark());
    for (const auto& normal : limit_normals(quads.elements(0), quads.scheme(0)))
        expect_normal(normal, {0, 0, 1});
    const hierarchy triangles(native(shapes::triangulated(plane)), kith::loop());
    for (const auto& normal : limit_normals(triangles.elements(0), triangles.scheme(0)))
        expect_normal(normal, {0, 0, 1});
}

TEST(limit, a_scheme_of_ones_own_says_its_masks_beside_it)
{
    const hierarchy levels(native(shapes::cube()), own_split_with_limits());
    using level = std::remove_cvref_t<decltype(levels.elements(0))>;
    EXPECT_FALSE((kith::has_limit_positions<own_split, kith::vertex<level>, level>));
    EXPECT_FALSE((kith::has_limit_tangents<own_split_with_limits, kith::vertex<level>, level>));
    const auto limits = limit_positions(levels.elements(0), levels.scheme(0));
    for (const double x : limits[6].value()) // twice the sum of (1, 1, -1), (1, -1, 1) and (-1, 1, 1)
        EXPECT_EQ(x, 2);
    EXPECT_EQ(limit_surface_of(levels, 0).positions[6], limits[6].value());
    EXPECT_EQ(limit_surface_of(hierarchy(levels[0], own_split()), 0).positions[6], levels[0].point(6));
}

namespace {

/// A scheme whose steps increase the distances between neighbouring vertices.
struct growing {
    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "growing", .reach = [](int rings) { return rings / 2 + 1; }};
    }
    static constexpr auto columns() { return kith::quad_split::columns(); }
    template <class R>
    void operator()(const R& r) const
    {
        const double t = -8. * (1 + r.generation);
        subdivide(kith::quad_split(),
                  r,
                  kith::at_vertices([t](auto v) { return (1 - t) * v + t * average(v.neighbors()); }),
                  kith::at_edges([](auto e) { return average(e.org(), e.dst()); }),
                  kith::at_faces([](auto f) { return average(f.vertices()); }));
    }
};

} // namespace

TEST(limit, what_grows_beyond_all_numbers_has_none)
{
    const auto mesh = native(shapes::shaken(shapes::cube()));
    const auto text = error_text<kith::mesh_error>([&] { static_cast<void>(limit_surface_of(mesh, growing())); });
    EXPECT_NE(text.find("growing: the faces around vertex"), std::string::npos) << text;
    EXPECT_NE(text.find("so it has no limit"), std::string::npos) << text;
}
