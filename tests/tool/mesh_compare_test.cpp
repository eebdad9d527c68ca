// SPDX-License-Identifier: BSD-3-Clause
#include "compare/mesh_compare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

using kith::face_list;
using kith::tool::compare_meshes;
using kith::tool::comparison;
using kith::tool::point3;

namespace {

struct soup {
    std::vector<point3> points;
    std::vector<std::vector<std::size_t>> faces;
};

comparison compare(const soup& a, const soup& b, double tolerance)
{
    return compare_meshes(a.points, face_list(a.faces), b.points, face_list(b.faces), tolerance);
}

/// Returns the mesh with other numbers and its faces in another order, from other first corners. Each point is moved by
/// up to `noise`.
soup shuffled(const soup& mesh, unsigned seed, double noise = 0)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> move(-noise / 2, noise / 2);
    std::vector<std::size_t> number(mesh.points.size());
    std::iota(number.begin(), number.end(), 0);
    std::ranges::shuffle(number, random);
    soup result{std::vector<point3>(mesh.points.size()), mesh.faces};
    for (std::size_t v = 0; v < number.size(); ++v) {
        auto& p = result.points[number[v]] = mesh.points[v];
        for (double& x : p)
            x += noise == 0 ? 0 : move(random);
    }
    for (auto& face : result.faces) {
        for (auto& v : face)
            v = number[v];
        std::ranges::rotate(face, face.begin() + std::ptrdiff_t(random() % face.size()));
    }
    std::ranges::shuffle(result.faces, random);
    return result;
}

/// Makes a torus of m x n quads that covers itself `covers` times, in one piece.
soup torus(std::size_t m, std::size_t n, std::size_t covers = 1)
{
    soup result;
    const double turn = 2 * std::acos(-1.);
    for (std::size_t i = 0; i < m * covers; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double u = turn * double(i % m) / double(m), v = turn * double(j) / double(n);
            const double r = 2 + std::cos(v);
            result.points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
            const std::size_t i1 = (i + 1) % (m * covers), j1 = (j + 1) % n;
            result.faces.push_back({i * n + j, i1 * n + j, i1 * n + j1, i * n + j1});
        }
    return result;
}

soup joined(const soup& a, const soup& b)
{
    soup result = a;
    result.points.insert(result.points.end(), b.points.begin(), b.points.end());
    for (auto face : b.faces) {
        for (auto& v : face)
            v += a.points.size();
        result.faces.push_back(face);
    }
    return result;
}

soup at_one_place(soup mesh)
{
    std::ranges::fill(mesh.points, point3{1, 2, 3});
    return mesh;
}

} // namespace

TEST(mesh_compare, does_not_mind_numbers)
{
    const soup mesh = torus(30, 20);
    for (unsigned seed = 0; seed < 5; ++seed) {
        const auto result = compare(mesh, shuffled(mesh, seed), 0);
        EXPECT_TRUE(result.equal());
        EXPECT_EQ(result.largest_distance, 0);
    }
}

TEST(mesh_compare, tells_the_largest_distance)
{
    const soup mesh = torus(30, 20);
    soup moved = shuffled(mesh, 1, 1e-6);
    const auto near = compare(mesh, moved, 1e-6);
    EXPECT_TRUE(near.equal());
    EXPECT_GT(near.largest_distance, 1e-7);
    EXPECT_LT(near.largest_distance, 1e-6);
    moved.points[7][2] += 1e-3;
    const auto far = compare(mesh, moved, 1e-6);
    EXPECT_FALSE(far.equal());
    EXPECT_EQ(far.unmatched_vertices, 2u);
    EXPECT_NEAR(far.largest_distance, 1e-3, 1e-6);
}

TEST(mesh_compare, sees_a_turned_face)
{
    const soup mesh = torus(5, 4);
    soup turned = shuffled(mesh, 1);
    std::ranges::reverse(turned.faces[3]);
    const auto result = compare(mesh, turned, 1e-9);
    EXPECT_EQ(result.unmatched_vertices, 0u);
    EXPECT_EQ(result.unmatched_faces, 2u);
    EXPECT_FALSE(result.same_faces);
}

TEST(mesh_compare, counts_faces_as_often_as_they_are_there)
{
    const soup mesh = torus(5, 4);
    soup twice = mesh, other = mesh;
    twice.faces.push_back(mesh.faces[0]);
    other.faces.push_back(mesh.faces[1]);
    EXPECT_TRUE(compare(twice, shuffled(twice, 3), 0).equal());
    EXPECT_EQ(compare(twice, other, 0).unmatched_faces, 2u);
    EXPECT_EQ(compare(twice, mesh, 0).unmatched_faces, 1u);
}

TEST(mesh_compare, takes_faces_without_corners_and_empty_meshes)
{
    const soup nothing;
    EXPECT_TRUE(compare(nothing, nothing, 0).equal());
    soup mesh = torus(3, 3);
    EXPECT_EQ(compare(mesh, nothing, 0).unmatched_vertices, 9u);
    EXPECT_EQ(compare(nothing, mesh, 0).unmatched_vertices, 9u);
    mesh.faces.push_back({});
    EXPECT_TRUE(compare(mesh, mesh, 0).equal());
    EXPECT_EQ(compare(mesh, torus(3, 3), 0).unmatched_faces, 1u);
}

TEST(mesh_compare, tells_coinciding_vertices_apart_by_their_faces)
{
    // Two pyramids whose tips coincide, as two vertices. If two of the eight sides exchange their tips, the mesh is
    // different.
    soup pyramids;
    for (const double up : {-1., 1.}) {
        const std::size_t tip = pyramids.points.size();
        pyramids.points.insert(pyramids.points.end(), {{0, 0, 0}, {1, 0, up}, {0, 1, up}, {-1, 0, up}, {0, -1, up}});
        for (std::size_t i = 0; i < 4; ++i)
            pyramids.faces.push_back({tip, tip + 1 + i, tip + 1 + (i + 1) % 4});
    }
    soup exchanged = pyramids;
    std::swap(exchanged.faces[0][0], exchanged.faces[4][0]);
    for (unsigned seed = 0; seed < 5; ++seed) {
        EXPECT_TRUE(compare(pyramids, shuffled(pyramids, seed, 1e-9), 1e-8).equal());
        const auto result = compare(pyramids, shuffled(exchanged, seed, 1e-9), 1e-8);
        EXPECT_EQ(result.unmatched_vertices, 0u);
        EXPECT_EQ(result.unmatched_faces, 0u);
        EXPECT_FALSE(result.same_faces);
    }
}

TEST(mesh_compare, sees_a_face_turned_round_in_one_place)
{
    // A triangle without extent, whose corners are identified by other triangles.
    const soup mesh{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                    {{0, 1, 2}, {0, 3, 4}, {1, 4, 5}, {2, 5, 3}}};
    soup turned = mesh;
    turned.faces[0] = {0, 2, 1};
    EXPECT_TRUE(compare(mesh, shuffled(mesh, 1), 0).equal());
    EXPECT_FALSE(compare(mesh, shuffled(turned, 1), 0).equal());
}

TEST(mesh_compare, follows_surfaces_that_lie_on_one_another)
{
    const soup once = torus(7, 5);
    const soup two_pieces = joined(once, once), one_piece = torus(7, 5, 2);
    for (unsigned seed = 0; seed < 5; ++seed) {
        EXPECT_TRUE(compare(two_pieces, shuffled(two_pieces, seed), 0).equal());
        EXPECT_TRUE(compare(one_piece, shuffled(one_piece, seed, 1e-9), 1e-8).equal());
        EXPECT_FALSE(compare(two_pieces, shuffled(one_piece, seed), 0).equal());
        EXPECT_FALSE(compare(one_piece, shuffled(two_pieces, seed), 0).equal());
        EXPECT_FALSE(compare(joined(one_piece, once), joined(once, joined(once, once)), 0).equal());
        EXPECT_TRUE(compare(joined(one_piece, once), shuffled(joined(once, one_piece), seed), 0).equal());
    }
}

TEST(mesh_compare, falls_back_on_faces_alone)
{
    // All points coincide, so only connectivity is left: an octahedron, and another mesh of six vertices and eight
    // triangles.
    const soup octahedron{std::vector<point3>(6, {0, 0, 0}),
                          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}}};
    soup other = octahedron; // the edge 0-1 turned to 2-4
    other.faces[0] = {0, 4, 2};
    other.faces[3] = {4, 1, 2};
    EXPECT_TRUE(compare(octahedron, shuffled(octahedron, 1), 0).equal());
    EXPECT_TRUE(compare(other, shuffled(other, 1), 0).equal());
    EXPECT_FALSE(compare(octahedron, shuffled(other, 1), 0).equal());
    const soup mesh = at_one_place(torus(6, 5));
    EXPECT_TRUE(compare(mesh, shuffled(mesh, 2), 0).equal());
    EXPECT_FALSE(compare(mesh, at_one_place(torus(10, 3)), 0).equal());
}

TEST(mesh_compare, keeps_every_pair_within_the_tolerance)
{
    // The nearest partner of the first point is the wrong one: it would leave none for the second point.
    const soup two{{{0, 0, 0}, {1, 0, 0}}, {}};
    const soup moved{{{0.6, 0, 0}, {-0.9, 0, 0}}, {}};
    const auto result = compare(two, moved, 1);
    EXPECT_TRUE(result.equal());
    EXPECT_EQ(result.largest_distance, 0.9);
    EXPECT_FALSE(compare(two, soup{{{0.6, 0, 0}, {-1.1, 0, 0}}, {}}, 1).equal());
}

TEST(mesh_compare, refuses_a_tolerance_that_says_nothing)
{
    const soup mesh = torus(100, 100);
    EXPECT_THROW((void)compare(mesh, mesh, 10), std::invalid_argument);
    EXPECT_THROW((void)compare(mesh, mesh, 1e300), std::invalid_argument);
}

TEST(mesh_compare, takes_native_meshes)
{
    const soup mesh = torus(4, 3);
    const auto a = kith::make_mesh(mesh.points, mesh.faces);
    const soup other = shuffled(mesh, 1);
    EXPECT_TRUE(compare_meshes(a, kith::make_mesh(other.points, other.faces), 0).equal());
}
