// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sharp_rules.hpp"

#include <kith/hierarchy.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace kith {

/// The limit at corners, and along boundaries and creases: 1/6, 2/3, 1/6, where a cubic B-spline curve ends up.
template <class Level, class Use>
void limit_on_curve(const sharp_rules<Level>& sharp, const vertex<Level>& v, const Use& use)
{
    using kinds = typename sharp_rules<Level>::limit_kind;
    const auto [kind, ends] = sharp.limit_of(v);
    if (kind == kinds::corner)
        use(sum(v));
    else if (kind == kinds::curve)
        use((ends[0] + 4. * v + ends[1]) / 6);
}

/// A corner with one face lies in the plane of its two edges; at other corners and along creases each side has a plane of
/// its own, and none is given.
template <class Level, class Use>
void limit_at_corner(const sharp_rules<Level>& sharp, const vertex<Level>& v, const Use& use)
{
    if (v.is_boundary() and v.face_count() == 1 and sharp.limit_of(v).kind == sharp_rules<Level>::limit_kind::corner)
        use(v.first_rim() - v, v.last_rim() - v);
}

namespace detail {

/// Gives the scheme's limit functions what they need besides the vertex: the sharp rules of schemes that have creases.
template <class Level, class Scheme, class Use>
void with_limits(const Level& level, const Scheme& scheme, const Use& use)
{
    if constexpr (requires { scheme.sharpness; }) {
        const sharp_rules sharp(level, scheme.sharpness, scheme.corners);
        use([&](const auto& v, const auto& take) { scheme.limit_position(sharp, v, take); },
            [&](const auto& v, const auto& take) { scheme.limit_tangents(sharp, v, take); });
    } else {
        use([&](const auto& v, const auto& take) { scheme.limit_position(v, take); },
            [&](const auto& v, const auto& take) { scheme.limit_tangents(v, take); });
    }
}

} // namespace detail

/// Where the vertices of a level end up when it is refined for ever; nothing where no closed mask is known (faces that
/// the first step splits, darts, semi-sharp creases that still decay): refine once more.
/// `level` is mesh.elements(i) of a hierarchy, `scheme` its scheme(i). Cost: O(corners).
template <class Level, class Scheme>
auto limit_positions(const Level& level, const Scheme& scheme)
{
    using point = typename Level::point_type;
    std::vector<std::optional<point>> result(level.vertex_count());
    const point_values<Level> values;
    detail::with_limits(level, scheme, [&](const auto& position, const auto&) {
        for (const auto v : level.vertices())
            position(v, [&](const auto& mask) { result[v.index()] = affine<point>::store(mask.evaluate(values)); });
    });
    return result;
}

/// The unit normals of the limit surface at the vertices of a level, outward for counter-clockwise faces; nothing where
/// no mask is known or the surface has none (corners with several faces, creases). For points of three coordinates.
template <class Level, class Scheme>
auto limit_normals(const Level& level, const Scheme& scheme)
{
    std::vector<std::optional<std::array<double, 3>>> result(level.vertex_count());
    const point_values<Level> values;
    detail::with_limits(level, scheme, [&](const auto&, const auto& tangents) {
        for (const auto v : level.vertices())
            tangents(v, [&](const auto& first, const auto& second) {
                const auto a = first.evaluate(values), b = second.evaluate(values);
                std::array<double, 3> n;
                for (std::size_t i = 0; i < 3; ++i)
                    n[i] = double(a[(i + 1) % 3]) * double(b[(i + 2) % 3]) -
                           double(a[(i + 2) % 3]) * double(b[(i + 1) % 3]);
                const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
                if (length > 0)
                    result[v.index()] = std::array{n[0] / length, n[1] / length, n[2] / length};
            });
    });
    return result;
}

} // namespace kith
