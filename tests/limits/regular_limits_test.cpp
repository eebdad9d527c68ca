// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limits/limit_surface.hpp>

#include "support/every_scheme.hpp"

#include <kith/hierarchy.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace {

using kith::hierarchy;

/// Expects the limits of a whole mesh, in which regular vertices have a compiled program, to equal the limits computed
/// vertex by vertex.
template <class Scheme>
void expect_same_one_by_one(const mesh3d& mesh, const Scheme& scheme)
{
    const std::vector<unsigned char> all(mesh.vertex_count(), 1);
    const auto made = limit_surface_of(mesh, scheme);
    const auto expected = limit_surface_around(mesh, scheme, std::span<const unsigned char>(all));
    EXPECT_TRUE(std::ranges::equal(made.positions, expected.positions));
    EXPECT_TRUE(std::ranges::equal(made.normals, expected.normals));
    EXPECT_EQ(made.corner_normals, expected.corner_normals);
}
template <class Scheme>
void expect_same_on_levels(const mesh3d& control, const Scheme& scheme, int count)
{
    hierarchy levels(control, scheme);
    levels.refine(count);
    for (int i = 0; i <= count; ++i)
        expect_same_one_by_one(levels[i], levels.scheme(i));
}

template <class Scheme>
bool have_program(const Scheme& scheme, std::size_t degree, bool with_tangents)
{
    const auto masks = kith::detail::regular_masks::of(scheme, degree, 0);
    return masks and masks->have_tangents() == with_tangents;
}

mesh3d scaled(const mesh3d& mesh, const std::array<double, 3>& by)
{
    kith::storage<std::array<double, 3>> points(mesh.points());
    for (auto& p : points)
        for (std::size_t i = 0; i < 3; ++i)
            p[i] *= by[i];
    return {std::move(points), mesh.topology(), mesh.generation()};
}

const auto torus = native(shapes::shaken(shapes::torus(6, 8)));
const auto triangles = native(shapes::shaken(shapes::triangulated(shapes::torus(6, 8))));

} // namespace

TEST(regular_limits, are_those_of_every_vertex_alone)
{
    for_each_of_all_schemes_and_shape(
        [](const auto& scheme, const mesh3d& mesh) { expect_same_on_levels(mesh, scheme, 2); });
}

TEST(regular_limits, are_so_beside_creases_and_boundaries)
{
    for (const auto& mesh : {torus, native(shapes::shaken(shapes::grid(7, 9)))}) {
        kith::catmull_clark creased;
        for (const std::size_t e : {0U, 1U, 17U, 40U})
            creased.sharpness.sharpen_edge(e, e % 2 == 0 ? kith::infinitely_sharp : 1.5);
        creased.sharpness.sharpen_vertex(20, kith::infinitely_sharp);
        expect_same_on_levels(mesh, creased, 2);
    }
    kith::loop creased;
    creased.sharpness.sharpen_edge(5, kith::infinitely_sharp);
    creased.sharpness.sharpen_vertex(30, 2.5);
    expect_same_on_levels(triangles, creased, 2);
}

TEST(regular_limits, are_so_where_tangents_are_extreme)
{
    for (const std::array<double, 3>& by : {std::array<double, 3>{1e-300, 1e-300, 1e-300},
                                            {1e300, 1e300, 1e300},
                                            {1, 1, 0},
                                            {1, 0, 0},
                                            {1e200, 1, 1e-200}}) {
        expect_same_one_by_one(scaled(torus, by), kith::catmull_clark());
        expect_same_one_by_one(scaled(triangles, by), kith::loop());
    }
}

TEST(regular_limits, have_programs)
{
    EXPECT_TRUE(have_program(kith::catmull_clark(), 4, true));
    EXPECT_FALSE(have_program(kith::catmull_clark(), 3, true));
    EXPECT_TRUE(have_program(kith::loop(), 3, true));
    EXPECT_TRUE(have_program(kith::doo_sabin(), 4, true));
    EXPECT_TRUE(have_program(kith::sqrt3(), 3, true));
    EXPECT_TRUE(have_program(kith::butterfly(), 3, true));
    EXPECT_TRUE(have_program(kith::kobbelt(), 4, true));
    EXPECT_TRUE(have_program(kith::nasri_hasbini(), 4, true));
    EXPECT_TRUE(have_program(kith::mid_edge(), 4, true));
    EXPECT_TRUE(have_program(kith::mid_edge(), 3, true));
    EXPECT_TRUE(have_program(kith::unified{.degree = 3}, 4, true));
}
