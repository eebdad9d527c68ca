// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/core/mesh/make_mesh.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace kith {

/// Makes a mesh of matrices in the form of libigl: a row with three coordinates per point, and a row with its vertices
/// per face. The rows of faces with fewer corners end in negative numbers. Errors: mesh_error for points of other
/// dimensions, and those of make_mesh. Cost: as make_mesh.
template <class V, class F>
basic_mesh<std::array<typename V::Scalar, 3>> mesh_of_matrices(const Eigen::MatrixBase<V>& points,
                                                               const Eigen::MatrixBase<F>& faces)
{
    using point = std::array<typename V::Scalar, 3>;
    if (points.cols() != 3)
        throw mesh_error("the points have " + std::to_string(points.cols()) + " coordinates; give three columns");
    std::vector<point> list(std::size_t(points.rows()));
    for (Eigen::Index v = 0; v < points.rows(); ++v)
        list[std::size_t(v)] = {points(v, 0), points(v, 1), points(v, 2)};
    face_list corners;
    std::vector<std::size_t> face;
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
        Eigen::Index degree = faces.cols();
        while (degree > 0 and faces(f, degree - 1) < 0)
            --degree;
        face.clear();
        for (Eigen::Index c = 0; c < degree; ++c)
            face.push_back(std::size_t(faces(f, c))); // a negative number becomes one that is out of range
        corners.push_back(face);
    }
    return make_mesh(list, corners);
}

/// Returns the points of a mesh, one per row. Cost: O(vertices).
template <class Scalar, std::unsigned_integral Index>
Eigen::Matrix<Scalar, Eigen::Dynamic, 3> points_as_matrix(const basic_mesh<std::array<Scalar, 3>, Index>& mesh)
{
    using rows = Eigen::Matrix<Scalar, Eigen::Dynamic, 3, Eigen::RowMajor>;
    return Eigen::Map<const rows>(mesh.points().data()->data(), Eigen::Index(mesh.vertex_count()), 3);
}

/// Returns the vertices of each face of a mesh, one face per row. The rows of faces with fewer corners than others end
/// in -1. Errors: mesh_error for more vertices than an int can number. Cost: O(corners).
template <class Point, std::unsigned_integral Index>
Eigen::MatrixXi faces_as_matrix(const basic_mesh<Point, Index>& mesh)
{
    constexpr auto most = std::size_t(std::numeric_limits<int>::max());
    if (mesh.vertex_count() > most)
        throw mesh_error("a matrix of ints can number " + std::to_string(most) + " vertices, the mesh has " +
                         std::to_string(mesh.vertex_count()) + "; read its topology() instead");
    std::size_t degree = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        degree = std::max(degree, mesh.face(f).size());
    Eigen::MatrixXi result = Eigen::MatrixXi::Constant(Eigen::Index(mesh.face_count()), Eigen::Index(degree), -1);
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t c = 0; c < mesh.face(f).size(); ++c)
            result(Eigen::Index(f), Eigen::Index(c)) = int(mesh.face(f)[c]);
    return result;
}

} // namespace kith
