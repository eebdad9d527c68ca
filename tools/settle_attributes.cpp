// SPDX-License-Identifier: BSD-3-Clause
#include "settle_attributes.hpp"

#include "attribute_fields.hpp"
#include "mesh_format.hpp"

#include <kith/format/held_attributes.hpp>
#include <kith/output/vtu_arrays.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace kith::tool {

namespace {

void settle_normals(control_mesh& control, const attribute_use& use)
{
    const bool is_kept = use.levels == 0 and not use.limit and not is_prepared(use.scheme);
    if (not is_kept and take_normals(control.attributes) and not use.limit)
        control.not_kept.emplace_back("normals");
}

void add_not_kept(control_mesh& control, const std::vector<std::string>& topics)
{
    for (const std::string& topic : topics)
        if (std::ranges::find(control.not_kept, topic) == control.not_kept.end())
            control.not_kept.push_back(topic);
}

template <class Which>
void move_if(std::vector<io::attribute>& from, std::vector<io::attribute>& to, const Which& which)
{
    const auto moved = std::stable_partition(from.begin(), from.end(), [&](const auto& a) { return not which(a); });
    std::move(moved, from.end(), std::back_inserter(to));
    from.erase(moved, from.end());
}

/// Takes out what VTK's format has no room for.
io::mesh_attributes not_in_vtu(io::mesh_attributes& attributes)
{
    io::mesh_attributes rest;
    const auto has_no_room = [](const io::attribute& a) { return not kith::detail::vtu_arrays::is_free(a.name); };
    move_if(attributes.vertices, rest.vertices, has_no_room);
    move_if(attributes.faces, rest.faces, has_no_room);
    std::swap(attributes.corners, rest.corners);
    std::swap(attributes.file_lines, rest.file_lines);
    return rest;
}

} // namespace

void settle_attributes(control_mesh& control, io::mesh_format format, const attribute_use& use)
{
    settle_normals(control, use);
    add_not_kept(control, not_held(format, control.attributes));
    keep_held(format, control.attributes);
}

void settle_tile_attributes(control_mesh& control, const std::string& output, const attribute_use& use)
{
    if (extension_of(output) != ".ply") {
        settle_normals(control, use);
        add_not_kept(control, topics_of(not_in_vtu(control.attributes)));
        return;
    }
    settle_attributes(control, io::mesh_format::ply, use);
    const auto lacks_some = [](const io::attribute& a) {
        return std::ranges::any_of(a.values, [](double x) { return std::isnan(x); });
    };
    if (std::ranges::any_of(control.attributes.corners, lacks_some)) {
        control.attributes.corners.clear();
        control.not_kept.emplace_back("texture coordinates, which some faces do not have");
    }
}

} // namespace kith::tool
