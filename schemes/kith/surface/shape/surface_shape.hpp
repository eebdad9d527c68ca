// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limit_polynomial.hpp"
#include "parametric_scheme.hpp"

#include <kith/core/base/storage.hpp>
#include <kith/surface/spline/surface_polynomial.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::detail {

/// A tag for the rule of values at vertices, which are refined as points are.
struct as_points {
    struct mark_type {};
};

/// The values at corners around a face, which may differ at a vertex; none if values are at vertices.
template <std::unsigned_integral Index, class Rule>
struct values_at_corners {
    std::vector<Index> inputs;                 ///< the input of each corner
    storage<typename Rule::mark_type> marks{}; ///< marks of the rule, for each corner; none before the first step
};
template <std::unsigned_integral Index>
struct values_at_corners<Index, as_points> {};

/// The neighbourhood of a face, and its children: the shapes around the faces that a step makes of it. Inputs are the
/// control points of the neighbourhood, or its values at corners by a rule of fields. The inputs of a child are
/// weighted sums of those of its parent.
template <std::unsigned_integral Index, parametric_scheme Scheme, class Rule>
struct surface_shape {
    static constexpr bool has_points = std::same_as<Rule, as_points>;
    using index_type = Index;
    using scheme_type = Scheme;
    using rule_type = Rule;
    using domain = domain_of<Scheme>;
    using mesh_type = basic_mesh<std::conditional_t<has_points, stencil_row, double>, Index>;
    using corner_values = values_at_corners<Index, Rule>;

    struct child {
        surface_shape* of; ///< nullptr if a boundary cuts off this part of the face
        subdivision_matrix rows;
        std::size_t first; ///< the corner of its face from which cells are counted
    };

    surface_shape(mesh_type m, corner_values at_each, std::size_t input_count, Scheme s, Index f, bool has_own_key)
        : inputs(input_count)
        , mesh(std::move(m))
        , values(std::move(at_each))
        , scheme(std::move(s))
        , face(f)
        , has_key(has_own_key)
        , in_domain(look_at(mesh.topology(), scheme, mesh.generation(), f))
        , polynomials(domain::cells(in_domain))
        , at_corners(in_domain.degree)
        , at_walls(domain::cells(in_domain))
    {
    }

    std::size_t inputs;
    mesh_type mesh; ///< with unit rows for points, if these are the inputs
    corner_values values;
    Scheme scheme;
    Index face;
    bool has_key; ///< parts with the same key have this shape
    domain_face in_domain;

    std::atomic<bool> is_decided = false; ///< true if all members below are final
    std::vector<child> children{};
    std::vector<polynomial_pointer> polynomials; ///< of the cells of the face that have one
    std::vector<polynomial_pointer> at_corners;  ///< of corners where the surface has no polynomial but limit masks, or
                                                 ///< of the centre of the face
    bool has_corner_limits = false;              ///< true if some corner has a limit
    std::vector<polynomial_pointer> at_walls;    ///< of cells that have none, between the limits of their corners
    polynomial_pointer at_end{};                 ///< of the face after many steps, between the limits of its corners
    bool leads_to_polynomials = false;           ///< true if it has one, or a shape that steps make of it has one
    std::size_t number = 0, oldest = 0;          ///< of a search for shapes that lead to one another
};

/// Returns the cell of a child in which a place in a cell of a shape lies. Replaces its parameters by those in that
/// cell. The cell has no meaning if the child does not exist.
template <class Shape>
child_cell descend(const Shape& shape, std::size_t cell, face_parameters& at)
{
    using domain = typename Shape::domain;
    child_cell next = domain::descend(shape.in_domain, cell, at);
    const auto& child = shape.children[next.child];
    if (child.of != nullptr)
        next.cell = domain::cell_of_child(child.of->in_domain, child.first, next.cell);
    return next;
}

/// A point in a cell of a shape, and in the cell of the child that contains it.
template <class Shape>
struct shape_sample {
    shape_sample(Shape& shape, std::size_t in_cell, double in_s, double in_t)
        : of(&shape), cell(in_cell), s(in_s), t(in_t), in_child{in_s, in_t}
    {
        next = descend(shape, cell, in_child);
    }

    [[nodiscard]] const typename Shape::child& child() const { return of->children[next.child]; }
    [[nodiscard]] const surface_polynomial* polynomial_of_child() const
    {
        return child().of == nullptr ? nullptr : child().of->polynomials[next.cell].get();
    }
    /// Returns true if the child can still get a polynomial, or has one.
    [[nodiscard]] bool child_may_have_polynomial() const
    {
        return child().of != nullptr and (not child().of->is_decided or polynomial_of_child() != nullptr);
    }

    Shape* of;
    std::size_t cell;
    double s, t;
    face_parameters in_child;
    child_cell next{};
};

/// Returns the row of a corner of the face of a shape.
template <class Shape>
control_row corner_row(const Shape& here, std::size_t k)
{
    const std::size_t corner = here.mesh.topology().first_corner(here.face) + k;
    control_row result(here.inputs);
    if constexpr (Shape::has_points)
        result[here.mesh.topology().corner_vertex[corner]] = 1;
    else
        result[here.values.inputs[corner]] = 1;
    return result;
}

} // namespace kith::detail
