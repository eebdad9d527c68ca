// SPDX-License-Identifier: BSD-3-Clause
#include <kith/mesh.hpp>

#include "support/error_text.hpp"
#include "support/same_mesh.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

TEST(mesh_builder, makes_the_mesh_of_its_points_and_faces)
{
    kith::mesh_builder builder;
    const auto a = builder.add_vertex({0, 0, 0}), b = builder.add_vertex({1, 0, 0}), c = builder.add_vertex({1, 1, 0}),
               d = builder.add_vertex({0, 1, 0}), top = builder.add_vertex({0.5, 0.5, 1});
    EXPECT_EQ(builder.add_face(d, c, b, a), 0U);
    EXPECT_EQ(builder.add_face(a, b, top), 1U);
    builder.add_face(b, c, top);
    builder.add_face(std::vector<int>{2, 3, 4});
    EXPECT_EQ(builder.add_face(3, 0, 4), 4U);
    EXPECT_EQ(builder.vertex_count(), 5U);
    EXPECT_EQ(builder.face_count(), 5U);

    const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
    const std::vector<std::vector<int>> faces{{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    EXPECT_TRUE(same_bits(builder.mesh(), kith::make_mesh(points, faces)));
}

TEST(mesh_builder, refuses_a_vertex_that_is_not_there_and_keeps_the_rest)
{
    kith::mesh_builder builder;
    for (int i = 0; i < 3; ++i)
        builder.add_vertex({double(i), double(i * i), 0});
    EXPECT_EQ(error_text<kith::mesh_error>([&] { builder.add_face(0, 1, 3); }),
              "face 0 has vertex 3 of 3; add its vertices first");
    EXPECT_EQ(error_text<kith::mesh_error>([&] { builder.add_face(-1, 1, 2); }),
              "face 0 has vertex -1 of 3; add its vertices first");
    EXPECT_EQ(builder.face_count(), 0U);
    builder.add_face(0, 1, 2);
    EXPECT_EQ(builder.mesh().face_count(), 1U);
    builder.add_face(0, 1, 2);
    EXPECT_THROW((void)builder.mesh(), kith::mesh_error); // twice the same side
}
