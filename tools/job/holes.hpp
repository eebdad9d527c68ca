// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "back_end.hpp"
#include "mesh_input.hpp"

#include <kith/core/mesh/basic_mesh.hpp>

namespace kith::tool {

/// The faces of a control mesh that its tags make holes: those they name, and where the boundary is not to be
/// interpolated all that touch it. Empty: there are none. Errors: mesh_error for a face that is not there, and when
/// nothing is left.
hole_field holes_of(const io::mesh_tags& tags, const basic_mesh<>& mesh);

/// For surfaces in tiles, of which holes are not left out. Errors: mesh_error.
void require_no_holes(const control_mesh& control);

/// As OpenSubdiv has it: holes shape the surface around them like other faces, and are left out in the end, with the
/// vertices that no other face has.
void leave_out_holes(refined_mesh& result, io::mesh_attributes& attributes);

} // namespace kith::tool
