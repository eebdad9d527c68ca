// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.hpp"

namespace kith::tool {

/// Whether a file can only be written in tiles, even if one will do.
bool is_tile_format_only(const boost::program_options::variables_map& values);

/// `kith refine --tiles` or `--journal`; returns the exit code.
int run_refine_tiles(const boost::program_options::variables_map& values);

} // namespace kith::tool
