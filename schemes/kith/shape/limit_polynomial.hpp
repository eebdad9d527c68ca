// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/limit/limit.hpp>
#include <kith/mask/stencil.hpp>
#include <kith/spline/surface_polynomial.hpp>
#include <kith/step/scheme.hpp>
#include <kith/step/step.hpp>

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

/// Returns a polynomial of degree zero, of which so many derivatives are known.
inline polynomial_pointer constant_polynomial(const control_row& row, int derivatives)
{
    auto made = polynomial_of(0, false, std::array{row});
    made.derivatives = derivatives;
    return std::make_unique<const surface_polynomial>(std::move(made));
}

/// Returns the rows of the limit of a vertex or face, and of its second and first tangent, as far as there are masks.
template <class Scheme, level Level, template <class> class Element>
std::vector<control_row> position_and_tangents(const Element<Level>& v, const Level& level, const Scheme& scheme,
                                               std::size_t inputs)
{
    [[maybe_unused]] const auto& rules = limit_rules<Scheme>::on(scheme, level);
    [[maybe_unused]] const auto value = [&](const auto& mask) {
        return dense(affine<stencil_row>::store(mask.evaluate(point_values<Level>())), inputs);
    };
    const auto are_finite = [](const control_row& row) {
        return std::ranges::all_of(row, [](double weight) { return std::isfinite(weight); });
    };
    std::vector<control_row> result;
    if constexpr (has_limit_positions<Scheme, Element<Level>, Level>)
        limit_rules<Scheme>::position(rules, v, [&](const auto& mask) { result.assign(1, value(mask)); });
    if constexpr (has_limit_tangents<Scheme, Element<Level>, Level>)
        if (not result.empty())
            limit_rules<Scheme>::tangents(rules, v, [&](const auto& first, const auto& second) {
                const auto a = value(first), b = value(second);
                if (are_finite(a) and are_finite(b)) { // not at a vertex of two edges
                    result.push_back(b);
                    result.push_back(a);
                }
            });
    return result;
}

/// Returns a limit by closed masks, with tangents if there are masks for them; nothing if there is none. It is that of
/// element `number` of elements(level). Precondition: the points of the mesh are unit rows.
template <std::unsigned_integral Index, class Scheme, class Elements>
polynomial_pointer limit_of_element(const basic_mesh<stencil_row, Index>& mesh, const Scheme& scheme, Index number,
                                    const Elements& elements)
{
    const auto coefficients = with_native_level<Scheme>(mesh, [&](const auto& level) {
        return position_and_tangents(elements(level)[number], level, scheme, mesh.vertex_count());
    });
    if (coefficients.empty())
        return {};
    if (coefficients.size() == 1)
        return constant_polynomial(coefficients[0], 0);
    auto made = polynomial_of(1, false, coefficients);
    made.derivatives = 1;
    return std::make_unique<const surface_polynomial>(std::move(made));
}

/// Returns the limit of a vertex.
template <std::unsigned_integral Index, class Scheme>
polynomial_pointer limit_at_vertex(const basic_mesh<stencil_row, Index>& mesh, const Scheme& scheme, Index number)
{
    return limit_of_element(mesh, scheme, number, [](const auto& level) { return level.vertices(); });
}
/// Returns the limit of the centre of a face.
template <std::unsigned_integral Index, class Scheme>
polynomial_pointer limit_at_centre(const basic_mesh<stencil_row, Index>& mesh, const Scheme& scheme, Index number)
{
    return limit_of_element(mesh, scheme, number, [](const auto& level) { return level.faces(); });
}

} // namespace kith::detail
