// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_attributes.hpp"
#include "mesh_format.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace kith::io {

using attribute_list = std::vector<const attribute*>;

/// The attributes that a format has room for, as its writer takes them: lists that are complete or empty. They refer to
/// the attributes that they were found in.
struct held_attributes {
    attribute_list colors;         ///< of vertices: three or four
    attribute_list normals;        ///< of vertices
    attribute_list textures;       ///< of vertices
    attribute_list face_colors;    ///< three or four
    attribute_list corner_normals; ///< which come before those of vertices
    attribute_list corner_textures;
    attribute_list labels;   ///< words of faces
    attribute_list vertices; ///< under their names, all of PLY
    attribute_list faces;
};

/// Finds the attributes that a format has room for. OBJ: normals and texture coordinates of corners, or of vertices,
/// colours of vertices, words. OFF: normals, colours and texture coordinates of vertices, colours of faces. PLY: all
/// numbers of vertices and faces, words of faces, texture coordinates of corners. STL: colours of faces if it is
/// binary.
held_attributes held_by(mesh_format format, const mesh_attributes& attributes, bool binary = false);

/// Returns the topics (topics_of) of the attributes for which a format has no room, and what binary STL rounds: colours
/// have 32 shades there, and no transparency.
std::vector<std::string> not_held(mesh_format format, const mesh_attributes& attributes, bool binary = false);

/// Returns what is written as 0 because the format has no word for "none": "the colours of 2 of 4 faces". These are
/// whole numbers, and in OFF and PLY what programs read as numbers: normals, texture coordinates, in PLY colours. Cost:
/// O(values).
std::vector<std::string> written_as_zero(mesh_format format, const mesh_attributes& attributes);

/// Whether the format has room for a line of file_lines.
bool holds_file_line(mesh_format format, std::string_view line);

/// Leaves out the attributes for which the format has no room.
void keep_held(mesh_format format, mesh_attributes& attributes, bool binary = false);

} // namespace kith::io
