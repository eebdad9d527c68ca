// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/basic_mesh.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <vector>

using mesh = kith::basic_mesh<>;

/// Returns the faces of a mesh in a normal form that depends neither on their order nor on their first corners.
inline std::vector<std::vector<std::size_t>> faces_of(const mesh& m)
{
    std::vector<std::vector<std::size_t>> result;
    for (std::size_t f = 0; f < m.face_count(); ++f) {
        auto& face = result.emplace_back(m.face(f).begin(), m.face(f).end());
        std::ranges::rotate(face, std::ranges::min_element(face));
    }
    std::ranges::sort(result);
    return result;
}

/// Returns true if the points of two meshes are equal up to rounding.
inline bool same_points(const mesh& a, const mesh& b)
{
    return std::ranges::equal(a.points(), b.points(), [](const auto& p, const auto& q) {
        return std::ranges::equal(p, q, [](double x, double y) { return x - y < 1e-15 and y - x < 1e-15; });
    });
}

/// Prints whether two ways led to the same mesh.
inline bool report(const char* routes, bool same)
{
    std::printf("%s: %s\n", routes, same ? "the same mesh" : "DIFFERENT");
    return same;
}
