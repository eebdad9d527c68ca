// SPDX-License-Identifier: BSD-3-Clause
#include "slice_attributes.hpp"

#include "job/settle_attributes.hpp"

#include <kith/io/format/ply_attributes.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace kith::tool {

slice_attributes::slice_attributes(tile_request& request, const std::string& path) : path_(path), file_(path)
{
    control_mesh control;
    control.attributes = io::kinds_in(file_.header());
    control.not_kept = io::not_kept(file_.header());
    take_odd_generation(control.attributes); // which matters at a boundary, of which slices know nothing
    settle_tile_attributes(control, request.output, {request.scheme, request.levels, request.limit});
    request.kinds = kinds_ = std::move(control.attributes);
    not_kept_ = std::move(control.not_kept);
}

attribute_fields slice_attributes::of_tile(const tile<std::array<double, 3>>& part)
{
    const auto& elements = file_.header().elements;
    io::mesh_attributes here = kinds_;
    for (io::attribute& a : here.vertices)
        a.values = file_.values_of_vertices(io::property_of(elements[0], a),
                                            {part.vertex_ids.data(), part.vertex_ids.size()});
    for (io::attribute& a : here.faces) {
        a.values = file_.values_of_faces(io::property_of(elements[1], a), {part.face_ids.data(), part.face_ids.size()});
        const auto has_no_word = [&](double x) { return x < 0 or x >= double(a.labels.size()); };
        if (const auto found = std::ranges::find_if(a.values, has_no_word);
            not a.labels.empty() and found != a.values.end())
            throw mesh_error(path_ + ": face " + std::to_string(part.face_ids[std::size_t(found - a.values.begin())]) +
                             ": " + a.name + " is a number without a name in the file; read it on one rank");
    }
    return attribute_fields(here, part.mesh);
}

} // namespace kith::tool
