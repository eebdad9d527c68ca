// SPDX-License-Identifier: BSD-3-Clause
#include <kith/nasri_hasbini.hpp>

#include "support/regular_masks.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace {

/// Returns the weights of the tensor product of two ternary cubic B-spline rules, given in units of 1/27.
std::vector<double> product(std::initializer_list<double> a, std::initializer_list<double> b)
{
    std::vector<double> result;
    for (const double x : a)
        for (const double y : b)
            result.push_back(x * y / 729);
    std::ranges::sort(result, std::greater());
    return result;
}

const edge_handle some_edge{0};

} // namespace

TEST(nasri_hasbini, is_the_ternary_bicubic_b_spline_at_vertices)
{
    expect_weights(weights_of(regular_quads, kith::nasri_hasbini(), vertex_handle{0}), product({4, 19, 4}, {4, 19, 4}));
}

TEST(nasri_hasbini, is_the_ternary_bicubic_b_spline_on_edges)
{
    expect_weights(weights_of(regular_quads, kith::nasri_hasbini(), vertex_handle{0}, some_edge),
                   product({1, 16, 10}, {4, 19, 4}));
}

TEST(nasri_hasbini, is_the_ternary_bicubic_b_spline_in_faces)
{
    expect_weights(weights_of(regular_quads, kith::nasri_hasbini(), vertex_handle{0}, face_handle{0}),
                   product({1, 16, 10}, {1, 16, 10}));
}

TEST(nasri_hasbini, keeps_the_degrees_of_faces_and_the_valences_of_vertices)
{
    const auto house = native(shapes::house());
    const auto fine = kith::refine(house, kith::nasri_hasbini(), 1); // V + 4E, 9E, F + 4E
    EXPECT_EQ(fine.vertex_count(), 91U);
    EXPECT_EQ(fine.edge_count(), 180U);
    EXPECT_EQ(fine.face_count(), 91U);
    EXPECT_EQ(fine.face(10).size(), 5U);
    const kith::level_of<mesh3d> level(fine);
    EXPECT_EQ(level.vertices()[0].valence(), 5U);
}
