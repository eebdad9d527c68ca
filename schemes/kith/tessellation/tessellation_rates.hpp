// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parametric_faces.hpp"

#include <kith/base/affine.hpp>
#include <kith/base/error.hpp>
#include <kith/base/storage.hpp>
#include <kith/limit/limit_sides.hpp>
#include <kith/limit/unit_normal.hpp>
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

/// The fineness of a tessellation. All that is asked for holds.
struct tessellation_options {
    /// The least number of segments of each edge of the mesh.
    std::size_t segments = 1;
    /// The largest length of an edge of a triangle.
    double longest_edge = std::numeric_limits<double>::infinity();
    /// The largest distance of the surface to the plane of the triangle that stands for it and, at boundaries and sharp
    /// edges, to the segment. Measured in the middle of each triangle, edge and segment.
    double chord_error = std::numeric_limits<double>::infinity();
    /// About the largest angle between segments that follow each other, in radians. Measured by nine points of an edge.
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

/// Returns the segments that a curve needs, of which some points are given at equal steps.
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
/// Rounds up to whole segments. Errors: mesh_error for more than an edge may have.
inline std::size_t whole_segments(double segments)
{
    constexpr std::size_t most_segments = 4096;
    if (not(segments <= double(most_segments)))
        throw mesh_error("tessellate: an edge would have more than " + std::to_string(most_segments) +
                         " segments; ask for less");
    return std::size_t(std::ceil(segments));
}

/// Returns the points of a surface at some places.
template <class Locator, class Point>
storage<Point> points_at(Locator& surface, std::span<const Point> control, const std::vector<surface_place>& places)
{
    constexpr std::size_t at_once = std::size_t(1) << 18; // so that located places take some megabytes
    storage<Point> result(places.size());
    for (std::size_t first = 0; first < places.size(); first += at_once) {
        const auto some = std::span(places).subspan(first, std::min(at_once, places.size() - first));
        const auto made = surface.locate(some).evaluate(control).points;
        std::ranges::copy(made, result.begin() + first);
    }
    return result;
}

/// Returns the place at u and v of a face, which rounding may have brought out of it.
inline surface_place place_in(const parametric_face& face, double u, double v)
{
    surface_place place = face.origin;
    place.u = std::clamp(u, 0., 1.);
    place.v = std::clamp(v, 0., face.sides.size() == 3 ? 1 - place.u : 1.);
    return place;
}

/// The numbers of segments of the curves that faces share, and of the grids within faces.
class tessellation_rates {
public:
    struct of_grid {
        std::size_t u, v;
    };

    std::vector<std::size_t> of_curves;
    std::vector<of_grid> of_faces;

    /// Chooses the numbers by samples of the curves and of lines across the faces. The faces must outlive this object.
    /// Errors: mesh_error for too many segments. Cost: that of some hundred evaluations for each face; O(faces) if
    /// segments alone are asked for.
    template <class Locator, class Point>
    tessellation_rates(const parametric_faces& faces, Locator& surface, std::span<const Point> control,
                       const tessellation_options& options)
        : of_curves(faces.curves().size()), of_faces(faces.faces().size()), faces_(faces)
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
        for (std::size_t c = 0; c < of_curves.size(); ++c) {
            for (std::size_t i = 0; i <= samples; ++i)
                places_.push_back(faces.place_on(faces.curves()[c], double(i) / samples));
            rates_.push_back(&of_curves[c]);
        }
        for (std::size_t f = 0; f < of_faces.size(); ++f)
            add_lines_across(f);
        const auto points = points_at(surface, control, places_);
        for (std::size_t line = 0; line < rates_.size(); ++line) {
            const std::span<const Point> of_line(points.data() + line * (samples + 1), samples + 1);
            *rates_[line] = std::max(*rates_[line], whole_segments(segments_of(of_line, options)));
        }
        for (std::size_t f = 0; f < of_faces.size(); ++f)
            if (faces.faces()[f].sides.size() == 3)
                of_faces[f].u = of_faces[f].v = std::max(of_faces[f].u, of_faces[f].v);
        places_.clear();
        rates_.clear();
    }

private:
    static constexpr std::size_t samples = 8; // segments of a line that is looked at

    /// Adds the samples of lines across a face.
    void add_lines_across(std::size_t f)
    {
        const parametric_face& face = faces_.faces()[f];
        const bool is_triangle = face.sides.size() == 3;
        const auto add_line = [&](double u, double v, double by_u, double by_v, std::size_t& rate) {
            for (std::size_t i = 0; i <= samples; ++i) {
                const double t = double(i) / samples;
                places_.push_back(place_in(face, u + by_u * t, v + by_v * t));
            }
            rates_.push_back(&rate);
        };
        for (const double at : {.125, .375, .625, .875}) {
            const double length = is_triangle ? 1 - at : 1;
            add_line(0, at, length, 0, of_faces[f].u);
            add_line(at, 0, 0, length, of_faces[f].v);
            if (is_triangle)
                add_line(length, 0, -length, length, of_faces[f].u);
        }
    }

    const parametric_faces& faces_;
    std::vector<surface_place> places_; // of all samples
    std::vector<std::size_t*> rates_;   // of the line of each
};

} // namespace detail

} // namespace kith
