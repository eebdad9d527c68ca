// SPDX-License-Identifier: BSD-3-Clause
#include "foreign_back_end.hpp"

#include <kith/plan.hpp>
#include <kith/refine.hpp>

#include <variant>

namespace kith::tool {

refined_mesh refine_native(basic_mesh<> control, const refine_request& request)
{
    require_possible(request, control, mesh_kind::native);
    if (request.limit or keeps_tags(request))
        return refine_on<basic_mesh<>>(control, request);
    return std::visit(
        [&](const auto& scheme) {
            // Nothing that is printed or written needs the last level's edges, and their number is known beforehand.
            const auto levels = plan(count(control.topology()), scheme, request.levels, control.generation());
            auto mesh = refine(control, scheme, request.levels, {connect::faces, request.memory.bytes});
            return refined_mesh{std::move(mesh), levels.back().counts.edges};
        },
        request.scheme);
}

} // namespace kith::tool
