// SPDX-License-Identifier: BSD-3-Clause
#include <kith/interpolatory_sqrt3.hpp>

#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/regular_masks.hpp"

#include <kith/presets.hpp>

#include <gtest/gtest.h>

#include <numeric>
#include <span>

using kith::interpolatory_sqrt3;

TEST(interpolatory_sqrt3, keeps_all_points)
{
    for (const auto& [name, shape] : shapes::triangle_shapes()) {
        const auto control = native(shape);
        if (count(control.topology()).boundary_edges != 0)
            continue;
        const auto fine = kith::refine(control, interpolatory_sqrt3(), 3);
        for (std::size_t v = 0; v < shape.points.size(); ++v)
            EXPECT_EQ(fine.point(v), shape.points[v]) << name;
    }
}

TEST(interpolatory_sqrt3, has_twelve_weights_between_regular_vertices)
{
    const double a = 32. / 81, b = -1. / 81, c = -2. / 81;
    expect_weights(weights_of(regular_triangles, interpolatory_sqrt3(), face_handle{0}),
                   {a, a, a, b, b, b, c, c, c, c, c, c});
}

TEST(interpolatory_sqrt3, reproduces_cubics_between_regular_vertices)
{
    const auto torus = native(shapes::triangulated(shapes::torus(8, 8)));
    const auto cubic = [](double x, double y) { return x * x * x - 2 * x * x * y + 3 * y * y * y + x * y - 5 * x + 7; };
    std::vector<double> values; // on a lattice, whose cuts lie far from the middle
    for (int i = 0; i < 64; ++i)
        values.push_back(cubic(i % 8, i / 8));
    kith::hierarchy levels(torus, interpolatory_sqrt3());
    levels.refine();
    const auto refined = levels.carry(0, 1, std::span<const double>(values));
    int faces = 0;
    for (const auto f : levels.elements(0).faces()) {
        double x = 0, y = 0;
        bool inside = true;
        for (const auto v : f.vertices()) {
            const auto column = v.index() % 8, row = v.index() / 8;
            x += double(column) / 3;
            y += double(row) / 3;
            inside = inside and column >= 2 and column <= 5 and row >= 2 and row <= 5;
        }
        if (not inside)
            continue;
        ++faces;
        EXPECT_NEAR(refined[levels.assoc(0, f.handle(), kith::targets::V).value], cubic(x, y), 1e-12);
    }
    EXPECT_EQ(faces, 18);
}

TEST(interpolatory_sqrt3, weighs_an_irregular_vertex_and_its_ring)
{
    // A corner of the tetrahedron, its neighbours and the mean over the three corners: (8/9 + 4/27 + 4/27)/3 of each.
    expect_weights(weights_of(shapes::tetrahedron(), interpolatory_sqrt3(), face_handle{0}),
                   {32. / 81, 32. / 81, 32. / 81, -5. / 27});
}

TEST(interpolatory_sqrt3, takes_the_ring_of_the_only_irregular_vertex)
{
    const auto torus = native(shapes::with_flips(shapes::triangulated(shapes::torus(6, 6)), 1, 10));
    kith::hierarchy levels(torus, interpolatory_sqrt3());
    levels.refine();
    const auto matrix = levels.matrix(0, 1);
    int rings = 0;
    for (const auto& c : levels.elements(0).corners()) {
        const auto is_regular = [](const auto& v) { return v.valence() == 6; };
        if (is_regular(c.v()) or not is_regular(c.next().v()) or not is_regular(c.prev().v()))
            continue;
        ++rings;
        const std::size_t point = levels.assoc(0, c.f().handle(), kith::targets::V).value;
        const auto weight = [&](const auto& v) {
            double result = 0;
            for (std::size_t k = matrix.begin_of_row(point); k < matrix.begin_of_row(point + 1); ++k)
                result += std::size_t(matrix.column[k]) == v.index() ? matrix.weight[k] : 0;
            return result;
        };
        const std::size_t n = c.v().valence();
        const auto row = interpolatory_sqrt3::ring_weights(n);
        EXPECT_EQ(matrix.begin_of_row(point + 1) - matrix.begin_of_row(point), n + 1);
        EXPECT_DOUBLE_EQ(weight(c.v()), interpolatory_sqrt3::center_weight(n));
        EXPECT_DOUBLE_EQ(weight(c.prev().v()), row[0]);
        EXPECT_DOUBLE_EQ(weight(c.next().v()), row[n - 1]);
        EXPECT_DOUBLE_EQ(weight(c.prev().across().prev().v()), row[1]);
        EXPECT_DOUBLE_EQ(weight(c.across().prev().v()), row[n - 2]);
    }
    EXPECT_GT(rings, 10);
}

TEST(interpolatory_sqrt3, rings_are_symmetric_and_sum_to_one)
{
    for (std::size_t n = 3; n < 30; ++n) {
        const auto row = interpolatory_sqrt3::ring_weights(n);
        EXPECT_EQ(row.size(), n);
        EXPECT_NEAR(std::accumulate(row.begin(), row.end(), interpolatory_sqrt3::center_weight(n)), 1, 1e-15);
        for (std::size_t j = 0; j < n; ++j)
            EXPECT_NEAR(row[j], row[n - 1 - j], 1e-15);
    }
}

TEST(interpolatory_sqrt3, refuses_a_boundary)
{
    EXPECT_EQ(
        error_text<kith::mesh_error>([] { kith::refine(native(shapes::umbrella(5)), interpolatory_sqrt3(), 1); }),
        "interpolatory-sqrt3: edge 5 between vertices 1 and 2 is a boundary edge; close the mesh first, or take a "
        "scheme with a boundary rule");
}

TEST(interpolatory_sqrt3, is_in_openmesh_too)
{
    EXPECT_NO_THROW(kith::like<interpolatory_sqrt3>(kith::library::openmesh));
    EXPECT_THROW(kith::like<interpolatory_sqrt3>(kith::library::cgal), kith::mesh_error);
}

TEST(interpolatory_sqrt3, refuses_an_inner_vertex_between_two_faces)
{
    const shapes::shape pillow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::refine(native(pillow), interpolatory_sqrt3(), 1); }),
              "interpolatory-sqrt3: vertex 0 lies between 2 faces only, the scheme needs three; remove these "
              "triangles, which are back to back, or put a vertex into one of them");
}
