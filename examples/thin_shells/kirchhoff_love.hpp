// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/surface/quadrature.hpp>
#include <kith/surface/surface_locator.hpp>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

/// Linear thin shells of Kirchhoff and Love whose middle surface is a limit surface (Cirak, Ortiz & Schröder 2000).
/// The unknowns are the displacements of the control points. There are no rotations, since the surface is smooth.
namespace thin_shells {

using mesh = kith::basic_mesh<>;
using point = std::array<double, 3>;
using vector = Eigen::VectorXd;
using matrix = Eigen::SparseMatrix<double>;
using strain_matrix = Eigen::Matrix<double, 6, Eigen::Dynamic>;

struct material {
    double young, poisson, thickness;
};

/// The derivatives of a surface, or of the weights of control points, at a place.
template <class T>
struct derivatives_at {
    T du, dv, duu, duv, dvv;
};

/// Returns the matrix from displacements (x, y, z of each control point) to strains. Rows 0 to 2 are membrane strains
/// (uu, vv, twice uv); rows 3 to 5 are changes of curvature (uu, vv, twice uv).
inline strain_matrix strain_rows(const derivatives_at<Eigen::Vector3d>& x, const derivatives_at<vector>& weights)
{
    const Eigen::Vector3d cross = x.du.cross(x.dv), normal = cross.normalized();
    strain_matrix rows(6, 3 * weights.du.size());
    const auto fill = [&](Eigen::Index i, auto block) {
        const double u = weights.du[i], v = weights.dv[i];
        // The curvature is the product of a second derivative and the normal, which rotates with du and dv.
        const auto curvature = [&](double second_weight, const Eigen::Vector3d& second) -> Eigen::Vector3d {
            const Eigen::Vector3d tangential = (second - normal * normal.dot(second)) / cross.norm();
            return second_weight * normal + u * x.dv.cross(tangential) + v * tangential.cross(x.du);
        };
        block.row(0) = u * x.du;
        block.row(1) = v * x.dv;
        block.row(2) = v * x.du + u * x.dv;
        block.row(3) = curvature(weights.duu[i], x.duu);
        block.row(4) = curvature(weights.dvv[i], x.dvv);
        block.row(5) = 2 * curvature(weights.duv[i], x.duv);
    };
    for (Eigen::Index i = 0; i < weights.du.size(); ++i)
        fill(i, rows.middleCols<3>(3 * i));
    return rows;
}

/// Returns the moduli of plane stress in the coordinates u and v, divided by Young's modulus.
inline Eigen::Matrix3d moduli(const derivatives_at<Eigen::Vector3d>& x, double poisson)
{
    const double e = x.du.squaredNorm(), f = x.du.dot(x.dv), g = x.dv.squaredNorm(), area = e * g - f * f;
    const std::array<std::array<double, 2>, 2> metric{{{g / area, -f / area}, {-f / area, e / area}}}; // contravariant
    constexpr std::array<std::array<std::size_t, 2>, 3> indices{{{0, 0}, {1, 1}, {0, 1}}};
    Eigen::Matrix3d result;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const auto [a, b] = indices[std::size_t(i)];
            const auto [c, d] = indices[std::size_t(j)];
            result(i, j) = poisson * metric[a][b] * metric[c][d] +
                           (1 - poisson) / 2 * (metric[a][c] * metric[b][d] + metric[a][d] * metric[b][c]);
        }
    return result / (1 - poisson * poisson);
}

/// The matrices of a shell over its control points.
struct shell_matrices {
    matrix stiffness; ///< of the displacements x, y, z of each control point in turn
    vector areas;     ///< the integral of each basis function
};

/// Integrates over a shell with these control points. `located` are the places of `quadrature`. Precondition: the
/// places of one face follow each other.
inline shell_matrices integrate(const kith::located_places& located, const std::vector<point>& control,
                                const kith::surface_quadrature& quadrature, const material& of)
{
    const auto& places = quadrature.places;
    const auto x = located.evaluate(control, kith::derivatives::second);
    const auto rows = located.weights(kith::derivatives::second);
    const auto count = Eigen::Index(control.size());
    std::vector<Eigen::Triplet<double>> entries;
    vector areas = vector::Zero(count);
    for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
        std::vector<std::size_t> around; // the control points of the face
        for (; end < places.size() and places[end].face == places[begin].face; ++end)
            for (const auto& [v, weight] : rows.points[end].entries)
                around.push_back(v);
        std::ranges::sort(around);
        around.erase(std::ranges::unique(around).begin(), around.end());
        const auto dense = [&](const kith::stencil_row& row) {
            vector result = vector::Zero(Eigen::Index(around.size()));
            for (const auto& [v, weight] : row.entries)
                result[std::ranges::lower_bound(around, v) - around.begin()] = weight;
            return result;
        };
        const auto size = 3 * Eigen::Index(around.size());
        Eigen::MatrixXd of_face = Eigen::MatrixXd::Zero(size, size);
        for (std::size_t i = begin; i < end; ++i) {
            const auto at = [i](const auto& points) { return Eigen::Vector3d(points[i].data()); };
            const derivatives_at<Eigen::Vector3d> surface_at{at(x.du), at(x.dv), at(x.duu), at(x.duv), at(x.dvv)};
            const strain_matrix strains = strain_rows(
                surface_at,
                {dense(rows.du[i]), dense(rows.dv[i]), dense(rows.duu[i]), dense(rows.duv[i]), dense(rows.dvv[i])});
            const double area = quadrature.weights[i] * surface_at.du.cross(surface_at.dv).norm();
            const Eigen::Matrix3d membrane = area * of.young * of.thickness * moduli(surface_at, of.poisson);
            const Eigen::Matrix3d bending = membrane * of.thickness * of.thickness / 12;
            of_face += strains.topRows<3>().transpose() * membrane * strains.topRows<3>();
            of_face += strains.bottomRows<3>().transpose() * bending * strains.bottomRows<3>();
            for (const auto& [v, weight] : rows.points[i].entries)
                areas[Eigen::Index(v)] += area * weight;
        }
        const auto number = [&](Eigen::Index k) { return 3 * Eigen::Index(around[std::size_t(k / 3)]) + k % 3; };
        for (Eigen::Index j = 0; j < size; ++j)
            for (Eigen::Index i = 0; i < size; ++i)
                entries.emplace_back(number(i), number(j), of_face(i, j));
    }
    matrix stiffness(3 * count, 3 * count);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    return {stiffness, areas};
}

} // namespace thin_shells
