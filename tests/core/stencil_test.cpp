// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/mask/stencil.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/regular_masks.hpp"
#include "support/thread_count.hpp"

#include <gtest/gtest.h>

#include <vector>

using kith::hierarchy;
using kith::stencil_row;

TEST(stencil, rows_are_added_entry_by_entry)
{
    stencil_row total{{{1, 0.5}, {4, 0.25}}};
    kith::affine<stencil_row>::add(total, {{{0, 1}, {4, 0.5}, {7, 2}}});
    EXPECT_EQ(total, (stencil_row{{{0, 1}, {1, 0.5}, {4, 0.75}, {7, 2}}}));
    kith::affine<stencil_row>::scale(total, 2);
    EXPECT_EQ(total, (stencil_row{{{0, 2}, {1, 1}, {4, 1.5}, {7, 4}}}));
}

TEST(stencil, every_row_sums_to_one)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        hierarchy levels(mesh, scheme);
        levels.refine(2);
        const auto matrix = levels.matrix(0, 2);
        EXPECT_EQ(matrix.rows(), levels[2].vertex_count());
        const std::vector<double> ones(mesh.vertex_count(), 1);
        for (const double sum : matrix.apply(std::span(ones)))
            EXPECT_NEAR(sum, 1, 1e-14);
    });
}

TEST(stencil, rows_times_points_are_the_points)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        hierarchy levels(mesh, scheme);
        levels.refine(2);
        const auto points = levels.matrix(0, 2).apply(mesh.points());
        for (std::size_t v = 0; v < points.size(); ++v)
            for (std::size_t i = 0; i < 3; ++i)
                ASSERT_NEAR(points[v][i], levels[2].point(v)[i], 2e-14);
    });
}

TEST(stencil, several_threads_carry_the_same_bits_as_one)
{
    hierarchy levels(native(shapes::shaken(shapes::torus(16, 24))), kith::catmull_clark());
    levels.refine(2);
    const auto matrix = levels.matrix(0, 2);
    ASSERT_GT(matrix.rows(), 4096U); // enough rows for several threads
    const auto with_threads = [&](int count) {
        const thread_count threads(count);
        return matrix.apply(levels[0].points());
    };
    const auto points = with_threads(1);
    for (const int count : {2, 3, 7})
        EXPECT_EQ(with_threads(count), points);
    const auto& last = levels[2].points();
    for (std::size_t v = 0; v < points.size(); ++v)
        for (std::size_t i = 0; i < 3; ++i)
            ASSERT_NEAR(points[v][i], last[v][i], 2e-14);
}

TEST(stencil, rows_without_entries_give_nothing_and_all_entries_are_listed)
{
    kith::storage<stencil_row> rows(3);
    rows[1].entries = {{0, 0.5}, {2, 0.25}};
    const auto matrix = kith::make_matrix(rows, 3);
    const std::vector<double> values{2, 3, 4};
    EXPECT_EQ(matrix.apply(std::span(values)), (std::vector<double>{0, 2, 0}));
    EXPECT_EQ(matrix.triplets(), (std::vector<kith::matrix_entry>{{1, 0, 0.5}, {1, 2, 0.25}}));
}

TEST(stencil, takes_what_it_gives_and_refuses_other_numbers_of_values)
{
    hierarchy levels(native(shapes::house()), kith::catmull_clark());
    levels.refine(2);
    const std::vector<double> values(levels[0].vertex_count(), 2.5);
    const std::vector<double> last = levels.matrix(1, 2).apply(levels.matrix(0, 1).apply(values));
    EXPECT_EQ(last.size(), levels[2].vertex_count());
    for (const double x : last)
        EXPECT_NEAR(x, 2.5, 1e-14);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(levels.matrix(1, 2).apply(values)); }),
              "a subdivision matrix over " + std::to_string(levels[1].vertex_count()) + " elements was given " +
                  std::to_string(values.size()) + " values; give it one for each");
}

TEST(stencil, two_steps_are_one_after_the_other)
{
    hierarchy levels(native(shapes::shaken(shapes::open_house())), kith::doo_sabin());
    levels.refine(2);
    const auto mesh = levels[0].points();
    const auto once = levels.matrix(0, 1).apply(mesh);
    const auto twice = levels.matrix(1, 2).apply(std::span(once));
    const auto at_once = levels.matrix(0, 2).apply(mesh);
    for (std::size_t v = 0; v < twice.size(); ++v)
        EXPECT_NEAR(twice[v][0], at_once[v][0], 1e-14);
}

TEST(stencil, transposing_exchanges_rows_and_columns)
{
    hierarchy levels(native(shapes::house()), kith::catmull_clark());
    levels.refine();
    const auto matrix = levels.matrix(0, 1), transposed = matrix.transposed(), back = transposed.transposed();
    EXPECT_EQ(transposed.rows(), 11U);
    EXPECT_EQ(transposed.columns, 42U);
    EXPECT_EQ(back.row_start, matrix.row_start);
    EXPECT_EQ(back.column, matrix.column);
    EXPECT_EQ(back.weight, matrix.weight);
    std::vector<double> first(42, 0); // the entries of column 3, from the transposed matrix
    for (std::size_t k = transposed.begin_of_row(3); k < transposed.begin_of_row(4); ++k)
        first[std::size_t(transposed.column[k])] = transposed.weight[k];
    for (std::size_t i = 0; i < 42; ++i)
        for (std::size_t k = matrix.begin_of_row(i); k < matrix.begin_of_row(i + 1); ++k)
            if (matrix.column[k] == 3) {
                EXPECT_EQ(matrix.weight[k], first[i]);
            }
}

TEST(stencil, catmull_clark_is_the_bicubic_b_spline)
{
    const kith::catmull_clark scheme;
    expect_weights(weights_of(regular_quads, scheme, vertex_handle{0}),
                   {9. / 16, 3. / 32, 3. / 32, 3. / 32, 3. / 32, 1. / 64, 1. / 64, 1. / 64, 1. / 64});
    expect_weights(weights_of(regular_quads, scheme, edge_handle{0}),
                   {3. / 8, 3. / 8, 1. / 16, 1. / 16, 1. / 16, 1. / 16});
    expect_weights(weights_of(regular_quads, scheme, face_handle{0}), {1. / 4, 1. / 4, 1. / 4, 1. / 4});
}

TEST(stencil, catmull_clark_is_the_cubic_b_spline_on_the_boundary)
{
    expect_weights(weights_of(shapes::grid(), kith::catmull_clark(), vertex_handle{1}), {3. / 4, 1. / 8, 1. / 8});
    expect_weights(weights_of(shapes::grid(), kith::catmull_clark(), edge_handle{0}), {1. / 2, 1. / 2});
    expect_weights(weights_of(shapes::grid(), kith::catmull_clark(), vertex_handle{0}), {1});
}

TEST(stencil, doo_sabin_is_the_biquadratic_b_spline)
{
    expect_weights(weights_of(regular_quads, kith::doo_sabin(), vertex_handle{0}, face_handle{0}),
                   {9. / 16, 3. / 16, 3. / 16, 1. / 16});
}

TEST(stencil, loop_is_the_quartic_box_spline)
{
    expect_weights(weights_of(regular_triangles, kith::loop(), vertex_handle{0}),
                   {5. / 8, 1. / 16, 1. / 16, 1. / 16, 1. / 16, 1. / 16, 1. / 16});
    expect_weights(weights_of(regular_triangles, kith::loop(), edge_handle{0}), {3. / 8, 3. / 8, 1. / 8, 1. / 8});
}

TEST(stencil, sqrt3_takes_two_thirds_of_a_regular_vertex)
{
    expect_weights(weights_of(regular_triangles, kith::sqrt3(), vertex_handle{0}),
                   {2. / 3, 1. / 18, 1. / 18, 1. / 18, 1. / 18, 1. / 18, 1. / 18});
    expect_weights(weights_of(regular_triangles, kith::sqrt3(), face_handle{0}), {1. / 3, 1. / 3, 1. / 3});
}

TEST(stencil, matrices_on_faces_send_values_down_and_sum_them_up)
{
    for_each_of_all_schemes_and_shape([]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        hierarchy levels(mesh, scheme);
        levels.refine(2);
        const auto matrix = levels.template matrix<kith::field_on::faces>(0, 2, kith::from_parent());
        ASSERT_EQ(matrix.rows(), levels[2].face_count());
        ASSERT_EQ(matrix.columns, mesh.face_count());
        std::vector<double> heirs(mesh.face_count());
        for (const auto f : levels.elements(2).faces()) {
            const auto parent = levels.ancestor(2, f.handle(), 1).f; // Doo-Sabin's faces of edges have none
            const auto from = parent ? levels.ancestor(1, *parent, 0).f : parent;
            ASSERT_EQ(matrix.row_start[f.index() + 1] - matrix.row_start[f.index()], from ? 1 : 0);
            if (from) {
                EXPECT_EQ(matrix.column[matrix.begin_of_row(f.index())], std::ptrdiff_t(from->value));
                ++heirs[from->value];
            }
        }
        const std::vector<double> ones(matrix.rows(), 1);
        EXPECT_EQ(matrix.transposed().apply(std::span(ones)), heirs);
    });
}

TEST(stencil, matrices_on_corners_and_edges_are_those_of_their_fields)
{
    const auto mesh = native(shapes::open_house());
    hierarchy levels(mesh, kith::catmull_clark());
    levels.refine(2);
    std::vector<double> values(mesh.corner_count());
    for (std::size_t c = 0; c < values.size(); ++c)
        values[c] = double(c * c % 7);
    const auto on_corners = levels.matrix<kith::field_on::corners>(0, 2, kith::linear_in_faces());
    const auto expected = levels.carry(0, 2, kith::on_corners(values));
    const auto made = on_corners.apply(std::span<const double>(values));
    ASSERT_EQ(made.size(), expected.size());
    for (std::size_t c = 0; c < made.size(); ++c)
        EXPECT_NEAR(made[c], expected[c], 1e-14);

    // A length: each of the two parts of an edge gets a half.
    const auto half = [](stencil_row row) {
        kith::affine<stencil_row>::scale(row, .5);
        return row;
    };
    const auto on_edges = levels.matrix<kith::field_on::edges>(0, 2, kith::along_edges{half});
    for (const auto e : levels.elements(2).edges()) {
        const auto from = levels.ancestor(2, e.handle(), 0);
        const auto begin = on_edges.begin_of_row(e.index()), end = on_edges.begin_of_row(e.index() + 1);
        ASSERT_EQ(end - begin, from.e ? 1U : 0U);
        if (from.e) {
            EXPECT_EQ(on_edges.column[begin], std::ptrdiff_t(from.e->value));
            EXPECT_EQ(on_edges.weight[begin], .25);
        }
    }
}
