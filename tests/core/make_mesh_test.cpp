// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/mesh/make_mesh.hpp>

#include "support/error_text.hpp"
#include "support/same_mesh.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <list>

namespace {

using shapes::polygons;
using indices = std::vector<std::size_t>;

std::vector<shapes::point> some_points(std::size_t n)
{
    return {n, shapes::point{0, 0, 0}};
}
std::string refusal(std::size_t vertices, const polygons& faces)
{
    return error_text<kith::mesh_error>([&] { kith::make_mesh(some_points(vertices), faces); });
}
std::string refusal_of_coordinate(double x)
{
    auto [points, faces] = shapes::cube();
    points[5][1] = x;
    return error_text<kith::mesh_error>([&] { kith::make_mesh(points, faces); });
}
indices face(const auto& mesh, std::size_t f)
{
    const auto corners = mesh.face(f);
    return {corners.begin(), corners.end()};
}

} // namespace

TEST(make_mesh, keeps_the_numbers_of_vertices_and_faces)
{
    const auto [points, faces] = shapes::house();
    const auto mesh = kith::make_mesh(points, faces);
    EXPECT_TRUE(std::ranges::equal(mesh.points(), points));
    for (std::size_t f = 0; f < faces.size(); ++f)
        EXPECT_EQ(as_cycles({face(mesh, f)}), as_cycles({faces[f]}));
}

TEST(make_mesh, stores_each_face_from_its_smallest_vertex_on)
{
    const auto mesh = kith::make_mesh(some_points(5), polygons{{3, 1, 4, 2, 0}});
    EXPECT_EQ(face(mesh, 0), (indices{0, 3, 1, 4, 2}));
}

TEST(make_mesh, takes_values_at_corners_along)
{
    const polygons faces{{3, 0, 1, 4}, {1, 2, 5}, {5, 4, 1}};
    const std::vector<int> values{13, 10, 11, 14, 21, 22, 25, 35, 34, 31}; // ten times the face number, plus the vertex
    const auto mesh = kith::make_mesh(some_points(6), faces);
    const auto at_corners = kith::values_at_corners(faces, values);
    std::vector<int> expected;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (const auto v : mesh.face(f))
            expected.push_back(10 * int(f + 1) + int(v));
    EXPECT_EQ(at_corners, expected);
    EXPECT_NE(error_text<kith::mesh_error>([&] {
                  kith::values_at_corners(faces, std::vector<int>(9));
              }).find("the faces have 10 corners, 9 values were given"),
              std::string::npos);
}

TEST(make_mesh, numbers_edges_by_their_ends)
{
    const auto mesh = kith::make_mesh(some_points(4), polygons{{3, 2, 1}, {1, 0, 3}});
    std::vector<indices> edges;
    for (std::size_t e = 0; e < mesh.edge_count(); ++e) {
        const auto h = mesh.topology().halfedge_corner[2 * e];
        const auto next = mesh.topology().next(h);
        edges.push_back({mesh.topology().corner_vertex[h], mesh.topology().corner_vertex[next]});
    }
    EXPECT_EQ(edges, (std::vector<indices>{{1, 0}, {0, 3}, {2, 1}, {1, 3}, {3, 2}}));
}

TEST(make_mesh, takes_any_ranges)
{
    const std::list<std::array<short, 3>> faces{{0, 1, 2}};
    const std::array<std::array<float, 3>, 3> points{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    const auto mesh = kith::make_mesh<std::uint64_t>(points, faces);
    EXPECT_TRUE((std::same_as<decltype(mesh), const kith::basic_mesh<std::array<float, 3>, std::uint64_t>>));
    EXPECT_EQ(mesh.edge_count(), 3U);
}

TEST(make_mesh, does_not_change_what_it_is_given)
{
    const auto original = shapes::house();
    auto [points, faces] = original;
    kith::make_mesh(points, faces);
    EXPECT_EQ(points, original.points);
    EXPECT_EQ(faces, original.faces);
}

TEST(make_mesh, a_face_and_its_back_are_a_closed_mesh)
{
    EXPECT_EQ(kith::make_mesh(some_points(3), polygons{{0, 1, 2}, {2, 1, 0}}).edge_count(), 3U);
}

TEST(make_mesh, refuses_an_edge_with_three_faces)
{
    EXPECT_EQ(refusal(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}),
              "edge 0-1: 3 faces (0, 1, 2); split the edge or remove faces so that at most two are left");
}

TEST(make_mesh, refuses_neighbours_of_different_orientation)
{
    EXPECT_EQ(refusal(4, {{0, 1, 2}, {0, 1, 3}}),
              "edge 0-1: faces 0 and 1 run through it in the same direction; reverse one of them");
}

TEST(make_mesh, refuses_a_moebius_strip)
{
    const std::string text = refusal(6, {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 3, 0, 5}});
    EXPECT_EQ(text,
              "edge 0-3: faces 0 and 2 run through it in the same direction, and reversing faces does not help, as the "
              "surface is one-sided (not orientable); cut it along edges from boundary to boundary");
}

TEST(make_mesh, tells_a_turned_face_beside_a_one_sided_surface)
{
    // The strip, and two triangles, one of which is turned round.
    const std::string text = refusal(10, {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 3, 0, 5}, {6, 7, 8}, {6, 7, 9}});
    EXPECT_NE(text.find("edge 0-3: faces 0 and 2 run through it in the same direction, and reversing"), text.npos);
    EXPECT_NE(text.find("edge 6-7: faces 3 and 4 run through it in the same direction; reverse one of them"),
              text.npos);
}

TEST(make_mesh, names_few_of_many_faces_at_an_edge)
{
    polygons book;
    for (std::size_t page = 2; page < 22; ++page)
        book.push_back({0, 1, page});
    EXPECT_EQ(
        refusal(22, book),
        "edge 0-1: 20 faces (0, 1, 2, 3, 4, 5, 6, 7, ...); split the edge or remove faces so that at most two are "
        "left");
}

TEST(make_mesh, refuses_a_face_given_twice)
{
    EXPECT_NE(refusal(3, {{0, 1, 2}, {0, 1, 2}}).find("edge 0-1: faces 0 and 1"), std::string::npos);
}

TEST(make_mesh, refuses_fans_that_only_meet_in_a_vertex)
{
    EXPECT_EQ(refusal(5, {{0, 1, 2}, {0, 3, 4}}),
              "vertex 0: its 2 faces form several fans; split the vertex, one copy per fan");
}

TEST(make_mesh, refuses_closed_surfaces_that_only_meet_in_a_vertex)
{
    auto two = shapes::both(shapes::tetrahedron(), shapes::tetrahedron());
    for (auto& f : two.faces)
        std::ranges::replace(f, std::size_t(4), std::size_t(0));
    two.points.erase(two.points.begin() + 4);
    for (auto& f : two.faces)
        for (auto& v : f)
            v -= v > 4 ? 1 : 0;
    EXPECT_EQ(refusal(7, two.faces), "vertex 0: its 6 faces form several fans; split the vertex, one copy per fan");
}

TEST(make_mesh, refuses_faces_without_area)
{
    EXPECT_EQ(refusal(3, {{0, 1, 2}, {0, 1}}), "face 1: has 2 corners; remove it");
    EXPECT_EQ(refusal(3, {{0, 1, 2}, {}}), "face 1: has 0 corners; remove it");
}

TEST(make_mesh, refuses_repeated_corners)
{
    EXPECT_EQ(refusal(4, {{0, 1, 2, 1}}), "face 0: contains vertex 1 twice; remove the repeated corner or the face");
}

TEST(make_mesh, refuses_vertices_without_faces)
{
    EXPECT_EQ(refusal(4, {{0, 1, 3}}), "vertex 2: belongs to no face; remove it or give it a face");
}

TEST(make_mesh, refuses_coordinates_that_are_not_numbers)
{
    const std::string text = "vertex 5: a coordinate is not a finite number; give finite coordinates";
    EXPECT_EQ(refusal_of_coordinate(std::nan("")), text);
    EXPECT_EQ(refusal_of_coordinate(std::numeric_limits<double>::infinity()), text);
    EXPECT_EQ(refusal_of_coordinate(-std::numeric_limits<double>::infinity()), text);
    EXPECT_EQ(refusal_of_coordinate(std::numeric_limits<double>::max()), "no error");
}

TEST(make_mesh, refuses_a_mesh_without_faces)
{
    EXPECT_EQ(refusal(0, {}), "the mesh has no faces; nothing can be refined");
}

TEST(make_mesh, refuses_vertices_that_do_not_exist)
{
    EXPECT_EQ(refusal(3, {{0, 1, 3}}), "face 0: vertex 3 does not exist, there are 3; correct the index");
    const std::vector<std::vector<int>> negative{{0, 1, -1}};
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::make_mesh(some_points(3), negative); }),
              "face 0: vertex -1 does not exist, there are 3; correct the index");
}

TEST(make_mesh, tells_all_problems_at_once)
{
    const std::string text = refusal(4, {{0, 1, 2}, {0, 1, 2, 2}, {0, 9, 1}, {3}});
    EXPECT_NE(text.find("face 1: contains vertex 2 twice"), std::string::npos);
    EXPECT_NE(text.find("face 2: vertex 9 does not exist"), std::string::npos);
    EXPECT_NE(text.find("face 3: has 1 corner;"), std::string::npos);
}

TEST(make_mesh, refuses_more_elements_than_its_index_can_number)
{
    const auto [points, faces] = shapes::torus();
    EXPECT_NE(error_text<kith::mesh_error>([&] { kith::make_mesh<std::uint8_t>(points, faces); }).find("8-bit index"),
              std::string::npos);
    EXPECT_NO_THROW(kith::make_mesh<std::uint16_t>(points, faces));
}
