// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "back_end.hpp"

#include <kith/limit.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith::tool {

/// For each vertex the mean of its faces' normals, each weighed by its area (Newell's formula).
inline std::vector<std::array<double, 3>> mean_face_normals(const basic_mesh<>& mesh)
{
    std::vector<std::array<double, 3>> result(mesh.vertex_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        std::array<double, 3> normal{};
        for (std::size_t i = 0; i < face.size(); ++i) {
            const auto &p = mesh.point(face[i]), &q = mesh.point(face[(i + 1) % face.size()]);
            for (std::size_t k = 0; k < 3; ++k)
                normal[k] += (p[(k + 1) % 3] - q[(k + 1) % 3]) * (p[(k + 2) % 3] + q[(k + 2) % 3]);
        }
        for (const auto v : face)
            for (std::size_t k = 0; k < 3; ++k)
                result[v][k] += normal[k];
    }
    for (auto& n : result)
        if (const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]); length > 0)
            for (double& x : n)
                x /= length;
    return result;
}

/// Moves the vertices of a result to the limit surface and gives it the normals there. `level` is the same mesh as its
/// elements. Vertices without a known limit stay; where the surface has no normal of its own stands the mean of the faces'.
template <class Level, class Scheme>
void move_to_limit(refined_mesh& result, const Level& level, const Scheme& scheme)
{
    using element = vertex<Level>;
    if constexpr (has_limit_positions<Scheme, element, Level>) {
        const auto limits = limit_positions(level, scheme);
        storage<std::array<double, 3>> points(result.mesh.points());
        for (std::size_t v = 0; v < limits.size(); ++v) {
            if (limits[v])
                points[v] = affine<std::array<double, 3>>::store(affine<typename Level::point_type>::load(*limits[v]));
            else
                ++result.without_limit;
        }
        result.mesh = basic_mesh<>(std::move(points), result.mesh.topology(), result.mesh.generation());
        result.normals = mean_face_normals(result.mesh);
        if constexpr (has_limit_tangents<Scheme, element, Level>) {
            const auto normals = limit_normals(level, scheme);
            for (std::size_t v = 0; v < normals.size(); ++v)
                if (normals[v])
                    result.normals[v] = *normals[v];
        }
    }
}

} // namespace kith::tool
