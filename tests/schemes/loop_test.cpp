// SPDX-License-Identifier: BSD-3-Clause
#include <kith/loop.hpp>

#include "support/exact_mesh.hpp"

#include <kith/refine.hpp>

#include <kith/presets.hpp>

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

exact_mesh once(const shapes::shape& s, const kith::loop& scheme = {})
{
    return kith::refine(exact(s), scheme, 1);
}

} // namespace

TEST(loop, the_weights_of_loop)
{
    EXPECT_EQ(kith::loop().beta(3), 3. / 16);
    EXPECT_EQ(kith::loop().beta(6), 1. / 16);
    EXPECT_EQ(kith::loop().beta(4), (5. / 8 - 9. / 64) / 4);
    EXPECT_NEAR(kith::loop().beta(5), 0.084093, 1e-6); // Loop 1987
}

TEST(loop, the_weights_of_warren)
{
    const kith::loop warren{.weights = kith::loop_weights::warren, .corners = {}, .sharpness = {}};
    EXPECT_EQ(warren.beta(3), 3. / 16);
    EXPECT_EQ(warren.beta(4), 3. / 32);
    EXPECT_EQ(warren.beta(8), 3. / 64);
}

TEST(loop, no_neighbour_has_a_negative_weight)
{
    for (std::size_t n = 3; n < 100; ++n) {
        EXPECT_GT(kith::loop().beta(n), 0);
        EXPECT_LT(double(n) * kith::loop().beta(n), 5. / 8);
    }
}

TEST(loop, a_corner_of_the_tetrahedron_goes_to_a_quarter)
{
    EXPECT_EQ(once(shapes::tetrahedron()).point(0), (exact_point{rational(1, 4), rational(1, 4), rational(1, 4)}));
}

TEST(loop, an_edge_of_the_tetrahedron_goes_to_a_half)
{
    const auto edge = edge_number(exact(shapes::tetrahedron()), 0, 1); // 3/8 (2, 0, 0) + 1/8 (-2, 0, 0)
    EXPECT_EQ(once(shapes::tetrahedron()).point(4 + edge), (exact_point{rational(1, 2), 0, 0}));
}

TEST(loop, an_edge_that_is_missing_has_no_number)
{
    EXPECT_THROW(edge_number(exact(shapes::grid()), 0, 6), std::invalid_argument);
}

TEST(loop, the_boundary_is_a_cubic_curve)
{
    const auto fine = once(shapes::triangulated(shapes::grid(2, 4))); // z = 0 1/2 1 1/4 3/4 along it
    EXPECT_EQ(fine.point(2)[2], (rational(1, 2) + 6 * rational(1) + rational(1, 4)) / 8);
}

TEST(loop, boundary_corners_are_kept_or_smoothed)
{
    const kith::loop smooth{.weights = {}, .corners = kith::boundary_corner::smoothed, .sharpness = {}};
    const shapes::shape triangle{{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{0, 1, 2}}};
    EXPECT_EQ(once(triangle).point(1), (exact_point{8, 0, 0}));
    EXPECT_EQ(once(triangle, smooth).point(0), (exact_point{1, 1, 0}));
}

TEST(loop, follows_the_conventions_of_other_libraries)
{
    using kith::library;
    EXPECT_EQ(kith::like<kith::loop>(library::opensubdiv).corners, kith::boundary_corner::kept);
    EXPECT_EQ(kith::like<kith::loop>(library::openmesh).corners, kith::boundary_corner::smoothed);
    EXPECT_EQ(kith::like<kith::loop>(library::libigl).weights, kith::loop_weights::warren);
}
