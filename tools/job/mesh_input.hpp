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
    basic_mesh<> mesh; ///< of the vertices that have a face
    io::mesh_tags tags{};
    std::vector<std::array<double, 3>> isolated{}; ///< where the other vertices are
    std::vector<std::string> not_kept{};           ///< what else the file holds, which refining loses
    io::mesh_attributes attributes{};              ///< the isolated vertices come last
};

/// The content of a file. Notes of the reader are written to standard error. Errors: file_error.
io::polygon_soup read_soup(const std::string& path);

/// Same as read_soup, but after a repair; what it did is written to standard error. Errors: file_error.
io::polygon_soup read_soup(const std::string& path, const input_repair& repair);

/// The mesh in a file. Vertices without a face are put aside, those after them move up. Errors: file_error for what the
/// file is, and with everything that is wrong with the mesh and the options that mend it. Elements have the numbers of
/// the file, or those after the repair.
control_mesh read_mesh(const std::string& path, const input_repair& repair);

/// The same of its content. Errors: mesh_error.
control_mesh control_mesh_of(const io::polygon_soup& soup);

/// The vertices that faces have.
std::vector<bool> vertices_with_faces(const io::polygon_soup& soup);

/// What is wrong with a file's mesh, in its numbers. Vertices without a face are told only where something else is
/// wrong.
mesh_report report_of(const io::polygon_soup& soup);

/// Notes in one line what of a file is lost on the way; nothing if that is nothing.
void note_losses(const std::string& input, const std::vector<std::string>& lost);

/// Notes in one line what an output has 0 for, as its format has no word for "none"; nothing if that is nothing.
void note_zeros(const std::string& output, const std::vector<std::string>& zeros);

/// Adds the sharp edges and vertices that are left to what is lost, where there are any.
void add_lost_sharpness(std::vector<std::string>& lost, std::size_t edges, std::size_t vertices);

} // namespace kith::tool
