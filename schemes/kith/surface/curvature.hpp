// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "located_places.hpp"

#include <kith/core/base/affine.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/limits/unit_normal.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace kith {

/// The curvatures of a surface at a place. They are positive if the surface bends towards its normal, so negative on a
/// sphere seen from outside.
struct surface_curvature {
    double mean, gaussian;
    double least, most; ///< the principal curvatures
};

/// Returns the unit normals at places, outward for counter-clockwise faces. A normal is zero if du and dv are parallel
/// or NaN. For points of three coordinates. Precondition: the first derivatives were asked for. Cost: O(places).
template <class Point>
storage<normal_vector> normals_of(const surface_values<Point>& values)
{
    storage<normal_vector> result(values.du.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = unit_normal(affine<Point>::load(values.du[i]), affine<Point>::load(values.dv[i]))
                        .value_or(normal_vector{});
    return result;
}

/// Returns the curvatures at places; they are NaN if the second derivatives are. For points of three coordinates.
/// Precondition: the second derivatives were asked for. Cost: O(places).
template <class Point>
storage<surface_curvature> curvatures_of(const surface_values<Point>& values)
{
    const auto normals = normals_of(values);
    storage<surface_curvature> result(normals.size());
    const auto dot = [](const auto& a, const auto& b) {
        return double(a[0]) * double(b[0]) + double(a[1]) * double(b[1]) + double(a[2]) * double(b[2]);
    };
    for (std::size_t i = 0; i < result.size(); ++i) {
        const auto load = [i](const storage<Point>& of) { return affine<Point>::load(of[i]); };
        const auto du = load(values.du), dv = load(values.dv);
        // The first and the second fundamental form.
        const double e = dot(du, du), f = dot(du, dv), g = dot(dv, dv);
        const double l = dot(normals[i], load(values.duu)), m = dot(normals[i], load(values.duv)),
                     n = dot(normals[i], load(values.dvv));
        const double area = e * g - f * f;
        const double mean = (e * n - 2 * f * m + g * l) / (2 * area), gaussian = (l * n - m * m) / area;
        const double difference = std::sqrt(std::fmax(mean * mean - gaussian, 0));
        result[i] = {mean, gaussian, mean - difference, mean + difference};
    }
    return result;
}

} // namespace kith
