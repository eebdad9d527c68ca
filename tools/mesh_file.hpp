// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon_soup.hpp"

#include <kith/basic_mesh.hpp>

#include <array>
#include <span>
#include <string>

namespace kith::tool {

/// The points and faces of an OFF, OBJ, PLY or STL file, or of OFF on standard input ("-"), read by CGAL's reader after
/// `guard` has looked at every byte. Triangles of STL that have a point in common share the vertex.
/// Errors: file_error.
polygon_soup read_mesh_file(const std::string& path);

/// Writes a mesh by CGAL's writers, text with 17 digits or binary (PLY, STL), and its vertices' normals, if there are any,
/// unless the format is STL. The file appears when it is complete.
/// Errors: file_error, after which there is no file, or the one that was there before.
void write_mesh_file(const std::string& path, const basic_mesh<>& mesh, bool binary,
                     std::span<const std::array<double, 3>> normals = {});

} // namespace kith::tool
