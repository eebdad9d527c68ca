// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_input.hpp"

namespace kith::tool {

/// Returns the mesh with its faces cut into triangles: a quad along the diagonal that keeps both triangles large and in
/// one plane, larger faces by the constrained Delaunay triangulation in their planes, so that they need not be convex.
/// Vertices keep their numbers, faces their order, holes are the triangles of a hole, and attributes go to the
/// triangles and corners of their face. The same file gives the same triangles.
/// Errors: mesh_error for faces that have no plane or cross themselves, and for triangles that are no manifold
/// together.
/// Cost: O(corners), of faces with n corners O(n log n).
control_mesh triangulated(control_mesh control);

} // namespace kith::tool
