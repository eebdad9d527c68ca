// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_triangles.hpp"
#include "tessellation_rates.hpp"

#include <kith/base/error.hpp>
#include <kith/level/lift.hpp>
#include <kith/limit/unit_normal.hpp>
#include <kith/mesh/make_mesh.hpp>
#include <kith/surface/curvature.hpp>
#include <kith/surface/surface_locator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// Triangles whose vertices lie on a limit surface.
template <class Point>
struct tessellation {
    basic_mesh<Point> mesh;
    std::vector<surface_place> places{}; ///< of the vertices
    storage<normal_vector> normals{};    ///< at the vertices; where faces meet sharply, that of one of them
    std::vector<std::size_t> faces{};    ///< of the control mesh, for each triangle the one that it lies in
    located_places at{};                 ///< the places, for other values at the control vertices
};

namespace detail {

template <class Point, parametric_scheme Scheme, std::unsigned_integral Index>
class tessellator {
    using number = affine<Point>;

public:
    /// Precondition: the options are positive numbers.
    tessellator(const basic_mesh<Point, Index>& control, const Scheme& scheme, const tessellation_options& options)
        : control_(control)
        , options_(options)
        , surface_(control, scheme)
        , faces_(parametric_faces::of(control.topology(), scheme))
        , rates_(faces_, surface_, std::span<const Point>(control.points()), options)
    {
    }

    /// Errors: mesh_error where more than most_segments are needed.
    tessellation<Point> make()
    {
        constexpr int most_rounds = 12;
        for (int round = 0;; ++round) {
            build();
            if (not split_repeated_edges() and not(is_measured() and raise_rates()))
                break;
            if (round == most_rounds)
                throw mesh_error("tessellate: " + std::to_string(most_rounds) +
                                 " rounds do not reach this chord error or edge length; ask for a larger one");
        }
        return finish();
    }

private:
    [[nodiscard]] bool is_measured() const
    {
        return std::isfinite(options_.chord_error) or std::isfinite(options_.longest_edge);
    }
    /// Makes vertices and triangles by the rates.
    void build()
    {
        places_.clear();
        triangles_.clear();
        parameters_.clear();
        face_of_.clear();
        std::vector<std::size_t> corner(faces_.corners(), 0);
        const auto add = [&](const surface_place& place) {
            places_.push_back(place);
            return places_.size() - 1;
        };
        std::vector<const shared_curve*> curve_at(corner.size(), nullptr);
        for (const shared_curve& curve : faces_.curves())
            for (const std::size_t end : {curve.first, curve.last})
                if (curve_at[end] == nullptr)
                    curve_at[end] = &curve;
        for (std::size_t x = 0; x < corner.size(); ++x) // vertices of the mesh come first, in their order
            if (curve_at[x] != nullptr)
                corner[x] = add(faces_.place_on(*curve_at[x], x == curve_at[x]->first ? 0 : 1));
        corners_ = places_.size();
        std::vector<std::size_t> first_on_curve;
        for (std::size_t c = 0; c < rates_.of_curves.size(); ++c) {
            first_on_curve.push_back(places_.size());
            for (std::size_t i = 1; i < rates_.of_curves[c]; ++i)
                add(faces_.place_on(faces_.curves()[c], double(i) / double(rates_.of_curves[c])));
        }
        for (std::size_t f = 0; f < faces_.faces().size(); ++f)
            build_face(f, corner, first_on_curve, add);
    }
    template <class Add>
    void build_face(std::size_t f, std::span<const std::size_t> corner, std::span<const std::size_t> first_on_curve,
                    const Add& add)
    {
        const parametric_face& face = faces_.faces()[f];
        std::vector<std::vector<face_vertex>> sides(face.sides.size());
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const double parts = double(face.sides[k].size());
            const auto append = [&](std::size_t vertex, double t) {
                const surface_place place = place_on_side(face, k, t);
                sides[k].push_back({place.u, place.v, vertex});
            };
            for (std::size_t p = 0; p < face.sides[k].size(); ++p) {
                const auto [c, is_reversed] = face.sides[k][p];
                const shared_curve& curve = faces_.curves()[c];
                const std::size_t n = rates_.of_curves[c];
                append(corner[is_reversed ? curve.last : curve.first], double(p) / parts);
                for (std::size_t i = 1; i < n; ++i)
                    append(first_on_curve[c] + (is_reversed ? n - i : i) - 1,
                           (double(p) + double(i) / double(n)) / parts);
            }
            append(corner[face.corners[(k + 1) % sides.size()]], 1);
        }
        const face_triangles made(sides, rates_.of_faces[f].u, rates_.of_faces[f].v, [&](double u, double v) {
            return add(place_in(face, u, v));
        });
        for (const auto& [a, b, c] : made.triangles()) {
            triangles_.push_back({std::uint32_t(a.number), std::uint32_t(b.number), std::uint32_t(c.number)});
            if (is_measured())
                parameters_.push_back({{{a.u, a.v}, {b.u, b.v}, {c.u, c.v}}});
        }
        face_of_.resize(triangles_.size(), f);
    }

    /// Cuts faces that are not cut and so would have an edge in common with two others. Returns whether there are any.
    bool split_repeated_edges()
    {
        struct edge {
            std::array<std::size_t, 2> ends;
            std::size_t face;
        };
        std::vector<edge> edges;
        for (std::size_t t = 0; t < triangles_.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [a, b] = std::minmax(triangles_[t][k], triangles_[t][(k + 1) % 3]);
                if (b < corners_)
                    edges.push_back({{a, b}, face_of_[t]});
            }
        std::ranges::sort(edges, {}, &edge::ends);
        bool are_split = false;
        for (std::size_t i = 0; i + 2 < edges.size(); ++i)
            if (edges[i].ends == edges[i + 2].ends)
                for (std::size_t k = i; k < i + 3; ++k) {
                    are_split = true;
                    auto& [u, v] = rates_.of_faces[edges[k].face];
                    u = std::max<std::size_t>(u, 2);
                    v = std::max<std::size_t>(v, 2);
                    for (const auto& side : faces_.faces()[edges[k].face].sides)
                        for (const part_of_side& part : side)
                            rates_.of_curves[part.curve] = std::max<std::size_t>(rates_.of_curves[part.curve], 2);
                }
        return are_split;
    }

    /// Measures how far the surface is from each triangle, and from segments of boundaries and sharp edges. Raises the
    /// rates where this is too far, or an edge too long, and returns whether there are such faces.
    bool raise_rates()
    {
        std::vector<double> of_faces(rates_.of_faces.size(), 1), of_curves(rates_.of_curves.size(), 1); // factors
        measure_triangles(of_faces);
        if (std::isfinite(options_.chord_error))
            measure_walls(of_curves);
        const auto raised = [](std::size_t rate, double factor) { return whole_segments(factor * double(rate)); };
        for (std::size_t f = 0; f < of_faces.size(); ++f) {
            auto& [u, v] = rates_.of_faces[f];
            u = raised(u, of_faces[f]);
            v = raised(v, of_faces[f]);
            for (const auto& side : faces_.faces()[f].sides)
                for (const part_of_side& part : side)
                    of_curves[part.curve] = std::max(of_curves[part.curve], of_faces[f]);
        }
        for (std::size_t c = 0; c < of_curves.size(); ++c)
            rates_.of_curves[c] = raised(rates_.of_curves[c], of_curves[c]);
        return std::ranges::any_of(of_curves, [](double factor) { return factor > 1; });
    }
    /// Makes a factor as large as an error asks for.
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
    void measure_triangles(std::vector<double>& factors)
    {
        const auto vertices = points_at(surface_, std::span<const Point>(control_.points()), places_);
        constexpr std::array<std::array<double, 3>, 4> weights{
            {{1. / 3, 1. / 3, 1. / 3}, {.5, .5, 0}, {0, .5, .5}, {.5, 0, .5}}};
        std::vector<surface_place> places;
        for (std::size_t t = 0; t < triangles_.size(); ++t)
            for (const auto& w : weights) {
                double u = 0, v = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    u += w[k] * parameters_[t][k][0];
                    v += w[k] * parameters_[t][k][1];
                }
                places.push_back(place_in(faces_.faces()[face_of_[t]], u, v));
            }
        const auto on_surface = points_at(surface_, std::span<const Point>(control_.points()), places);
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            const auto corner = [&](std::size_t k) -> const Point& { return vertices[triangles_[t][k]]; };
            const auto normal = unit_normal(difference(corner(1), corner(0)), difference(corner(2), corner(0)));
            for (std::size_t i = 0; i < weights.size(); ++i) {
                const normal_vector from_corner = difference(on_surface[weights.size() * t + i], corner(0));
                note_error(normal ? std::abs(dot(from_corner, *normal)) : length_of(from_corner), factors[face_of_[t]]);
            }
            for (std::size_t k = 0; k < 3; ++k)
                note_length(length_of(difference(corner((k + 1) % 3), corner(k))), factors[face_of_[t]]);
        }
    }
    void measure_walls(std::vector<double>& factors)
    {
        std::vector<surface_place> places;
        std::vector<std::size_t> curve_of;
        for (std::size_t c = 0; c < rates_.of_curves.size(); ++c)
            for (std::size_t i = 0; faces_.curves()[c].is_wall and i <= 2 * rates_.of_curves[c]; ++i) {
                places.push_back(faces_.place_on(faces_.curves()[c], double(i) / double(2 * rates_.of_curves[c])));
                curve_of.push_back(c);
            }
        const auto points = points_at(surface_, std::span<const Point>(control_.points()), places);
        for (std::size_t i = 0; i + 2 < points.size(); ++i)
            if (curve_of[i] == curve_of[i + 2]) // every other triple is a segment; those between them are no worse
                note_error(length_across(difference(points[i + 1], points[i]), difference(points[i + 2], points[i])),
                           factors[curve_of[i]]);
    }

    tessellation<Point> finish()
    {
        tessellation<Point> result;
        result.at = surface_.locate(places_);
        const auto values = result.at.evaluate(std::span<const Point>(control_.points()), derivatives::first);
        result.mesh = make_mesh(std::vector<Point>(values.points.begin(), values.points.end()), triangles_);
        result.normals = normals_of(values);
        std::vector<unsigned char> has_none(places_.size(), 0);
        for (std::size_t v = 0; v < has_none.size(); ++v)
            has_none[v] = result.normals[v] == normal_vector{};
        if (std::ranges::find(has_none, 1) != has_none.end()) {
            const auto means = mean_face_normals(result.mesh,
                                                 std::span<const Point>(std::as_const(result.mesh).points()),
                                                 std::span<const unsigned char>(has_none));
            for (std::size_t v = 0; v < has_none.size(); ++v)
                if (has_none[v] != 0)
                    result.normals[v] = means[v];
        }
        for (const std::size_t f : face_of_)
            result.faces.push_back(faces_.faces()[f].origin.face);
        result.places = std::move(places_);
        return result;
    }

    const basic_mesh<Point, Index>& control_;
    tessellation_options options_;
    surface_locator<Scheme, Index> surface_;
    parametric_faces faces_;
    tessellation_rates rates_;
    std::size_t corners_ = 0;           // the first vertices are corners
    std::vector<surface_place> places_; // of the vertices
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<std::array<std::array<double, 2>, 3>> parameters_; // u and v of their corners, if they are measured
    std::vector<std::size_t> face_of_;                             // of each triangle
};

} // namespace detail

/// Tessellates the limit surface of a mesh: returns triangles that fit together without cracks, whose vertices lie on
/// the surface. The vertices of the mesh come first, in their order. Each edge of the mesh is cut as often as its curve
/// and the faces beside it need. For points of three coordinates. Errors: mesh_error for options that are not positive,
/// for more than 4096 segments of an edge, and those of `surface_locator`. Cost: that of some evaluations per vertex;
/// with a chord error or an edge length four more per triangle, in some rounds.
template <class Point, std::unsigned_integral Index, parametric_scheme Scheme>
tessellation<Point> tessellate(const basic_mesh<Point, Index>& mesh, const Scheme& scheme,
                               const tessellation_options& options)
{
    if (options.segments == 0 or not(options.longest_edge > 0) or not(options.chord_error > 0) or
        not(options.angle > 0))
        throw mesh_error("tessellate: segments, longest edge, chord error and angle must be positive");
    return detail::tessellator<Point, Scheme, Index>(mesh, scheme, options).make();
}
template <mesh M, parametric_scheme Scheme>
auto tessellate(const M& mesh, const Scheme& scheme, const tessellation_options& options)
{
    return tessellate(lift_valid(mesh), scheme, options);
}

} // namespace kith
