// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.hpp"

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/tiles/part/partition.hpp>

#include <cstddef>
#include <string>

namespace kith::tool {

/// Returns the value of --partitioner: metis (the default), block or file:PATH. Errors: usage_error.
std::string partitioner_from(const boost::program_options::variables_map& values);

/// Returns the partition of a mesh that a value of --partitioner asks for: metis, block or file:PATH. Errors:
/// file_error, mesh_error.
partition make_partition(const std::string& partitioner, const basic_mesh<>& mesh, std::size_t parts);

} // namespace kith::tool
