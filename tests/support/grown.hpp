// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace shapes {

/// Returns a small surface that grows by adding faces at random boundary edges, over a few vertices. Surfaces of all
/// kinds occur, closed or with a boundary; some are no manifolds. Faces have `degree` corners, or 3 to 5 if it is 0.
/// The seed determines the result.
inline shape grown(std::uint32_t seed, std::size_t degree)
{
    std::minstd_rand random(seed);
    for (int i = 0; i < 5; ++i) // skips the first numbers, which are alike for small seeds
        random();
    const auto below = [&random](std::size_t bound) { return std::size_t(random() >> 8) % bound; };
    const std::size_t most_vertices = 3 + below(8), most_faces = 2 + below(24);
    shape result;
    std::set<std::pair<std::size_t, std::size_t>> sides;
    const auto add = [&](const std::vector<std::size_t>& face) {
        std::set<std::pair<std::size_t, std::size_t>> own;
        for (std::size_t i = 0; i < face.size(); ++i)
            own.emplace(face[i], face[(i + 1) % face.size()]);
        const std::set<std::size_t> corners(face.begin(), face.end());
        if (corners.size() < face.size() or
            std::ranges::any_of(own, [&](const auto& s) { return sides.count(s) != 0; }))
            return;
        sides.merge(own);
        result.faces.push_back(face);
        while (result.points.size() <= *corners.rbegin())
            result.points.push_back({double(below(100)), double(below(100)), double(below(100))});
    };
    const auto corner_count = [&] { return degree != 0 ? degree : 3 + below(3); };
    std::vector<std::size_t> first(corner_count());
    for (std::size_t i = 0; i < first.size(); ++i)
        first[i] = i;
    add(first);
    for (std::size_t i = 0; i < 4 * most_faces and result.faces.size() < most_faces; ++i) {
        std::vector<std::pair<std::size_t, std::size_t>> open;
        for (const auto& [a, b] : sides)
            if (sides.count({b, a}) == 0)
                open.emplace_back(b, a);
        if (open.empty())
            break;
        const auto [a, b] = open[below(open.size())];
        std::vector<std::size_t> face{a, b};
        std::size_t vertices = result.points.size();
        for (std::size_t corners = corner_count(); face.size() < corners;) {
            const std::size_t v = below(std::max(vertices, std::min(most_vertices, vertices + 1)));
            vertices = std::max(vertices, v + 1);
            face.push_back(v);
        }
        add(face);
    }
    return result;
}

} // namespace shapes
