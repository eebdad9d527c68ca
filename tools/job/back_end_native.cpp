// SPDX-License-Identifier: BSD-3-Clause
#include "foreign_back_end.hpp"

#include <kith/fields/values_in_patches.hpp>
#include <kith/fields/with_fields.hpp>
#include <kith/plan.hpp>
#include <kith/refine_with_fields.hpp>

#include <cstdint>
#include <tuple>
#include <utility>
#include <variant>

namespace kith::tool {

namespace {

/// Returns true if the edges and the scheme of the last level are needed: for limits, and for sharpness that is left.
bool needs_last_scheme(const refine_request& request)
{
    return request.limit or keeps_tags(request);
}

} // namespace

refined_mesh refine_native(basic_mesh<> control, const refine_request& request)
{
    require_possible(request, control, mesh_kind::native);
    const bool needs_scheme = needs_last_scheme(request);
    const refine_options options{needs_scheme ? connect::everything : connect::faces, request.memory.bytes};
    return std::visit(
        [&]<class Scheme>(const Scheme& scheme) {
            const auto levels = plan(count(control.topology()), scheme, request.levels, control.generation());
            refined_mesh result{{}, levels.back().counts.edges};
            if (not needs_scheme and request.holes.empty() and request.attributes.empty()) {
                result.mesh = refine(control, scheme, request.levels, options);
                return result;
            }
            result.holes = request.holes;
            result.attributes = request.attributes;
            auto fields = std::tie(result.holes, result.attributes);
            if (not needs_scheme) {
                result.mesh = refine_with_fields(control, scheme, request.levels, fields, options);
                return result;
            }
            with_fields last(scheme, request.holes, request.attributes);
            result.mesh = refine_with_fields(control, last, request.levels, options);
            fields = last.fields();
            add_sharpness_and_limit(result, last.plain(), request);
            return result;
        },
        request.scheme);
}

strategy strategy_of(mesh_kind mesh, const basic_mesh<>& control, const refine_request& request)
{
    if (mesh != mesh_kind::native)
        return {.reason = strategy_reason::all_levels};
    const bool needs_scheme = needs_last_scheme(request);
    return std::visit(
        [&]<class Scheme>(const Scheme& scheme) -> strategy {
            if constexpr (scheme_with_creases<Scheme>)
                if (needs_scheme and not scheme.sharpness.empty())
                    return {.reason = strategy_reason::all_levels};
            if (not request.attributes.empty() and not goes_in_patches<attribute_fields, Scheme, std::uint32_t>)
                return {.reason = strategy_reason::single_steps};
            return kith::strategy_of(
                control, scheme, request.levels, {needs_scheme ? connect::everything : connect::faces});
        },
        request.scheme);
}

} // namespace kith::tool
