// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_input.hpp"
#include "schemes.hpp"

#include <kith/io/format/mesh_format.hpp>

#include <string>

namespace kith::tool {

/// The use of a control mesh on which the handling of its attributes depends.
struct attribute_use {
    const any_scheme& scheme;
    int levels = 0;
    bool limit = false;
    bool binary = false; ///< determines what STL can hold
};

/// Keeps the attributes that the output can hold (held_by), and adds the others to what is not kept. Normals of the
/// file are kept if the mesh is not changed; otherwise they are not used.
void settle_attributes(control_mesh& control, io::mesh_format format, const attribute_use& use);

/// Keeps the attributes that a file of tiles can hold, and adds the others to what is not kept. A .ply file holds the
/// same as without tiles. But it holds texture coordinates of corners only if all faces have them, so that every byte
/// has its place. Files .vtu and .pvtu hold the numbers and labels of vertices and faces, except under names that the
/// formats use themselves.
void settle_tile_attributes(control_mesh& control, const std::string& output, const attribute_use& use);

} // namespace kith::tool
