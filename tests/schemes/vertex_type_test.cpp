// SPDX-License-Identifier: BSD-3-Clause
#include <kith/schemes/crease/vertex_type.hpp>

#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/hierarchy.hpp>
#include <kith/refine.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using kith::boundary_corner;
using kith::creases;
using kith::infinitely_sharp;
using kith::vertex_type;

namespace {

using level_type = kith::level_of<mesh3d>;

/// A test on 4 x 4 quads, with vertices numbered row by row. Vertex 12 is the middle, 2 and 10 lie on the boundary, and
/// 0 is its corner.
struct vertex_types_of_a_grid : testing::Test {
    auto edge(std::size_t a, std::size_t b) const { return kith::edge(level, edge_between(level, a, b)); }
    auto vertex(std::size_t v) const { return level.vertices()[v]; }
    vertex_type type(std::size_t v, boundary_corner corners = boundary_corner::kept) const
    {
        return type_of(vertex(v), sharp, corners);
    }
    /// Returns the new point of a vertex after one step of Catmull-Clark.
    shapes::point refined(std::size_t v) const
    {
        return kith::refine(mesh, kith::catmull_clark{.corners = {}, .sharpness = sharp}, 1).point(v);
    }
    void expect_point(std::size_t v, double x, double y, double z) const
    {
        const auto is = refined(v);
        EXPECT_DOUBLE_EQ(is[0], x);
        EXPECT_DOUBLE_EQ(is[1], y);
        EXPECT_DOUBLE_EQ(is[2], z);
    }
    double z(std::size_t v) const { return mesh.point(v)[2]; }
    std::string refusal(std::size_t v, vertex_type type, std::initializer_list<kith::edge<level_type>> along = {})
    {
        const creases before = sharp;
        auto text = error_text<kith::mesh_error>([&] { set_type(sharp, vertex(v), type, along); });
        EXPECT_EQ(sharp.edges(), before.edges());
        EXPECT_EQ(sharp.vertices(), before.vertices());
        return text;
    }

    mesh3d mesh = native(shapes::grid(4, 4));
    level_type level{mesh};
    creases sharp;
};

} // namespace

TEST_F(vertex_types_of_a_grid, without_creases_they_are_inner_or_of_the_boundary)
{
    const auto types = vertex_types(mesh, sharp);
    EXPECT_EQ(std::ranges::count(types, vertex_type::inner), 9);
    EXPECT_EQ(std::ranges::count(types, vertex_type::boundary), 12);
    EXPECT_EQ(std::ranges::count(types, vertex_type::corner), 4);
    EXPECT_EQ(types[0], vertex_type::corner);
    EXPECT_EQ(type(0, boundary_corner::smoothed), vertex_type::boundary);
}

TEST_F(vertex_types_of_a_grid, sharp_edges_and_vertices_make_them)
{
    for (const std::size_t v : {10U, 11U, 12U}) // from the boundary to the third inner vertex of the middle row
        sharp.sharpen_edge(edge(v, v + 1).index(), 0.5);
    sharp.sharpen_vertex(7, 1);
    sharp.sharpen_vertex(2, infinitely_sharp);
    EXPECT_EQ(type(10), vertex_type::boundary_crease);
    EXPECT_EQ(type(11), vertex_type::crease);
    EXPECT_EQ(type(12), vertex_type::crease);
    EXPECT_EQ(type(13), vertex_type::inner); // the dart
    EXPECT_EQ(type(7), vertex_type::corner);
    EXPECT_EQ(type(2), vertex_type::corner);
    sharp.sharpen_edge(edge(7, 12).index(), 1);
    EXPECT_EQ(type(12), vertex_type::corner);
}

TEST_F(vertex_types_of_a_grid, a_corner_stays)
{
    set_type(sharp, vertex(12), vertex_type::corner);
    EXPECT_EQ(type(12), vertex_type::corner);
    expect_point(12, 2, 2, z(12));
    set_type(sharp, vertex(2), vertex_type::corner);
    EXPECT_EQ(type(2), vertex_type::corner);
    expect_point(2, 2, 0, z(2));
}

TEST_F(vertex_types_of_a_grid, a_crease_follows_its_two_edges)
{
    sharp.sharpen_vertex(12, 3);
    sharp.sharpen_edge(edge(12, 17).index(), 2);
    set_type(sharp, vertex(12), vertex_type::crease, {edge(7, 12), edge(12, 13)});
    EXPECT_EQ(type(12), vertex_type::crease);
    EXPECT_EQ(sharp.of_edge(edge(12, 17).index()), 0.);
    expect_point(12, (6 * 2. + 2 + 3) / 8, (6 * 2. + 1 + 2) / 8, (6 * z(12) + z(7) + z(13)) / 8);
}

TEST_F(vertex_types_of_a_grid, a_boundary_crease_stays)
{
    set_type(sharp, vertex(2), vertex_type::boundary_crease, {edge(2, 7)}, 2);
    EXPECT_EQ(type(2), vertex_type::boundary_crease);
    EXPECT_EQ(type(7), vertex_type::inner);
    EXPECT_EQ(sharp.of_edge(edge(2, 7).index()), 2.);
    expect_point(2, 2, 0, z(2));
}

TEST_F(vertex_types_of_a_grid, a_boundary_vertex_follows_the_boundary)
{
    sharp.sharpen_vertex(2, 1);
    sharp.sharpen_edge(edge(2, 7).index(), 1);
    set_type(sharp, vertex(2), vertex_type::boundary);
    EXPECT_EQ(type(2), vertex_type::boundary);
    EXPECT_TRUE(sharp.empty());
    expect_point(2, 2, 0, (6 * z(2) + z(1) + z(3)) / 8);
}

TEST_F(vertex_types_of_a_grid, a_boundary_corner_is_of_the_boundary_where_corners_are_smoothed)
{
    set_type(sharp, vertex(0), vertex_type::boundary, {}, infinitely_sharp, boundary_corner::smoothed);
    EXPECT_EQ(type(0, boundary_corner::smoothed), vertex_type::boundary);
    EXPECT_EQ(refusal(0, vertex_type::boundary),
              "vertex 0: is a boundary corner, which is kept; refine with boundary_corner::smoothed");
}

TEST_F(vertex_types_of_a_grid, an_inner_vertex_is_smooth)
{
    const auto smooth = refined(12);
    for (const std::size_t v : {7U, 11U, 13U})
        sharp.sharpen_edge(edge(v, 12).index(), infinitely_sharp);
    EXPECT_NE(refined(12), smooth);
    set_type(sharp, vertex(12), vertex_type::inner);
    EXPECT_EQ(type(12), vertex_type::inner);
    EXPECT_TRUE(sharp.empty());
    EXPECT_EQ(refined(12), smooth);
}

TEST_F(vertex_types_of_a_grid, types_follow_the_levels)
{
    set_type(sharp, vertex(12), vertex_type::crease, {edge(11, 12), edge(12, 13)}, 1.5);
    kith::hierarchy levels(mesh, kith::catmull_clark{.corners = {}, .sharpness = sharp});
    levels.refine(2);
    const auto count = [&](int l, vertex_type type) {
        return std::ranges::count(vertex_types(levels[l], levels.scheme(l).sharpness), type);
    };
    EXPECT_EQ(count(0, vertex_type::crease), 1);
    EXPECT_EQ(count(1, vertex_type::crease), 3); // the vertex and the points of its two edges
    EXPECT_EQ(count(2, vertex_type::crease), 0);
}

TEST_F(vertex_types_of_a_grid, what_lies_inside_is_not_of_the_boundary)
{
    EXPECT_EQ(refusal(12, vertex_type::boundary), "vertex 12: lies inside; make it inner, crease or corner");
    EXPECT_EQ(refusal(12, vertex_type::boundary_crease, {edge(7, 12)}),
              "vertex 12: lies inside; make it inner, crease or corner");
    EXPECT_EQ(refusal(2, vertex_type::inner),
              "vertex 2: lies on the boundary; make it boundary, boundary_crease or corner");
}

TEST_F(vertex_types_of_a_grid, edges_have_to_be_its_own)
{
    const std::string not_its_own = " is not an inner edge of this vertex or is given twice; give other edges";
    EXPECT_EQ(refusal(12, vertex_type::crease, {edge(7, 12), edge(6, 7)}),
              "vertex 12: edge " + std::to_string(edge(6, 7).index()) + not_its_own);
    EXPECT_EQ(refusal(12, vertex_type::crease, {edge(7, 12), edge(7, 12)}),
              "vertex 12: edge " + std::to_string(edge(7, 12).index()) + not_its_own);
    EXPECT_EQ(refusal(2, vertex_type::boundary_crease, {edge(1, 2)}),
              "vertex 2: edge " + std::to_string(edge(1, 2).index()) + not_its_own);
}

TEST_F(vertex_types_of_a_grid, the_number_of_edges_has_to_fit)
{
    const std::string takes = " edges; a crease takes two, a boundary crease one or more, other types none";
    EXPECT_EQ(refusal(12, vertex_type::crease, {edge(7, 12)}), "vertex 12: was given 1" + takes);
    EXPECT_EQ(refusal(2, vertex_type::boundary_crease), "vertex 2: was given 0" + takes);
    EXPECT_EQ(refusal(12, vertex_type::corner, {edge(7, 12)}), "vertex 12: was given 1" + takes);
}
