// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "eigen_mesh.hpp"

#include <kith/linear.hpp>
#include <kith/loop.hpp>
#include <kith/presets.hpp>
#include <kith/refine.hpp>

/// Subdivision of matrices of points and faces, in the shape of libigl's functions of these names.
namespace kith::igl {

/// Refines by any scheme. The results may be the same matrices as the arguments. Errors: as `refine`. Cost: as
/// `refine`, and two copies.
template <scheme Scheme, class V, class F, class NewV, class NewF>
void refine(const Scheme& scheme, const Eigen::MatrixBase<V>& points, const Eigen::MatrixBase<F>& faces,
            Eigen::PlainObjectBase<NewV>& new_points, Eigen::PlainObjectBase<NewF>& new_faces, int steps = 1)
{
    const auto fine = kith::refine(mesh_of_matrices(points, faces), scheme, steps);
    new_points = points_as_matrix(fine).template cast<typename NewV::Scalar>();
    new_faces = faces_as_matrix(fine).template cast<typename NewF::Scalar>();
}

/// Refines by Loop 1987 with the weights and boundaries of libigl's loop. New vertices follow the old ones in the order
/// of kith's edges, which is not the order of libigl.
template <class V, class F, class NewV, class NewF>
void loop(const Eigen::MatrixBase<V>& points, const Eigen::MatrixBase<F>& faces,
          Eigen::PlainObjectBase<NewV>& new_points, Eigen::PlainObjectBase<NewF>& new_faces, int steps = 1)
{
    refine(like<kith::loop>(library::libigl), points, faces, new_points, new_faces, steps);
}

/// Splits each triangle into four in its plane; no vertex moves.
template <class V, class F, class NewV, class NewF>
void upsample(const Eigen::MatrixBase<V>& points, const Eigen::MatrixBase<F>& faces,
              Eigen::PlainObjectBase<NewV>& new_points, Eigen::PlainObjectBase<NewF>& new_faces, int steps = 1)
{
    refine(linear_triangles(), points, faces, new_points, new_faces, steps);
}

} // namespace kith::igl
