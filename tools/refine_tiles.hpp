// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "back_end.hpp"

#include <kith/checksum.hpp>
#include <kith/whole_numbering.hpp>

#include <cstdint>
#include <string>

namespace kith::tool {

struct tiled_result {
    whole_counts counts;
    mesh_checksum checksum;
};

/// Refines in tiles, one after the other, and writes each where it belongs; the whole surface is never in memory.
/// Errors: usage_error for a scheme without reach, file_error, mesh_error, write_error; no file is left then.
tiled_result refine_tiles(const basic_mesh<>& control, const refine_request& request, std::uint64_t tiles,
                          const std::string& partitioner, const std::string& output);

} // namespace kith::tool
