// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_shape.hpp"

#include <kith/surface/spline/repeated_step.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace kith::detail {

/// Returns the point of the surface at a sample, by steps until there is a polynomial. The result is nothing if a
/// boundary cuts off the place.
template <class Shape>
std::optional<control_row> limit_at(const shape_sample<Shape>& at, int depth = 0)
{
    const auto& child = at.child();
    if (child.of == nullptr)
        return {};
    if (child.of->is_decided and at.polynomial_of_child() != nullptr)
        return composed(at.polynomial_of_child()->at(at.in_child.s, at.in_child.t), child.rows);
    if (depth == Shape::domain::most_steps or child.of->children.empty())
        return composed(corner_row(*child.of, 0), child.rows);
    const auto of_child = limit_at(shape_sample<Shape>(*child.of, at.next.cell, at.in_child.s, at.in_child.t),
                                   depth + 1);
    return of_child ? std::optional(composed(*of_child, child.rows)) : std::nullopt;
}

/// A corner of the face of a shape, or its centre, at which the surface has no polynomial. Finds its limit by repeating
/// the step that makes the same shape again there.
template <class Shape>
class corner_of_shape {
    using domain = typename Shape::domain;
    using sample = shape_sample<Shape>;

public:
    /// Takes a shape with its children, and the number of the corner.
    corner_of_shape(Shape& here, std::size_t corner) : here_(&here), corner_(corner)
    {
        for (std::size_t cell = 0; cell < here.polynomials.size() and not place_; ++cell)
            for (const auto& at : domain::corners)
                if (not place_ and domain::corner_at(here.in_domain, cell, at) == corner)
                    place_.emplace(here, cell, at[0], at[1]);
    }

    /// Returns true if a few steps lead to a limit with tangents.
    [[nodiscard]] bool leads_to_tangents() const
    {
        constexpr int few_steps = 8;
        corner_of_shape at = *this;
        for (int step = 0; step < few_steps; ++step) {
            const auto next = at.corner_of_child();
            if (not next or not at.child()->is_decided)
                return false;
            at = corner_of_shape(*at.child(), *next);
            if (const auto& limit = at.here_->at_corners[at.corner_])
                return limit->derivatives > 0;
        }
        return false;
    }
    /// Returns true if the vertex at the corner lies at the boundary.
    [[nodiscard]] bool is_at_boundary() const
    {
        const auto& mesh = here_->mesh.topology();
        const auto vertex = mesh.corner_vertex[mesh.first_corner(here_->face) + corner_];
        return domain::has_vertices_at_corners(here_->in_domain) and
               mesh.across(mesh.vertex_corner[vertex]) == mesh.none;
    }
    /// A limit, and whether differences of points shrink to it as parameters do, so that it has finite derivatives.
    struct found_limit {
        polynomial_pointer limit{};
        bool has_finite_derivatives = false;
    };
    /// Returns the limit, with tangents if there is a tangent plane; nothing if no step makes the same shape.
    [[nodiscard]] found_limit limit() const
    {
        const auto next = corner_of_child();
        if (not next or *next != corner_ or child() != here_)
            return {};
        const std::size_t n = here_->in_domain.degree;
        const bool has_vertices = domain::has_vertices_at_corners(here_->in_domain);
        control_row start = corner_row(*here_, corner_);
        if (not has_vertices)
            for (std::size_t k = 1; k < n; ++k)
                add(start, 1, corner_row(*here_, k));
        const double points = has_vertices ? 1 : double(n);
        for (double& weight : start)
            weight /= points;
        // Two directions, counter-clockwise.
        control_row first = corner_row(*here_, has_vertices ? (corner_ + 1) % n : 0);
        control_row second = corner_row(*here_, has_vertices ? (corner_ + n - 1) % n : 1);
        add(first, -1, start);
        add(second, -1, start);
        const repeated_step repeated(place_->child().rows, std::move(start));
        if (not repeated.point())
            return {};
        std::vector<control_row> rows{*repeated.point()};
        const auto tangents = repeated.tangents(std::move(first), std::move(second));
        if (tangents)
            rows.insert(rows.end(), {tangents->second, tangents->first});
        const auto& at = place_->in_child;
        const double scale = std::sqrt(std::abs(at.s_u * at.t_v - at.s_v * at.t_u)); // of parameters in a step
        const auto is_one = [](double x) { return std::abs(x - 1) < 1e-9; };
        return {polynomial_of_limit(rows),
                tangents and is_one(scale * tangents->largest_factor) and is_one(scale * tangents->smallest_factor)};
    }

private:
    [[nodiscard]] Shape* child() const { return place_->child().of; }
    /// Returns the corner of the child's face at which the corner lies, if there is a child and a limit can be there.
    [[nodiscard]] std::optional<std::size_t> corner_of_child() const
    {
        if (not place_ or child() == nullptr)
            return {};
        const std::size_t corner = domain::corner_at(
            child()->in_domain, place_->next.cell, {place_->in_child.s, place_->in_child.t});
        return corner == domain::sides ? std::nullopt : std::optional(corner);
    }

    Shape* here_;
    std::size_t corner_;
    std::optional<sample> place_{}; // in a cell
};

/// Keeps the limit at a corner of the face of a shape, or at its centre, given that by masks. Keeps none without
/// tangents if steps lead to one with them. Along a boundary without polynomials keeps none but tangents where
/// derivatives are zero or infinite.
template <class Shape>
void keep_limit(Shape& here, std::size_t corner, polynomial_pointer by_masks)
{
    using level = level_of<typename Shape::mesh_type>;
    constexpr bool masks_know_sides = has_limit_sides<typename Shape::scheme_type, vertex<level>, level>;
    if (not by_masks or by_masks->derivatives == 0) {
        const corner_of_shape<Shape> at(here, corner);
        const bool is_known = by_masks and masks_know_sides; // there is no tangent plane
        auto [found, has_finite_derivatives] = is_known ? typename corner_of_shape<Shape>::found_limit() : at.limit();
        if constexpr (not Shape::domain::has_polynomials_at_boundaries)
            if (at.is_at_boundary() and (has_finite_derivatives or not found or found->derivatives == 0))
                return;
        if (found and (not by_masks or found->derivatives > 0))
            by_masks = std::move(found);
        else if (at.leads_to_tangents())
            return;
    }
    here.has_corner_limits = here.has_corner_limits or by_masks != nullptr;
    here.at_corners[corner] = std::move(by_masks);
}

} // namespace kith::detail
