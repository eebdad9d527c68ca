// SPDX-License-Identifier: BSD-3-Clause
#include <kith/kobbelt.hpp>

#include "support/error_text.hpp"
#include "support/regular_masks.hpp"

#include <kith/evaluator.hpp>
#include <kith/hierarchy.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

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

TEST(kobbelt, refuses_a_tension_that_the_paper_does_not_allow)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), most = kith::kobbelt::max_tension;
    const auto refusal = [](const kith::kobbelt& scheme, const mesh3d& mesh, int levels) {
        return error_text<kith::mesh_error>([&] { kith::refine(mesh, scheme, levels); });
    };
    const auto cube = native(shapes::cube()), large = native(shapes::torus(40, 40));
    for (const double tension : {nan, -1., 0., most, 5., std::numeric_limits<double>::infinity()}) {
        const kith::kobbelt scheme{.tension = tension};
        const auto text = "kobbelt: a tension of " + std::to_string(tension) +
                          " was asked for; ask for one between 0 and 2.472";
        EXPECT_EQ(refusal(scheme, cube, 1), text);
        EXPECT_EQ(refusal(scheme, large, 4), text); // where faces that look alike have templates
        EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::hierarchy<mesh3d, kith::kobbelt>(cube, scheme); }), text);
        EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::evaluator(large, scheme, 3); }), text);
    }
    for (const double tension : {1e-300, 1., std::nextafter(most, 0.)})
        EXPECT_EQ(refusal({.tension = tension}, cube, 1), "no error");
    EXPECT_EQ(refusal({.gamma = nan}, cube, 1), "kobbelt: gamma is nan; give it a finite number");
}

TEST(kobbelt, refuses_faces_that_are_no_quads)
{
    EXPECT_EQ(error_text<kith::mesh_error>([] { kith::refine(native(shapes::house()), kith::kobbelt(), 1); }),
              "kobbelt: face 0 has 3 vertices; split it into quads first, by one step of the linear scheme");
}
