// SPDX-License-Identifier: BSD-3-Clause
#include "foreign_back_end.hpp"

#include <kith/plan.hpp>
#include <kith/refine_with_fields.hpp>

#include <tuple>
#include <utility>
#include <variant>

namespace kith::tool {

refined_mesh refine_native(basic_mesh<> control, const refine_request& request)
{
    require_possible(request, control, mesh_kind::native);
    if (request.limit or keeps_tags(request))
        return refine_on<basic_mesh<>>(control, request);
    return std::visit(
        [&]<class Scheme>(const Scheme& scheme) {
            // Nothing that is printed or written needs the last level's edges, and their number is known beforehand.
            const auto levels = plan(count(control.topology()), scheme, request.levels, control.generation());
            const refine_options options{connect::faces, request.memory.bytes};
            refined_mesh result{{}, levels.back().counts.edges};
            if (request.holes.empty() and request.attributes.empty()) {
                result.mesh = refine(control, scheme, request.levels, options);
                return result;
            }
            result.holes = request.holes;
            result.attributes = request.attributes;
            result.mesh = refine_with_fields(
                control, scheme, request.levels, std::tie(result.holes, result.attributes), options);
            return result;
        },
        request.scheme);
}

strategy strategy_of_native(const basic_mesh<>& control, const refine_request& request)
{
    if (request.limit or keeps_tags(request)) // then all levels are made
        return {.reason = strategy_reason::all_levels};
    return std::visit(
        [&](const auto& scheme) { return strategy_of(control, scheme, request.levels, {connect::faces}); },
        request.scheme);
}

} // namespace kith::tool
