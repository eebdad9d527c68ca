// SPDX-License-Identifier: BSD-3-Clause
#include <kith/catmull_clark.hpp>
#include <kith/eigen.hpp>
#include <kith/eigen_mesh.hpp>
#include <kith/hierarchy.hpp>
#include <kith/igl.hpp>

#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"

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

namespace {

Eigen::MatrixXd points_of(const shapes::shape& s)
{
    Eigen::MatrixXd result(Eigen::Index(s.points.size()), 3);
    for (std::size_t v = 0; v < s.points.size(); ++v)
        for (std::size_t axis = 0; axis < 3; ++axis)
            result(Eigen::Index(v), Eigen::Index(axis)) = s.points[v][axis];
    return result;
}

} // namespace

TEST(eigen, meshes_of_matrices_come_back)
{
    const auto shape = shapes::house(); // has triangles, quads and larger faces
    Eigen::MatrixXi faces = Eigen::MatrixXi::Constant(Eigen::Index(shape.faces.size()), 6, -1);
    for (std::size_t f = 0; f < shape.faces.size(); ++f)
        for (std::size_t c = 0; c < shape.faces[f].size(); ++c)
            faces(Eigen::Index(f), Eigen::Index(c)) = int(shape.faces[f][c]);
    const auto mesh = kith::mesh_of_matrices(points_of(shape), faces);
    EXPECT_TRUE(same_bits(mesh, native(shape)));
    EXPECT_EQ(kith::points_as_matrix(mesh), points_of(shape));
    const Eigen::MatrixXi back = kith::faces_as_matrix(mesh);
    EXPECT_EQ(back.cols(), 5); // the degree of the largest face
    EXPECT_TRUE(same_bits(kith::mesh_of_matrices(points_of(shape), back), mesh));
}

TEST(eigen, refuses_matrices_that_are_no_mesh)
{
    Eigen::MatrixXi faces(1, 3);
    faces << 0, 1, 9;
    EXPECT_THROW(kith::mesh_of_matrices(points_of(shapes::cube()), faces), kith::mesh_error);
    faces << 0, -1, 2; // a -1 inside a row does not make a shorter face
    EXPECT_THROW(kith::mesh_of_matrices(points_of(shapes::cube()), faces), kith::mesh_error);
    EXPECT_THROW(kith::mesh_of_matrices(Eigen::MatrixXd(Eigen::MatrixXd::Zero(8, 2)), faces), kith::mesh_error);
}

TEST(eigen, igl_users_find_their_functions)
{
    const auto shape = shapes::shaken(shapes::tetrahedron());
    Eigen::MatrixXi faces(Eigen::Index(shape.faces.size()), 3);
    for (std::size_t f = 0; f < shape.faces.size(); ++f)
        for (int c = 0; c < 3; ++c)
            faces(Eigen::Index(f), c) = int(shape.faces[f][std::size_t(c)]);
    Eigen::MatrixXd v = points_of(shape);
    Eigen::MatrixXi f = faces;
    kith::igl::loop(v, f, v, f, 2);
    const auto expected = kith::refine(native(shape), kith::like<kith::loop>(kith::library::libigl), 2);
    EXPECT_EQ(v, kith::points_as_matrix(expected));
    EXPECT_EQ(f, kith::faces_as_matrix(expected));
    kith::igl::upsample(points_of(shape), faces, v, f);
    EXPECT_EQ(f.rows(), 4 * faces.rows());
    EXPECT_EQ(v.topRows(4), points_of(shape)); // the scheme does not smooth
}

TEST(eigen, fixed_vectors_are_values_of_masks)
{
    EXPECT_TRUE(kith::affine_value<Eigen::Vector2f> and kith::affine_value<Eigen::RowVector3d>);
    EXPECT_FALSE(kith::affine_value<Eigen::VectorXd> or kith::affine_value<Eigen::Matrix3d>);
    kith::hierarchy levels(native(shapes::cube()), kith::catmull_clark());
    levels.refine(1);
    std::vector<Eigen::Vector2d> values(8, Eigen::Vector2d(0, 24));
    values[0] = {12, 0};
    const auto fine = levels.carry(0, 1, std::span<const Eigen::Vector2d>(values));
    EXPECT_LT((fine[0] - Eigen::Vector2d(5, 14)).norm(), 1e-13); // 5/12 of the first value
}
