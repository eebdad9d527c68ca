// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json.hpp"

#include <kith/tiles/part/phase_seconds.hpp>

#include <iosfwd>
#include <string>

namespace kith::tool {

inline constexpr const char* stats_help =
    "write the seconds of each phase as JSON; with --json, the result line has them as well";

/// What this process has had of the processors, in seconds.
double processor_seconds();

/// Returns the seconds of each phase by its name.
json json_of(const phase_seconds& seconds);

/// Writes the phases of this process and what it took in all, a line of JSON. Errors: io::file_error.
void write_stats(const std::string& path, const phase_seconds& seconds);

/// Prints the line that says what has been done. Errors: file_error, which says that `output` is complete all the same.
void print_result(std::ostream& out, const std::string& line, const std::string& output);

} // namespace kith::tool
