// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_attributes.hpp"
#include "mesh_tags.hpp"

#include <kith/io/text/text_cursor.hpp>

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace kith::io {

/// The statements of an OBJ file that name all faces up to the next statement of their kind, and the attribute of each.
/// They have the order in which they are written.
inline constexpr std::array<std::pair<std::string_view, std::string_view>, 4> label_statements{
    {{"o", label_names[0]}, {"g", label_names[1]}, {"usemtl", label_names[2]}, {"s", label_names[3]}}};

/// Reads the rest of a line `t name i/f/s ...` of an OBJ file: i whole numbers, f numbers, s words.
/// Errors: file_error.
void read_obj_tag(text_cursor<text_kind::with_continuations>& text, mesh_tags& tags);

/// Returns the lines that read_obj_tag reads as these tags. An infinite sharpness is written as 10, as OpenSubdiv does.
std::string obj_tag_lines(const mesh_tags& tags);

} // namespace kith::io
