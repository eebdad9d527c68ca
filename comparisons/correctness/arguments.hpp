// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace kith::comparison {

/// What every compare_... program is told.
struct arguments {
    std::vector<std::filesystem::path> files;
    std::size_t max_faces;
    int levels;
};

/// Nothing when --help was asked for, which is then answered. Errors: boost::program_options::error.
std::optional<arguments> parse(int count, char** words, const std::string& what_it_does);

} // namespace kith::comparison
