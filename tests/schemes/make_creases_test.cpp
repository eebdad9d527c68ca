// SPDX-License-Identifier: BSD-3-Clause
#include <kith/make_creases.hpp>

#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"

#include <kith/loop.hpp>
#include <kith/schemes/crease/vertex_type.hpp>
#include <kith/tri_quad.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using kith::creases;
using kith::infinitely_sharp;

namespace {

const mesh3d cube = native(shapes::cube());

std::size_t number_of_edge(std::size_t a, std::size_t b)
{
    const kith::level_of<mesh3d> level(cube);
    return level.index(edge_between(level, a, b));
}

std::size_t sharp_edges(const shapes::shape& s, double degrees)
{
    return creases_by_angle(native(s), degrees).edges().size();
}

/// A property map in the style of Boost, read by get(map, handle).
struct marks {
    std::vector<bool> of;

    template <class Handle>
    friend bool get(const marks& map, Handle x)
    {
        return map.of[x.value];
    }
};

/// An array with operator[] for handles.
struct numbers {
    std::vector<float> of;

    template <class Handle>
    float operator[](Handle x) const
    {
        return of[x.value];
    }
};

} // namespace

TEST(make_creases, handles_of_a_mesh_may_name_them)
{
    const std::size_t chosen = number_of_edge(5, 6);
    const auto sharp = make_creases(
        cube, [&](auto e) { return e.value == chosen ? 3. : 0.; }, [](auto v) { return v.value == 7 ? 2. : 0.; });
    EXPECT_EQ(sharp.edges().size(), 1U);
    EXPECT_EQ(sharp.of_edge(chosen), 3.);
    EXPECT_EQ(sharp.vertices().size(), 1U);
    EXPECT_EQ(sharp.of_vertex(7), 2.);
}

TEST(make_creases, marks_are_sharp_for_ever)
{
    marks marked{std::vector<bool>(12)};
    marked.of[4] = true;
    const auto sharp = make_creases(cube, marked, kith::crease_method::chaikin);
    EXPECT_EQ(sharp.edges(), (std::vector<std::pair<std::size_t, double>>{{4, infinitely_sharp}}));
    EXPECT_EQ(sharp.method, kith::crease_method::chaikin);
}

TEST(make_creases, numbers_in_brackets_are_sharpness)
{
    numbers of_edges{std::vector<float>(12)}, of_vertices{std::vector<float>(8)};
    of_edges.of[3] = 1.5F;
    of_vertices.of[2] = 0.25F;
    const auto sharp = make_creases(cube, of_edges, of_vertices);
    EXPECT_EQ(sharp.edges(), (std::vector<std::pair<std::size_t, double>>{{3, 1.5}}));
    EXPECT_EQ(sharp.vertices(), (std::vector<std::pair<std::size_t, double>>{{2, 0.25}}));
}

TEST(make_creases, a_whole_number_is_no_mark)
{
    EXPECT_EQ(make_creases(cube, [](auto) { return 1; }).of_edge(0), 1.);
    EXPECT_EQ(make_creases(cube, [](auto) { return std::numeric_limits<int>::max() - 1; }).of_edge(0), 2147483646.);
    EXPECT_EQ(make_creases(cube, [](auto) { return std::numeric_limits<int>::max(); }).of_edge(0), infinitely_sharp);
}

TEST(make_creases, negative_sharpness_is_refused)
{
    EXPECT_EQ(error_text<kith::mesh_error>([] { make_creases(cube, [](auto e) { return e.value == 5 ? -1. : 0.; }); }),
              "edge 5: its sharpness is -1.000000; give 0 or more, or infinitely_sharp");
}

TEST(make_creases, sharpness_that_is_no_number_is_refused)
{
    const auto none = [](auto) { return false; };
    const auto nan = [](auto v) { return v.value == 2 ? std::nan("") : 0.; };
    EXPECT_EQ(error_text<kith::mesh_error>([&] { make_creases(cube, none, nan); }),
              "vertex 2: its sharpness is nan; give 0 or more, or infinitely_sharp");
}

TEST(make_creases, angles_find_them)
{
    EXPECT_EQ(sharp_edges(shapes::cube(), 89), 12U);
    EXPECT_EQ(sharp_edges(shapes::cube(), 91), 0U);
    EXPECT_EQ(sharp_edges(shapes::triangulated(shapes::cube()), 45), 12U); // not the diagonals
}

TEST(make_creases, the_native_mesh_marks_no_features)
{
    EXPECT_FALSE(kith::mesh_with_features<mesh3d>);
}

TEST(make_creases, a_mesh_without_edges_is_refused)
{
    const auto faces = kith::refine(native(shapes::tetrahedron()), kith::loop(), 1, {kith::connect::faces});
    const char* text = "the mesh has face-vertex lists only and no edges; refine it with connect::everything";
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::make_creases(faces, [](const auto&) { return true; }); }), text);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::creases_by_angle(faces, 30); }), text);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::vertex_types(faces, kith::creases()); }), text);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::mark_edges(faces, {}); }), text);
}
