// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "basic_mesh.hpp"
#include "match.hpp"
#include "mesh_report.hpp"

#include <kith/core/base/diagnostics.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <ranges>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// The faces as in a file: vertex numbers, counter-clockwise, face after face.
struct face_list {
    std::vector<std::size_t> first{0}; ///< faces+1: the position of each face in `vertices`
    std::vector<std::size_t> vertices;

    face_list() = default;
    /// Takes the faces from any range of ranges of numbers, e.g. a vector of vectors or of arrays.
    template <std::ranges::input_range Faces>
        requires std::ranges::input_range<std::ranges::range_reference_t<const Faces&>>
    explicit face_list(const Faces& faces)
    {
        for (const auto& face : faces)
            push_back(face);
    }

    [[nodiscard]] std::size_t size() const { return first.size() - 1; }
    [[nodiscard]] std::span<const std::size_t> operator[](std::size_t face) const
    {
        return std::span(vertices).subspan(first[face], first[face + 1] - first[face]);
    }
    template <std::ranges::input_range Face>
    void push_back(const Face& face)
    {
        for (const auto v : face)
            vertices.push_back(static_cast<std::size_t>(v)); // a negative number becomes one that is out of range
        first.push_back(vertices.size());
    }
};

namespace detail {

template <class Point>
bool point_is_finite(const Point& point)
{
    using traits = affine<Point>;
    if constexpr (std::floating_point<typename traits::scalar>) {
        const typename traits::sum value = traits::load(point);
        if constexpr (std::floating_point<typename traits::sum>)
            return std::isfinite(value);
        else if constexpr (std::ranges::range<typename traits::sum>)
            for (const auto& x : value)
                if (not std::isfinite(x))
                    return false;
    }
    return true;
}

template <class Points>
void check_points(const Points& points, mesh_report& report)
{
    std::size_t v = 0;
    for (const auto& point : points) {
        if (not point_is_finite(point))
            report.add_not_finite(v);
        ++v;
    }
}

/// Reports the vertices of a face that do not exist.
void check_indices(std::size_t vertices, const face_list& faces, std::size_t face, mesh_report& report);
/// Throws mesh_error if there are vertices that do not exist.
void require_indices(std::size_t vertices, const face_list& faces, std::size_t first_number);
void check_faces(std::size_t vertices, const face_list& faces, mesh_report& report);
#ifdef KITH_HAS_BODIES
KITH_IN_LIBRARY void check_indices(std::size_t vertices, const face_list& faces, std::size_t face, mesh_report& report)
{
    for (const std::size_t v : faces[face])
        if (v >= vertices)
            report.add(problem::bad_index, [&] {
                return "face " + report.number(face) + ": vertex " + report.number(v) + " does not exist, there are " +
                       std::to_string(vertices) + "; correct the index";
            });
}
KITH_IN_LIBRARY void require_indices(std::size_t vertices, const face_list& faces, std::size_t first_number)
{
    mesh_report report(first_number);
    for (std::size_t f = 0; f < faces.size(); ++f)
        check_indices(vertices, faces, f, report);
    report.require_ok();
}
KITH_IN_LIBRARY void check_faces(std::size_t vertices, const face_list& faces, mesh_report& report)
{
    if (faces.size() == 0)
        report.add_no_faces();
    std::vector<std::size_t> sorted;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto face = faces[f];
        check_indices(vertices, faces, f, report);
        if (face.size() < 3)
            report.add_few_corners(f, face.size());
        sorted.assign(face.begin(), face.end());
        std::ranges::sort(sorted);
        if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
            report.add_repeated_corner(f, *twice);
    }
}
#endif

/// Copies the values at the corners of a face, beginning with the corner of the smallest vertex.
template <class Values, class Out>
void from_smallest_vertex(std::span<const std::size_t> face, const Values& at_corners, Out out)
{
    std::ranges::rotate_copy(at_corners, at_corners.begin() + (std::ranges::min_element(face) - face.begin()), out);
}

/// Returns the connectivity of the faces, each from its smallest vertex on, without edges.
template <std::unsigned_integral Index>
connectivity<Index> connect_faces(std::size_t vertices, const face_list& faces)
{
    connectivity<Index> t;
    t.vertices = vertices;
    const std::size_t degree = faces.size() == 0 ? 0 : faces[0].size();
    bool uniform = degree == 3 or degree == 4;
    for (std::size_t f = 0; uniform and f < faces.size(); ++f)
        uniform = faces[f].size() == degree;
    t.allocate_faces(faces.size(), uniform ? int(degree) : 0, [&](std::size_t f) { return faces[f].size(); });
    for (std::size_t f = 0; f < faces.size(); ++f)
        from_smallest_vertex(faces[f], faces[f], t.corner_vertex.begin() + faces.first[f]);
    return t;
}
#ifdef KITH_COMPILED_SCHEMES
extern template connectivity<std::uint32_t> connect_faces(std::size_t, const face_list&);
extern template connectivity<std::size_t> connect_faces(std::size_t, const face_list&);
#endif

} // namespace detail

/// Returns a report of everything that is wrong with a list of points and faces. It is empty if they form a mesh. In
/// messages, vertices and faces are numbered from `first_number` on.
/// Cost: O(corners log valence) time, O(corners) memory.
template <std::ranges::input_range Points>
mesh_report validate(const Points& points, const face_list& faces, std::size_t first_number = 0)
{
    mesh_report report(first_number);
    const auto vertices = static_cast<std::size_t>(std::ranges::distance(points));
    detail::check_points(points, report);
    detail::check_faces(vertices, faces, report);
    if (not report.has(problem::bad_index) and not report.has(problem::degenerate_face)) {
        auto topology = detail::connect_faces<std::size_t>(vertices, faces);
        match(topology, report);
    }
    return report;
}

/// Returns the native mesh of these points and faces. Vertices and faces keep their numbers; each face is stored from
/// its smallest vertex on, and edges are numbered by their ends. So the order of the faces in a file, or of the corners
/// of a face, does not change a bit of any refined point.
/// Errors: mesh_error with everything that `validate` finds, with elements numbered from `first_number` on. Cost: that
/// of `validate`.
template <std::unsigned_integral Index = std::uint32_t, std::ranges::sized_range Points>
    requires affine_value<std::ranges::range_value_t<Points>>
auto make_mesh(const Points& points, const face_list& faces, std::size_t first_number = 0)
{
    using point = std::ranges::range_value_t<Points>;
    mesh_report report(first_number);
    const std::size_t vertices = std::ranges::size(points);
    detail::check_points(points, report);
    detail::check_faces(vertices, faces, report);
    report.require_ok();
    if (vertices >= connectivity<Index>::none or faces.vertices.size() >= connectivity<Index>::none / 2)
        throw mesh_error("the mesh has " + std::to_string(vertices) + " vertices and " +
                         std::to_string(faces.vertices.size()) + " corners, more than a " +
                         std::to_string(8 * sizeof(Index)) +
                         "-bit index can number; use basic_mesh<Point, std::uint64_t>");
    auto topology = detail::connect_faces<Index>(vertices, faces);
    match(topology, report);
    report.require_ok();
    storage<point> copy(vertices);
    std::ranges::copy(points, copy.begin());
    return basic_mesh<point, Index>(std::move(copy), std::move(topology));
}

/// Returns the native mesh of points and faces from a range of ranges, e.g. std::vector<std::vector<int>>.
template <std::unsigned_integral Index = std::uint32_t, std::ranges::sized_range Points, std::ranges::input_range Faces>
    requires(not std::same_as<Faces, face_list> and affine_value<std::ranges::range_value_t<Points>>)
auto make_mesh(const Points& points, const Faces& faces)
{
    return make_mesh<Index>(points, face_list(faces));
}
/// Reports at compile time that points of this type cannot be combined.
template <std::unsigned_integral Index = std::uint32_t, std::ranges::sized_range Points, class Faces>
    requires(not affine_value<std::ranges::range_value_t<Points>>)
auto make_mesh(const Points&, const Faces&, std::size_t = 0)
{
    static_cast<void>(diagnostics::point_without_affine<(sizeof(Points) > 0)>());
    return basic_mesh<std::array<double, 3>, Index>();
}

/// Returns values at the corners of faces in the order that `on_corners` takes: that of the mesh which `make_mesh`
/// makes of these faces. There each face begins with its smallest vertex. Errors: mesh_error unless there is one value
/// per corner. Cost: O(corners).
template <std::ranges::contiguous_range Values>
auto values_at_corners(const face_list& faces, const Values& values)
{
    if (std::ranges::size(values) != faces.vertices.size())
        throw mesh_error("the faces have " + std::to_string(faces.vertices.size()) + " corners, " +
                         std::to_string(std::ranges::size(values)) + " values were given; give one per corner");
    std::vector<std::ranges::range_value_t<Values>> result(faces.vertices.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
        detail::from_smallest_vertex(faces[f],
                                     std::span(values).subspan(faces.first[f], faces[f].size()),
                                     result.begin() + std::ptrdiff_t(faces.first[f]));
    return result;
}
template <std::ranges::input_range Faces, std::ranges::contiguous_range Values>
    requires(not std::same_as<Faces, face_list>)
auto values_at_corners(const Faces& faces, const Values& values)
{
    return values_at_corners(face_list(faces), values);
}

} // namespace kith
