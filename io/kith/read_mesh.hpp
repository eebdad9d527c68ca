// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon_soup.hpp"

#include <kith/io/format/mesh_format.hpp>

#include <string>
#include <string_view>

namespace kith::io {

/// Reads the points and faces in the bytes of a file. The bytes are not trusted: each index, count, degree and length
/// is checked. Memory grows with the content of the file, not with the counts that it announces. An error names its
/// line. Lines end with LF, CR or CRLF; a byte order mark of UTF-8 may come first. Triangles of STL that have a point
/// in common share the vertex. The result and the error are the same on any number of threads.
/// Errors: file_error. Cost: one sweep over the bytes; memory of a few times their size.
polygon_soup read_mesh(mesh_format format, std::string_view bytes);

/// Reads a file in the format of its extension, or OFF from standard input ("-"). Errors: file_error, which begins with
/// the path.
polygon_soup read_mesh_file(const std::string& path);

/// Reads the bytes of a file in one format each. Errors and cost: as read_mesh.
polygon_soup read_off(std::string_view bytes);
polygon_soup read_obj(std::string_view bytes);
polygon_soup read_ply(std::string_view bytes);
polygon_soup read_stl(std::string_view bytes);
/// Reads VTK's UnstructuredGrid or PolyData of triangles, quads, polygons and strips: as text, in base64 or raw, also
/// compressed by zlib. Several pieces become one mesh: vertices with the same id (GlobalPointIds) are joined, and ids
/// set the order of vertices and faces. Use read_mesh_file for an index of files (.pvtu, .pvtp).
polygon_soup read_vtu(std::string_view bytes);

} // namespace kith::io
