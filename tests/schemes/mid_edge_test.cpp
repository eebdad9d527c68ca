// SPDX-License-Identifier: BSD-3-Clause
#include <kith/mid_edge.hpp>

#include "support/error_text.hpp"
#include "support/exact_mesh.hpp"

#include <kith/refine.hpp>

#include <gtest/gtest.h>

TEST(mid_edge, makes_a_cuboctahedron_of_the_cube)
{
    const auto cube = exact(shapes::cube());
    const auto fine = kith::refine(cube, kith::mid_edge(), 1);
    EXPECT_EQ(fine.vertex_count(), 12U);
    EXPECT_EQ(fine.edge_count(), 24U);
    EXPECT_EQ(fine.face_count(), 14U);
    EXPECT_EQ(fine.point(edge_number(cube, 5, 6)), (exact_point{1, 0, 1}));
    EXPECT_EQ(fine.face(3).size(), 4U);     // of a face
    EXPECT_EQ(fine.face(6 + 3).size(), 3U); // of a vertex
}

TEST(mid_edge, closes_the_faces_of_boundary_vertices)
{
    const auto fine = kith::refine(exact(shapes::grid(2, 2)), kith::mid_edge(), 1); // 12 edges, 4 faces
    EXPECT_EQ(fine.face_count(), 4U + 1 + 4);
    EXPECT_EQ(count(fine.topology()).boundary_edges, 8U);
}

TEST(mid_edge, refuses_an_inner_vertex_between_two_faces)
{
    EXPECT_EQ(
        error_text<kith::mesh_error>([] { kith::refine(exact(shapes::valence_two()), kith::mid_edge(), 1); }),
        "mid-edge: vertex 3 lies between 2 faces only, the scheme needs three; merge its two edges into one first");
}
