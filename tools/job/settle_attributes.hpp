// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_input.hpp"
#include "schemes.hpp"

#include <kith/io/format/mesh_format.hpp>

#include <string>

namespace kith::tool {

/// What is done with a control mesh, as far as its attributes go.
struct attribute_use {
    const any_scheme& scheme;
    int levels = 0;
    bool limit = false;
    bool binary = false; ///< which says what STL holds
};

/// Leaves to the fields what the output holds (held_by), and adds the rest to what is not kept. Normals are kept where
/// the mesh is, and else not made from those of the file.
void settle_attributes(control_mesh& control, io::mesh_format format, const attribute_use& use);

/// The same for files of tiles: .ply has what it has without tiles, texture coordinates of corners only where all faces
/// have some, so that every byte has its place; .vtu and .pvtu have the numbers and words of vertices and faces, but
/// for names that they take.
void settle_tile_attributes(control_mesh& control, const std::string& output, const attribute_use& use);

} // namespace kith::tool
