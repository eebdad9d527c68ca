// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

namespace kith {

/// A place on a limit surface: a face of the control mesh and parameters in it, 0 to 1.
///
/// In a quad u leads from the first corner to the second and v from the first to the last. In a triangle that a scheme
/// of triangles refines, u leads to the second corner and v to the third, and u + v <= 1. Every other polygon consists
/// of sub-faces, one per corner: (0, 0) is the place of the corner, u leads to the middle of the edge after it, v to
/// the middle of the edge before it, and (1, 1) is the centre of the polygon.
struct surface_place {
    std::size_t face = 0;
    double u = 0, v = 0;
    std::size_t corner = 0; ///< which sub-face of a polygon, counted in the face; else 0

    friend bool operator==(const surface_place&, const surface_place&) = default;
};

namespace detail {

/// Parameters s and t in a face of some level, and their derivatives by u and v of the face in the control mesh.
struct face_parameters {
    double s, t;
    double s_u = 1, s_v = 0, t_u = 0, t_v = 1;

    /// Replaces s and t by linear functions of them, constant + of_s * s + of_t * t.
    void replace(double new_s, double s_by_s, double s_by_t, double new_t, double t_by_s, double t_by_t)
    {
        *this = {new_s,
                 new_t,
                 s_by_s * s_u + s_by_t * t_u,
                 s_by_s * s_v + s_by_t * t_v,
                 t_by_s * s_u + t_by_t * t_u,
                 t_by_s * s_v + t_by_t * t_v};
    }
};

/// Makes parameters in a quad those in the one of its four children that they lie in. Returns the corner of that child.
inline std::size_t descend_in_quad(face_parameters& at)
{
    const double s = at.s, t = at.t;
    if (s < .5 and t < .5) {
        at.replace(2 * s, 2, 0, 2 * t, 0, 2);
        return 0;
    }
    if (t < .5) {
        at.replace(2 * t, 0, 2, 2 * (1 - s), -2, 0);
        return 1;
    }
    if (s >= .5) {
        at.replace(2 * (1 - s), -2, 0, 2 * (1 - t), 0, -2);
        return 2;
    }
    at.replace(2 * (1 - t), 0, -2, 2 * s, 2, 0);
    return 3;
}

/// Same as descend_in_quad, but in a triangle. Returns 3 for the child in the middle.
inline std::size_t descend_in_triangle(face_parameters& at)
{
    const double s = at.s, t = at.t, r = std::max(1 - s - t, 0.);
    if (s + t <= .5) {
        at.replace(2 * s, 2, 0, 2 * t, 0, 2);
        return 0;
    }
    if (s >= .5) {
        at.replace(2 * t, 0, 2, 2 * r, -2, -2);
        return 1;
    }
    if (t >= .5) {
        at.replace(2 * r, -2, -2, 2 * s, 2, 0);
        return 2;
    }
    at.replace(1 - 2 * t, 0, -2, std::max(1 - 2 * r, 0.), 2, 2);
    return 3;
}

} // namespace detail

} // namespace kith
