// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_polynomial.hpp"

#include <kith/mesh/connectivity.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace kith::detail {

/// The mesh around a face: its connectivity, the rows of its vertices, and which edges are infinitely sharp.
template <std::unsigned_integral Index>
struct rows_of_part {
    const connectivity<Index>& mesh;
    std::span<const stencil_row> rows; ///< of the vertices
    std::size_t inputs;                ///< that the rows have weights of
    std::function<bool(Index edge)> is_sharp;

    /// Returns true if the surface ends or bends at the edge of a corner: control points beyond it have no weight.
    [[nodiscard]] bool is_wall(Index corner) const
    {
        return mesh.across(corner) == mesh.none or is_sharp(Index(mesh.corner_halfedge[corner] / 2));
    }
    [[nodiscard]] std::size_t degree_at(Index corner) const
    {
        const std::size_t face = mesh.face_of(corner);
        return std::size_t(mesh.first_corner(face + 1) - mesh.first_corner(face));
    }
    [[nodiscard]] control_row row(Index corner) const { return dense(rows[mesh.corner_vertex[corner]], inputs); }
};

/// Returns a - b + c. Mirrors a point at an edge, so that a spline goes on beyond a boundary.
inline control_row mirrored(const control_row& a, const control_row& b, const control_row& c)
{
    control_row result = a;
    add(result, -1, b);
    add(result, 1, c);
    return result;
}

/// Returns true if all points of two nets are equal but for rounding.
inline bool are_equal(std::span<const control_row> a, std::span<const control_row> b)
{
    constexpr double rounding = 1e-12;
    const auto is_near = [](double x, double y) { return std::abs(x - y) <= rounding; };
    return std::ranges::equal(
        a, b, [&](const control_row& x, const control_row& y) { return std::ranges::equal(x, y, is_near); });
}

} // namespace kith::detail
