// SPDX-License-Identifier: BSD-3-Clause
#include "holes.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/level/to_native.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace kith::tool {

namespace {

/// Removes the values of the elements for which is_left(element) is false.
template <class IsLeft>
void keep_values(std::vector<io::attribute>& attributes, const IsLeft& is_left)
{
    for (io::attribute& a : attributes) {
        std::size_t left = 0;
        for (std::size_t element = 0; element < a.values.size(); ++element)
            if (is_left(element))
                a.values[left++] = a.values[element];
        a.values.resize(left);
    }
}

} // namespace

hole_field holes_of(const io::mesh_tags& tags, const basic_mesh<>& mesh)
{
    storage<bool> result(mesh.face_count(), false);
    for (const std::size_t face : tags.holes) {
        if (face >= result.size())
            throw mesh_error("hole " + std::to_string(face) + ": there is no such face; correct the tag");
        result[face] = true;
    }
    if (tags.boundary_is_hole) {
        const level_of<basic_mesh<>> level(mesh);
        for (const auto v : level.vertices())
            if (v.is_boundary())
                for (const auto f : v.faces())
                    result[f.index()] = true;
    }
    const auto count = std::size_t(std::ranges::count(result, true));
    if (count == result.size())
        throw mesh_error(
            (count == 1 ? "the only face is a hole" : "all " + std::to_string(count) + " faces are holes") +
            std::string(", nothing would be left; correct the tags"));
    return count == 0 ? hole_field() : hole_field(result);
}

void require_no_holes(const control_mesh& control)
{
    if (not holes_of(control.tags, control.mesh).empty())
        throw mesh_error("the file has holes, which tiles cannot leave out; write .off, .obj, .ply or .stl without "
                         "--tiles, or ignore the holes with --ignore-tags");
}

void leave_out_holes(refined_mesh& result, io::mesh_attributes& attributes)
{
    const basic_mesh<>& mesh = result.mesh;
    using index = basic_mesh<>::index_type;
    std::vector<bool> used(mesh.vertex_count());
    std::vector<std::pair<index, index>> edges;
    connectivity<index> kept;
    kept.degree = mesh.topology().degree;
    std::vector<index> corners, first{0};
    std::vector<bool> corner_is_left(mesh.corner_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (result.holes[f])
            continue;
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            used[face[i]] = true;
            corner_is_left[mesh.topology().first_corner(f) + i] = true;
            corners.push_back(face[i]);
            edges.push_back(std::minmax({face[i], face[(i + 1) % face.size()]}));
        }
        first.push_back(index(corners.size()));
    }
    std::vector<index> number(mesh.vertex_count());
    std::vector<std::array<double, 3>> points, normals;
    for (std::size_t v = 0; v < number.size(); ++v)
        if (used[v]) {
            number[v] = index(points.size());
            points.push_back(mesh.point(v));
            if (not result.normals.empty())
                normals.push_back(result.normals[v]);
        }
    for (auto& v : corners)
        v = number[v];
    std::ranges::sort(edges);
    edges.erase(std::ranges::unique(edges).begin(), edges.end());
    result.edges = edges.size();
    result.normals = storage<std::array<double, 3>>(normals);
    std::vector<std::array<double, 3>> corner_normals;
    for (std::size_t c = 0; c < result.corner_normals.size(); ++c)
        if (corner_is_left[c])
            corner_normals.push_back(std::as_const(result.corner_normals)[c]);
    result.corner_normals = storage<std::array<double, 3>>(corner_normals);
    keep_values(attributes.vertices, [&](std::size_t v) { return used[v]; });
    keep_values(attributes.faces, [&](std::size_t f) { return not result.holes[f]; });
    keep_values(attributes.corners, [&](std::size_t c) { return corner_is_left[c]; });
    std::erase_if(result.tags.edges, [&](const auto& edge) {
        const std::pair<index, index> ends = std::minmax({index(edge.from), index(edge.to)});
        return not std::ranges::binary_search(edges, ends);
    });
    for (auto& [from, to, sharpness] : result.tags.edges) {
        from = number[from];
        to = number[to];
    }
    std::erase_if(result.tags.vertices, [&](const auto& corner) { return not used[corner.first]; });
    for (auto& [vertex, sharpness] : result.tags.vertices)
        vertex = number[vertex];
    kept.vertices = points.size();
    kept.faces = first.size() - 1;
    kept.corner_vertex = storage<index>(corners);
    if (kept.degree == 0)
        kept.face_corner = storage<index>(first);
    result.mesh = basic_mesh<>(storage<std::array<double, 3>>(points), std::move(kept));
}

} // namespace kith::tool
