// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace kith::detail {

/// The parameters s and t in a face of some level. They have derivatives by u and v of the face in the control mesh.
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

} // namespace kith::detail
