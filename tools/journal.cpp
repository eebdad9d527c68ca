// SPDX-License-Identifier: BSD-3-Clause
#include "journal.hpp"

#include "errors.hpp"
#include "input_file.hpp"

#include <kith/offset_file.hpp>
#include <kith/pack.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include <sys/stat.h>
#include <unistd.h>

namespace kith::tool {

namespace fs = std::filesystem;

namespace {

std::string recipe_in(const std::string& directory)
{
    return (fs::path(directory) / "recipe").string();
}

std::optional<recipe> find_recipe(const std::string& directory)
{
    const std::string path = recipe_in(directory);
    std::error_code failed;
    if (not fs::exists(path, failed))
        return std::nullopt;
    const std::string bytes = read_bytes(path);
    const auto view = std::as_bytes(std::span(bytes));
    try {
        return unpack_recipe({view.begin(), view.end()});
    } catch (const pack_error& error) {
        throw file_error(path + ": " + error.what() + "; remove " + directory + " and begin again");
    }
}

/// The surface gets its name by renaming, which no file system does for another.
void require_one_file_system(const std::string& output, const std::string& directory)
{
    struct stat there = {}, here = {};
    if (stat(fs::absolute(output).parent_path().c_str(), &there) != 0)
        throw file_error(output + ": cannot be written: " + std::strerror(errno));
    std::error_code failed;
    const fs::path kept = fs::exists(directory, failed) ? fs::path(directory) : fs::absolute(directory).parent_path();
    if (stat(kept.c_str(), &here) == 0 and here.st_dev != there.st_dev)
        throw file_error(directory + ": is on another file system than " + output +
                         "; put the journal next to the output");
}

} // namespace

std::optional<journal_place> place_of(const std::string& directory, const recipe& recipe)
{
    if (directory.empty())
        return std::nullopt;
    return journal_place{directory, recipe.parts.parts, checksum_of(recipe)};
}

recipe kept_recipe(const std::string& directory)
{
    auto kept = find_recipe(directory);
    if (not kept)
        throw file_error(directory + ": holds no recipe to go on with; name the mesh, and what to do with it");
    return std::move(*kept);
}

recipe recipe_for(const std::string& directory, const tile_request& request, const std::function<partition()>& make)
{
    auto kept = find_recipe(directory);
    if (not kept)
        return recipe_of(request, make());
    if (const auto text = difference(*kept, recipe_of(request, {})); not text.empty())
        throw file_error(directory + ": is the journal of another refinement, " + text +
                         "; finish that one, or name another directory");
    return std::move(*kept);
}

void begin_journal(const std::string& directory, const recipe& recipe, const std::string& output)
{
    if (directory.empty())
        return;
    require_one_file_system(output, directory);
    const std::string path = recipe_in(directory);
    std::error_code failed;
    if (fs::exists(path, failed))
        return;
    fs::create_directory(directory, failed);
    if (failed)
        throw file_error(directory + ": cannot be made: " + failed.message());
    const auto bytes = pack_recipe(recipe);
    const std::string incomplete = path + ".incomplete-" + std::to_string(getpid());
    try {
        auto file = offset_file::create(incomplete, bytes.size());
        file.write(0, bytes.data(), bytes.size());
        file.flush();
        file.close();
        fs::rename(incomplete, path);
    } catch (...) {
        std::remove(incomplete.c_str());
        throw;
    }
}

void remove_journal(const std::string& directory) noexcept
{
    std::remove(recipe_in(directory).c_str());
    std::remove(directory.c_str());
}

} // namespace kith::tool
