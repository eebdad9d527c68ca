// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limit_by_steps.hpp"
#include "surface_shape.hpp"

#include <kith/surface/spline/polynomial_lattice.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// The search for the polynomials of shapes. No scheme declares that it is a spline. The surface over a face is a
/// polynomial if a polynomial through some of its points agrees with those over the children of the face.
template <class Shape>
class shape_polynomials {
    using domain = typename Shape::domain;
    using sample = shape_sample<Shape>;

public:
    /// Takes the largest degree of polynomials that are searched for.
    explicit shape_polynomials(std::size_t most_degree)
        : degree_(most_degree)
        , lattice_(most_degree, domain::is_tensor)
        , points_(lattice_points(domain::fineness * most_degree, domain::is_tensor))
    {
    }

    /// Decides shapes that lead to one another. Precondition: all other shapes that they lead to are decided. Cost: for
    /// each shape that of some hundred products of matrices and rows.
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
            result.push_back(limit_at(sample(here, cell, s, t)).value_or(corner_row(here, 0)));
        return result;
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
    /// Returns the limit that masks give, if the shape has points and the state stays as it is.
    template <class LimitOf>
    static polynomial_pointer limit_by_masks([[maybe_unused]] const Shape& here, const LimitOf& limit_of)
    {
        if constexpr (Shape::has_points)
            if (is_settled(here.scheme))
                return limit_of(here);
        return {};
    }
    /// Finds the limits where steps end: at the corners that have no polynomial, and everywhere after many steps.
    static void find_ends(Shape& here)
    {
        const std::span<const polynomial_pointer> own(here.polynomials);
        if (std::ranges::all_of(own, [](const auto& polynomial) { return polynomial != nullptr; }))
            return;
        const domain_face& face = here.in_domain;
        const bool has_vertices = face.degree == domain::sides and domain::has_vertices_at_corners(face);
        const bool has_centre = face.degree != domain::sides and not domain::has_vertices_at_corners(face);
        if (has_centre)
            keep_limit(here, 0, limit_by_masks(here, [](const auto& of) {
                           return limit_at_centre(of.mesh, of.scheme, of.face);
                       }));
        std::vector<control_row> corners; // in the order of the lattice: (0, 0), (0, 1), (1, 0), (1, 1)
        for (const auto& [s, t] : lattice_points(1, domain::is_tensor)) {
            const auto k = std::size_t(std::ranges::find(domain::corners, std::array{s, t}) - domain::corners.begin());
            corners.push_back(corner_row(here, std::min(k, face.degree - 1)));
            if (not has_vertices)
                continue;
            auto limit = limit_by_masks(here, [k](const auto& of) {
                return limit_at_vertex(of.mesh, of.scheme, of.mesh.face(of.face)[k], of.face);
            });
            if (limit)
                corners.back() = limit->at(0, 0);
            // The child at a regular corner is a polynomial, which has derivatives.
            const bool is_needed = here.leads_to_polynomials or not here.has_key;
            if (is_needed and not has_polynomial_at(here, k))
                keep_limit(here, k, std::move(limit));
        }
        auto made = polynomial_lattice(1, domain::is_tensor).through(corners);
        made.derivatives = here.leads_to_polynomials ? 0 : 1;
        here.at_end = std::make_unique<const surface_polynomial>(std::move(made));
        if constexpr (not domain::has_polynomials_at_boundaries)
            find_walls(here);
    }

    /// Makes the linear functions that replace polynomials along a boundary, after many steps.
    static void find_walls(Shape& here)
    {
        bool touches_boundary = std::ranges::any_of(here.in_domain.is_wall, std::identity());
        for (std::size_t k = 0; k < here.in_domain.degree; ++k)
            touches_boundary = touches_boundary or corner_of_shape<Shape>(here, k).is_at_boundary();
        if (not touches_boundary)
            return;
        const polynomial_lattice lattice(1, domain::is_tensor);
        for (std::size_t cell = 0; cell < here.polynomials.size(); ++cell) {
            std::vector<control_row> corners;
            for (const auto& [s, t] : lattice.points())
                if (auto limit = limit_at(sample(here, cell, s, t)))
                    corners.push_back(std::move(*limit));
            if (here.polynomials[cell] or corners.size() < lattice.points().size())
                continue;
            auto made = lattice.through(corners);
            made.derivatives = 1;
            here.at_walls[cell] = std::make_unique<const surface_polynomial>(std::move(made));
        }
    }

    std::size_t degree_;
    polynomial_lattice lattice_;
    std::vector<std::array<double, 2>> points_; // the points by which cells are checked
};

} // namespace kith::detail
