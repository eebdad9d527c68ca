// SPDX-License-Identifier: BSD-3-Clause
#include <kith/kobbelt.hpp>

#include "error_text.hpp"
#include "regular_masks.hpp"

#include <gtest/gtest.h>

TEST(kobbelt, keeps_all_points)
{
    for (const auto& shape : {shapes::cube(), shapes::grid(), shapes::l_shape(), shapes::ring()}) {
        const auto fine = kith::refine(native(shape), kith::kobbelt(), 2);
        for (std::size_t v = 0; v < shape.points.size(); ++v)
            EXPECT_EQ(fine.point(v), shape.points[v]);
    }
}

TEST(kobbelt, is_the_four_point_scheme_along_regular_lines)
{
    expect_weights(weights_of(regular_quads, kith::kobbelt(), edge_handle{0}), {9. / 16, 9. / 16, -1. / 16, -1. / 16});
}

TEST(kobbelt, is_the_four_point_scheme_in_both_directions_in_faces)
{
    const double a = 81. / 256, b = -9. / 256, c = 1. / 256;
    expect_weights(weights_of(regular_quads, kith::kobbelt(), face_handle{0}),
                   {a, a, a, a, c, c, c, c, b, b, b, b, b, b, b, b});
}

TEST(kobbelt, tension_weighs_the_outer_points)
{
    const kith::kobbelt flat{.tension = 0.5};
    expect_weights(weights_of(regular_quads, flat, edge_handle{0}), {17. / 32, 17. / 32, -1. / 32, -1. / 32});
}

TEST(kobbelt, refuses_faces_that_are_no_quads)
{
    EXPECT_EQ(error_text<kith::mesh_error>([] { kith::refine(native(shapes::house()), kith::kobbelt(), 1); }),
              "kobbelt: face 0 has 3 vertices; split it into quads first, by one step of the linear scheme");
}
