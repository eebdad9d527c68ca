// SPDX-License-Identifier: BSD-3-Clause
#include <kith/catmull_clark.hpp>
#include <kith/eigen.hpp>
#include <kith/hierarchy.hpp>

#include "native_shape.hpp"

#include <gtest/gtest.h>

#include <span>
#include <vector>

TEST(eigen, sees_the_matrix_itself)
{
    kith::hierarchy levels(native(shapes::shaken(shapes::house())), kith::catmull_clark());
    levels.refine(2);
    const auto matrix = levels.matrix(0, 2);
    const auto seen = kith::as_eigen(matrix);
    EXPECT_EQ(seen.valuePtr(), matrix.weight.data());
    ASSERT_EQ(std::size_t(seen.rows()), levels[2].vertex_count());
    ASSERT_EQ(std::size_t(seen.cols()), levels[0].vertex_count());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Eigen::VectorXd coarse(seen.cols());
        for (Eigen::Index v = 0; v < coarse.size(); ++v)
            coarse[v] = levels[0].point(std::size_t(v))[axis];
        const Eigen::VectorXd fine = seen * coarse;
        for (Eigen::Index v = 0; v < fine.size(); ++v)
            EXPECT_NEAR(fine[v], levels[2].point(std::size_t(v))[axis], 1e-14);
    }
}

TEST(eigen, multiplies_matrices_level_by_level)
{
    kith::hierarchy levels(native(shapes::shaken(shapes::house())), kith::catmull_clark());
    levels.refine(2);
    const auto first = levels.matrix(0, 1), second = levels.matrix(1, 2), both = levels.matrix(0, 2);
    const Eigen::SparseMatrix<double, Eigen::RowMajor, std::ptrdiff_t> product = kith::as_eigen(second) *
                                                                                 kith::as_eigen(first);
    EXPECT_LT((product - kith::as_eigen(both)).norm(), 1e-14);
}
