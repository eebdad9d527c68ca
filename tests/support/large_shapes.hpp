// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapes.hpp"

#include <cmath>
#include <cstddef>

/// Shapes with one or two rings of any size. None of them is symmetric.
namespace shapes {

inline point on_rim(std::size_t i, std::size_t n)
{
    const double t = 2 * std::acos(-1.) * double(i) / double(n);
    return {std::cos(t) + 0.1 * std::cos(3 * t), std::sin(t), 0.1 * std::sin(5 * t)};
}

/// Returns two n-gons with n quads between them.
inline shape prism(std::size_t n)
{
    shape result;
    std::vector<std::size_t> bottom, top;
    for (std::size_t i = 0; i < 2 * n; ++i) {
        result.points.push_back(on_rim(i % n, n));
        result.points.back()[2] += i < n ? 0 : 1;
    }
    for (std::size_t i = 0; i < n; ++i) {
        bottom.push_back(n - 1 - i);
        top.push_back(n + i);
        result.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    }
    result.faces.push_back(bottom);
    result.faces.push_back(top);
    return result;
}

/// Returns two vertices, n and n + 1, with n triangles each.
inline shape double_pyramid(std::size_t n)
{
    shape result;
    for (std::size_t i = 0; i < n; ++i) {
        result.points.push_back(on_rim(i, n));
        result.faces.push_back({i, (i + 1) % n, n});
        result.faces.push_back({(i + 1) % n, i, n + 1});
    }
    result.points.push_back({.1, 0, 1});
    result.points.push_back({0, .2, -1});
    return result;
}

/// Returns two vertices, 2n and 2n + 1, with n quads each; all others have valence 3.
inline shape quads_around(std::size_t n)
{
    shape result;
    const std::size_t rim = 2 * n;
    for (std::size_t i = 0; i < rim; ++i)
        result.points.push_back(on_rim(i, rim));
    for (std::size_t i = 0; i < rim; i += 2) {
        result.faces.push_back({rim, i, i + 1, (i + 2) % rim});
        result.faces.push_back({rim + 1, (i + 3) % rim, (i + 2) % rim, i + 1});
    }
    result.points.push_back({.1, 0, 1});
    result.points.push_back({0, .2, -1});
    return result;
}

/// Returns vertex 0 with n triangles and quads in alternation, closed by one large face. Precondition: n is even.
inline shape triangles_and_quads_around(std::size_t n)
{
    shape result{{{.1, 0, 1}}, {}};
    const std::size_t rim = n + n / 2;
    std::vector<std::size_t> below;
    for (std::size_t i = 0; i < rim; ++i) {
        result.points.push_back(on_rim(i, rim));
        below.push_back(rim - i);
        const auto at = [&](std::size_t k) { return 1 + (i + k) % rim; };
        if (i % 3 == 0)
            result.faces.push_back({0, at(0), at(1)});
        else if (i % 3 == 1)
            result.faces.push_back({0, at(0), at(1), at(2)});
    }
    result.faces.push_back(below);
    return result;
}

} // namespace shapes
