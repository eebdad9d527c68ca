// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_shape.hpp"

#include <kith/spline/polynomial_lattice.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// Finds the polynomials of shapes. No scheme says that it is a spline: the surface over a face is a polynomial if the
/// one through some of its points agrees with the polynomials over the children of the face.
template <class Shape>
class shape_polynomials {
    using domain = typename Shape::domain;
    using sample = shape_sample<Shape>;

public:
    /// Looks for polynomials up to a degree.
    explicit shape_polynomials(std::size_t most_degree)
        : degree_(most_degree)
        , lattice_(most_degree, domain::is_tensor)
        , points_(lattice_points(domain::fineness * most_degree, domain::is_tensor))
    {
    }

    /// Decides shapes that lead to one another. All others that they lead to are decided.
    /// Cost: for each shape that of some hundred products of matrices and rows.
    void decide(std::span<Shape* const> shapes) const
    {
        std::vector<sample> samples;
        for (Shape* const here : shapes)
            for (std::size_t cell = 0; cell < here->polynomials.size(); ++cell)
                propose(*here, cell, samples);
        for (const sample& at : samples)
            if (auto& own = at.of->polynomials[at.cell]; own and not agrees_with_child(at))
                own.reset();
        bool has_changed = true;
        while (has_changed) {
            has_changed = false;
            for (const sample& at : samples)
                if (auto& own = at.of->polynomials[at.cell]; own and at.polynomial_of_child() == nullptr) {
                    own.reset();
                    has_changed = true;
                }
        }
        bool lead_to_polynomials = false;
        for (const Shape* const here : shapes) {
            for (const auto& own : here->polynomials)
                lead_to_polynomials = lead_to_polynomials or own != nullptr;
            for (const auto& child : here->children)
                lead_to_polynomials = lead_to_polynomials or (child.of != nullptr and child.of->leads_to_polynomials);
        }
        for (Shape* const here : shapes) {
            here->leads_to_polynomials = lead_to_polynomials;
            find_ends(*here);
        }
        for (Shape* const here : shapes)
            here->is_decided.store(true, std::memory_order_release);
    }

private:
    /// Adds the samples by which a cell is checked. Gives it the polynomial through its points, unless some child is
    /// known to have none.
    void propose(Shape& here, std::size_t cell, std::vector<sample>& samples) const
    {
        bool may_have_one = here.has_key;
        for (const auto& [s, t] : points_) {
            const sample& at = samples.emplace_back(here, cell, s, t);
            may_have_one = may_have_one and at.child_may_have_polynomial();
        }
        if (not may_have_one)
            return;
        const auto values = points_on(here, cell, lattice_);
        // Fewer points have smaller rounding errors.
        const std::size_t degree = lattice_.degree_through(values);
        const polynomial_lattice smaller(degree, domain::is_tensor);
        here.polynomials[cell] = std::make_unique<const surface_polynomial>(
            degree == degree_ ? lattice_.through(values) : smaller.through(points_on(here, cell, smaller)));
    }
    static std::vector<control_row> points_on(Shape& here, std::size_t cell, const polynomial_lattice& lattice)
    {
        std::vector<control_row> result;
        for (const auto& [s, t] : lattice.points())
            result.push_back(limit_at({here, cell, s, t}, 0));
        return result;
    }
    /// Returns the point of the surface at a sample, by steps until there is a polynomial.
    static control_row limit_at(const sample& at, int depth)
    {
        const auto& child = at.child();
        if (child.of == nullptr) // the cell is no polynomial
            return corner_row(*at.of, 0);
        if (child.of->is_decided and at.polynomial_of_child() != nullptr)
            return composed(at.polynomial_of_child()->at(at.in_child.s, at.in_child.t), child.rows);
        if (depth == domain::most_steps or child.of->children.empty())
            return composed(corner_row(*child.of, 0), child.rows);
        return composed(limit_at({*child.of, at.next.cell, at.in_child.s, at.in_child.t}, depth + 1), child.rows);
    }
    static bool agrees_with_child(const sample& at)
    {
        const surface_polynomial* const of_child = at.polynomial_of_child();
        return of_child != nullptr and are_near(composed(of_child->at(at.in_child.s, at.in_child.t), at.child().rows),
                                                at.of->polynomials[at.cell]->at(at.s, at.t));
    }

    /// Returns true if the children at a corner of the face have polynomials.
    static bool has_polynomial_at(Shape& here, std::size_t corner)
    {
        bool result = true;
        for (std::size_t cell = 0; cell < here.polynomials.size(); ++cell)
            for (const auto& at : domain::corners)
                if (domain::corner_at(here.in_domain, cell, at) == corner)
                    result = result and sample(here, cell, at[0], at[1]).polynomial_of_child() != nullptr;
        return result;
    }
    /// Finds the limits where steps end: at the corners that have no polynomial, and everywhere after many steps.
    static void find_ends(Shape& here)
    {
        const std::span<const polynomial_pointer> own(here.polynomials);
        if (std::ranges::all_of(own, [](const auto& polynomial) { return polynomial != nullptr; }))
            return;
        if constexpr (Shape::has_points)
            if (here.in_domain.degree != domain::sides and not domain::has_vertices_at_corners(here.in_domain) and
                is_settled(here.scheme)) {
                here.at_corners[0] = limit_at_centre(here.mesh, here.scheme, here.face);
                here.has_corner_limits = here.at_corners[0] != nullptr;
            }
        std::vector<control_row> corners; // in the order of the lattice: (0, 0), (0, 1), (1, 0), (1, 1)
        for (const auto& [s, t] : lattice_points(1, domain::is_tensor)) {
            const auto k = std::size_t(std::ranges::find(domain::corners, std::array{s, t}) - domain::corners.begin());
            corners.push_back(corner_row(here, std::min(k, here.in_domain.degree - 1)));
            if constexpr (Shape::has_points) // of the masks of limits
                if (here.in_domain.degree == domain::sides and domain::has_vertices_at_corners(here.in_domain) and
                    is_settled(here.scheme))
                    if (auto limit = limit_at_vertex(here.mesh, here.scheme, here.mesh.face(here.face)[k])) {
                        corners.back() = limit->at(0, 0);
                        // The child at a regular corner is a polynomial, which has derivatives.
                        const bool is_needed = here.leads_to_polynomials or not here.has_key;
                        if (is_needed and not has_polynomial_at(here, k)) {
                            here.at_corners[k] = std::move(limit);
                            here.has_corner_limits = true;
                        }
                    }
        }
        auto made = polynomial_lattice(1, domain::is_tensor).through(corners);
        made.derivatives = here.leads_to_polynomials ? 0 : 1;
        here.at_end = std::make_unique<const surface_polynomial>(std::move(made));
    }

    std::size_t degree_;
    polynomial_lattice lattice_;
    std::vector<std::array<double, 2>> points_; // by which cells are checked
};

} // namespace kith::detail
