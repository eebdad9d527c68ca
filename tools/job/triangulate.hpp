// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_input.hpp"

namespace kith::tool {

/// Returns the mesh with its faces cut into triangles. A quad is cut along the diagonal that keeps both triangles large
/// and in one plane. Larger faces are cut by the constrained Delaunay triangulation in their planes, so they need not
/// be convex. Vertices keep their numbers, and faces their order. The triangles of a hole are holes, and attributes go
/// to the triangles and corners of their face. The same file gives the same triangles.
/// Errors: mesh_error for faces that have no plane or cross themselves, and for triangles that together form no
/// manifold.
/// Cost: O(corners), and O(n log n) for a face with n corners.
control_mesh triangulated(control_mesh control);

} // namespace kith::tool
