// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../limit_interpolation.hpp"
#include "kirchhoff_love.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

namespace thin_shells {

struct point_load {
    point at, force;
};

/// A shell with its supports and loads. Vertices are points of the middle surface. Faces may extend beyond the shell:
/// such ghost faces carry control points, so that the basis is complete up to a free edge.
struct shell_problem {
    mesh surface;
    material of;
    std::array<bool, 3> is_mirrored{}; ///< the mirror planes x = 0, y = 0, z = 0
    /// Returns true if a face with this centre belongs to the shell.
    std::function<bool(const point&)> is_inside;
    /// Returns which of the displacements x, y, z a support prevents at a point.
    std::function<std::array<bool, 3>(const point&)> held;
    double gravity = 0; ///< the load per area, downwards
    std::vector<point_load> loads{};
    point_load probe; ///< `force` is a direction; the result is the displacement along it
    double reference; ///< the displacement in the literature
};

struct shell_solution {
    double displacement; ///< of the probe
    std::ptrdiff_t unknowns;
};

/// A solver of shell problems with the basis functions of a scheme.
class shell_solver {
public:
    template <class Scheme>
    shell_solver(const shell_problem& problem, const Scheme& scheme)
        : problem_(problem)
        , locate_([surface = std::make_shared<kith::surface_locator<Scheme>>(problem.surface, scheme)](
                      const std::vector<kith::surface_place>& places) { return surface->locate(places); })
        , centres_(kith::quadrature_places(problem.surface, scheme, 1).places)
        , quadrature_(kith::quadrature_places(problem.surface, scheme, 2))
        , limits_(locate_(places_of_vertices(problem.surface)).weights().points)
        , control_(interpolating_control_points(problem.surface, limits_))
    {
    }

    /// Returns the solution. Errors: std::runtime_error if the supports leave the shell movable.
    [[nodiscard]] shell_solution solve() const
    {
        const auto shell = shell_places();
        const auto [elasticity, areas] = integrate(locate_(shell.places), control_, shell, problem_.of);
        const matrix stiffness = elasticity + support_stiffness(shell);
        vector load = vector::Zero(stiffness.rows());
        for (Eigen::Index v = 0; v < areas.size(); ++v)
            load[3 * v + 2] = -problem_.gravity * areas[v];
        for (const point_load& one : problem_.loads)
            load += at_vertex(one);
        const matrix unknowns = unknowns_of(stiffness);
        const Eigen::SimplicialLDLT<matrix> factors(unknowns.transpose() * stiffness * unknowns);
        if (factors.info() != Eigen::Success)
            throw std::runtime_error("the stiffness matrix is singular; the shell needs more supports");
        const vector displacements = unknowns * factors.solve(unknowns.transpose() * load);
        return {at_vertex(problem_.probe).dot(displacements), unknowns.cols()};
    }

private:
    /// Returns the side of a mirror plane: -1, 0 (on the plane) or 1.
    static int side_of(double coordinate) { return (coordinate > 1e-6) - (coordinate < -1e-6); }

    /// Returns the places on faces of the shell on the positive sides of the mirrors. Their weights count all images;
    /// a face that a mirror halves counts half.
    [[nodiscard]] kith::surface_quadrature shell_places() const
    {
        const auto centres = locate_(centres_).evaluate(control_).points;
        kith::surface_quadrature result;
        for (std::size_t i = 0; i < quadrature_.places.size(); ++i) {
            const point& centre = centres[quadrature_.places[i].face];
            double images = problem_.is_inside(centre) ? 1 : 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                images *= problem_.is_mirrored[axis] ? 1 + side_of(centre[axis]) : 1;
            if (images > 0) {
                result.places.push_back(quadrature_.places[i]);
                result.weights.push_back(images * quadrature_.weights[i]);
            }
        }
        return result;
    }

    /// Returns stiff springs at the held vertices of the shell. Springs between vertices are not needed; with Loop's
    /// scheme they would also hold faces beside the supported curve.
    [[nodiscard]] matrix support_stiffness(const kith::surface_quadrature& shell) const
    {
        std::vector<bool> is_of_shell(control_.size(), false);
        for (const kith::surface_place& place : shell.places)
            for (const auto v : problem_.surface.face(place.face))
                is_of_shell[v] = true;
        std::vector<Eigen::Triplet<double>> entries;
        for (std::size_t v = 0; v < control_.size(); ++v) {
            const auto is_held = problem_.held(problem_.surface.point(v));
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (is_of_shell[v] and is_held[axis])
                    for (const auto& [column, weight] : limits_[v].entries)
                        entries.emplace_back(3 * v + axis, 3 * column + axis, weight);
        }
        const auto size = 3 * Eigen::Index(control_.size());
        matrix springs(size, size);
        springs.setFromTriplets(entries.begin(), entries.end());
        return 1e4 * problem_.of.young * problem_.of.thickness * matrix(springs.transpose() * springs);
    }

    /// Returns the matrix from unknowns to displacements of control points. Displacements of mirror images are equal or
    /// opposite, and zero where neither the point nor an image has a stiffness.
    [[nodiscard]] matrix unknowns_of(const matrix& stiffness) const
    {
        const vector diagonal = stiffness.diagonal();
        const auto image = [&](Eigen::Index k) { // the axis, and the rounded place of the positive image
            const point& at = problem_.surface.point(std::size_t(k / 3));
            std::array<long, 4> key{k % 3};
            for (std::size_t a = 0; a < 3; ++a)
                key[a + 1] = std::lround(1e6 * (problem_.is_mirrored[a] ? std::abs(at[a]) : at[a]));
            return key;
        };
        const auto sign_of = [&](Eigen::Index k) {
            const auto axis = std::size_t(k % 3);
            return problem_.is_mirrored[axis] ? side_of(problem_.surface.point(std::size_t(k / 3))[axis]) : 1;
        };
        std::map<std::array<long, 4>, Eigen::Index> numbers;
        for (Eigen::Index k = 0; k < diagonal.size(); ++k)
            if (diagonal[k] != 0 and sign_of(k) != 0)
                numbers.try_emplace(image(k), Eigen::Index(numbers.size()));
        std::vector<Eigen::Triplet<double>> entries;
        for (Eigen::Index k = 0; k < diagonal.size(); ++k)
            if (const auto number = numbers.find(image(k)); number != numbers.end())
                entries.emplace_back(k, number->second, sign_of(k));
        matrix result(diagonal.size(), Eigen::Index(numbers.size()));
        result.setFromTriplets(entries.begin(), entries.end());
        return result;
    }

    /// Returns the weights of the control points' displacements in the work of a force at a vertex.
    [[nodiscard]] vector at_vertex(const point_load& load) const
    {
        const auto distance = [&](std::size_t v) {
            const point& p = problem_.surface.point(v);
            return std::hypot(p[0] - load.at[0], p[1] - load.at[1], p[2] - load.at[2]);
        };
        std::size_t nearest = 0;
        for (std::size_t v = 1; v < control_.size(); ++v)
            nearest = distance(v) < distance(nearest) ? v : nearest;
        vector result = vector::Zero(3 * Eigen::Index(control_.size()));
        for (const auto& [v, weight] : limits_[nearest].entries)
            for (std::size_t axis = 0; axis < 3; ++axis)
                result[Eigen::Index(3 * v + axis)] = weight * load.force[axis];
        return result;
    }

    const shell_problem& problem_;
    std::function<kith::located_places(const std::vector<kith::surface_place>&)> locate_;
    std::vector<kith::surface_place> centres_; ///< of the faces
    kith::surface_quadrature quadrature_;      ///< over all faces
    kith::storage<kith::stencil_row> limits_;  ///< of the vertices
    std::vector<point> control_;
};

} // namespace thin_shells
