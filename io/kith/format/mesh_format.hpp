// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/in_library.hpp>

#include <string>

namespace kith::io {

/// The formats that are read. All but VTU are written here, VTU in tiles (output/). VTU stands for the XML files of VTK
/// that hold surfaces: .vtu, .vtp, and the indices .pvtu and .pvtp of such files.
enum class mesh_format : unsigned char { off, obj, ply, stl, vtu };

/// "-" is standard input or output, which carries OFF.
inline const std::string standard_stream = "-";

/// The extension of a path, in small letters: ".off".
std::string extension_of(const std::string& path);

/// The format that a path's extension names, in any case of letters. Errors: file_error when it names none.
mesh_format format_of(const std::string& path);
/// The same of a file that is to be written; the error names the formats of tiles, too.
mesh_format output_format_of(const std::string& path);

} // namespace kith::io
