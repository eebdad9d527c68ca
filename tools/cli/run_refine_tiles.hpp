// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.hpp"

namespace kith::tool {

/// Returns true if the output has a format that is always written in tiles (.vtu, .pvtu), even if there is only one
/// tile.
bool is_tile_format_only(const boost::program_options::variables_map& values);

/// Runs `kith refine --tiles` or `--journal`. Returns the exit code.
int run_refine_tiles(const boost::program_options::variables_map& values);

} // namespace kith::tool
