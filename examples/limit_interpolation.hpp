// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/surface/surface_locator.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

/// Returns a place at each vertex of a mesh of triangles or of quads.
inline std::vector<kith::surface_place> places_of_vertices(const kith::basic_mesh<>& m)
{
    constexpr std::array<std::array<double, 2>, 4> quad{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    constexpr std::array<std::array<double, 2>, 3> triangle{{{0, 0}, {1, 0}, {0, 1}}};
    std::vector<kith::surface_place> result(m.vertex_count());
    for (std::size_t f = 0; f < m.face_count(); ++f)
        for (std::size_t k = 0; k < m.face(f).size(); ++k) {
            const auto [u, v] = m.face(f).size() == 4 ? quad[k] : triangle[k];
            result[m.face(f)[k]] = {f, u, v};
        }
    return result;
}

/// Returns control points whose limit surface interpolates the points of `m`. `limits` has the weights at vertices.
inline std::vector<std::array<double, 3>> interpolating_control_points(const kith::basic_mesh<>& m,
                                                                       std::span<const kith::stencil_row> limits)
{
    const auto rows = kith::make_matrix(limits, m.vertex_count());
    std::vector<std::array<double, 3>> control(m.points().begin(), m.points().end());
    for (double error = 1; error > 1e-13;) { // the eigenvalues of `rows` are above 0 and at most 1
        const auto reached = rows.apply(control);
        double largest = 0, size = 0;
        for (std::size_t v = 0; v < control.size(); ++v)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double correction = m.point(v)[axis] - reached[v][axis];
                control[v][axis] += correction;
                largest = std::fmax(largest, std::abs(correction));
                size = std::fmax(size, std::abs(control[v][axis]));
            }
        error = largest / size;
    }
    return control;
}
