// SPDX-License-Identifier: BSD-3-Clause
#include <kith/four_eight.hpp>

#include "support/error_text.hpp"
#include "support/native_shape.hpp"

#include <kith/linear.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

using faces = std::vector<std::vector<std::size_t>>;
using ends = std::pair<std::size_t, std::size_t>;

/// Returns a mesh with these faces over random points.
mesh3d scattered(const faces& list, std::size_t vertices)
{
    std::minstd_rand random;
    std::vector<shapes::point> points(vertices);
    for (auto& point : points)
        for (double& x : point)
            x = double(random() % 1000) / 7;
    return native({points, list});
}
std::set<ends> edges_of(const mesh3d& mesh)
{
    std::set<ends> result;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t k = 0, n = mesh.face(f).size(); k < n; ++k)
            result.insert(std::minmax<std::size_t>(mesh.face(f)[k], mesh.face(f)[(k + 1) % n]));
    return result;
}
bool joins_no_vertices_twice(const mesh3d& mesh)
{
    return edges_of(mesh).size() == mesh.edge_count();
}
/// Returns the sorted points, which do not depend on the numbers of vertices.
auto sorted_points(const mesh3d& mesh)
{
    std::vector<shapes::point> result(mesh.points().begin(), mesh.points().end());
    std::ranges::sort(result);
    return result;
}
/// Returns true if there is a choice of diagonals that joins no two vertices twice.
bool has_choice(const mesh3d& quads)
{
    const auto edges = edges_of(quads);
    const auto is_choice = [&](std::size_t bits) {
        std::set<ends> diagonals;
        for (std::size_t f = 0; f < quads.face_count(); ++f, bits /= 2) {
            const auto face = quads.face(f);
            const ends pair = std::minmax<std::size_t>(face[bits % 2], face[bits % 2 + 2]);
            if (edges.contains(pair) or not diagonals.insert(pair).second)
                return false;
        }
        return true;
    };
    for (std::size_t bits = 0; bits < std::size_t(1) << quads.face_count(); ++bits)
        if (is_choice(bits))
            return true;
    return false;
}
/// Returns the complete graph of five vertices on a torus, in which all diagonals are edges.
faces five_on_a_torus()
{
    faces result;
    for (std::size_t i = 0; i < 5; ++i)
        result.push_back({i, (i + 1) % 5, (i + 3) % 5, (i + 2) % 5});
    return result;
}

/// Returns a square of two triangles, which both start with the diagonal 0-2.
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

TEST(four_eight, two_quads_back_to_back_get_different_diagonals)
{
    const auto mesh = tri_quad(scattered({{0, 1, 2, 3}, {3, 2, 1, 0}}, 4));
    EXPECT_EQ(edges_of(mesh), (std::set<ends>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
}

TEST(four_eight, a_diagonal_turns_where_an_edge_is_already)
{
    // 0-2 is an edge of the lower faces, and the quads at vertex 3 share their diagonal 0-2.
    const auto mesh = tri_quad(scattered({{0, 1, 2, 3}, {0, 3, 2, 4}, {0, 5, 2, 1}, {0, 4, 2, 5}}, 6));
    EXPECT_TRUE(joins_no_vertices_twice(mesh));
}

TEST(four_eight, refuses_quads_whose_diagonals_are_all_edges)
{
    EXPECT_EQ(
        error_text<kith::mesh_error>([] { tri_quad(scattered(five_on_a_torus(), 5)); }),
        "4-8: face 2 cannot be cut along a diagonal, since 0-2 and 3-4 are edges already or diagonals of other faces; "
        "refine the mesh once by the linear scheme first");
    const auto fine = kith::refine(scattered(five_on_a_torus(), 5), kith::linear(), 1);
    EXPECT_TRUE(joins_no_vertices_twice(tri_quad(fine)));
}

TEST(four_eight, finds_diagonals_where_there_are_any_and_the_order_of_faces_changes_no_bit)
{
    std::minstd_rand random(1);
    int found = 0, impossible = 0;
    for (int round = 0; round < 60; ++round) {
        faces list = round % 3 == 0 ? five_on_a_torus() : faces{{0, 1, 2, 3}, {3, 2, 1, 0}};
        std::size_t vertices = round % 3 == 0 ? 5 : 4;
        for (auto cuts = 1 + random() % 4; cuts > 0; --cuts) { // cuts a face along a path between opposite vertices
            auto& face = list[random() % list.size()];
            std::ranges::rotate(face, face.begin() + std::ptrdiff_t(random() % 2));
            const auto old = std::exchange(face, {face[0], face[1], face[2], vertices});
            list.push_back({old[0], vertices++, old[2], old[3]});
        }
        if (round % 2 == 0)
            list.erase(list.begin()); // makes a boundary
        std::vector<std::size_t> name(vertices);
        for (std::size_t v = 0; v < vertices; ++v)
            name[v] = v;
        std::ranges::shuffle(name, random);
        for (auto& face : list)
            for (auto& v : face)
                v = name[v];
        auto other = list;
        std::ranges::shuffle(other, random);
        const auto mesh = scattered(list, vertices), again = scattered(other, vertices);
        if (not has_choice(mesh)) {
            ++impossible;
            EXPECT_THROW(tri_quad(mesh), kith::mesh_error);
            continue;
        }
        ++found;
        EXPECT_TRUE(joins_no_vertices_twice(tri_quad(mesh)));
        EXPECT_EQ(edges_of(tri_quad(mesh)), edges_of(tri_quad(again)));
        EXPECT_EQ(sorted_points(kith::refine(tri_quad(mesh), kith::four_eight(), 3)),
                  sorted_points(kith::refine(tri_quad(again), kith::four_eight(), 3)));
    }
    EXPECT_GT(found, 10);
    EXPECT_GT(impossible, 5);
}

TEST(four_eight, the_order_of_faces_changes_no_bit_where_they_are_polygons)
{
    auto house = shapes::shaken(shapes::house());
    const auto fine = sorted_points(kith::refine(tri_quad(native(house)), kith::four_eight(), 3));
    std::ranges::reverse(house.faces);
    EXPECT_EQ(sorted_points(kith::refine(tri_quad(native(house)), kith::four_eight(), 3)), fine);
}
