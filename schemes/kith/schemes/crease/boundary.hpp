// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mask/mask.hpp>

namespace kith {

/// The rule for a boundary vertex with a single face. OpenSubdiv calls the choices EDGE_AND_CORNER and EDGE_ONLY.
enum class boundary_corner : unsigned char {
    kept,     ///< a corner of the surface, which does not move
    smoothed, ///< a vertex of the boundary curve like any other
};

/// The vertex rule along a boundary.
enum class boundary_curve : unsigned char {
    cubic, ///< the uniform cubic B-spline: 1/8 3/4 1/8
    thirds ///< 1/6 2/3 1/6, OpenMesh's Catmull-Clark: the mean of the vertex and its two edge points. These are the
           ///< limit weights of the B-spline, not its refinement rule; C1
};

/// Returns the vertex rule of the uniform cubic B-spline curve, 1/8 3/4 1/8, along a boundary or a crease. DeRose, Kass
/// & Truong 1998, section 3.
template <mask V>
auto cubic_curve_vertex(const V& v, const V& before, const V& after)
{
    return 3. / 4 * v + 1. / 8 * (before + after);
}

/// Returns the vertex rule of boundary_curve::thirds.
template <mask V>
auto thirds_curve_vertex(const V& v, const V& before, const V& after)
{
    return (4. * v + (before + after)) / 6;
}

} // namespace kith
