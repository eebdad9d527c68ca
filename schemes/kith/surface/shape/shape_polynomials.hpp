// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_shape.hpp"

#include <kith/engine/neighbourhood/sparse_state.hpp>
#include <kith/surface/spline/polynomial_lattice.hpp>
#include <kith/surface/spline/repeated_step.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
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
    /// Keeps the limit at a corner of the face, or at its centre. Finds a limit that masks do not give by repeating the
    /// step, if this makes the same shape there. Keeps none without tangents if steps lead to one with them.
    static void keep_limit(Shape& here, std::size_t corner, polynomial_pointer limit)
    {
        if (not limit or limit->derivatives == 0) {
            if (auto found = limit_by_steps(here, corner); found and (not limit or found->derivatives > 0))
                limit = std::move(found);
            else if (leads_to_tangents(here, corner))
                return;
        }
        here.has_corner_limits = here.has_corner_limits or limit != nullptr;
        here.at_corners[corner] = std::move(limit);
    }
    /// Returns the place of a corner of the face, or of its centre, if a limit can be there.
    static std::optional<sample> sample_at(Shape& here, std::size_t corner)
    {
        for (std::size_t cell = 0; cell < here.polynomials.size(); ++cell)
            for (const auto& at : domain::corners)
                if (domain::corner_at(here.in_domain, cell, at) == corner)
                    return sample(here, cell, at[0], at[1]);
        return {};
    }
    /// Returns the corner of the child's face at which a place lies, if there is a child and the place is at a corner.
    static std::optional<std::size_t> corner_of_child(const sample& there)
    {
        if (there.child().of == nullptr)
            return {};
        const std::size_t corner = domain::corner_at(
            there.child().of->in_domain, there.next.cell, {there.in_child.s, there.in_child.t});
        return corner == domain::sides ? std::nullopt : std::optional(corner);
    }
    /// Returns true if a few steps lead from a corner or centre to a limit with tangents.
    static bool leads_to_tangents(Shape& here, std::size_t corner)
    {
        constexpr int few_steps = 8;
        Shape* shape = &here;
        for (int step = 0; step < few_steps; ++step) {
            const auto there = sample_at(*shape, corner);
            const auto next = there ? corner_of_child(*there) : std::nullopt;
            if (not next or not there->child().of->is_decided)
                return false;
            shape = there->child().of;
            corner = *next;
            if (const auto& limit = shape->at_corners[corner])
                return limit->derivatives > 0;
        }
        return false;
    }
    /// Returns the limit at a corner or at the centre of a face, inside and without state, by repeating the step.
    static polynomial_pointer limit_by_steps(Shape& here, std::size_t corner)
    {
        const subdivision_matrix* const step = step_to_itself(here, corner);
        if (step == nullptr or not is_inside(here, corner))
            return {};
        const std::size_t n = here.in_domain.degree;
        const bool has_vertices = domain::has_vertices_at_corners(here.in_domain);
        control_row point = corner_row(here, corner);
        if (not has_vertices)
            for (std::size_t k = 1; k < n; ++k)
                add(point, 1, corner_row(here, k));
        const double points = has_vertices ? 1 : double(n);
        for (double& weight : point)
            weight /= points;
        // Two directions, counter-clockwise.
        control_row first = corner_row(here, has_vertices ? (corner + 1) % n : 0);
        control_row second = corner_row(here, has_vertices ? (corner + n - 1) % n : 1);
        add(first, -1, point);
        add(second, -1, point);
        const repeated_step repeated(*step, std::move(point));
        if (not repeated.point())
            return {};
        std::vector<control_row> rows{*repeated.point()};
        if (const auto tangents = repeated.tangents(first, second))
            rows.insert(rows.end(), {(*tangents)[1], (*tangents)[0]});
        return polynomial_of_limit(rows);
    }
    /// Returns the matrix of the step that makes the same shape again around a corner or the centre; nullptr if none
    /// does.
    static const subdivision_matrix* step_to_itself(Shape& here, std::size_t corner)
    {
        const auto there = sample_at(here, corner);
        const bool is_same = there and there->child().of == &here and corner_of_child(*there) == corner;
        return is_same ? &there->child().rows : nullptr;
    }
    /// Returns true if there is no state around and a corner of the face does not lie at a boundary. If the face has a
    /// limit at its centre, none of its sides may lie at a boundary.
    static bool is_inside(const Shape& here, std::size_t corner)
    {
        const auto& mesh = here.mesh.topology();
        bool result = true;
        for_each_state(here.scheme, [&](const auto& state) {
            if constexpr (sparse_state<std::remove_cvref_t<decltype(state)>>)
                state.for_each_place([&](auto&&...) { result = false; });
            else
                result = false;
        });
        const auto is_wall = [&](std::size_t c) {
            return mesh.across(static_cast<typename Shape::index_type>(c)) == mesh.none;
        };
        const std::size_t first = mesh.first_corner(here.face);
        if (domain::has_vertices_at_corners(here.in_domain))
            return result and not is_wall(mesh.vertex_corner[mesh.corner_vertex[first + corner]]);
        for (std::size_t k = 0; k < here.in_domain.degree; ++k)
            result = result and not is_wall(first + k);
        return result;
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
        if constexpr (Shape::has_points)
            if (has_centre and is_settled(here.scheme))
                keep_limit(here, 0, limit_at_centre(here.mesh, here.scheme, here.face));
        std::vector<control_row> corners; // in the order of the lattice: (0, 0), (0, 1), (1, 0), (1, 1)
        for (const auto& [s, t] : lattice_points(1, domain::is_tensor)) {
            const auto k = std::size_t(std::ranges::find(domain::corners, std::array{s, t}) - domain::corners.begin());
            corners.push_back(corner_row(here, std::min(k, face.degree - 1)));
            if constexpr (Shape::has_points) // the limit by masks
                if (has_vertices and is_settled(here.scheme)) {
                    auto limit = limit_at_vertex(here.mesh, here.scheme, here.mesh.face(here.face)[k], here.face);
                    if (limit)
                        corners.back() = limit->at(0, 0);
                    // The child at a regular corner is a polynomial, which has derivatives.
                    const bool is_needed = here.leads_to_polynomials or not here.has_key;
                    if (is_needed and not has_polynomial_at(here, k))
                        keep_limit(here, k, std::move(limit));
                }
        }
        auto made = polynomial_lattice(1, domain::is_tensor).through(corners);
        made.derivatives = here.leads_to_polynomials ? 0 : 1;
        here.at_end = std::make_unique<const surface_polynomial>(std::move(made));
    }

    std::size_t degree_;
    polynomial_lattice lattice_;
    std::vector<std::array<double, 2>> points_; // the points by which cells are checked
};

} // namespace kith::detail
