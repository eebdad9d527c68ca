// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contest.hpp"

#include <map>
#include <string>
#include <vector>

namespace kith::comparison {

/// Processor, compiler, flags, page size: by name.
std::map<std::string, std::string> machine();

void print(const std::map<std::string, std::string>& facts);

/// A line per contestant: nanoseconds, those of the same work again, and peak bytes per face of the last level,
/// medians, and how many times as fast as the first one, with the least and the most of any round.
void print(const contest& contest);

/// All runs of all contests. Errors: io::file_error.
void write_json(const std::string& path, const std::map<std::string, std::string>& facts,
                const std::vector<contest>& contests);

} // namespace kith::comparison
