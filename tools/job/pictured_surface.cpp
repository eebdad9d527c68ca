// SPDX-License-Identifier: BSD-3-Clause
#include "pictured_surface.hpp"

#include "back_end.hpp"
#include "holes.hpp"
#include "limit_surface.hpp"
#include "surface_places.hpp"

#include <kith/face_varying.hpp>
#include <kith/limits/unit_normal.hpp>
#include <kith/plan.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <variant>

namespace kith::tool {

namespace {

constexpr int finest_level = 12;

/// A level, with the attributes of the control mesh. The last attribute of faces is the number of the control face.
struct pictured_level {
    refined_mesh refined;
    io::mesh_attributes attributes;
};

pictured_level refined(const pictured_job& job, int levels, bool limit)
{
    const control_mesh& control = job.control;
    pictured_level result{{}, control.attributes};
    io::attribute numbers{.name = "face", .values = std::vector<double>(control.mesh.face_count())};
    std::iota(numbers.values.begin(), numbers.values.end(), 0);
    result.attributes.faces.push_back(std::move(numbers));
    refine_request request{.scheme = job.scheme, .levels = levels, .memory = job.memory, .limit = limit};
    request.corner_normals = limit and has_sides(job.scheme);
    request.holes = holes_of(control.tags, control.mesh);
    request.attributes = attribute_fields(result.attributes, control.mesh);
    request.counted = count_of(result.attributes);
    auto start = prepared(job.scheme, control.mesh, request.attributes);
    result.refined = refine_native(std::move(start), request);
    result.attributes = result.refined.attributes.at_level(result.attributes);
    if (not result.refined.holes.empty())
        leave_out_holes(result.refined, result.attributes);
    return result;
}

/// Returns true if the polygons of all levels hide their backs: the control mesh is closed and not turned inside out.
bool hides_backs(const control_mesh& control)
{
    const auto& mesh = control.mesh;
    if (mesh.corner_count() != 2 * mesh.edge_count() or not holes_of(control.tags, mesh).empty())
        return false;
    double volume = 0; // six times that of the cones over the triangles of all faces
    for (const auto face : mesh.faces())
        for (std::size_t i = 2; i < face.size(); ++i) {
            std::array<std::array<double, 3>, 3> p{};
            for (std::size_t k = 0; k < 3; ++k) {
                p[0][k] = mesh.point(face[0])[k] - mesh.point(0)[k];
                p[1][k] = mesh.point(face[i - 1])[k] - mesh.point(0)[k];
                p[2][k] = mesh.point(face[i])[k] - mesh.point(0)[k];
            }
            const auto normal = kith::detail::cross(p[1], p[2]);
            volume += p[0][0] * normal[0] + p[0][1] * normal[1] + p[0][2] * normal[2];
        }
    return volume > 0;
}

pictured_surface pictured(const pictured_job& job, pictured_level level)
{
    pictured_surface result{picture::surface_of(level.refined.mesh), {}, std::move(level.attributes)};
    result.shape.normals.assign(level.refined.normals.begin(), level.refined.normals.end());
    result.shape.corner_normals.assign(level.refined.corner_normals.begin(), level.refined.corner_normals.end());
    result.shape.closed = hides_backs(job.control);
    result.parents = std::move(result.attributes.faces.back().values);
    result.attributes.faces.pop_back();
    return result;
}

/// Returns the first level from `least` on that has enough faces, or the last that is possible.
int fine_level(const pictured_job& job, int least)
{
    const auto& mesh = job.control.mesh;
    const auto levels = std::visit(
        [&](const auto& scheme) {
            return plan_what_fits(count(mesh.topology()), scheme, finest_level, mesh.generation()).levels;
        },
        job.scheme);
    int result = least;
    while (result + 1 < int(levels.size()) and levels[std::size_t(result)].counts.faces < job.enough_faces)
        ++result;
    return result;
}

/// Lines of places on a surface.
struct place_lines {
    std::vector<surface_place> places;
    std::vector<std::array<std::uint32_t, 2>> segments;

    void add(const surface_place& from, const surface_place& to, std::size_t pieces)
    {
        for (std::size_t i = 0; i <= pieces; ++i) {
            const double t = double(i) / double(pieces);
            if (i != 0)
                segments.push_back({std::uint32_t(places.size() - 1), std::uint32_t(places.size())});
            places.push_back({from.face, from.u + t * (to.u - from.u), from.v + t * (to.v - from.v), from.corner});
        }
    }
};

/// Returns the edges of a level of Catmull-Clark or Loop, in the parameters of the faces.
place_lines edges_in_faces(const basic_mesh<>& mesh, const hole_field& holes, bool has_triangles, int level,
                           std::size_t pieces)
{
    place_lines result;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (not holes.empty() and holes[f])
            continue;
        const std::size_t degree = mesh.face(f).size();
        const bool is_polygon = not has_triangles and degree != 4;
        const std::size_t parts = is_polygon ? degree : 1; // each sub-face is a quad of level 1
        const std::size_t count = std::size_t(1) << std::size_t(is_polygon ? std::max(level - 1, 0) : level);
        for (std::size_t part = 0; part < parts; ++part)
            for (std::size_t i = 0; i <= count; ++i) {
                const double t = double(i) / double(count);
                const std::size_t all = std::max<std::size_t>(pieces / count, 1) * count;
                if (is_polygon and level == 0 and i != 0)
                    continue;
                if (has_triangles) {
                    result.add({f, t, 0}, {f, t, 1 - t}, all);
                    result.add({f, 0, t}, {f, 1 - t, t}, all);
                    result.add({f, t, 0}, {f, 0, t}, all);
                } else {
                    result.add({f, t, 0, part}, {f, t, 1, part}, all);
                    result.add({f, 0, t, part}, {f, 1, t, part}, all);
                }
            }
    }
    return result;
}

double square_distance(const picture::point& a, const picture::point& b)
{
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]);
}

/// Returns the edges of a mesh as cubic curves that are perpendicular to the normals at their ends (Vlachos et al.
/// 2001).
picture::lines curved_edges(const refined_mesh& of, bool is_straight)
{
    const picture::lines edges = picture::edges_of(of.mesh);
    picture::lines result;
    const std::size_t pieces = is_straight ? 1 : 8;
    double length = 0;
    for (const auto& [a, b] : edges.segments)
        length += std::sqrt(square_distance(edges.points[a], edges.points[b]));
    constexpr double of_length = .1; // so much of an edge may lie below the surface
    result.lift = edges.segments.empty() ? 0 : of_length * length / double(edges.segments.size());
    for (const auto& [a, b] : edges.segments) {
        const auto &p = edges.points[a], &q = edges.points[b];
        const auto &m = of.normals[a], &n = of.normals[b];
        std::array<double, 2> lift{};
        for (std::size_t k = 0; k < 3; ++k) {
            lift[0] += (q[k] - p[k]) * m[k];
            lift[1] += (p[k] - q[k]) * n[k];
        }
        for (std::size_t i = 0; i <= pieces; ++i) {
            const double t = double(i) / double(pieces), s = 1 - t;
            std::array<double, 3> x{};
            for (std::size_t k = 0; k < 3; ++k) {
                const double first = (2 * p[k] + q[k]) / 3 - (is_straight ? 0 : lift[0] * m[k] / 3);
                const double second = (p[k] + 2 * q[k]) / 3 - (is_straight ? 0 : lift[1] * n[k] / 3);
                x[k] = s * s * s * p[k] + 3 * s * s * t * first + 3 * s * t * t * second + t * t * t * q[k];
            }
            if (i != 0)
                result.segments.push_back(
                    {std::uint32_t(result.points.size() - 1), std::uint32_t(result.points.size())});
            result.points.push_back(x);
        }
    }
    return result;
}

} // namespace

pictured_surface limit_in_picture(const pictured_job& job, int least_level)
{
    return pictured(job, refined(job, fine_level(job, least_level), true));
}

pictured_surface level_in_picture(const pictured_job& job, int level)
{
    pictured_surface result = pictured(job, refined(job, level, false));
    result.level = level;
    return result;
}

pictured_surface curvature_in_picture(const pictured_job& job)
{
    const auto& mesh = job.control.mesh;
    const double triangles = 2 * double(std::max<std::size_t>(mesh.face_count(), 1));
    const auto segments = std::size_t(std::clamp(std::ceil(std::sqrt(double(job.enough_faces) / triangles)), 1., 64.));
    const auto made = tessellate_with(job.scheme, "picture: --color", mesh, {.segments = segments});
    const auto at = locate_with(job.scheme, "picture: --color", mesh, made.places);
    pictured_surface result{picture::surface_of(made.mesh), {}, {}};
    if (not has_sides(job.scheme)) // a vertex on a sharp edge has the normal of one side
        result.shape.normals.assign(made.normals.begin(), made.normals.end());
    result.shape.closed = hides_backs(job.control);
    result.parents.assign(made.faces.begin(), made.faces.end());
    const auto curvatures = curvatures_of(at.evaluate(mesh.points(), derivatives::second));
    result.curvatures.assign(curvatures.begin(), curvatures.end());
    return result;
}

picture::lines wire_in_picture(const pictured_job& job, int level)
{
    if (not has_places(job.scheme)) {
        const bool is_straight = std::visit([]<class Scheme>(const Scheme&) { return kith::detail::is_linear<Scheme>; },
                                            job.scheme);
        return curved_edges(refined(job, level, true).refined, is_straight);
    }
    const auto& mesh = job.control.mesh;
    const auto pieces = std::size_t(1) << std::size_t(std::min(fine_level(job, level), finest_level));
    const bool has_triangles = std::holds_alternative<loop>(job.scheme);
    const place_lines edges = edges_in_faces(mesh, holes_of(job.control.tags, mesh), has_triangles, level, pieces);
    const auto values = locate_with(job.scheme, "picture", mesh, edges.places).evaluate(mesh.points());
    picture::lines result{.points = {values.points.begin(), values.points.end()}, .segments = edges.segments};
    return result;
}

} // namespace kith::tool
