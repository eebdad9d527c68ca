// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon_soup.hpp"

#include <kith/io/format/mesh_format.hpp>

#include <string>
#include <string_view>

namespace kith::io {

/// The points and faces in the bytes of a file. Nothing in them is believed: each index, count, degree and length is
/// checked, memory grows with what is there and not with what is announced, and what is wrong is refused with its line.
/// Lines end with LF, CR or CRLF; a byte order mark of UTF-8 may come first. Triangles of STL that have a point in
/// common share the vertex. The same result and the same error on any number of threads.
/// Errors: file_error. Cost: one sweep over the bytes; memory a few times that of the bytes.
polygon_soup read_mesh(mesh_format format, std::string_view bytes);

/// The same of a file, by its extension, or of OFF on standard input ("-"). Errors: file_error, which begins with the
/// path.
polygon_soup read_mesh_file(const std::string& path);

/// The same of one format each. Errors and cost: as read_mesh.
polygon_soup read_off(std::string_view bytes);
polygon_soup read_obj(std::string_view bytes);
polygon_soup read_ply(std::string_view bytes);
polygon_soup read_stl(std::string_view bytes);
/// Reads VTK's UnstructuredGrid or PolyData of triangles, quads, polygons and strips: as text, in base64 or raw, also
/// compressed by zlib. Several pieces become one mesh: vertices with the same id (GlobalPointIds) are joined, and
/// vertices and faces are numbered by their ids. An index of files (.pvtu, .pvtp) is read by read_mesh_file.
polygon_soup read_vtu(std::string_view bytes);

} // namespace kith::io
