// SPDX-License-Identifier: BSD-3-Clause
#include <kith/doo_sabin.hpp>

#include "support/error_text.hpp"
#include "support/exact_mesh.hpp"
#include "support/native_shape.hpp"

#include <kith/hierarchy.hpp>
#include <kith/linear.hpp>

#include <kith/presets.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using kith::doo_sabin;
using kith::doo_sabin_boundary;
using vertex = kith::mesh_traits<exact_mesh>::vertex;
using face = kith::mesh_traits<exact_mesh>::face;

/// Returns the new point of a vertex in a face.
exact_point corner_point(const shapes::shape& s, std::uint32_t v, std::uint32_t f, const doo_sabin& scheme = {})
{
    kith::hierarchy levels(exact(s), scheme);
    levels.refine();
    return levels[1].point(levels.assoc(0, vertex{v}, face{f}, kith::targets::V).value);
}

/// Returns a bilinear surface over four quads: x = 0 16 32, y = 0 16 32, z = x y / 16.
shapes::shape bilinear()
{
    auto result = shapes::grid(2, 2);
    for (auto& [x, y, z] : result.points)
        x *= 16, y *= 16, z = x * y / 16;
    return result;
}

} // namespace

TEST(doo_sabin, the_weights_of_a_quad_are_the_b_splines)
{
    EXPECT_EQ(doo_sabin().weight(0, 4), 9. / 16);
    EXPECT_EQ(doo_sabin().weight(1, 4), 3. / 16);
    EXPECT_EQ(doo_sabin().weight(2, 4), 1. / 16);
    EXPECT_EQ(doo_sabin().weight(3, 4), 3. / 16);
}

TEST(doo_sabin, the_weights_of_a_triangle)
{
    const doo_sabin averaging{.boundary = {}, .weights = kith::doo_sabin_weights::averaging};
    EXPECT_DOUBLE_EQ(doo_sabin().weight(0, 3), 2. / 3);
    EXPECT_DOUBLE_EQ(doo_sabin().weight(1, 3), 1. / 6);
    EXPECT_DOUBLE_EQ(averaging.weight(0, 3), 7. / 12);
    EXPECT_DOUBLE_EQ(averaging.weight(2, 3), 5. / 24);
}

TEST(doo_sabin, the_weights_of_every_polygon_sum_to_one)
{
    for (const auto weights : {kith::doo_sabin_weights::cosine, kith::doo_sabin_weights::averaging})
        for (std::size_t n = 3; n <= 30; ++n) {
            double sum = 0;
            for (std::size_t j = 0; j < n; ++j)
                sum += doo_sabin{.boundary = {}, .weights = weights}.weight(j, n);
            EXPECT_NEAR(sum, 1, 1e-14);
        }
}

TEST(doo_sabin, corners_of_the_cube_go_half_way_to_the_middle_of_each_face)
{
    EXPECT_EQ(corner_point(shapes::cube(), 6, 1), (exact_point{rational(1, 2), rational(1, 2), 1}));
    EXPECT_EQ(corner_point(shapes::cube(), 0, 2), (exact_point{rational(-1, 2), -1, rational(-1, 2)}));
}

TEST(doo_sabin, the_thesis_cuts_corners_along_the_boundary)
{
    EXPECT_EQ(corner_point(bilinear(), 1, 0), (exact_point{12, 0, 0}));  // 3/4 of vertex 1, 1/4 of vertex 0
    EXPECT_EQ(corner_point(bilinear(), 1, 1), (exact_point{20, 0, 0}));  // 3/4 of vertex 1, 1/4 of vertex 2
    EXPECT_EQ(corner_point(bilinear(), 0, 0), (exact_point{0, 0, 0}));   // with two boundary edges it stays
    EXPECT_EQ(corner_point(bilinear(), 4, 0), (exact_point{12, 12, 9})); // inner points do not depend on the boundary
}

TEST(doo_sabin, clamped_keeps_the_boundary_and_halves_beside_it)
{
    const doo_sabin clamped{.boundary = doo_sabin_boundary::clamped};
    EXPECT_EQ(corner_point(bilinear(), 0, 0, clamped), (exact_point{0, 0, 0}));
    EXPECT_EQ(corner_point(bilinear(), 1, 0, clamped), (exact_point{8, 0, 0}));
    EXPECT_EQ(corner_point(bilinear(), 4, 0, clamped), (exact_point{8, 8, 4}));
}

TEST(doo_sabin, clamped_keeps_a_straight_boundary_where_faces_are_no_quads)
{
    // A half plane: three quads at the origin, whose vertex becomes a triangle at the boundary, then its corners do.
    const shapes::shape half{
        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 5, 0}, {0, 6, 0}, {-2, 5, 0}, {-4, 4, 0}, {-4, 0, 0}},
        {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 7}}};
    for (int level = 1; level <= 4; ++level) {
        const auto fine = kith::refine(native(half), doo_sabin{.boundary = doo_sabin_boundary::clamped}, level);
        const auto& t = fine.topology();
        double left = 0, right = 0;
        std::size_t near_origin = 0;
        for (std::size_t e = 0; e < t.edges(); ++e)
            if (t.halfedge_corner[2 * e + 1] == t.none) {
                const auto& [x, y, z] = fine.point(t.corner_vertex[t.halfedge_corner[2 * e]]);
                if (y < 2.5 and -2.5 < x and x < 2.5) {
                    EXPECT_EQ(y, 0) << "level " << level;
                    ++near_origin;
                }
                left = std::min(left, x);
                right = std::max(right, x);
            }
        EXPECT_GE(near_origin, 2U);
        EXPECT_EQ(left, -4); // its ends stay
        EXPECT_EQ(right, 4);
    }
}

TEST(doo_sabin, clamped_falls_back_to_the_thesis_in_faces_that_are_no_quads)
{
    const auto hexagon = exact(shapes::polygon(6));
    const auto clamped = kith::refine(hexagon, doo_sabin{.boundary = doo_sabin_boundary::clamped}, 1);
    const auto thesis = kith::refine(hexagon, doo_sabin(), 1);
    for (std::size_t v = 0; v < thesis.vertex_count(); ++v)
        EXPECT_EQ(clamped.point(v), thesis.point(v));
}

TEST(doo_sabin, drop_lets_the_surface_recede)
{
    const doo_sabin drop{.boundary = doo_sabin_boundary::drop};
    EXPECT_EQ(corner_point(bilinear(), 0, 0, drop), (exact_point{4, 4, 1}));
    EXPECT_EQ(corner_point(bilinear(), 1, 0, drop), (exact_point{12, 4, 3}));
}

TEST(doo_sabin, boundary_vertices_with_three_faces_get_a_face_unless_dropped)
{
    const auto l = exact(shapes::l_shape()); // V, E, F = 8, 10, 3; one boundary vertex with three faces, two with two
    EXPECT_EQ(kith::refine(l, doo_sabin(), 1).face_count(), 3U + 2 + 1);
    EXPECT_EQ(kith::refine(l, doo_sabin{.boundary = doo_sabin_boundary::drop}, 1).face_count(), 3U + 2);
}

TEST(doo_sabin, refuses_an_inner_vertex_between_two_faces)
{
    EXPECT_EQ(
        error_text<kith::mesh_error>([] { kith::refine(exact(shapes::valence_two()), doo_sabin(), 1); }),
        "doo-sabin: vertex 3 lies between 2 faces only, the scheme needs three; merge its two edges into one first");
}

TEST(doo_sabin, follows_the_boundary_of_cgal)
{
    EXPECT_EQ(kith::like<doo_sabin>(kith::library::cgal).boundary, doo_sabin_boundary::drop);
    EXPECT_EQ(kith::like<doo_sabin>(kith::library::kith).boundary, doo_sabin_boundary::thesis);
    EXPECT_THROW(kith::like<doo_sabin>(kith::library::openmesh), kith::mesh_error);
}

TEST(doo_sabin, refuses_such_a_vertex_that_another_scheme_left)
{
    const auto mesh = kith::refine(exact(shapes::valence_two()), kith::linear(), 1);
    EXPECT_EQ(
        error_text<kith::mesh_error>([&] { kith::refine(mesh, doo_sabin(), 1); }),
        "doo-sabin: vertex 3 lies between 2 faces only, the scheme needs three; merge its two edges into one first");
}
