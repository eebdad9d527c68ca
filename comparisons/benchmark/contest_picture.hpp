// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contest.hpp"

#include <map>
#include <string>
#include <vector>

namespace kith::comparison {

/// Writes an SVG picture of the contests, one after the other: a bar for the median of each contestant, in nanoseconds
/// per face of the last level. Errors: io::file_error.
void write_bars(const std::string& path, const std::map<std::string, std::string>& facts,
                const std::vector<contest>& contests);

/// The numbers of faces or of threads below the curves of a plot.
enum class curves_over { faces, threads };

/// Writes one SVG picture, scheme by scheme: nanoseconds per face over the numbers of `over`, on logarithmic axes. Each
/// contestant has a curve of the medians of its first runs (dashed) and one of its second runs. Contests of one scheme
/// at several numbers make a curve. Errors: io::file_error.
void write_curves(const std::string& path, const std::map<std::string, std::string>& facts,
                  const std::vector<contest>& contests, curves_over over);

} // namespace kith::comparison
