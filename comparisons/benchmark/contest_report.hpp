// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contest.hpp"

#include <map>
#include <string>
#include <vector>

namespace kith::comparison {

/// Returns facts about the machine by name: processor, compiler, flags, page size.
std::map<std::string, std::string> machine();

void print(const std::map<std::string, std::string>& facts);

/// Prints one line per contestant with medians per face of the last level: nanoseconds, nanoseconds of the second run
/// of the same work, and peak bytes. The speed relative to the first contestant follows, with its least and largest
/// value over the rounds.
void print(const contest& contest);

/// Writes all runs of all contests as JSON. Errors: io::file_error.
void write_json(const std::string& path, const std::map<std::string, std::string>& facts,
                const std::vector<contest>& contests);

} // namespace kith::comparison
