// SPDX-License-Identifier: BSD-3-Clause
#include "tile_request.hpp"

#include "holes.hpp"
#include "limit_surface.hpp"
#include "mesh_input.hpp"
#include "settle_attributes.hpp"

#include <kith/io/format/held_attributes.hpp>
#include <kith/io/format/mesh_format.hpp>
#include <kith/io/text/counted.hpp>
#include <kith/numbering/step/children.hpp>

#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace kith::tool {

namespace {

/// Returns true if a scheme makes faces at edges or vertices; such faces have no parent face, and so no value.
bool has_faces_without_parent(const any_scheme& scheme)
{
    return std::visit(
        [](const auto& s) {
            return std::apply(
                []<tuple_kind... K, class... W, class... D>(const column<K, W, D>&...) {
                    return ((parent_kind(K) != element_kind::face) or ...);
                },
                columns_of(s, 0).faces.list);
        },
        scheme);
}

/// Returns the names of the values for which the output has 0, as far as the control mesh shows.
std::vector<std::string> zeros_of(const tile_request& request, const io::mesh_attributes& attributes)
{
    const auto format = io::extension_of(request.output) == ".ply" ? io::mesh_format::ply : io::mesh_format::vtu;
    std::vector<std::string> result = written_as_zero(format, attributes);
    io::mesh_attributes of_a_face;
    for (const io::attribute& a : attributes.faces)
        of_a_face.faces.push_back({a.name, a.type, {std::numeric_limits<double>::quiet_NaN()}, a.labels});
    if (request.levels > 0 and not written_as_zero(format, of_a_face).empty() and
        has_faces_without_parent(request.scheme))
        result.emplace_back("the values of faces made at edges or vertices");
    return result;
}

} // namespace

bool has_corner_normals(const tile_request& request)
{
    return request.limit and io::extension_of(request.output) == ".ply" and has_sides(request.scheme);
}

tiling_kind tiling_of(const tile_request& request, std::uint64_t threads)
{
    return {.threads = threads,
            .limit = request.limit,
            .corner_normals = has_corner_normals(request),
            .attributes = count_of(request.kinds, request.linear)};
}

std::uint64_t usual_tiles_per_rank(const tile_request& request, std::uint64_t ranks)
{
    const std::uint64_t all = usual_tiles(request.scheme, request.control, request.levels, tiling_of(request));
    return (all + ranks - 1) / ranks;
}

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
    if (request.limit and has_sides(request.scheme) and not has_corner_normals(request))
        control.not_kept.emplace_back(normals_of_sides);
    if (not control.isolated.empty())
        control.not_kept.push_back(io::counted(control.isolated.size(), "vertex") + " without a face");
    take_control(request, control);
    note_losses(path, control.not_kept);
    note_zeros(request.output, zeros_of(request, control.attributes));
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
