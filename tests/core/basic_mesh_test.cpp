// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/mesh/basic_mesh.hpp>

#include "support/native_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

using kith::counts;

namespace {

using traits = kith::mesh_traits<mesh3d>;

} // namespace

TEST(basic_mesh, starts_empty)
{
    const mesh3d none;
    EXPECT_EQ(none.vertex_count() + none.edge_count() + none.face_count() + none.corner_count(), 0U);
    EXPECT_FALSE(none.topology().faces_only());
}

TEST(basic_mesh, counts_its_elements)
{
    const auto mesh = native(shapes::house());
    EXPECT_EQ(mesh.vertex_count(), 11U);
    EXPECT_EQ(mesh.edge_count(), 20U);
    EXPECT_EQ(mesh.face_count(), 11U);
    EXPECT_EQ(mesh.corner_count(), 40U);
}

TEST(basic_mesh, faces_of_one_degree_need_no_offsets)
{
    const auto quads = native(shapes::cube()).topology(), mixed = native(shapes::house()).topology();
    EXPECT_EQ(quads.degree, 4);
    EXPECT_TRUE(quads.face_corner.empty());
    EXPECT_EQ(mixed.degree, 0);
    EXPECT_EQ(mixed.face_corner.size(), mixed.faces + 1);
}

TEST(basic_mesh, knows_the_vertices_of_a_face)
{
    const auto mesh = native(shapes::house());
    EXPECT_TRUE(std::ranges::equal(mesh.face(10), std::vector{6U, 10U, 9U, 8U, 7U}));
    EXPECT_TRUE(std::ranges::equal(native(shapes::cube()).face(2), std::vector{0U, 1U, 5U, 4U}));
}

TEST(basic_mesh, points_can_be_moved)
{
    auto mesh = native(shapes::cube());
    mesh.points()[3] = {7, 8, 9};
    EXPECT_EQ(mesh.point(3), (shapes::point{7, 8, 9}));
}

TEST(basic_mesh, a_copy_is_deep)
{
    auto mesh = native(shapes::cube());
    const auto copy = mesh;
    mesh.points()[0] = {7, 8, 9};
    EXPECT_EQ(copy.point(0), (shapes::point{-1, -1, -1}));
}

TEST(basic_mesh, counts_the_classes_of_its_boundary)
{
    EXPECT_EQ(count(native(shapes::l_shape()).topology()),
              (counts{.vertices = 8,
                      .edges = 10,
                      .faces = 3,
                      .boundary_edges = 8,
                      .boundary_vertices_of_one_face = 5,
                      .boundary_vertices_of_many_faces = 1,
                      .boundary_corners = 12}));
}

TEST(basic_mesh, a_closed_mesh_has_no_boundary_classes)
{
    EXPECT_EQ(count(native(shapes::house()).topology()),
              (counts{.vertices = 11, .edges = 20, .faces = 11, .triangles = 5}));
}

TEST(basic_mesh, traits_walk_around_a_face)
{
    const auto mesh = native(shapes::house());
    for (const auto f : traits::faces(mesh)) {
        auto h = traits::halfedge_of(mesh, f);
        for (const auto v : mesh.face(f.value)) {
            EXPECT_EQ(traits::source(mesh, h).value, v);
            EXPECT_EQ(traits::face_of(mesh, h), f);
            EXPECT_EQ(traits::prev(mesh, traits::next(mesh, h)), h);
            h = traits::next(mesh, h);
        }
        EXPECT_EQ(h, traits::halfedge_of(mesh, f));
    }
}

TEST(basic_mesh, traits_know_both_sides_of_an_edge)
{
    const auto mesh = native(shapes::l_shape());
    std::size_t boundary = 0;
    for (const auto e : traits::edges(mesh)) {
        const auto h = traits::halfedge_of(mesh, e), o = traits::opposite(mesh, h);
        EXPECT_EQ(traits::opposite(mesh, o), h);
        EXPECT_EQ(traits::edge_of(mesh, o), e);
        EXPECT_FALSE(traits::is_boundary(mesh, h));
        EXPECT_EQ(traits::source(mesh, o), traits::source(mesh, traits::next(mesh, h)));
        boundary += traits::is_boundary(mesh, o);
    }
    EXPECT_EQ(boundary, 8U);
}

TEST(basic_mesh, traits_enter_from_a_vertex)
{
    const auto mesh = native(shapes::l_shape());
    for (const auto v : traits::vertices(mesh))
        EXPECT_EQ(traits::source(mesh, traits::halfedge_of(mesh, v)), v);
}
