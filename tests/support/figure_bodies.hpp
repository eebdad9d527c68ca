// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "figures.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// Stand-ins for bodies of which the thesis has pictures and counts only. They have these counts.
namespace figures {

/// The radius and the height of a ring of vertices.
using ring = std::array<double, 2>;

/// Returns a body of revolution around the z axis, with rings of vertices from the bottom up and a vertex at each end
/// of the axis. Faces are quads, and triangles at the ends.
inline shape revolved(const std::vector<ring>& rings, std::size_t segments, double bottom, double top)
{
    const double turn = 2 * std::acos(-1.) / double(segments);
    shape result;
    for (const auto& [radius, height] : rings)
        for (std::size_t j = 0; j < segments; ++j)
            result.points.push_back({radius * std::cos(turn * double(j)), radius * std::sin(turn * double(j)), height});
    const std::size_t low = result.points.size(), high = low + 1, last = low - segments;
    result.points.push_back({0, 0, bottom});
    result.points.push_back({0, 0, top});
    for (std::size_t j = 0; j < segments; ++j) {
        const std::size_t right = (j + 1) % segments;
        result.faces.push_back({low, right, j});
        for (std::size_t i = 0; i < last; i += segments)
            result.faces.push_back({i + j, i + right, i + segments + right, i + segments + j});
        result.faces.push_back({last + j, last + right, high});
    }
    return result;
}

/// Returns a round body between the heights 0 and 1: at height t it has radius_at(t) times the radius of a ball there.
template <class Radius>
shape round(std::size_t rings, std::size_t segments, const Radius& radius_at)
{
    std::vector<ring> profile;
    for (std::size_t i = 1; i <= rings; ++i) {
        const double angle = std::acos(-1.) * double(i) / double(rings + 1), height = (1 - std::cos(angle)) / 2;
        profile.push_back({radius_at(height) * std::sin(angle) / 2, height});
    }
    return revolved(profile, segments, 0, 1);
}

/// Returns both bodies in one mesh, the second one moved.
inline shape joined(shape a, const shape& b, const point& move)
{
    const std::size_t before = a.points.size();
    for (const auto& [x, y, z] : b.points)
        a.points.push_back({x + move[0], y + move[1], z + move[2]});
    for (auto face : b.faces) {
        for (std::size_t& v : face)
            v += before;
        a.faces.push_back(std::move(face));
    }
    return a;
}

/// Returns an axe, a blade of triangles through a handle of quads; V, E, F = 28, 54, 30. Figure 2.8.
inline shape axe()
{
    shape handle;
    for (std::size_t i = 0; i < 5; ++i)
        for (const auto& [x, y] : {std::array{-1., -1.}, {1., -1.}, {1., 1.}, {-1., 1.}})
            handle.points.push_back({.12 * x, .12 * y, .9 * double(i)});
    handle.faces = {{0, 3, 2, 1}, {16, 17, 18, 19}};
    for (std::size_t i = 0; i < 16; i += 4)
        for (std::size_t j = 0; j < 4; ++j)
            handle.faces.push_back({i + j, i + (j + 1) % 4, i + 4 + (j + 1) % 4, i + 4 + j});
    shape blade = triangulated(cube());
    for (auto& [x, y, z] : blade.points) {
        z *= x < 0 ? .9 : .3; // the edge is longer than the back
        y *= x < 0 ? .02 : .2;
        x = x < 0 ? -1.3 : .35;
    }
    return joined(std::move(handle), blade, {0, 0, 3});
}

/// Returns a gourd of triangles; V, E, F = 326, 972, 648. Figure 2.15.
inline shape gourd()
{
    const auto waist = [](double t) { return (1.1 - .5 * t) * (1 - .5 * std::exp(-50 * (t - .65) * (t - .65))); };
    return triangulated(round(18, 18, waist));
}

/// Returns a rook of triangles; V, E, F = 130, 384, 256. Figure 2.20.
inline shape rook()
{
    return triangulated(revolved(
        {{.5, 0}, {.5, .12}, {.36, .22}, {.26, .5}, {.26, .9}, {.42, 1}, {.42, 1.25}, {.28, 1.25}}, 16, 0, 1.08));
}

/// Returns five ellipsoids for the cupid: V, E, F = 6713, 14235, 7532. Figure 2.27.
inline shape cupid()
{
    const auto ellipsoid = [](std::size_t rings, std::size_t segments, const point& size) {
        shape result = round(rings, segments, [](double) { return 1.; });
        for (point& p : result.points)
            for (std::size_t i = 0; i < 3; ++i)
                p[i] *= size[i];
        return result;
    };
    shape result = ellipsoid(8, 190, {1, .8, 1.5});                                   // the body
    result = joined(std::move(result), ellipsoid(9, 71, {.8, .8, .9}), {0, 0, 1.35}); // the head
    for (const double side : {-1., 1.})                                               // the wings
        result = joined(std::move(result), ellipsoid(8, 189, {1.1, .15, 1.3}), {.8 * side, .35, .6});
    return joined(std::move(result), ellipsoid(8, 190, {2.4, 1.6, .5}), {0, 0, -.3}); // the cloud
}

} // namespace figures
