// SPDX-License-Identifier: BSD-3-Clause
#include "tile_request.hpp"

#include "holes.hpp"
#include "mesh_input.hpp"
#include "settle_attributes.hpp"

#include <kith/text/counted.hpp>

#include <utility>

namespace kith::tool {

void read_control(tile_request& request, const std::string& path)
{
    control_mesh control = read_mesh(path, request.repair);
    give_creases(request.scheme, control, request.words);
    const sharp_elements left = sharp_after(request.scheme, request.levels);
    add_lost_sharpness(control.not_kept, left.edges, left.vertices);
    if (not request.limit) {
        tell_next_step(control, request.scheme, request.levels);
        add_lost_boundary_rule(control.not_kept, control.tags, request.scheme);
    }
    if (not control.isolated.empty())
        control.not_kept.push_back(io::counted(control.isolated.size(), "vertex") + " without a face");
    take_control(request, control);
    note_losses(path, control.not_kept);
}

void take_control(tile_request& request, control_mesh& control)
{
    settle_tile_attributes(control, request.output, {request.scheme, request.levels, request.limit});
    require_no_holes(control);
    request.kinds = kinds_of(control.attributes);
    request.attributes = attribute_fields(control.attributes, control.mesh, request.linear);
    request.control = prepared(request.scheme, std::move(control.mesh), request.attributes);
    require_scheme_takes(request.scheme, request.control);
}

} // namespace kith::tool
