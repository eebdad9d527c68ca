// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limit.hpp"

#include <kith/schemes/crease/sectors.hpp>

#include <cstddef>
#include <optional>
#include <span>

namespace kith::detail {

/// The normal of a sector of a vertex, and its weight in the mean normal of the vertex.
struct limit_side {
    std::size_t faces;
    std::optional<normal_vector> normal{}; ///< nothing if the surface is too thin or too short to have one
    double weight = 0;                     ///< one minus the cosine of the angle; 2 for half a turn, 4 for a whole one
};

inline double dot(const normal_vector& a, const normal_vector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Returns the normal and weight of a sector. The normal is that of the plane of the tangents along the two edges of
/// the sector. If these make a straight line, to about one degree, the plane is that of the line and the direction into
/// the sector. This direction also tells the orientation of a sector of several faces that spans more than half a turn.
template <level Level, class First, class Last, class Middle>
limit_side side_of(const vertex_sector<Level>& part, bool is_half_turn, const First& first, const Last& last,
                   const Middle& middle)
{
    constexpr double straight = 1. / 64;
    const auto [a, z, m] = tangents_of<Level>(first, last, middle);
    const auto from = unit_vector(a), to = unit_vector(z), between = unit_vector(m);
    limit_side result{.faces = part.faces};
    if (not from or not to)
        return result;
    const normal_vector plane = cross(*from, *to);
    const double cosine = dot(*from, *to);
    result.weight = is_half_turn ? 2 : 1 - cosine;
    normal_vector inwards{};
    if (between) {
        const normal_vector along{(*from)[0] - (*to)[0], (*from)[1] - (*to)[1], (*from)[2] - (*to)[2]};
        inwards = cross(along, *between);
    }
    if (cosine < 0 and length_of(plane) < straight) {
        result.normal = unit_vector(inwards);
        return result;
    }
    result.normal = unit_vector(plane);
    if (result.normal and not is_half_turn and part.faces > 1 and dot(plane, inwards) < 0) {
        for (double& x : *result.normal)
            x = -x;
        result.weight = 3 + cosine;
    }
    return result;
}

/// Returns the weighted mean of the normals of all sides; nothing if they cancel out, or there are none.
inline std::optional<normal_vector> mean_normal(std::span<const limit_side> sides)
{
    normal_vector sum{};
    double total = 0;
    for (const limit_side& side : sides)
        if (side.normal) {
            for (std::size_t i = 0; i < 3; ++i)
                sum[i] += side.weight * (*side.normal)[i];
            total += side.weight;
        }
    constexpr double rounding = 0x1p-45;
    return length_of(sum) < rounding * total ? std::nullopt : unit_vector(sum);
}

} // namespace kith::detail
