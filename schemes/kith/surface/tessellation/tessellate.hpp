// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tessellation_measures.hpp"
#include "tessellation_numbers.hpp"
#include "tessellation_rates.hpp"

#include <kith/core/base/affine.hpp>
#include <kith/core/base/error.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/core/level/to_native.hpp>
#include <kith/limits/unit_normal.hpp>
#include <kith/surface/surface_lattices.hpp>
#include <kith/surface/surface_locator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// Triangles whose vertices lie on a limit surface.
template <class Point>
struct tessellation {
    basic_mesh<Point> mesh;
    storage<surface_place> places{};  ///< of the vertices; a `surface_locator` evaluates other values there
    storage<normal_vector> normals{}; ///< at the vertices; if faces meet sharply, that of one of them
    storage<std::uint32_t> faces{};   ///< the face of the control mesh that contains each triangle
};

namespace detail {

/// Returns the point with these coordinates.
template <class Point>
Point point_from(const std::array<double, 3>& coordinates)
{
    typename affine<Point>::sum result;
    for (std::size_t x = 0; x < 3; ++x)
        result[x] = static_cast<std::remove_reference_t<decltype(result[x])>>(coordinates[x]);
    return affine<Point>::store(result);
}

template <class Point, parametric_scheme Scheme, std::unsigned_integral Index>
class tessellator {
    using lattices = surface_lattices<Scheme, Index>;

public:
    /// Takes a control mesh and options. Precondition: the options are positive numbers.
    tessellator(const basic_mesh<Point, Index>& control, const Scheme& scheme, const tessellation_options& options)
        : control_(control.points())
        , options_(options)
        , surface_(control, scheme)
        , lattices_(surface_)
        , faces_(parametric_faces::of(control.topology(), scheme))
        , rates_(faces_, lattices_, control_, options)
    {
    }

    /// Returns the tessellation. Errors: mesh_error if more than most_segments are needed.
    tessellation<Point> make()
    {
        constexpr int most_rounds = 12;
        for (int round = 0;; ++round) {
            numbers_.emplace(faces_, rates_);
            requests_.clear();
            for (std::size_t f = 0; f < faces_.faces().size(); ++f) {
                const surface_place& origin = faces_.faces()[f].origin;
                requests_.push_back({origin.face, origin.corner, numbers_->pattern_of(f)});
            }
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

    /// Cuts faces that are not cut and so would share an edge with two others. Returns true if there are any.
    bool split_repeated_edges()
    {
        struct edge {
            std::array<std::size_t, 2> ends;
            std::size_t face;
        };
        std::vector<edge> edges; // between corners, for each triangle
        for (std::size_t f = 0; f < faces_.faces().size(); ++f) {
            const parametric_face& face = faces_.faces()[f];
            const auto add = [&](std::size_t a, std::size_t b) {
                edges.push_back({{std::min(a, b), std::max(a, b)}, f});
            };
            for (const part_of_side& part : face.parts())
                if (const shared_curve& curve = faces_.curves()[part.curve]; rates_.of_curves[part.curve] == 1)
                    add(curve.first, curve.last);
            if (numbers_->pattern(numbers_->pattern_of(f)).vertices_inside() == 0 and face.sides == 4)
                for (int triangle = 0; triangle < 2; ++triangle)
                    add(faces_.corner_of(face.parts()[0]), faces_.corner_of(face.parts()[2]));
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
                    for (const part_of_side& part : faces_.faces()[edges[k].face].parts())
                        rates_.of_curves[part.curve] = std::max<std::size_t>(rates_.of_curves[part.curve], 2);
                }
        return are_split;
    }

    /// Measures the distance of the surface from each triangle, and from segments of boundaries and sharp edges. Raises
    /// the rates where this distance or an edge is too long. Returns true if there are such faces.
    bool raise_rates()
    {
        storage<normal_vector> vertices(numbers_->vertices());
        evaluate<false>([&](std::size_t vertex, std::size_t, const auto&, const auto& values, std::size_t i) {
            vertices[vertex] = values.point(i);
        });
        tessellation_measures factors(*numbers_, faces_, options_);
        factors.measure_triangles(lattices_, requests_, control_, vertices);
        if (std::isfinite(options_.chord_error))
            factors.measure_walls(surface_, control_, rates_);
        const auto raised = [](std::size_t rate, double factor) { return whole_segments(factor * double(rate)); };
        for (std::size_t f = 0; f < factors.of_faces.size(); ++f) {
            const double factor = factors.of_faces[f];
            auto& [u, v] = rates_.of_faces[f];
            u = raised(u, factor);
            v = raised(v, factor);
            for (const part_of_side& part : faces_.faces()[f].parts())
                factors.of_curves[part.curve] = std::max(factors.of_curves[part.curve], factor);
        }
        for (std::size_t c = 0; c < factors.of_curves.size(); ++c)
            rates_.of_curves[c] = raised(rates_.of_curves[c], factors.of_curves[c]);
        return std::ranges::any_of(factors.of_curves, [](double factor) { return factor > 1; });
    }

    /// Evaluates the vertices on threads: calls take(vertex, face, u and v, values, i) for each vertex, in no order. i
    /// is the number of the vertex among the values.
    template <bool HasNormals, class Take>
    void evaluate(const Take& take)
    {
        lattices_.template for_each<HasNormals, Point>(
            requests_,
            control_,
            numbers_->vertices(),
            [&](std::size_t pattern) { return numbers_->pattern(pattern).parameters(); },
            [&](std::size_t f, auto& lattice) {
                const auto parameters = numbers_->pattern(numbers_->pattern_of(f)).parameters();
                using index = tessellation_numbers::index;
                numbers_->for_own_vertices(f, [&](std::size_t begin, std::size_t end, index vertex, index step) {
                    lattice.evaluate(begin, end, [&](std::size_t place, const auto& values, std::size_t i) {
                        take(vertex, f, parameters[place], values, i);
                        vertex += step;
                    });
                });
            });
    }
    tessellation<Point> finish()
    {
        storage<Point> points(numbers_->vertices());
        tessellation<Point> result{{},
                                   storage<surface_place>(points.size()),
                                   storage<normal_vector>(points.size()),
                                   storage<std::uint32_t>(numbers_->triangles())};
        evaluate<true>([&](std::size_t vertex, std::size_t f, const auto& uv, const auto& values, std::size_t i) {
            const surface_place& origin = faces_.faces()[f].origin;
            points[vertex] = point_from<Point>(values.point(i));
            result.normals[vertex] = values.normal(i);
            result.places[vertex] = {origin.face, uv[0], uv[1], origin.corner};
        });
        result.mesh = basic_mesh<Point>(std::move(points), numbers_->connect());
        for (std::size_t f = 0; f < faces_.faces().size(); ++f)
            std::fill(result.faces.begin() + numbers_->first_triangle(f),
                      result.faces.begin() + numbers_->first_triangle(f + 1),
                      std::uint32_t(faces_.faces()[f].origin.face));
        add_missing_normals(result);
        return result;
    }
    /// Gives vertices at which derivatives are NaN the mean of the normals of their triangles.
    static void add_missing_normals(tessellation<Point>& made)
    {
        const auto is_missing = [](const normal_vector& normal) { return normal == normal_vector{}; };
        if (std::ranges::none_of(made.normals, is_missing))
            return;
        std::vector<unsigned char> has_none(made.normals.size(), 0);
        for (std::size_t v = 0; v < has_none.size(); ++v)
            has_none[v] = is_missing(made.normals[v]);
        const auto means = mean_face_normals(
            made.mesh, std::as_const(made.mesh).points(), std::span<const unsigned char>(has_none));
        for (std::size_t v = 0; v < has_none.size(); ++v)
            if (has_none[v] != 0)
                made.normals[v] = means[v];
    }

    std::span<const Point> control_;
    tessellation_options options_;
    surface_locator<Scheme, Index> surface_;
    lattices lattices_;
    parametric_faces faces_;
    tessellation_rates rates_;
    std::optional<tessellation_numbers> numbers_;      // by the rates
    std::vector<typename lattices::request> requests_; // of each face
};

} // namespace detail

/// Returns a tessellation of the limit surface of a mesh: triangles that fit together without cracks, whose vertices
/// lie on the surface. The vertices of the mesh come first, in their order. Each edge of the mesh is cut as often as
/// its curve and the faces beside it need. For points of three coordinates. Errors: mesh_error for options that are not
/// positive, for more than 4096 segments of an edge, and those of `surface_locator`. Cost: that of some evaluations per
/// vertex; with a chord error or an edge length four more per triangle, in some rounds.
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
    return tessellate(to_native_valid(mesh), scheme, options);
}

} // namespace kith
