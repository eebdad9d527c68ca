// SPDX-License-Identifier: BSD-3-Clause
#include "journal.hpp"

#include "input_file.hpp"
#include "cli/errors.hpp"

#include <kith/output_file.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
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
        throw file_error(path + ": " + error.what() + "; remove " + directory + " and start again");
    }
}

/// Waits for the lock, if the file system has locks.
void lock(int descriptor, int kind)
{
    while (::flock(descriptor, kind) != 0 and errno == EINTR)
        ;
}

void write_recipe(const std::string& path, const recipe& recipe)
{
    const auto bytes = pack_recipe(recipe);
    io::output_file file(path);
    file.stream().write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    file.commit();
}

} // namespace

void require_one_file_system(const std::string& output, const std::string& directory)
{
    struct stat there = {}, here = {};
    if (stat(fs::absolute(io::target_of(output)).parent_path().c_str(), &there) != 0)
        throw file_error(output + ": cannot be written: " + std::strerror(errno));
    std::error_code failed;
    const fs::path kept = fs::exists(directory, failed) ? fs::path(directory) : fs::absolute(directory).parent_path();
    if (stat(kept.c_str(), &here) == 0 and here.st_dev != there.st_dev)
        throw file_error(directory + ": is on another file system than " + output +
                         "; put the journal next to the output");
}

void require_apart(const std::string& output, const std::string& directory)
{
    const auto place = [](const std::string& path) {
        std::error_code failed;
        return fs::weakly_canonical(fs::absolute(path), failed);
    };
    const std::string surface = journal_share::surface_in(directory);
    for (const auto& own : {surface, surface + ".pieces", journal_share::records_in(directory), recipe_in(directory)})
        if (place(own) == place(output))
            throw file_error(output + ": is a file of the journal itself; name another output, or another "
                                      "directory for the journal");
}

recipe kept_recipe(const std::string& directory)
{
    auto kept = find_recipe(directory);
    if (not kept)
        throw file_error(directory +
                         ": holds no recipe to resume; name the input mesh, the scheme and the other options");
    return std::move(*kept);
}

found_recipe recipe_for(const std::string& directory, const tile_request& request,
                        const std::function<partition()>& make)
{
    auto kept = find_recipe(directory);
    if (not kept)
        return {recipe_of(request, make()), false};
    if (const auto text = difference(*kept, recipe_of(request, {})); not text.empty())
        throw file_error(directory + ": is the journal of another refinement: " + text +
                         "; finish that one, or name another directory");
    return {std::move(*kept), true};
}

journal_share::journal_share(std::string directory) : directory_(std::move(directory)), recipe_(recipe_in(directory_))
{
    while (not hold()) // another job has just given this surface its name
        ;
}

journal_share::journal_share(std::string directory, const found_recipe& recipe, const std::string& output)
    : journal_share((require_one_file_system(output, directory), std::move(directory)))
{
    const auto there = find_recipe(directory_);
    if (there and checksum_of(*there) != checksum_of(recipe.value))
        throw file_error(directory_ + ": another job started this journal at the same time with other tiles; "
                                      "run this job again");
    if (not there and recipe.is_kept)
        leave();
    else if (not there)
        write_recipe(recipe_, recipe.value);
    std::error_code failed;
    if (is_over() and not fs::exists(output, failed))
        throw file_error(directory_ + ": was removed while this job started; run the job again");
}

journal_share::journal_share(journal_share&& other) noexcept
    : directory_(std::move(other.directory_))
    , surface_(std::move(other.surface_))
    , records_(std::move(other.records_))
    , recipe_(std::move(other.recipe_))
    , descriptor_(std::exchange(other.descriptor_, -1))
{
}

journal_share::~journal_share()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

std::string journal_share::surface_in(const std::string& directory)
{
    return (fs::path(directory) / "surface").string();
}

std::string journal_share::records_in(const std::string& directory)
{
    return surface_in(directory) + ".records";
}

bool journal_share::hold()
{
    std::error_code failed;
    fs::create_directory(directory_, failed);
    if (failed)
        throw file_error(directory_ + ": cannot be created: " + failed.message());
    descriptor_ = ::open(surface_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0 and errno != ENOENT)
        throw file_error(surface_ + ": cannot be opened for writing: " + std::strerror(errno));
    if (descriptor_ < 0)
        return false;
    if (is_of_others()) {
        ::close(std::exchange(descriptor_, -1));
        throw file_error(surface_ + ": exists without a recipe, so it may belong to another program; remove it, or "
                                    "name another directory for the journal");
    }
    lock(descriptor_, LOCK_SH);
    if (holds_surface())
        return true;
    ::close(std::exchange(descriptor_, -1));
    return false;
}

/// Returns true if the surface is a file of another program. A surface of a journal is empty until there is a recipe.
/// It is locked while a job works on after another job has removed the recipe.
bool journal_share::is_of_others() const
{
    struct stat mine = {};
    return ::fstat(descriptor_, &mine) == 0 and mine.st_size > 0 and ::access(recipe_.c_str(), F_OK) != 0 and
           (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 or errno != EWOULDBLOCK) and holds_surface();
}

bool journal_share::holds_surface() const
{
    struct stat mine = {}, there = {};
    return ::fstat(descriptor_, &mine) == 0 and ::stat(surface_.c_str(), &there) == 0 and
           mine.st_ino == there.st_ino and mine.st_dev == there.st_dev;
}

/// Leaves a journal that is over: removes what this job has created there meanwhile, unless other jobs use it.
void journal_share::leave() noexcept
{
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 and holds_surface()) {
        std::remove(surface_.c_str());
        std::remove(directory_.c_str());
    }
    ::close(std::exchange(descriptor_, -1));
}

bool journal_share::own()
{
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 and errno == EWOULDBLOCK) {
        std::cerr << "kith: note: all tiles in " << directory_
                  << " are finished; waiting for another job that still uses the journal\n";
        lock(descriptor_, LOCK_EX);
    }
    return holds_surface();
}

void journal_share::remove() noexcept
{
    std::remove(records_.c_str());
    std::remove(recipe_.c_str());
    std::remove(directory_.c_str());
}

} // namespace kith::tool
