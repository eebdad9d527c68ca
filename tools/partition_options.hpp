// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/basic_mesh.hpp>
#include <kith/partition.hpp>

#include <cstddef>
#include <string>

namespace kith::tool {

/// Errors: usage_error when --partitioner is none of metis, block, file:PATH.
void require_partitioner(const std::string& partitioner);

/// The partition that --partitioner asks for: metis, block or file:PATH. Errors: file_error, mesh_error.
partition make_partition(const std::string& partitioner, const basic_mesh<>& mesh, std::size_t parts);

} // namespace kith::tool
