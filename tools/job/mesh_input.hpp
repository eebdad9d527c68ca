// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repair_input.hpp"

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/core/mesh/mesh_report.hpp>
#include <kith/polygon_soup.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace kith::tool {

struct control_mesh {
    basic_mesh<> mesh; ///< the mesh, with the vertices that have a face only
    io::mesh_tags tags{};
    std::vector<std::array<double, 3>> isolated{}; ///< the points of the other vertices
    std::vector<std::string> not_kept{};           ///< the contents of the file that refining loses
    io::mesh_attributes attributes{};              ///< the values of the isolated vertices come last
};

/// Returns the content of a file, and writes notes of the reader to standard error. Errors: file_error.
io::polygon_soup read_soup(const std::string& path);

/// Returns the content of a file after a repair, and writes what the repair did to standard error. Errors: file_error.
io::polygon_soup read_soup(const std::string& path, const input_repair& repair);

/// Returns the mesh in a file. Vertices without a face are put aside, and the vertices after them move up. Errors:
/// file_error for an unreadable file, and for a mesh with problems. The text then names all problems and the options
/// that solve them. Elements have the numbers of the file, or those after the repair.
control_mesh read_mesh(const std::string& path, const input_repair& repair);

/// Returns the mesh of a file's content, with isolated vertices put aside as in read_mesh. Errors: mesh_error.
control_mesh control_mesh_of(const io::polygon_soup& soup);

/// Returns a flag for each vertex: true if a face has the vertex.
std::vector<bool> vertices_with_faces(const io::polygon_soup& soup);

/// Returns the problems of a file's mesh, in the numbers of the file. Vertices without a face are reported only if
/// there is another problem.
mesh_report report_of(const io::polygon_soup& soup);

/// Prints a note of one line on the contents of a file that are lost; prints nothing if the list is empty.
void note_losses(const std::string& input, const std::vector<std::string>& lost);

/// Prints a note of one line on the values for which an output has 0, since its format cannot mark missing values.
/// Prints nothing if the list is empty.
void note_zeros(const std::string& output, const std::vector<std::string>& zeros);

/// Adds the edges and vertices that are still sharp to what is lost, if there are any.
void add_lost_sharpness(std::vector<std::string>& lost, std::size_t edges, std::size_t vertices);

} // namespace kith::tool
