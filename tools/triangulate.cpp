// SPDX-License-Identifier: BSD-3-Clause
#include "triangulate.hpp"

#include <kith/base/error.hpp>
#include <kith/mesh/make_mesh.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::tool {

namespace {

using point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using polygon = CGAL::Surface_mesh<point>;

/// Appends the triangles of a face of a mesh.
void cut(const basic_mesh<>& mesh, std::size_t face, face_list& triangles)
{
    const std::span<const std::uint32_t> corners = mesh.face(face);
    if (corners.size() == 3) {
        triangles.push_back(corners);
        return;
    }
    polygon alone;
    std::vector<polygon::Vertex_index> loop;
    for (const auto v : corners) {
        const auto& p = mesh.point(v);
        loop.push_back(alone.add_vertex(point(p[0], p[1], p[2])));
    }
    if (not CGAL::Polygon_mesh_processing::triangulate_face(alone.add_face(loop), alone))
        throw mesh_error(
            "face " + std::to_string(face) +
            ": its corners lie on a line, or its sides cross; it cannot be cut into triangles, correct it");
    for (const auto triangle : alone.faces()) {
        std::array<std::uint32_t, 3> numbers{};
        std::size_t i = 0;
        for (const auto v : alone.vertices_around_face(alone.halfedge(triangle)))
            numbers[i++] = corners[std::size_t(v)];
        triangles.push_back(numbers);
    }
}

} // namespace

namespace {

/// Gives triangles and their corners what the faces have from which they were cut.
void cut_attributes(io::mesh_attributes& attributes, const basic_mesh<>& mesh, const basic_mesh<>& triangles,
                    const std::vector<std::size_t>& first)
{
    std::vector<std::size_t> face_of, corner_of;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t t = first[f]; t < first[f + 1]; ++t) {
            face_of.push_back(f);
            for (const auto v : triangles.face(t))
                corner_of.push_back(mesh.topology().first_corner(f) +
                                    std::size_t(std::ranges::find(face, v) - face.begin()));
        }
    }
    const auto take = [](std::vector<io::attribute>& list, const std::vector<std::size_t>& from) {
        for (io::attribute& a : list) {
            std::vector<double> values;
            for (const std::size_t element : from)
                values.push_back(a.values[element]);
            a.values = std::move(values);
        }
    };
    take(attributes.faces, face_of);
    take(attributes.corners, corner_of);
}

} // namespace

control_mesh triangulated(control_mesh control)
{
    const basic_mesh<>& mesh = control.mesh;
    face_list triangles;
    std::vector<std::size_t> first; // triangle of each face
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        first.push_back(triangles.size());
        cut(mesh, f, triangles);
    }
    first.push_back(triangles.size());
    std::vector<std::size_t> holes;
    for (const std::size_t hole : control.tags.holes) {
        if (hole >= mesh.face_count())
            throw mesh_error("hole " + std::to_string(hole) + ": there is no such face; correct the tag");
        for (std::size_t t = first[hole]; t < first[hole + 1]; ++t)
            holes.push_back(t);
    }
    control.tags.holes = std::move(holes);
    basic_mesh<> cut_mesh = make_mesh(mesh.points(), triangles);
    cut_attributes(control.attributes, mesh, cut_mesh, first);
    // It is as many steps old as it was.
    auto topology = cut_mesh.topology();
    control.mesh = {storage<basic_mesh<>::point_type>(cut_mesh.points()), std::move(topology), mesh.generation()};
    return control;
}

} // namespace kith::tool
