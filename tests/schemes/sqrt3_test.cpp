// SPDX-License-Identifier: BSD-3-Clause
#include <kith/sqrt3.hpp>

#include "support/error_text.hpp"
#include "support/native_shape.hpp"

#include <kith/hierarchy.hpp>

#include <kith/presets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

/// Returns one triangle with its corners at (0,0,0), (27,0,0), (0,27,0).
mesh3d triangle()
{
    return native({{{0, 0, 0}, {27, 0, 0}, {0, 27, 0}}, {{0, 1, 2}}});
}
bool has_point(const mesh3d& mesh, const shapes::point& p)
{
    return std::ranges::any_of(mesh.points(), [&p](const auto& q) {
        return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) < 1e-13;
    });
}

} // namespace

TEST(sqrt3, the_weights_of_kobbelt)
{
    EXPECT_DOUBLE_EQ(kith::sqrt3::alpha(3), 5. / 9);
    EXPECT_DOUBLE_EQ(kith::sqrt3::alpha(4), 4. / 9);
    EXPECT_DOUBLE_EQ(kith::sqrt3::alpha(6), 1. / 3);
}

TEST(sqrt3, a_corner_of_the_tetrahedron)
{
    const auto fine = kith::refine(native(shapes::tetrahedron()), kith::sqrt3(), 1); // 4/9 v + 5/9 * -1/3 v
    for (const double x : fine.point(0))
        EXPECT_DOUBLE_EQ(x, 4. / 9 - 5. / 27);
}

TEST(sqrt3, faces_get_their_centroid)
{
    EXPECT_EQ(kith::refine(triangle(), kith::sqrt3(), 1).point(3), (shapes::point{9, 9, 0}));
}

TEST(sqrt3, an_even_step_leaves_the_boundary_alone)
{
    const auto fine = kith::refine(triangle(), kith::sqrt3(), 1);
    EXPECT_EQ(fine.point(1), (shapes::point{27, 0, 0}));
    EXPECT_EQ(count(fine.topology()).boundary_edges, 3U);
}

TEST(sqrt3, an_odd_step_trisects_the_boundary)
{
    const auto fine = kith::refine(triangle(), kith::sqrt3(), 2);
    EXPECT_EQ(count(fine.topology()).boundary_edges, 9U);
    EXPECT_TRUE(has_point(fine, {4, 4, 0}));  // (4 v0 + 19 v1 + 4 v2) / 27 at the corner (0,0,0)
    EXPECT_TRUE(has_point(fine, {10, 1, 0})); // (v0 + 16 v1 + 10 v2) / 27 on the edge to (27,0,0)
    EXPECT_TRUE(has_point(fine, {16, 1, 0})); // the other point on this edge
}

TEST(sqrt3, two_steps_make_nine_triangles_of_one)
{
    const auto fine = kith::refine(triangle(), kith::sqrt3(), 2);
    EXPECT_EQ(fine.vertex_count(), 10U);
    EXPECT_EQ(fine.face_count(), 9U);
}

TEST(sqrt3, closed_meshes_triple_their_faces_whatever_the_generation)
{
    auto mesh = native(shapes::tetrahedron());
    for (std::size_t faces = 12; faces <= 108; faces *= 3) {
        mesh = kith::refine(mesh, kith::sqrt3(), 1);
        EXPECT_EQ(mesh.face_count(), faces);
    }
}

TEST(sqrt3, refuses_to_trisect_two_edges_of_one_face)
{
    const auto once_too_many = triangle();
    const mesh3d odd(kith::storage<shapes::point>(once_too_many.points()), once_too_many.topology(), 1);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::refine(odd, kith::sqrt3(), 1); }),
              "sqrt3: face 0 has 3 boundary edges in a step that trisects them; start with generation 0");
}

TEST(sqrt3, is_in_cgal_and_openmesh_too)
{
    EXPECT_NO_THROW(kith::like<kith::sqrt3>(kith::library::cgal));
    EXPECT_THROW(kith::like<kith::sqrt3>(kith::library::opensubdiv), kith::mesh_error);
}
