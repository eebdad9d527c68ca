// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace kith {

/// A place on a limit surface: a face of the control mesh and parameters in it, 0 to 1.
///
/// In a quad u leads from the first corner to the second, v from the first to the last. In a triangle of a scheme for
/// triangles u leads to the second corner and v to the third, and u + v <= 1. Every other polygon consists of
/// sub-faces, one per corner. (0, 0) is the place of the corner; u leads to the middle of the edge after it, v to the
/// middle of the edge before it. (1, 1) is the centre of the polygon.
struct surface_place {
    std::size_t face = 0;
    double u = 0, v = 0;
    std::size_t corner = 0; ///< the sub-face of a polygon, counted in the face; else 0

    friend bool operator==(const surface_place&, const surface_place&) = default;
};

} // namespace kith
