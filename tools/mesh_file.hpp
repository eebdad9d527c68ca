// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/write_mesh.hpp>

#include <string>

namespace kith::tool {

/// Writes a mesh in the format that the extension of the path names. The file appears when it is complete.
/// Errors: file_error, after which there is no file, or the one that was there before.
void write_mesh_file(const std::string& path, const io::written_mesh& what);

} // namespace kith::tool
