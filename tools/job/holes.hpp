// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "back_end.hpp"
#include "mesh_input.hpp"

#include <kith/core/mesh/basic_mesh.hpp>

namespace kith::tool {

/// Returns the faces of a control mesh that its tags make holes: the faces that they name and, if the boundary is not
/// interpolated, all faces that touch it. The result is empty if there are none. Errors: mesh_error for a face that
/// does not exist, and if no face is left.
hole_field holes_of(const io::mesh_tags& tags, const basic_mesh<>& mesh);

/// Throws mesh_error if a mesh has holes, which surfaces in tiles cannot leave out.
void require_no_holes(const control_mesh& control);

/// Removes the holes of a refined mesh, with the vertices that no other face has, as OpenSubdiv does. Until then holes
/// shape the surface around them like other faces.
void leave_out_holes(refined_mesh& result, io::mesh_attributes& attributes);

} // namespace kith::tool
