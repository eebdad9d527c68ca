// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/level/mesh_level.hpp>

#include "support/error_text.hpp"
#include "support/every_level.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using general_level = kith::level_elements<kith::mesh_level<mesh3d>>;

std::vector<std::size_t> numbers(const auto& range)
{
    std::vector<std::size_t> result;
    for (const auto& x : range)
        result.push_back(x.index());
    return result;
}

/// Calls test(level read through the traits, native level) for every shape.
template <class Test>
void for_each_pair(const Test& test)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        const auto mesh = native(shape);
        test(general_level(mesh), level_type(mesh));
    }
}

} // namespace

TEST(mesh_level, counts_as_the_native_level)
{
    for_each_pair([](const general_level& general, const level_type& native) {
        EXPECT_EQ(general.counts(), native.counts());
        EXPECT_EQ(general.is_closed(), native.is_closed());
        EXPECT_EQ(general.corner_count(), native.corner_count());
    });
}

TEST(mesh_level, walks_as_the_native_level)
{
    for_each_pair([](const general_level& general, const level_type& native) {
        for (const auto v : native.vertices()) {
            const auto w = general.vertices()[v.index()];
            EXPECT_EQ(numbers(w.neighbors()), numbers(v.neighbors()));
            EXPECT_EQ(numbers(w.edges()), numbers(v.edges()));
            EXPECT_EQ(numbers(w.faces()), numbers(v.faces()));
        }
        for (const auto f : native.faces()) {
            const auto g = general.faces()[f.index()];
            EXPECT_EQ(numbers(g.vertices()), numbers(f.vertices()));
            EXPECT_EQ(numbers(g.edges()), numbers(f.edges()));
            EXPECT_EQ(numbers(g.corners()), numbers(f.corners()));
        }
    });
}

TEST(mesh_level, directs_edges_as_the_native_level)
{
    for_each_pair([](const general_level& general, const level_type& native) {
        for (const auto e : native.edges()) {
            const auto g = general.edges()[e.index()];
            EXPECT_EQ(g.org().index(), e.org().index());
            EXPECT_EQ(g.lface().index(), e.lface().index());
            EXPECT_EQ(g.is_boundary(), e.is_boundary());
        }
        for (const auto c : native.corners())
            EXPECT_EQ(general.corners()[c.index()].halfedge(), c.halfedge());
    });
}

TEST(mesh_level, fans_at_the_boundary_start_there_wherever_the_mesh_enters)
{
    const auto good = native(shapes::open_house());
    auto t = good.topology();
    for (std::size_t c = 0; c < t.corners(); ++c) // sets the last corner of each vertex, not the first of its fan
        t.vertex_corner[t.corner_vertex[c]] = std::uint32_t(c);
    const mesh3d mesh(kith::storage<shapes::point>(good.points()), std::move(t));
    const general_level general(mesh);
    const level_type native(good);
    for (const auto v : native.vertices())
        if (v.is_boundary()) {
            EXPECT_EQ(numbers(general.vertices()[v.index()].neighbors()), numbers(v.neighbors()));
        }
}

TEST(mesh_level, refuses_vertices_without_faces)
{
    const auto good = native(shapes::cube());
    kith::storage<shapes::point> points(10, {0, 0, 0});
    auto t = good.topology();
    t.vertices = 10;
    t.vertex_corner = kith::storage<std::uint32_t>(10, t.none);
    for (std::size_t c = 0; c < t.corners(); ++c)
        t.vertex_corner[t.corner_vertex[c]] = std::uint32_t(c);
    const mesh3d mesh(std::move(points), std::move(t));
    EXPECT_EQ(error_text<kith::mesh_error>([&] { general_level level(mesh); }),
              "vertex 8: belongs to no face; remove it or give it a face\n"
              "vertex 9: belongs to no face; remove it or give it a face");
}
