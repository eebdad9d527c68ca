// SPDX-License-Identifier: BSD-3-Clause
#include <kith/four_eight.hpp>

#include "error_text.hpp"
#include "native_shape.hpp"

#include <gtest/gtest.h>

namespace {

/// A square of two triangles that both start with the diagonal 0-2.
mesh3d square()
{
    return tri_quad(native({{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 8}}, {{0, 1, 2, 3}}}));
}

} // namespace

TEST(four_eight, cuts_quads_along_a_diagonal)
{
    EXPECT_EQ(square().face_count(), 2U);
    EXPECT_EQ(square().generation(), 0);
    EXPECT_EQ(tri_quad(native(shapes::cube())).edge_count(), 18U);
}

TEST(four_eight, puts_a_vertex_into_other_faces)
{
    const auto mesh = tri_quad(native(shapes::house()));
    EXPECT_EQ(mesh.vertex_count(), 22U);
    EXPECT_EQ(mesh.face_count(), 40U);
    EXPECT_EQ(mesh.generation(), 1);
}

TEST(four_eight, bisects_every_triangle)
{
    const auto fine = kith::refine(square(), kith::four_eight(), 1);
    EXPECT_EQ(fine.face_count(), 4U);
    EXPECT_EQ(fine.vertex_count(), 5U);
    EXPECT_EQ(fine.point(4), (shapes::point{4, 4, 2})); // the mean of the four
}

TEST(four_eight, smooths_the_boundary_where_it_was_bisected)
{
    const auto fine = kith::refine(square(), kith::four_eight(), 2);
    EXPECT_EQ(count(fine.topology()).boundary_edges, 8U);
    EXPECT_EQ(fine.point(0), (shapes::point{1, 1, 1})); // 1/8 (8, 0, 0) + 6/8 (0, 0, 0) + 1/8 (0, 8, 8)
}

TEST(four_eight, marked_edges_can_be_chosen)
{
    using pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    const auto mesh = native(shapes::triangulated(shapes::polygon(4))); // its diagonal is 1-3
    const auto marked = mark_edges(mesh, pairs{{3, 1}});
    EXPECT_EQ(kith::refine(marked, kith::four_eight(), 1).face_count(), 4U);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { mark_edges(mesh, pairs{{0, 1}}); }),
              "4-8: face 0 has 0 marked edges; mark exactly one");
}

TEST(four_eight, refuses_triangles_that_do_not_agree_on_their_marks)
{
    EXPECT_NE(error_text<kith::mesh_error>([] {
                  kith::refine(native(shapes::tetrahedron()), kith::four_eight(), 1);
              }).find("do not both start with the edge between them; make a tri-quad mesh first"),
              std::string::npos);
}
