// SPDX-License-Identifier: BSD-3-Clause
#include "triangulate.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/make_mesh.hpp>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

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

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using point = kernel::Point_3;
using polygon = CGAL::Surface_mesh<point>;

/// The traits of a triangulation in a plane whose vertices store the number of their corner of the face.
using plane = CGAL::Projection_traits_3<kernel>;
using plane_vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, plane>;
using plane_face = CGAL::Constrained_triangulation_face_base_2<
    plane, CGAL::Triangulation_face_base_with_info_2<bool, plane>>; // whether it lies outside
using plane_triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    plane, CGAL::Triangulation_data_structure_2<plane_vertex, plane_face>, CGAL::No_constraint_intersection_tag>;

using triangle = std::array<std::size_t, 3>; ///< the numbers of three corners

/// Marks the triangles that can be reached from the infinite ones without crossing a side of the face.
void mark_outside(plane_triangulation& all)
{
    for (const auto& face : all.all_face_handles())
        face->info() = false;
    std::vector<plane_triangulation::Face_handle> reached{all.infinite_face()};
    all.infinite_face()->info() = true;
    while (not reached.empty()) {
        const auto face = reached.back();
        reached.pop_back();
        for (int side = 0; side < 3; ++side)
            if (const auto next = face->neighbor(side); not face->is_constrained(side) and not next->info()) {
                next->info() = true;
                reached.push_back(next);
            }
    }
}

/// Returns the triangles of a face with many corners, or nothing if its sides cross. They are those of CGAL's
/// triangulate_face, except where corners lie on a circle, but the time is not quadratic. Cost: O(n log n), except for
/// adversarial positions of the corners.
std::vector<triangle> large_face(const std::vector<point>& corners, const kernel::Vector_3& normal)
{
    std::vector<std::pair<point, std::size_t>> numbered;
    for (std::size_t i = 0; i < corners.size(); ++i)
        numbered.emplace_back(corners[i], i);
    plane_triangulation all{plane(normal)};
    all.insert(numbered.begin(), numbered.end());
    if (all.number_of_vertices() != corners.size() or all.dimension() != 2)
        return {};
    std::vector<plane_triangulation::Vertex_handle> vertices(corners.size());
    for (const auto vertex : all.finite_vertex_handles())
        vertices[vertex->info()] = vertex;
    try {
        for (std::size_t i = 0; i < corners.size(); ++i)
            all.insert_constraint(vertices[i], vertices[(i + 1) % corners.size()]);
    } catch (const plane_triangulation::Intersection_of_constraints_exception&) {
        return {};
    }
    mark_outside(all);
    std::vector<triangle> result;
    for (const auto face : all.finite_face_handles())
        if (not face->info())
            result.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    std::ranges::sort(result);
    return result;
}

/// Returns the triangles of a face, or nothing if it has no plane or its sides cross.
std::vector<triangle> triangles_of(const std::vector<point>& corners)
{
    namespace pmp = CGAL::Polygon_mesh_processing;
    constexpr std::size_t many = 1000; // so that ordinary faces have the triangles that triangulate_face gives
    polygon alone;
    std::vector<polygon::Vertex_index> loop;
    for (const point& p : corners)
        loop.push_back(alone.add_vertex(p));
    const auto face = alone.add_face(loop);
    if (corners.size() > many) {
        const kernel::Vector_3 normal = pmp::compute_face_normal(face, alone);
        return normal == CGAL::NULL_VECTOR ? std::vector<triangle>() : large_face(corners, normal);
    }
    std::vector<triangle> result;
    if (not pmp::triangulate_face(face, alone))
        return result;
    for (const auto part : alone.faces()) {
        auto& numbers = result.emplace_back();
        std::size_t i = 0;
        for (const auto v : alone.vertices_around_face(alone.halfedge(part)))
            numbers[i++] = std::size_t(v);
    }
    return result;
}

/// Appends the triangles of a face of a mesh.
void cut(const basic_mesh<>& mesh, std::size_t face, face_list& triangles)
{
    const std::span<const std::uint32_t> corners = mesh.face(face);
    if (corners.size() == 3) {
        triangles.push_back(corners);
        return;
    }
    std::vector<point> places;
    for (const auto v : corners)
        places.emplace_back(mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]);
    const auto parts = triangles_of(places);
    if (parts.size() + 2 != corners.size())
        throw mesh_error(
            "face " + std::to_string(face) +
            ": its corners lie on a line, or its sides cross; it cannot be cut into triangles, correct it");
    for (const auto& part : parts)
        triangles.push_back(std::array{corners[part[0]], corners[part[1]], corners[part[2]]});
}

/// Copies the values of faces and their corners to the triangles that were cut from them.
void cut_attributes(io::mesh_attributes& attributes, const basic_mesh<>& mesh, const basic_mesh<>& triangles,
                    const std::vector<std::size_t>& first)
{
    std::vector<std::size_t> face_of, corner_of;
    std::vector<std::size_t> corner_at(mesh.vertex_count()); // of each vertex of the face
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::size_t corner = mesh.topology().first_corner(f);
        for (const auto v : mesh.face(f))
            corner_at[v] = corner++;
        for (std::size_t t = first[f]; t < first[f + 1]; ++t) {
            face_of.push_back(f);
            for (const auto v : triangles.face(t))
                corner_of.push_back(corner_at[v]);
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
