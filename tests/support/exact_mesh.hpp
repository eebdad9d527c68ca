// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rational.hpp"
#include "shapes.hpp"

#include <kith/core/mesh/make_mesh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

/// A point with rational coordinates, so that schemes compute exactly.
using exact_point = std::array<rational, 3>;
using exact_mesh = kith::basic_mesh<exact_point, std::uint32_t>;

inline exact_mesh exact(const shapes::shape& s)
{
    std::vector<exact_point> points;
    for (const auto& [x, y, z] : s.points)
        points.push_back({rational(x), rational(y), rational(z)});
    return kith::make_mesh(points, s.faces);
}

/// Returns the number of the edge between two vertices. Errors: std::invalid_argument if there is none.
inline std::size_t edge_number(const exact_mesh& mesh, std::size_t a, std::size_t b)
{
    const auto& t = mesh.topology();
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i)
            if (std::minmax(std::size_t(face[i]), std::size_t(face[(i + 1) % face.size()])) == std::minmax(a, b))
                return t.corner_halfedge[t.first_corner(f) + i] / 2;
    }
    throw std::invalid_argument("no edge joins vertices " + std::to_string(a) + " and " + std::to_string(b));
}
