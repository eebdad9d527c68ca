// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contest.hpp"

#include <map>
#include <string>
#include <vector>

namespace kith::comparison {

/// Draws nanoseconds per face over the number of faces, both as logarithms, as SVG: of each contestant the median of
/// its first runs (dashed) and of those again, scheme by scheme. Contests of one scheme at several sizes make a curve.
/// Errors: io::file_error.
void write_curves(const std::string& path, const std::map<std::string, std::string>& facts,
                  const std::vector<contest>& contests);

} // namespace kith::comparison
