// SPDX-License-Identifier: BSD-3-Clause
#include "settle_attributes.hpp"

#include "attribute_fields.hpp"
#include "cli/errors.hpp"

#include <kith/io/format/held_attributes.hpp>
#include <kith/io/format/mesh_format.hpp>
#include <kith/tiles/output/vtu_arrays.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <unordered_set>
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
    std::unordered_set<std::string> told(control.not_kept.begin(), control.not_kept.end());
    for (const std::string& topic : topics)
        if (told.insert(topic).second)
            control.not_kept.push_back(topic);
}

/// Adds attributes that some vertices have no value of to what is not kept. A vertex made from such a vertex has no
/// value, either.
void add_spreading_lack(control_mesh& control, int levels)
{
    std::vector<std::string> topics;
    for (const io::attribute& a : control.attributes.vertices) {
        const auto missing = std::ranges::count_if(a.values, [](double x) { return std::isnan(x); });
        if (levels > 0 and missing != 0 and missing != std::ranges::ssize(a.values))
            topics.push_back(io::topic_of(a.name, "vertices") + " around vertices without a value");
    }
    add_not_kept(control, topics);
}

template <class Which>
void move_if(std::vector<io::attribute>& from, std::vector<io::attribute>& to, const Which& which)
{
    const auto moved = std::stable_partition(from.begin(), from.end(), [&](const auto& a) { return not which(a); });
    std::move(moved, from.end(), std::back_inserter(to));
    from.erase(moved, from.end());
}

/// Removes and returns the attributes that VTK's format cannot hold.
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

/// Returns true if some face has values at some corners and none at others. In PLY such a face has no values.
bool some_faces_lack_some(const control_mesh& control)
{
    for (std::size_t f = 0; f < control.mesh.face_count(); ++f) {
        const std::size_t first = control.mesh.topology().first_corner(f), degree = control.mesh.face(f).size();
        std::size_t missing = 0;
        for (const io::attribute& a : control.attributes.corners)
            missing += std::size_t(std::ranges::count_if(std::span(a.values).subspan(first, degree),
                                                         [](double x) { return std::isnan(x); }));
        if (missing != 0 and missing != degree * control.attributes.corners.size())
            return true;
    }
    return false;
}

} // namespace

void settle_attributes(control_mesh& control, io::mesh_format format, const attribute_use& use)
{
    settle_normals(control, use);
    add_not_kept(control, not_held(format, control.attributes, use.binary));
    keep_held(format, control.attributes, use.binary);
    add_spreading_lack(control, use.levels);
    if (format == io::mesh_format::ply and some_faces_lack_some(control))
        control.not_kept.emplace_back("texture coordinates of faces where some corners have none");
}

void settle_tile_attributes(control_mesh& control, const std::string& output, const attribute_use& use)
{
    if (extension_of(output) != ".ply") {
        settle_normals(control, use);
        add_not_kept(control, topics_of(not_in_vtu(control.attributes)));
        add_spreading_lack(control, use.levels);
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
