// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mask/stencil.hpp>
#include <kith/limits/limit.hpp>
#include <kith/numbering/step/scheme.hpp>
#include <kith/numbering/step/step.hpp>
#include <kith/schemes/crease/sectors.hpp>
#include <kith/surface/spline/surface_polynomial.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace kith::detail {

using polynomial_pointer = std::unique_ptr<const surface_polynomial>;

/// Returns a polynomial of degree zero, of which `derivatives` derivatives are known.
inline polynomial_pointer constant_polynomial(const control_row& row, int derivatives)
{
    auto made = polynomial_of(0, false, std::array{row});
    made.derivatives = derivatives;
    return std::make_unique<const surface_polynomial>(std::move(made));
}

/// Returns the row of a mask over unit rows.
template <level Level, class Mask>
control_row row_of_limit(const Mask& mask, std::size_t inputs)
{
    return dense(affine<stencil_row>::store(mask.evaluate(point_values<Level>())), inputs);
}
/// Adds the second and first of two tangents, unless they are not finite, as at a vertex of two edges.
inline void add_tangents(const control_row& first, const control_row& second, std::vector<control_row>& result)
{
    const auto are_finite = [](const control_row& row) {
        return std::ranges::all_of(row, [](double weight) { return std::isfinite(weight); });
    };
    if (are_finite(first) and are_finite(second)) {
        result.push_back(second);
        result.push_back(first);
    }
}

/// Returns the rows of the limit of an element, and of its second and first tangent, as far as there are masks.
template <class Scheme, level Level, template <class> class Element>
std::vector<control_row> position_and_tangents(const Element<Level>& x, const Level& level, const Scheme& scheme,
                                               std::size_t inputs)
{
    [[maybe_unused]] const auto& rules = limit_rules<Scheme>::on(scheme, level);
    std::vector<control_row> result;
    if constexpr (has_limit_positions<Scheme, Element<Level>, Level>)
        limit_rules<Scheme>::position(
            rules, x, [&](const auto& mask) { result.assign(1, row_of_limit<Level>(mask, inputs)); });
    if constexpr (has_limit_tangents<Scheme, Element<Level>, Level>)
        if (not result.empty())
            limit_rules<Scheme>::tangents(rules, x, [&](const auto& first, const auto& second) {
                add_tangents(row_of_limit<Level>(first, inputs), row_of_limit<Level>(second, inputs), result);
            });
    return result;
}

/// Returns true if a sector contains a face.
template <level Level>
bool has_face(const vertex_sector<Level>& part, std::size_t face)
{
    std::size_t faces = 0;
    for (const auto& c : part.first.fan_from_here())
        if (faces++ == part.faces)
            break;
        else if (c.f().index() == face)
            return true;
    return false;
}

/// Adds the second and first tangent of the sector of a vertex that contains a face, if there are masks for them.
/// Beside a curve they are along it and into the sector. At a corner the tangents of the edges span a plane if
/// everything else shrinks faster than these: in sectors of few faces.
template <class Scheme, level Level>
void add_tangents_of_sector([[maybe_unused]] const vertex<Level>& v, [[maybe_unused]] const Level& level,
                            [[maybe_unused]] const Scheme& scheme, [[maybe_unused]] std::size_t face,
                            [[maybe_unused]] std::vector<control_row>& result)
{
    if constexpr (has_limit_sides<Scheme, vertex<Level>, Level>) {
        const std::size_t inputs = result[0].size();
        limit_rules<Scheme>::sides(
            limit_rules<Scheme>::on(scheme, level),
            v,
            [&](const vertex_sector<Level>& part, bool is_half_turn, const auto& a, const auto& z, const auto& middle) {
                if (not has_face(part, face))
                    return;
                if (is_half_turn and part.faces > 1)
                    add_tangents(row_of_limit<Level>(a, inputs), row_of_limit<Level>(middle, inputs), result);
                else if (not part.is_closed and part.faces <= limit_rules<Scheme>::most_faces_of_planes)
                    add_tangents(row_of_limit<Level>(a, inputs), row_of_limit<Level>(z, inputs), result);
            });
    }
}

/// Returns the polynomial of a limit: constant, or with tangents. The result is nothing if there are no rows.
inline polynomial_pointer polynomial_of_limit(const std::vector<control_row>& position_and_tangents)
{
    if (position_and_tangents.empty())
        return {};
    if (position_and_tangents.size() == 1)
        return constant_polynomial(position_and_tangents[0], 0);
    auto made = polynomial_of(1, false, position_and_tangents);
    made.derivatives = 1;
    return std::make_unique<const surface_polynomial>(std::move(made));
}

/// Returns the limit of a vertex by closed-form masks, with the tangents of the surface in a face if there are masks
/// for them. The result is nothing if there is no mask. Precondition: the points of the mesh are unit rows.
template <std::unsigned_integral Index, class Scheme>
polynomial_pointer limit_at_vertex(const basic_mesh<stencil_row, Index>& mesh, const Scheme& scheme, Index vertex,
                                   Index face)
{
    return with_native_level<Scheme>(mesh, [&](const auto& level) {
        const auto v = level.vertices()[vertex];
        auto rows = position_and_tangents(v, level, scheme, mesh.vertex_count());
        if (rows.size() == 1)
            add_tangents_of_sector(v, level, scheme, face, rows);
        return polynomial_of_limit(rows);
    });
}
/// Returns the limit of the centre of a face, in the same way as that of a vertex.
template <std::unsigned_integral Index, class Scheme>
polynomial_pointer limit_at_centre(const basic_mesh<stencil_row, Index>& mesh, const Scheme& scheme, Index face)
{
    return with_native_level<Scheme>(mesh, [&](const auto& level) {
        return polynomial_of_limit(position_and_tangents(level.faces()[face], level, scheme, mesh.vertex_count()));
    });
}

} // namespace kith::detail
