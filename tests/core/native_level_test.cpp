// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/level/native_level.hpp>

#include "support/native_shape.hpp"

#include <kith/core/level/level_elements.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace {

template <int Degree>
using level = kith::level_elements<kith::native_level<shapes::point, std::uint32_t, Degree>>;

/// Expects equal walks on a level with a fixed face degree and on one without.
template <int Degree>
void expect_same_walks(const mesh3d& mesh)
{
    const level<Degree> fixed(mesh);
    const level<0> general(mesh);
    for (std::size_t i = 0; i < mesh.corner_count(); ++i) {
        const auto c = fixed.corners()[i];
        const auto d = general.corners()[i];
        EXPECT_EQ(c.next().index(), d.next().index());
        EXPECT_EQ(c.prev().index(), d.prev().index());
        EXPECT_EQ(c.f().index(), d.f().index());
        EXPECT_EQ(c.v().index(), d.v().index());
        EXPECT_EQ(c.halfedge(), d.halfedge());
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        EXPECT_EQ(fixed.faces()[f].degree(), std::size_t(Degree));
        EXPECT_EQ(fixed.faces()[f].first_corner().index(), general.faces()[f].first_corner().index());
    }
}

} // namespace

TEST(native_level, knows_quads_while_compiling)
{
    expect_same_walks<4>(native(shapes::l_shape()));
    expect_same_walks<4>(native(shapes::cube()));
}

TEST(native_level, knows_triangles_while_compiling)
{
    expect_same_walks<3>(native(shapes::umbrella(7)));
    expect_same_walks<3>(native(shapes::tetrahedron()));
}

TEST(native_level, walks_around_faces_of_any_degree)
{
    const auto mesh = native(shapes::open_house());
    const level<0> mixed(mesh);
    for (const auto c : mixed.corners()) {
        EXPECT_EQ(c.next().prev(), c);
        EXPECT_EQ(mesh.face(c.f().index())[c.index() - c.f().first_corner().index()], c.v().index());
    }
}

TEST(native_level, hands_out_the_points_of_the_mesh)
{
    const auto mesh = native(shapes::cube());
    EXPECT_EQ(&level<4>(mesh).vertices()[5].point(), &mesh.point(5));
}

TEST(native_level, knows_whether_it_is_closed)
{
    EXPECT_TRUE(level<0>(native(shapes::house())).is_closed());
    EXPECT_FALSE(level<0>(native(shapes::open_house())).is_closed());
}

TEST(native_level, visits_each_vertex_once_face_by_face)
{
    for (const auto& shape : {shapes::house(), shapes::open_house(), shapes::valence_two()}) {
        const auto mesh = native(shape);
        const level<0> mixed(mesh);
        std::vector<int> visits(mesh.vertex_count());
        const std::size_t half = mesh.face_count() / 2;
        mixed.for_vertices_of(0, half, [&](auto v) { ++visits[v.value]; });
        mixed.for_vertices_of(half, mesh.face_count(), [&](auto v) { ++visits[v.value]; });
        EXPECT_EQ(visits, std::vector<int>(mesh.vertex_count(), 1));
    }
}
