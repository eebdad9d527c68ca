// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parametric_faces.hpp"

#include <kith/core/base/affine.hpp>
#include <kith/core/base/error.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/limits/limit_sides.hpp>
#include <kith/limits/unit_normal.hpp>
#include <kith/surface/surface_place.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace kith {

/// The fineness of a tessellation, which satisfies all options at once.
struct tessellation_options {
    /// The least number of segments of each edge of the mesh.
    std::size_t segments = 1;
    /// The largest length of an edge of a triangle.
    double longest_edge = std::numeric_limits<double>::infinity();
    /// The largest distance of the surface from the plane of the triangle that approximates it. At boundaries and sharp
    /// edges it is the distance from the segment. It is measured in the middle of each triangle, edge and segment.
    double chord_error = std::numeric_limits<double>::infinity();
    /// The approximate largest angle between consecutive segments, in radians. It is measured by nine points of an
    /// edge.
    double angle = std::numeric_limits<double>::infinity();
};

namespace detail {

template <class Point>
normal_vector difference(const Point& to, const Point& from)
{
    const auto &a = affine<Point>::load(to), &b = affine<Point>::load(from);
    return {double(a[0] - b[0]), double(a[1] - b[1]), double(a[2] - b[2])};
}

/// Returns the length of the part of a vector that is orthogonal to a direction.
inline double length_across(const normal_vector& a, const normal_vector& direction)
{
    const double square = dot(direction, direction);
    if (square == 0)
        return length_of(a);
    return std::sqrt(std::max(dot(a, a) - dot(a, direction) * dot(a, direction) / square, 0.));
}

/// Returns the number of segments that a curve needs, given some of its points at equal steps.
template <class Point>
double segments_of(std::span<const Point> points, const tessellation_options& options)
{
    double whole_length = 0, bend = 0, turn = 0;
    normal_vector before{};
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const normal_vector step = difference(points[i + 1], points[i]);
        whole_length += length_of(step);
        if (i > 0) {
            const normal_vector change{step[0] - before[0], step[1] - before[1], step[2] - before[2]};
            const normal_vector direction{step[0] + before[0], step[1] + before[1], step[2] + before[2]};
            bend = std::max(bend, length_across(change, direction));
            if (const double product = length_of(step) * length_of(before); product > 0)
                turn += std::acos(std::clamp(dot(step, before) / product, -1., 1.));
        }
        before = step;
    }
    const double curved = bend * double((points.size() - 1) * (points.size() - 1));
    return std::max(
        {1., whole_length / options.longest_edge, turn / options.angle, std::sqrt(curved / (8 * options.chord_error))});
}
/// Rounds up to whole segments. Errors: mesh_error for more segments than an edge may have.
inline std::size_t whole_segments(double segments)
{
    constexpr std::size_t most_segments = 4096;
    if (not(segments <= double(most_segments)))
        throw mesh_error("tessellate: an edge would have more than " + std::to_string(most_segments) +
                         " segments; ask for less");
    return std::size_t(std::ceil(segments));
}

/// The numbers of segments of the curves that faces share, and of the grids within faces.
class tessellation_rates {
public:
    struct of_grid {
        std::size_t u, v;
    };

    std::vector<std::size_t> of_curves;
    std::vector<of_grid> of_faces;

    /// Chooses the numbers by samples of the curves and of lines across the faces. Errors: mesh_error for too many
    /// segments. Cost: that of some hundred evaluations for each face; O(faces) if only `segments` is set.
    template <class Lattices, class Point>
    tessellation_rates(const parametric_faces& faces, Lattices& lattices, std::span<const Point> control,
                       const tessellation_options& options)
        : of_curves(faces.curves().size()), of_faces(faces.faces().size())
    {
        const auto least = [&](bool is_half) {
            return whole_segments(double(is_half ? (options.segments + 1) / 2 : options.segments));
        };
        for (std::size_t c = 0; c < of_curves.size(); ++c)
            of_curves[c] = least(faces.curves()[c].is_half);
        for (std::size_t f = 0; f < of_faces.size(); ++f)
            of_faces[f] = {least(faces.faces()[f].is_sub_face), least(faces.faces()[f].is_sub_face)};
        if (std::isinf(options.longest_edge) and std::isinf(options.chord_error) and std::isinf(options.angle))
            return;
        // The number of a list encodes the number of sides of its faces, and of parts of a side.
        const auto list_of = [](const parametric_face& face) {
            return std::size_t(2 * (face.sides - 3) + face.parts_of_side - 1);
        };
        std::vector<std::vector<std::array<double, 2>>> lists;
        for (const std::size_t sides : {3, 4})
            for (const std::size_t parts_of_side : {1, 2})
                lists.push_back(samples_of(sides, parts_of_side));
        std::vector<typename Lattices::request> requests;
        for (const parametric_face& face : faces.faces())
            requests.push_back({face.origin.face, face.origin.corner, list_of(face)});
        lattices.template for_each<false, Point>(
            requests,
            control,
            requests.size() * lists.back().size(),
            [&](std::size_t list) -> const auto& { return lists[list]; },
            [&](std::size_t f, auto& lattice) {
                const parametric_face& face = faces.faces()[f];
                std::array<normal_vector, samples + 1> points;
                const auto raise = [&](std::size_t line, std::size_t& rate) {
                    const std::size_t first = line * points.size();
                    lattice.evaluate(
                        first, first + points.size(), [&](std::size_t place, const auto& values, std::size_t i) {
                            points[place - first] = values.point(i);
                        });
                    rate = std::max(rate, whole_segments(segments_of(std::span<const normal_vector>(points), options)));
                };
                for (std::size_t q = 0; q < face.parts().size(); ++q)
                    if (const std::size_t c = face.parts()[q].curve;
                        faces.curves()[c].face == f and faces.curves()[c].part == q)
                        raise(q, of_curves[c]);
                for (std::size_t line = face.parts().size(); line * points.size() < lists[list_of(face)].size(); ++line)
                    raise(line,
                          (line - face.parts().size()) % lines_at_once(face.sides) == 1 ? of_faces[f].v
                                                                                        : of_faces[f].u);
                if (face.sides == 3)
                    of_faces[f].u = of_faces[f].v = std::max(of_faces[f].u, of_faces[f].v);
            });
    }

private:
    static constexpr std::size_t samples = 8; // segments of a sampled line

    /// Returns the number of directions of lines across a face.
    static std::size_t lines_at_once(std::size_t sides) { return sides == 3 ? 3 : 2; }
    /// Returns the samples of the parts of the sides of a face, then those of lines across it: along u, along v and, in
    /// a triangle, along its second side.
    static std::vector<std::array<double, 2>> samples_of(std::size_t sides, std::size_t parts_of_side)
    {
        std::vector<std::array<double, 2>> result;
        for (std::size_t q = 0; q < sides * parts_of_side; ++q)
            for (std::size_t i = 0; i <= samples; ++i)
                result.push_back(
                    parameters_on_side(sides,
                                       q / parts_of_side,
                                       (double(q % parts_of_side) + double(i) / samples) / double(parts_of_side)));
        for (const double at : {.125, .375, .625, .875}) {
            const double length = sides == 3 ? 1 - at : 1;
            const std::array<std::array<double, 4>, 3> lines{
                {{0, at, length, 0}, {at, 0, 0, length}, {length, 0, -length, length}}};
            for (std::size_t k = 0; k < lines_at_once(sides); ++k)
                for (std::size_t i = 0; i <= samples; ++i) {
                    const double t = double(i) / samples;
                    const auto& [u, v, by_u, by_v] = lines[k];
                    result.push_back(parameters_within(sides, u + by_u * t, v + by_v * t));
                }
        }
        return result;
    }
};

} // namespace detail

} // namespace kith
