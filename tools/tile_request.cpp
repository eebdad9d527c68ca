// SPDX-License-Identifier: BSD-3-Clause
#include "tile_request.hpp"

#include "holes.hpp"
#include "mesh_input.hpp"

#include <kith/text/counted.hpp>

#include <utility>

namespace kith::tool {

void read_control(tile_request& request, const std::string& path)
{
    control_mesh control = read_mesh(path);
    give_creases(request.scheme, control, request.words);
    const sharp_elements left = sharp_after(request.scheme, request.levels);
    add_lost_sharpness(control.not_kept, left.edges, left.vertices);
    if (not control.isolated.empty())
        control.not_kept.push_back(io::counted(control.isolated.size(), "vertex") + " without a face");
    for (const std::string& topic : topics_of(control.attributes))
        control.not_kept.push_back(topic);
    note_losses(path, control.not_kept);
    require_no_holes(control);
    request.control = prepared(request.scheme, std::move(control.mesh));
    require_scheme_takes(request.scheme, request.control);
}

} // namespace kith::tool
