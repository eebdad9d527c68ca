// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contest.hpp"

#include <map>
#include <string>
#include <vector>

namespace kith::comparison {

/// Writes an SVG picture of the contests, one after the other: a bar for the median of each contestant, in nanoseconds
/// per face of the last level. Errors: io::file_error.
void write_svg(const std::string& path, const std::map<std::string, std::string>& facts,
               const std::vector<contest>& contests);

} // namespace kith::comparison
