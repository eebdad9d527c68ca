// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <string>

namespace kith::io {

/// The formats. All but VTU are written here; VTU is written in tiles (output/). VTU and VTP are VTK's XML files with
/// surfaces, and the indices .pvtu and .pvtp of such files. GLB is the binary form of glTF 2.0; it is only written.
enum class mesh_format : unsigned char { off, obj, ply, stl, vtu, vtp, glb };

/// The contents that a format may have room for, beside places, faces and attributes.
struct format_contents {
    bool tags = false;           ///< sharpness, holes, rules of the boundary
    bool normals = true;         ///< of vertices
    bool corner_normals = false; ///< normals that differ on the sides of sharp edges
    bool isolated_points = true; ///< points without a face
    bool binary = false;         ///< numbers as they lie in memory, beside text
};
/// Returns the contents of a format. Errors: file_error for a number that is no format.
const format_contents& contents_of(mesh_format format);

/// The path of standard input and output, which carry OFF.
inline const std::string standard_stream = "-";

/// Returns the extension of a path, in small letters: ".off".
std::string extension_of(const std::string& path);

/// Returns the format of a file to be read, which its extension names in capital or small letters. Errors: file_error
/// if it names none.
mesh_format format_of(const std::string& path);
/// Returns the same as format_of, but for a file to be written: the error also names the formats of tiles.
mesh_format output_format_of(const std::string& path);

} // namespace kith::io
