// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limits/tangent_matrix.hpp>

#include "support/every_scheme.hpp"

#include <kith/limits/limit_surface.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace {

using vector = std::array<double, 3>;

vector unit_cross(const vector& a, const vector& b)
{
    vector n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    for (double& x : n)
        x /= length;
    return n;
}

bool has_row(const kith::subdivision_matrix& matrix, std::size_t i)
{
    return matrix.begin_of_row(i) != matrix.begin_of_row(i + 1);
}

/// Expects that the rows times the points give tangents with the normals of limit_normals, and that all vertices with a
/// normal have rows. Returns the number of compared normals.
template <class Scheme>
std::size_t expect_normals(const mesh3d& mesh, const Scheme& scheme, int from, int to)
{
    kith::hierarchy levels(mesh, scheme);
    levels.refine(to);
    const auto [first, second] = kith::tangent_matrices_of(levels, from, to);
    EXPECT_EQ(first.columns, levels[from].vertex_count());
    EXPECT_EQ(first.rows(), levels[to].vertex_count());
    const auto a = first.apply(levels[from].points()), b = second.apply(levels[from].points());
    const auto ones = std::vector<double>(first.columns, 1);
    const auto sums = first.apply(std::span(ones)), other_sums = second.apply(std::span(ones));
    const auto expected = kith::limit_normals(levels.elements(to), levels.scheme(to));
    std::size_t found = 0;
    for (std::size_t v = 0; v < expected.size(); ++v) {
        EXPECT_EQ(has_row(first, v), has_row(second, v));
        if (expected[v]) {
            EXPECT_TRUE(has_row(first, v));
        }
        if (not has_row(first, v))
            continue;
        EXPECT_NEAR(sums[v], 0, 1e-13);
        EXPECT_NEAR(other_sums[v], 0, 1e-13);
        if (not expected[v])
            continue; // the tangents of this mask are parallel here
        ++found;
        const vector n = unit_cross(a[v], b[v]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(n[axis], (*expected[v])[axis], 1e-9) << v;
    }
    return found;
}

} // namespace

TEST(tangent_matrix, spans_the_tangent_planes_of_the_limit_surface)
{
    std::size_t found = 0;
    for_each_of_all_schemes_and_shape([&]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        using level = kith::level_of<mesh3d>;
        if constexpr (kith::has_limit_tangents<Scheme, kith::vertex<level>, level>)
            if (mesh.face_count() < 40) {
                found += expect_normals(mesh, scheme, 0, 0);
                found += expect_normals(mesh, scheme, 0, 1);
            }
    });
    EXPECT_GT(found, 1000);
}

TEST(tangent_matrix, agrees_with_the_limit_surface_of_any_level)
{
    const auto mesh = native(shapes::shaken(shapes::torus(5, 7)));
    kith::hierarchy levels(mesh, kith::catmull_clark{});
    levels.refine(2);
    const auto [first, second] = kith::tangent_matrices_of(levels, 1, 2);
    const auto a = first.apply(levels[1].points()), b = second.apply(levels[1].points());
    const auto limits = limit_surface_of(levels, 2);
    for (std::size_t v = 0; v < a.size(); ++v) {
        const vector n = unit_cross(a[v], b[v]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(n[axis], limits.normals[v][axis], 1e-12);
    }
}

TEST(tangent_matrix, has_no_rows_where_no_mask_is_known)
{
    kith::catmull_clark scheme;
    scheme.sharpness.sharpen_edge(0, 1.5);
    const auto mesh = native(shapes::torus(4, 5));
    kith::hierarchy levels(mesh, scheme);
    const auto [first, second] = kith::tangent_matrices_of(levels, 0, 0);
    const kith::level_of<mesh3d> level(mesh);
    const auto e = level.edges()[0];
    for (std::size_t v = 0; v < first.rows(); ++v)
        EXPECT_EQ(has_row(first, v), v != e.org().index() and v != e.dst().index());
    EXPECT_THROW(static_cast<void>(kith::tangent_matrices_of(levels, 0, 1)), kith::mesh_error);
}
