// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_tags.hpp"
#include "text_scanner.hpp"

namespace kith::tool {

/// Reads the rest of a line `t name i/f/s ...` of an OBJ file: i whole numbers, f numbers, s words.
/// Errors: file_error.
void read_obj_tag(text_scanner& scan, mesh_tags& tags);

} // namespace kith::tool
