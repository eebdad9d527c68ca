// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limits/limit_matrix.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>

namespace {

/// Expects that the limit matrix maps the points of level `from` to the limits of level `to`.
template <class Scheme>
void expect_limits(const mesh3d& mesh, const Scheme& scheme, int from, int to)
{
    kith::hierarchy levels(mesh, scheme);
    levels.refine(to);
    const auto matrix = kith::limit_matrix_of(levels, from, to);
    const auto limits = limit_surface_of(levels, to);
    ASSERT_EQ(matrix.columns, levels[from].vertex_count());
    ASSERT_EQ(matrix.rows(), levels[to].vertex_count());
    const auto points = matrix.apply(levels[from].points());
    for (std::size_t v = 0; v < points.size(); ++v)
        for (std::size_t axis = 0; axis < 3; ++axis)
            ASSERT_NEAR(points[v][axis], limits.positions[v][axis], 1e-12) << v;
}

} // namespace

TEST(limit_matrix, takes_points_to_their_limits)
{
    for_each_of_all_schemes_and_shape([]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        expect_limits(mesh, scheme, 0, 0);
        if (mesh.face_count() <= 12)
            expect_limits(mesh, scheme, 0, 1);
    });
}

TEST(limit_matrix, has_weights_that_do_not_depend_on_the_points)
{
    const auto mesh = native(shapes::shaken(shapes::house()));
    kith::hierarchy levels(mesh, kith::catmull_clark());
    levels.refine(1);
    const auto matrix = kith::limit_matrix_of(levels, 0, 1);
    auto moved = mesh;
    for (auto& p : moved.points())
        p = {p[2] * p[2], p[0] - 7, std::sin(p[1])};
    levels.move_points(0, std::as_const(moved).points());
    const auto limits = limit_surface_of(levels, 1);
    const auto points = matrix.apply(std::as_const(moved).points());
    for (std::size_t v = 0; v < points.size(); ++v)
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(points[v][axis], limits.positions[v][axis], 1e-13);
}

TEST(limit_matrix, refuses_levels_in_the_wrong_order)
{
    kith::hierarchy levels(native(shapes::cube()), kith::catmull_clark());
    levels.refine(1);
    EXPECT_THROW(static_cast<void>(kith::limit_matrix_of(levels, 1, 0)), kith::mesh_error);
    EXPECT_THROW(static_cast<void>(kith::limit_matrix_of(levels, 0, 2)), kith::mesh_error);
}
