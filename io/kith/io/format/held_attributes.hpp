// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_attributes.hpp"
#include "mesh_format.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace kith::io {

using attribute_list = std::vector<const attribute*>;

/// The attributes that a format has room for, in the lists that its writer takes, which are complete or empty. The
/// lists refer to the attributes in which they were found.
struct held_attributes {
    attribute_list colors;         ///< of vertices: three or four
    attribute_list normals;        ///< of vertices
    attribute_list textures;       ///< of vertices
    attribute_list face_colors;    ///< three or four
    attribute_list corner_normals; ///< take precedence over normals of vertices
    attribute_list corner_textures;
    attribute_list labels;   ///< words of faces
    attribute_list vertices; ///< under their names; in PLY all of them
    attribute_list faces;
};

/// Finds the attributes that a format has room for. OBJ: normals and texture coordinates of corners, or of vertices,
/// colours of vertices, words. OFF: normals, colours and texture coordinates of vertices, colours of faces. PLY: all
/// numbers of vertices and faces, words of faces, texture coordinates of corners. STL: colours of faces if it is
/// binary.
held_attributes held_by(mesh_format format, const mesh_attributes& attributes, bool binary = false);

/// Returns the topics (topics_of) of the attributes for which a format has no room, and of those that binary STL
/// rounds. Colours have 32 shades there, and no transparency.
std::vector<std::string> not_held(mesh_format format, const mesh_attributes& attributes, bool binary = false);

/// Returns what is written as 0 because the format has no word for "none": "the colours of 2 of 4 faces". These are
/// attributes of whole numbers. In OFF and PLY they are also normals and texture coordinates, and in PLY colours,
/// because programs read these as numbers. Cost: O(values).
std::vector<std::string> written_as_zero(mesh_format format, const mesh_attributes& attributes);

/// Returns true if the format has room for a line of file_lines.
bool holds_file_line(mesh_format format, std::string_view line);

/// Removes the attributes for which the format has no room.
void keep_held(mesh_format format, mesh_attributes& attributes, bool binary = false);

} // namespace kith::io
