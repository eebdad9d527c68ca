// SPDX-License-Identifier: BSD-3-Clause
// Computes the lowest eigenvalues of the Laplace-Beltrami operator on a limit surface of Catmull-Clark through the unit
// sphere, which has l(l+1) with multiplicity 2l+1. LOBPCG (Knyazev 2001) is preconditioned by a V-cycle of multigrid,
// whose prolongations are the scheme's matrices. On finer levels the number of iterations stays and the error falls.
// Sample run: surface_eigenvalues [finest level]

#include "limit_interpolation.hpp"
#include "v_cycle.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/eigen.hpp>
#include <kith/hierarchy.hpp>
#include <kith/surface/quadrature.hpp>
#include <kith/surface/surface_locator.hpp>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

namespace {

using mesh = kith::basic_mesh<>;
using matrix = multigrid::matrix;
using vector = Eigen::VectorXd;
using columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

mesh cube()
{
    std::vector<std::array<double, 3>> points;
    for (int i = 0; i < 8; ++i)
        points.push_back({double(i & 1) - .5, double(i >> 1 & 1) - .5, double(i >> 2) - .5});
    const std::vector<std::array<int, 4>> faces{
        {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return kith::make_mesh(points, faces);
}

/// The integrals of products of basis functions, and of their gradients, over the limit surface.
struct discretisation {
    matrix stiffness, mass;
};
discretisation discretise(kith::surface_locator<kith::catmull_clark>& surface,
                          const std::vector<std::array<double, 3>>& control, const kith::surface_quadrature& quadrature)
{
    const auto located = surface.locate(quadrature.places);
    const auto at = located.evaluate(control, kith::derivatives::first);
    const auto weights = located.weights(kith::derivatives::first);
    const auto as_matrix = [&](std::span<const kith::stencil_row> rows) {
        const auto made = kith::make_matrix(rows, control.size());
        return matrix(kith::as_eigen(made));
    };
    const matrix n = as_matrix(weights.points), n_u = as_matrix(weights.du), n_v = as_matrix(weights.dv);
    vector areas(n.rows()), uu(n.rows()), uv(n.rows()), vv(n.rows()); // the contravariant metric times the area
    for (Eigen::Index i = 0; i < n.rows(); ++i) {
        const auto k = std::size_t(i);
        const Eigen::Vector3d du(at.du[k].data()), dv(at.dv[k].data());
        const double jacobian = du.cross(dv).norm();
        areas[i] = quadrature.weights[k] * jacobian;
        const double factor = quadrature.weights[k] / jacobian;
        uu[i] = factor * dv.squaredNorm();
        uv[i] = -factor * du.dot(dv);
        vv[i] = factor * du.squaredNorm();
    }
    const auto product = [](const matrix& left, const vector& factors, const matrix& right) {
        return matrix(left.transpose() * matrix(factors.asDiagonal() * right));
    };
    const matrix mixed = product(n_u, uv, n_v);
    return {product(n_u, uu, n_u) + product(n_v, vv, n_v) + mixed + matrix(mixed.transpose()), product(n, areas, n)};
}

struct eigenpairs {
    vector values;
    columns vectors;
};
/// Returns the lowest eigenpairs within the space that the columns of a matrix span.
eigenpairs rayleigh_ritz(const columns& space, const discretisation& d, Eigen::Index count)
{
    // First makes an orthonormal basis of the space, without directions that nearly depend on others.
    const vector scales = space.colwise().norm().cwiseInverse();
    const columns scaled = space * scales.asDiagonal();
    const columns by_mass = d.mass * scaled;
    const Eigen::MatrixXd gram = scaled.transpose() * by_mass;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(gram);
    Eigen::Index dropped = 0;
    while (axes.eigenvalues()[dropped] < 1e-12 * axes.eigenvalues()[gram.rows() - 1])
        ++dropped;
    const Eigen::Index kept = gram.rows() - dropped;
    const Eigen::MatrixXd to_basis = axes.eigenvectors().rightCols(kept) *
                                     axes.eigenvalues().tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
    const columns basis = scaled * to_basis;
    const columns by_stiffness = d.stiffness * basis;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> pairs(basis.transpose() * by_stiffness);
    return {pairs.eigenvalues().head(count), basis * pairs.eigenvectors().leftCols(count)};
}

struct spectrum {
    vector values;
    int iterations = 0;
};
/// Finds the lowest eigenvalues. Each step takes the best vectors in the span of the current vectors, their
/// preconditioned residuals and their last change.
spectrum lowest_eigenvalues(const discretisation& d, const std::vector<matrix>& prolongations, Eigen::Index count)
{
    const multigrid preconditioner(d.stiffness, prolongations);
    const Eigen::Index rows = d.stiffness.rows(), block = count + 4; // more columns, as the last converge late
    columns start(rows, block);
    for (Eigen::Index i = 0; i < rows; ++i) // start vectors without structure
        for (Eigen::Index j = 0; j < block; ++j)
            start(i, j) = std::sin(double((i + 1) * (j + 2)) * 1.6180339887);
    eigenpairs best = rayleigh_ritz(start, d, block);
    columns change(rows, 0);
    for (spectrum result;; ++result.iterations) {
        const columns residuals = d.stiffness * best.vectors - d.mass * best.vectors * best.values.asDiagonal();
        const double error = residuals.leftCols(count).norm() / (d.stiffness * best.vectors).norm();
        if (error < 1e-9 or result.iterations == 100) {
            result.values = best.values.head(count);
            return result;
        }
        columns corrections = columns::Zero(rows, block);
        preconditioner.cycle(corrections, residuals);
        columns space(rows, 2 * block + change.cols());
        space << best.vectors, corrections, change;
        eigenpairs next = rayleigh_ritz(space, d, block);
        const columns by_mass = d.mass * next.vectors;
        const Eigen::MatrixXd common = best.vectors.transpose() * by_mass;
        change = next.vectors - best.vectors * common;
        best = std::move(next);
    }
}

} // namespace

int main(int count, char** words)
{
    const int finest = count > 1 ? std::atoi(words[1]) : 5;
    Eigen::setNbThreads(1);    // the dense matrices are small
    constexpr int degrees = 4; // l = 0, ..., 3
    kith::hierarchy<mesh, kith::catmull_clark> levels(cube());
    levels.refine(finest);
    std::vector<matrix> prolongations;
    std::vector<double> errors;
    std::vector<int> iterations;
    std::printf("level  vertices  iterations  largest relative errors for l = 1, 2, 3\n");
    for (int level = 1; level <= finest; ++level) {
        const auto p = levels.matrix(level - 1, level);
        prolongations.emplace_back(kith::as_eigen(p));
        if (level < 2)
            continue;
        mesh sphere = levels[level];
        for (auto& [x, y, z] : sphere.points()) {
            const double radius = std::hypot(x, y, z);
            x /= radius, y /= radius, z /= radius;
        }
        kith::surface_locator surface(sphere, kith::catmull_clark());
        const auto limits = surface.locate(places_of_vertices(sphere)).weights().points;
        const auto quadrature = kith::quadrature_places(sphere, kith::catmull_clark(), 3);
        const auto d = discretise(surface, interpolating_control_points(sphere, limits), quadrature);
        const auto found = lowest_eigenvalues(d, prolongations, degrees * degrees);
        iterations.push_back(found.iterations);
        errors.push_back(0);
        std::printf("%5d %9zu %11d ", level, sphere.vertex_count(), found.iterations);
        for (int l = 1; l < degrees; ++l) {
            double error = 0;
            for (Eigen::Index k = l * l; k < (l + 1) * (l + 1); ++k)
                error = std::fmax(error, std::abs(found.values[k] / (l * (l + 1)) - 1));
            errors.back() = std::fmax(errors.back(), error);
            std::printf(" %.1e", error);
        }
        std::printf("\n");
    }
    for (std::size_t i = 0; i < errors.size(); ++i)
        if (iterations[i] > 20 or (i > 0 and errors[i] > errors[i - 1] / 4))
            return 1;
}
