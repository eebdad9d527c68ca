// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json.hpp"

#include <kith/tiles/part/phase_seconds.hpp>

#include <iosfwd>
#include <string>

namespace kith::tool {

inline constexpr const char* stats_help =
    "write the seconds of each phase as JSON; with --json, the result line has them as well";

/// Returns the processor time that this process has used, in seconds.
double processor_seconds();

/// Returns the seconds of each phase by its name.
json json_of(const phase_seconds& seconds);

/// Writes the seconds of each phase, the processor seconds and the peak memory of this process as a line of JSON.
/// Errors: io::file_error.
void write_stats(const std::string& path, const phase_seconds& seconds);

/// Prints the line that reports the result. Errors: file_error, whose text says that `output` is complete all the same.
void print_result(std::ostream& out, const std::string& line, const std::string& output);

} // namespace kith::tool
