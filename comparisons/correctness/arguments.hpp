// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace kith::comparison {

/// The arguments of every compare_... program.
struct arguments {
    std::vector<std::filesystem::path> files;
    std::size_t max_faces;
    int levels;
};

/// Parses the command line. Returns no value after printing the help text for --help. Errors:
/// boost::program_options::error.
std::optional<arguments> parse(int count, char** words, const std::string& what_it_does);

} // namespace kith::comparison
