// SPDX-License-Identifier: BSD-3-Clause
#include "drawing.hpp"

#include <kith/picture/color.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kith::viewer {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

point operator-(const point& a, const point& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
point& operator+=(point& a, const point& b)
{
    for (std::size_t i = 0; i < 3; ++i)
        a[i] += b[i];
    return a;
}
point cross(const point& a, const point& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const point& a, const point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double length(const point& a)
{
    return std::sqrt(dot(a, a));
}

/// Returns the normal of a polygon in a frame by Newell's formula; its length is twice the area.
point normal_of(const auto& f, const frame& seen)
{
    point result{};
    for (const auto c : f.corners())
        result += cross(seen(c.v().point()), seen(c.next().v().point()));
    return result;
}

std::array<float, 3> drawn(const point& p)
{
    return {float(p[0]), float(p[1]), float(p[2])};
}

drawn_normal drawn_normal_of(const point& n)
{
    const double scale = 127 / std::fmax(length(n), std::numeric_limits<double>::min());
    const auto byte = [&](double x) { return std::int8_t(std::lround(x * scale)); };
    return {byte(n[0]), byte(n[1]), byte(n[2]), 0};
}

/// Returns the mean of the normals of the faces around each vertex, weighted by their areas.
std::vector<drawn_normal> vertex_normals(const level_type& level, const frame& seen)
{
    std::vector<point> sums(level.vertex_count());
    for (const auto f : level.faces()) {
        const point normal = normal_of(f, seen);
        for (const auto c : f.corners())
            sums[c.v().index()] += normal;
    }
    std::vector<drawn_normal> result(sums.size());
    std::ranges::transform(sums, result.begin(), drawn_normal_of);
    return result;
}

/// Calls function(triangle) with the three corners of each triangle of a face.
template <class Face, class Function>
void for_each_triangle(const Face& f, const Function& function)
{
    const auto first = f.first_corner();
    for (auto c = first.next(); c.next() != first; c = c.next())
        function(std::array{first, c, c.next()});
}

/// Returns a flag for each vertex of a level: true if one of its edges is sharp.
std::vector<bool> vertices_at_sharp_edges(const level_type& level, const creases* sharpness)
{
    std::vector<bool> result(level.vertex_count(), false);
    if (sharpness != nullptr)
        for (const auto& [edge, s] : sharpness->edges()) {
            const auto e = level.edges()[edge];
            result[e.org().index()] = result[e.dst().index()] = true;
        }
    return result;
}

double angle_at(const point& p, const point& a, const point& b)
{
    const point u = a - p, v = b - p;
    return std::atan2(length(cross(u, v)), dot(u, v));
}

/// Returns the Gaussian curvature at each vertex: 2 pi less the angles of its corners, over its share of their faces.
std::vector<double> gaussian_curvature(const level_type& level)
{
    std::vector<double> result(level.vertex_count()), areas(level.vertex_count());
    for (const auto f : level.faces()) {
        const double share = length(normal_of(f, {})) / 2 / double(f.degree());
        for (const auto c : f.corners()) {
            result[c.v().index()] += angle_at(c.v().point(), c.prev().v().point(), c.next().v().point());
            areas[c.v().index()] += share;
        }
    }
    for (const auto v : level.vertices())
        result[v.index()] = v.is_boundary() ? no_value : (2 * std::numbers::pi - result[v.index()]) / areas[v.index()];
    return result;
}

/// Returns the mean curvature at each vertex: a quarter of the sum of length times turn over its edges, over its share
/// of the areas of its faces.
std::vector<double> mean_curvature(const level_type& level)
{
    std::vector<point> normals(level.face_count());
    std::vector<double> turns(level.vertex_count()), areas(level.vertex_count());
    for (const auto f : level.faces()) {
        normals[f.index()] = normal_of(f, {});
        for (const auto c : f.corners())
            areas[c.v().index()] += length(normals[f.index()]) / 2 / double(f.degree());
    }
    for (const auto e : level.edges()) {
        if (e.is_boundary())
            continue;
        const point along = e.dst().point() - e.org().point();
        const point &left = normals[e.lface().index()], &right = normals[e.rface().index()];
        const double turn = std::atan2(dot(cross(right, left), along) / std::fmax(length(along), 1e-300),
                                       dot(left, right));
        for (const auto v : {e.org(), e.dst()})
            turns[v.index()] += turn * length(along) / 4; // half of the edge and half of the turn
    }
    for (const auto v : level.vertices())
        turns[v.index()] = v.is_boundary() ? no_value : turns[v.index()] / areas[v.index()];
    return turns;
}

/// Returns the number of its face of the control mesh for each face of a level, or NaN for the faces of vertices and
/// edges.
std::vector<double> parents_of(const surface& shape, int level)
{
    std::vector<double> result(shape.elements(level).face_count(), no_value);
    for (std::size_t face = 0; face < shape.elements(0).face_count(); ++face)
        for (const auto& [begin, end] : shape.descendants(0, {element_kind::face, face}, level).faces)
            std::fill(result.begin() + std::ptrdiff_t(begin), result.begin() + std::ptrdiff_t(end), double(face));
    return result;
}

std::uint8_t byte_of(float x)
{
    return std::uint8_t(std::lround(std::fmin(std::fmax(x, 0.F), 1.F) * 255));
}

} // namespace

std::vector<drawn_corner> triangles_of(const surface& shape, int level_number, bool is_smooth, const frame& seen)
{
    const level_type& level = shape.elements(level_number);
    const auto normals = is_smooth ? vertex_normals(level, seen) : std::vector<drawn_normal>();
    const std::vector<bool> is_flat = vertices_at_sharp_edges(level, shape.sharpness(level_number));
    std::vector<drawn_corner> result;
    result.reserve(3 * (level.corner_count() - 2 * level.face_count()));
    for (const auto f : level.faces()) {
        const auto normal = [&](std::size_t v) {
            return is_smooth and not is_flat[v] ? normals[v] : drawn_normal_of(normal_of(f, seen));
        };
        for_each_triangle(f, [&](const auto& corners) {
            for (const auto c : corners)
                result.push_back({drawn(seen(c.v().point())), normal(c.v().index())});
        });
    }
    return result;
}

std::vector<std::array<float, 3>> edge_ends(const level_type& level, const frame& seen)
{
    std::vector<std::array<float, 3>> result;
    result.reserve(2 * level.edge_count());
    for (const auto e : level.edges())
        for (const auto v : {e.org(), e.dst()})
            result.push_back(drawn(seen(v.point())));
    return result;
}

shown_values values_of(const surface& shape, int level, coloring by, std::span<const double> given)
{
    switch (by) {
    case coloring::parent: return {parents_of(shape, level)};
    case coloring::face_number:
    case coloring::face_value: {
        shown_values result{parents_of(shape, level)};
        for (double& value : result.values)
            if (std::isfinite(value))
                value = given[std::size_t(value)];
        return result;
    }
    case coloring::vertex_value: return {shape.carry(level, given), true};
    case coloring::gaussian: return {gaussian_curvature(shape.elements(level)), true};
    case coloring::mean: return {mean_curvature(shape.elements(level)), true};
    case coloring::level: return {std::vector<double>(shape.elements(level).face_count(), level)};
    default: return {};
    }
}

std::optional<std::array<double, 2>> range_of(std::span<const double> values, bool is_signed)
{
    std::vector<double> finite;
    for (const double value : values)
        if (std::isfinite(value))
            finite.push_back(is_signed ? std::abs(value) : value);
    if (finite.empty())
        return std::nullopt;
    if (not is_signed) {
        const auto [least, most] = std::ranges::minmax(finite);
        return std::array{least, most};
    }
    const auto at = finite.end() - 1 - std::ptrdiff_t(finite.size() / 20);
    std::ranges::nth_element(finite, at);
    return std::array{-*at, *at};
}

drawn_color color_of(double value, palette colors, std::array<double, 2> range)
{
    if (not std::isfinite(value))
        return {224, 224, 224, 255};
    const auto [least, most] = range;
    const double share = most > least ? (value - least) / (most - least) : .5;
    const picture::color found = colors == palette::numbers ? picture::color_of_number(std::size_t(value))
                                 : colors == palette::signs ? picture::color_of_signed(2 * share - 1)
                                                            : picture::color_of_share(share);
    return {byte_of(found.red), byte_of(found.green), byte_of(found.blue), 255};
}

std::vector<drawn_color> colors_of(const level_type& level, const shown_values& shown, palette colors,
                                   std::array<double, 2> range)
{
    constexpr picture::color plain = picture::gray;
    std::vector<drawn_color> of_values;
    for (const double value : shown.values)
        of_values.push_back(color_of(value, colors, range));
    std::vector<drawn_color> result;
    result.reserve(3 * (level.corner_count() - 2 * level.face_count()));
    for (const auto f : level.faces())
        for_each_triangle(f, [&](const auto& corners) {
            for (const auto c : corners)
                result.push_back(of_values.empty()
                                     ? drawn_color{byte_of(plain.red), byte_of(plain.green), byte_of(plain.blue), 255}
                                     : of_values[shown.are_at_vertices ? c.v().index() : f.index()]);
        });
    return result;
}

std::vector<std::uint32_t> first_triangles(const level_type& level)
{
    std::vector<std::uint32_t> result{0};
    for (const auto f : level.faces())
        result.push_back(result.back() + std::uint32_t(f.degree() - 2));
    return result;
}

std::optional<std::uint32_t> face_at(const level_type& level, const point& from, const point& direction,
                                     const frame& seen)
{
    // Moeller & Trumbore 1997.
    std::optional<std::uint32_t> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const auto f : level.faces())
        for_each_triangle(f, [&](const auto& corners) {
            const point a = seen(corners[0].v().point()), u = seen(corners[1].v().point()) - a,
                        v = seen(corners[2].v().point()) - a;
            const point across = cross(direction, v), offset = from - a, turned = cross(offset, u);
            const double volume = dot(u, across);
            const double s = dot(offset, across) / volume, t = dot(direction, turned) / volume;
            const double distance = dot(v, turned) / volume;
            if (s >= 0 and t >= 0 and s + t <= 1 and
                distance < least) { // false if the ray lies in the triangle's plane
                least = distance;
                nearest = std::uint32_t(f.index());
            }
        });
    return nearest;
}

} // namespace kith::viewer
