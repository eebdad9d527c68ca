// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tessellation_numbers.hpp"

#include <kith/surface/surface_locator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// The factors, at least 1, by which the rates of faces and of curves must be raised. Errors and lengths then become as
/// small as the options ask for.
class tessellation_measures {
public:
    tessellation_measures(const tessellation_numbers& numbers, const parametric_faces& faces,
                          const tessellation_options& options)
        : of_faces(faces.faces().size(), 1)
        , of_curves(faces.curves().size(), 1)
        , numbers_(numbers)
        , faces_(faces)
        , options_(options)
    {
    }

    std::vector<double> of_faces, of_curves;

    /// Measures the distance of the surface from each triangle, and the length of edges. Cost: that of evaluating a
    /// place for each triangle and for each edge.
    template <class Lattices, class Point>
    void measure_triangles(Lattices& lattices, std::span<const typename Lattices::request> requests,
                           std::span<const Point> control, const storage<normal_vector>& vertices)
    {
        lattices.template for_each<false, Point>(
            requests,
            control,
            3 * numbers_.triangles(),
            [&](std::size_t pattern) { return middles_of(numbers_.pattern(pattern)); },
            [&](std::size_t f, auto& lattice) {
                const triangle_pattern& pattern = numbers_.pattern(numbers_.pattern_of(f));
                std::vector<tessellation_numbers::index> vertex;
                numbers_.list_vertices(f, vertex);
                std::vector<normal_vector> middles(middles_in(pattern));
                lattice.evaluate(0, middles.size(), [&](std::size_t place, const auto& values, std::size_t i) {
                    middles[place] = values.point(i);
                });
                for (std::size_t t = 0; t < pattern.triangles(); ++t) {
                    const auto corner = [&](std::size_t k) -> const normal_vector& {
                        return vertices[vertex[pattern.corner_vertex()[3 * t + k % 3]]];
                    };
                    const auto normal = unit_normal(difference(corner(1), corner(0)), difference(corner(2), corner(0)));
                    const auto note_distance = [&](const normal_vector& on_surface) {
                        const normal_vector from_corner = difference(on_surface, corner(0));
                        note_error(normal ? std::abs(dot(from_corner, *normal)) : length_of(from_corner), of_faces[f]);
                    };
                    note_distance(middles[t]);
                    for (std::size_t k = 0; k < 3; ++k) {
                        note_distance(middles[pattern.triangles() + edge_of(pattern, 3 * t + k)]);
                        note_length(length_of(difference(corner(k + 1), corner(k))), of_faces[f]);
                    }
                }
            });
    }
    /// Measures the distance of boundaries and sharp edges from their segments.
    template <class Locator, class Point>
    void measure_walls(Locator& surface, std::span<const Point> control, const tessellation_rates& rates)
    {
        std::vector<surface_place> places;
        std::vector<std::size_t> curve_of;
        for (std::size_t c = 0; c < of_curves.size(); ++c)
            for (std::size_t i = 0; faces_.curves()[c].is_wall and i <= 2 * rates.of_curves[c]; ++i) {
                const shared_curve& curve = faces_.curves()[c];
                const surface_place origin = faces_.faces()[curve.face].origin;
                const auto [u, v] = faces_.parameters_on(curve, double(i) / double(2 * rates.of_curves[c]));
                places.push_back({origin.face, u, v, origin.corner});
                curve_of.push_back(c);
            }
        const auto points = surface.locate(places).evaluate(control).points;
        for (std::size_t i = 0; i + 2 < points.size(); ++i)
            if (curve_of[i] == curve_of[i + 2]) // every other triple is a segment; the triples between are no worse
                note_error(length_across(difference(points[i + 1], points[i]), difference(points[i + 2], points[i])),
                           of_curves[curve_of[i]]);
    }

private:
    /// Returns the number of the edge of a corner: edges on the sides come first.
    static std::size_t edge_of(const triangle_pattern& pattern, std::size_t corner)
    {
        const std::size_t halfedge = pattern.corner_halfedge()[corner], on_sides = pattern.vertices_on_sides();
        return halfedge < on_sides ? halfedge : on_sides + (halfedge - on_sides) / 2;
    }
    static std::size_t middles_in(const triangle_pattern& pattern)
    {
        return pattern.triangles() + pattern.vertices_on_sides() + pattern.edges_inside();
    }
    /// Returns the parameters of the middles of the triangles and of the edges of a pattern.
    static std::vector<std::array<double, 2>> middles_of(const triangle_pattern& pattern)
    {
        std::vector<std::array<double, 2>> result(middles_in(pattern));
        const auto at = [&](std::size_t corner) { return pattern.parameters()[pattern.corner_vertex()[corner]]; };
        for (std::size_t t = 0; t < pattern.triangles(); ++t) {
            const auto a = at(3 * t), b = at(3 * t + 1), c = at(3 * t + 2);
            const auto within = [&](double u, double v) { return parameters_within(pattern.rates().sides, u, v); };
            result[t] = within((a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3);
            const auto add_edge = [&](std::size_t corner, const auto& from, const auto& to) {
                result[pattern.triangles() + edge_of(pattern, corner)] = within((from[0] + to[0]) / 2,
                                                                                (from[1] + to[1]) / 2);
            };
            add_edge(3 * t, a, b);
            add_edge(3 * t + 1, b, c);
            add_edge(3 * t + 2, c, a);
        }
        return result;
    }
    /// Raises a factor to the value that an error asks for.
    void note_error(double error, double& factor) const
    {
        if (error > options_.chord_error)
            factor = std::max(factor, std::min(1.1 * std::sqrt(error / options_.chord_error), 3.));
    }
    void note_length(double length, double& factor) const
    {
        if (length > options_.longest_edge)
            factor = std::max(factor, 1.05 * length / options_.longest_edge);
    }

    const tessellation_numbers& numbers_;
    const parametric_faces& faces_;
    const tessellation_options& options_;
};

} // namespace kith::detail
