// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/dense_numbers.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/core/mesh/mesh_traits.hpp>
#include <kith/core/repair/mend_faces.hpp>
#include <kith/core/repair/repair_options.hpp>
#include <kith/core/repair/repair_report.hpp>
#include <kith/core/repair/weld_points.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <ranges>
#include <utility>
#include <vector>

namespace kith {

/// The points and faces after `repair`, and the elements from which they come.
template <class Point>
struct repaired {
    static constexpr std::size_t none = std::size_t(-1);

    std::vector<Point> points;
    face_list faces;
    std::vector<std::size_t> from_vertex; ///< by new vertex: the old vertex whose point and values it has
    std::vector<std::size_t> from_face;   ///< by new face: the old face
    std::vector<std::size_t> from_corner; ///< by new corner, in the order of `faces.vertices`: the old corner
    std::vector<std::size_t> vertex_at;   ///< by old corner: the new vertex there, or `none` if its face is left out
    repair_report report;                 ///< what was done, in the numbers of the input
};

namespace detail {

/// Throws mesh_error unless the distance is a finite number of 0 or more.
inline void require_distance(double tolerance)
{
    if (not(tolerance >= 0) or std::isinf(tolerance))
        throw mesh_error("the distance within which vertices are joined is not a finite number of 0 or more; give one");
}

} // namespace detail

/// Changes points and faces as the options allow, so that `make_mesh` takes them: `weld`, `drop`, `orient` and `split`
/// in this order, each only if it is chosen. `make_mesh` refuses what is still wrong then. The result depends on the
/// order of vertices and faces and on nothing else. Vertices and faces that stay keep their order; new vertices come
/// last. The maps name the old element of each new one, so that values and creases can be carried along.
/// Errors: mesh_error for vertices that do not exist, in numbers from `first_number` on, and for a `weld` that is no
/// distance. Cost: O(corners log corners).
template <std::ranges::sized_range Points>
auto repair(const Points& points, const face_list& faces, const repair_options& options, std::size_t first_number = 0)
{
    using point = std::ranges::range_value_t<Points>;
    detail::require_indices(std::ranges::size(points), faces, first_number);
    detail::point_coordinates coordinates;
    if (options.weld) {
        detail::require_distance(*options.weld);
        coordinates = detail::coordinates_of(points);
    }
    auto mended = detail::mend_faces(std::ranges::size(points), faces, coordinates, options, first_number);
    repaired<point> result{{},
                           std::move(mended.faces),
                           std::move(mended.from_vertex),
                           std::move(mended.from_face),
                           std::move(mended.from_corner),
                           std::move(mended.vertex_at),
                           std::move(mended.report)};
    result.points.reserve(result.from_vertex.size());
    for (const std::size_t v : result.from_vertex)
        result.points.push_back(*(std::ranges::begin(points) + std::ptrdiff_t(v)));
    return result;
}

/// Repairs faces that are given as a range of ranges, e.g. std::vector<std::vector<int>>.
template <std::ranges::sized_range Points, std::ranges::input_range Faces>
    requires(not std::same_as<Faces, face_list>)
auto repair(const Points& points, const Faces& faces, const repair_options& options)
{
    return repair(points, face_list(faces), options);
}

/// Repairs the faces of a mesh, such as a mesh of CGAL with a vertex that has several fans. The report names elements
/// by their places among the elements that are not removed. A face without half-edges, or whose half-edges do not lead
/// back to the first, has no corners here. `make_mesh` makes a mesh of the result, `convert` a mesh of another type.
template <mesh M>
auto repair(const M& mesh, const repair_options& options)
{
    using traits = mesh_traits<M>;
    const dense_numbers<M, typename traits::vertex> numbers(mesh, traits::vertices(mesh), traits::vertex_bound(mesh));
    std::vector<typename traits::point> points;
    for (const auto v : traits::vertices(mesh))
        points.push_back(traits::point_of(mesh, v));
    face_list faces;
    std::vector<std::size_t> corners;
    for (const auto f : traits::faces(mesh)) {
        corners.clear();
        if (not detail::for_each_side(
                mesh, f, [&](const auto& h) { corners.push_back(numbers.number(mesh, traits::source(mesh, h))); }))
            corners.clear();
        faces.push_back(corners);
    }
    return repair(points, faces, options);
}

/// Returns the vertices that `repair` would join within a distance, each with the vertex that it is joined with. In
/// most files such vertices at the boundary are cracks. Errors: as `repair`. Cost: O(corners log corners).
template <std::ranges::sized_range Points>
std::vector<std::pair<std::size_t, std::size_t>> coinciding_vertices(const Points& points, const face_list& faces,
                                                                     double tolerance = 0)
{
    detail::require_indices(std::ranges::size(points), faces, 0);
    detail::require_distance(tolerance);
    return detail::pairs_to_weld(faces, detail::coordinates_of(points), tolerance);
}

/// Returns a distance that covers rounding to floats: a millionth of the diagonal of the box around the points.
template <std::ranges::input_range Points>
double rounding_distance(const Points& points)
{
    return 1e-6 * detail::diagonal_of(detail::coordinates_of(points));
}

} // namespace kith
