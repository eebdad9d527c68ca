// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "recipe.hpp"

#include <functional>
#include <optional>
#include <string>

namespace kith::tool {

/// Where a refinement in tiles keeps what it has finished, and how much of it there will be.
struct journal_place {
    std::string directory;
    std::uint64_t tiles = 0;
    std::uint64_t recipe = 0; ///< its checksum
};

/// No directory is no journal.
std::optional<journal_place> place_of(const std::string& directory, const recipe& recipe);

/// The recipe that a journal's directory keeps. Errors: file_error when there is none, or it is damaged.
recipe kept_recipe(const std::string& directory);

/// The recipe that a journal's directory keeps or, where there is none, one of this request with the partition that `make`
/// gives. Errors: file_error for the recipe of another refinement.
recipe recipe_for(const std::string& directory, const tile_request& request, const std::function<partition()>& make);

/// Begins a journal, unless it is there already or there shall be none. The recipe appears when it is complete, so that a
/// process that is ended meanwhile leaves no half of one.
/// Errors: file_error, also when the output is on another file system, write_error.
void begin_journal(const std::string& directory, const recipe& recipe, const std::string& output);

/// When the surface has its name: nothing of the journal is left, nor of the directory if nothing else is in it.
void remove_journal(const std::string& directory) noexcept;

} // namespace kith::tool
