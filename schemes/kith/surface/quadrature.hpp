// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_place.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/level/to_native.hpp>
#include <kith/surface/shape/parametric_scheme.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <vector>

namespace kith {

/// The places at which an integrand is evaluated, and the weight of each in the parameters u and v. The integral over
/// the surface is the sum of weight * |du x dv| * integrand.
struct surface_quadrature {
    std::vector<surface_place> places; ///< face by face
    std::vector<double> weights;       ///< their sum is 1 in a quad or sub-face and 1/2 in a triangle
};

namespace detail {

/// A point of a quadrature rule. Points of a rule on a line have v = 0.
struct quadrature_point {
    double u, v, weight;
};

/// Returns the rule of Gauss and Legendre on the interval from 0 to 1.
inline std::vector<quadrature_point> gauss_points(int count)
{
    // Distances from the middle of the interval from -1 to 1, and weights there.
    using half = std::vector<std::array<double, 2>>;
    static const std::array<half, 4> rules{
        {{{0, 2}},
         {{.57735026918962576, 1}},
         {{.77459666924148338, 5. / 9}, {0, 8. / 9}},
         {{.86113631159405258, .34785484513745386}, {.33998104358485626, .65214515486254614}}}};
    std::vector<quadrature_point> result;
    const half& rule = rules[std::size_t(count - 1)];
    for (const auto& [distance, weight] : rule)
        result.push_back({(1 - distance) / 2, 0, weight / 2});
    for (std::size_t i = rule.size(); i-- > 0;)
        if (rule[i][0] > 0)
            result.push_back({(1 + rule[i][0]) / 2, 0, rule[i][1] / 2});
    return result;
}

/// Returns the tensor product of Gauss's rule with itself, on the unit square.
inline std::vector<quadrature_point> square_points(int per_direction)
{
    std::vector<quadrature_point> result;
    const auto line = gauss_points(per_direction);
    for (const auto& y : line)
        for (const auto& x : line)
            result.push_back({x.u, y.u, x.weight * y.weight});
    return result;
}

/// Returns a symmetric rule on the triangle u, v >= 0, u + v <= 1 (Strang & Fix 1973, Dunavant 1985). It has 1, 3, 6 or
/// 12 points and is exact for polynomials of degree 1, 2, 4 or 6.
inline std::vector<quadrature_point> triangle_points(int per_direction)
{
    // Two barycentric coordinates, and the weight of each point that is a permutation of them.
    struct orbit {
        double a, b, weight;
    };
    static const std::array<std::vector<orbit>, 4> rules{
        {{{1. / 3, 1. / 3, 1}},
         {{1. / 6, 1. / 6, 1. / 3}},
         {{.44594849091596488, .44594849091596488, .22338158967801147},
          {.091576213509770744, .091576213509770744, .10995174365532187}},
         {{.24928674517091042, .24928674517091042, .11678627572637937},
          {.063089014491502228, .063089014491502228, .050844906370206817},
          {.053145049844816947, .31035245103378440, .082851075618373575}}}};
    std::vector<quadrature_point> result;
    for (const auto& [a, b, weight] : rules[std::size_t(per_direction - 1)]) {
        const double c = 1 - a - b, w = weight / 2;
        if (per_direction == 1)
            result.push_back({a, b, w});
        else if (a == b)
            for (const auto& [u, v] : {std::array{a, a}, {a, c}, {c, a}})
                result.push_back({u, v, w});
        else
            for (const auto& [u, v] : {std::array{a, b}, {b, c}, {c, a}, {b, a}, {c, b}, {a, c}})
                result.push_back({u, v, w});
    }
    return result;
}

} // namespace detail

/// Returns places and weights that integrate over the limit surface of a mesh. No place lies on an edge or a vertex, so
/// that all derivatives exist.
///
/// A quad, or a sub-face of another polygon, has the tensor product of Gauss's rule: n points per direction are exact
/// for polynomials of degree 2n - 1 in u and in v. A triangle of Loop's scheme has a symmetric rule of 1, 3, 6 or 12
/// points for n = 1, 2, 3 or 4. It is exact for total degree 1, 2, 4 or 6. Beside an irregular vertex the surface has
/// infinitely many pieces, and these rules converge more slowly there; refine the mesh for more accuracy. Errors:
/// mesh_error unless there are 1 to 4 points per direction. Cost: O(places).
template <std::unsigned_integral Index, class Point, parametric_scheme Scheme>
surface_quadrature quadrature_places(const basic_mesh<Point, Index>& mesh, const Scheme&, int points_per_direction)
{
    if (points_per_direction < 1 or points_per_direction > 4)
        throw mesh_error("quadrature_places: there is no rule of " + std::to_string(points_per_direction) +
                         " points per direction; give 1 to 4");
    constexpr std::size_t degree = detail::has_quad_parameters<Scheme> ? 4 : 3;
    const auto rule = degree == 4 ? detail::square_points(points_per_direction)
                                  : detail::triangle_points(points_per_direction);
    surface_quadrature result;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t corners = mesh.face(f).size(), parts = corners == degree ? 1 : corners;
        for (std::size_t k = 0; k < parts; ++k)
            for (const auto& [u, v, weight] : rule) {
                result.places.push_back({f, u, v, k});
                result.weights.push_back(weight);
            }
    }
    return result;
}
template <mesh M, parametric_scheme Scheme>
surface_quadrature quadrature_places(const M& mesh, const Scheme& scheme, int points_per_direction)
{
    return quadrature_places(to_native_valid(mesh), scheme, points_per_direction);
}

} // namespace kith
