// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <string>

namespace kith::io {

/// The formats that are read. All but VTU are written here, VTU in tiles (output/). VTU and VTP stand for the XML files
/// of VTK that hold surfaces, and for the indices .pvtu and .pvtp of such files.
enum class mesh_format : unsigned char { off, obj, ply, stl, vtu, vtp };

/// Contents that a format may have room for, beside places, faces and attributes.
struct format_contents {
    bool tags = false;           ///< sharpness, holes, rules of the boundary
    bool normals = true;         ///< of vertices
    bool corner_normals = false; ///< which differ on the sides of sharp edges
    bool isolated_points = true; ///< points without a face
    bool binary = false;         ///< numbers as they lie in memory, beside text
};
/// Returns the contents of a format. Errors: file_error for a number that is none.
const format_contents& contents_of(mesh_format format);

/// "-" is standard input or output, which carries OFF.
inline const std::string standard_stream = "-";

/// The extension of a path, in small letters: ".off".
std::string extension_of(const std::string& path);

/// The format that a path's extension names, in any case of letters. Errors: file_error when it names none.
mesh_format format_of(const std::string& path);
/// Same as format_of, but of a file that is to be written. The error names the formats of tiles, too.
mesh_format output_format_of(const std::string& path);

} // namespace kith::io
