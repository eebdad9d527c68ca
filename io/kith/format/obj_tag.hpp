// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_tags.hpp"

#include <kith/text/text_cursor.hpp>

#include <string>

namespace kith::io {

/// Reads the rest of a line `t name i/f/s ...` of an OBJ file: i whole numbers, f numbers, s words.
/// Errors: file_error.
void read_obj_tag(text_cursor<text_kind::with_continuations>& text, mesh_tags& tags);

/// The lines that read_obj_tag understands as these tags. A sharpness without end is written as 10, as OpenSubdiv has it.
std::string obj_tag_lines(const mesh_tags& tags);

} // namespace kith::io
