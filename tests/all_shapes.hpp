// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace shapes {

/// Triangles whose edges have been flipped at random: all kinds of valences, the same for the same seed.
inline shape with_flips(shape s, std::uint32_t seed, int flips = 200)
{
    std::minstd_rand random(seed);
    const auto face_of = [&](std::size_t a, std::size_t b) { // the triangle with half-edge a -> b, turned to start so
        for (auto& f : s.faces)
            for (std::size_t i = 0; i < 3; ++i)
                if (f[i] == a and f[(i + 1) % 3] == b) {
                    std::ranges::rotate(f, f.begin() + std::ptrdiff_t(i));
                    return &f;
                }
        return static_cast<std::vector<std::size_t>*>(nullptr);
    };
    for (int i = 0; i < flips; ++i) {
        auto* const left = &s.faces[random() % s.faces.size()];
        const std::size_t a = (*left)[0], b = (*left)[1], p = (*left)[2];
        auto* const right = face_of(b, a);
        if (right == nullptr)
            continue;
        const std::size_t q = (*right)[2];
        if (p == q or face_of(p, q) != nullptr or face_of(q, p) != nullptr)
            continue;
        *left = {q, p, a}; // of the diamond a q b p
        *right = {p, q, b};
    }
    return s;
}

/// Polygons made by joining neighbours at random, where they have only one edge in common. Its ends keep two edges and
/// more besides.
inline shape with_joins(shape s, std::uint32_t seed, int joins)
{
    std::minstd_rand random(seed);
    for (int i = 0; i < joins; ++i) {
        const std::size_t one = random() % s.faces.size(), other = random() % s.faces.size();
        auto &f = s.faces[one], &g = s.faces[other];
        const auto in_g = [&g](std::size_t v) { return std::ranges::count(g, v) != 0; };
        if (one == other or std::ranges::count_if(f, in_g) != 2)
            continue;
        for (std::size_t turn = 1; turn < f.size() and not(in_g(f[0]) and in_g(f[1])); ++turn)
            std::ranges::rotate(f, f.begin() + 1);
        if (not(in_g(f[0]) and in_g(f[1])))
            continue;
        std::ranges::rotate(g, std::ranges::find(g, f[1]));
        const auto faces_at = [&s](std::size_t v) {
            return std::ranges::count_if(s.faces, [v](const auto& face) { return std::ranges::count(face, v) != 0; });
        };
        if (g[1] != f[0] or faces_at(f[0]) < 4 or faces_at(f[1]) < 4)
            continue;
        f.insert(f.begin() + 1, g.begin() + 2, g.end());
        s.faces.erase(s.faces.begin() + std::ptrdiff_t(other));
    }
    return s;
}

using named_shape = std::pair<std::string, shape>;

inline std::vector<named_shape> triangle_shapes()
{
    return {{"one triangle", polygon(3)},
            {"tetrahedron", shaken(tetrahedron())},
            {"triangulated cube", shaken(triangulated(cube()))},
            {"triangulated grid", shaken(triangulated(grid()))},
            {"triangulated L", shaken(triangulated(l_shape()))},
            {"triangulated ring", shaken(triangulated(ring()))},
            {"umbrella of 3", shaken(umbrella(3))},
            {"umbrella of 9", shaken(umbrella(9))},
            {"torus of triangles", shaken(triangulated(torus(5, 7)))},
            {"flipped torus", with_flips(shaken(triangulated(torus(5, 7))), 1)},
            {"flipped grid", with_flips(shaken(triangulated(grid(5, 5))), 2)},
            {"two components", both(tetrahedron(), triangulated(grid(1, 2)))}};
}

inline std::vector<named_shape> all_shapes()
{
    auto result = triangle_shapes();
    const std::vector<named_shape> more{
        {"cube", shaken(cube())},
        {"torus", shaken(torus(5, 7))},
        {"grid", shaken(grid())},
        {"L", shaken(l_shape())},
        {"ring", shaken(ring())},
        {"house", shaken(house())},
        {"open house", shaken(open_house())},
        {"joined torus", with_joins(shaken(torus(6, 6)), 3, 100)},
        {"joined grid", with_joins(with_flips(shaken(triangulated(grid(6, 6))), 4), 5, 1000)},
        {"one quad", polygon(4)},
        {"one heptagon", polygon(7)},
        {"valence two", valence_two()},
        {"cube and triangle", both(cube(), polygon(3))}};
    result.insert(result.end(), more.begin(), more.end());
    return result;
}

/// For schemes that make a face of every vertex.
inline std::vector<named_shape> shapes_without_valence_two()
{
    auto result = all_shapes();
    std::erase_if(result, [](const named_shape& s) { return s.first == "valence two"; });
    return result;
}

} // namespace shapes
