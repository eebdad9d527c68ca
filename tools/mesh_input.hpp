// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_tags.hpp"

#include <kith/basic_mesh.hpp>

#include <string>

namespace kith::tool {

struct control_mesh {
    basic_mesh<> mesh;
    mesh_tags tags;
};

/// The mesh in a file. Errors: file_error for what the file is, and with everything that is wrong with the mesh.
control_mesh read_mesh(const std::string& path);

} // namespace kith::tool
