// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "same_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

/// A surface as points and faces, in any order.
struct surface {
    std::vector<std::array<double, 3>> points;
    std::vector<std::vector<std::size_t>> faces;
};

/// Returns a difference between two surfaces, whatever the numbers of their elements. Returns "" if each vertex lies
/// within the tolerance of one vertex of the other surface, and the faces agree under this pairing. Precondition: no
/// two vertices of one surface are that close.
inline std::string difference(const surface& a, const surface& b, double tolerance = 1e-12)
{
    if (a.points.size() != b.points.size() or a.faces.size() != b.faces.size())
        return std::to_string(a.points.size()) + " points, " + std::to_string(a.faces.size()) + " faces and " +
               std::to_string(b.points.size()) + ", " + std::to_string(b.faces.size());
    std::vector<std::size_t> by_x(b.points.size()), partner(a.points.size());
    std::iota(by_x.begin(), by_x.end(), std::size_t(0));
    std::ranges::sort(by_x, {}, [&](std::size_t v) { return b.points[v][0]; });
    std::vector<bool> is_taken(b.points.size());
    for (std::size_t v = 0; v < a.points.size(); ++v) {
        const auto& p = a.points[v];
        auto i = std::ranges::lower_bound(by_x, p[0] - tolerance, {}, [&](std::size_t w) { return b.points[w][0]; });
        const auto is_near = [&](std::size_t w) {
            return std::hypot(b.points[w][0] - p[0], b.points[w][1] - p[1], b.points[w][2] - p[2]) <= tolerance;
        };
        while (i != by_x.end() and b.points[*i][0] <= p[0] + tolerance and (is_taken[*i] or not is_near(*i)))
            ++i;
        if (i == by_x.end() or b.points[*i][0] > p[0] + tolerance)
            return "nothing lies at vertex " + std::to_string(v);
        is_taken[partner[v] = *i] = true;
    }
    auto renumbered = a.faces;
    for (auto& face : renumbered)
        for (std::size_t& v : face)
            v = partner[v];
    return as_cycles(renumbered) == as_cycles(b.faces) ? "" : "other faces";
}
