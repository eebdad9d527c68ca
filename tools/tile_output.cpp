// SPDX-License-Identifier: BSD-3-Clause
#include "tile_output.hpp"

#include "errors.hpp"

#include <kith/checksum.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace kith::tool {

namespace {

std::string extension_of(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(
        extension, extension.begin(), [](char c) { return c >= 'A' and c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return extension;
}

std::uint64_t owned_faces(const tile_output::tile_type& part)
{
    std::uint64_t result = 0;
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
        result += part.owns_face(f);
    return result;
}

} // namespace

bool is_stitched_format(const std::string& path)
{
    return extension_of(path) == ".vtu" or extension_of(path) == ".ply";
}

void require_stitched_format(const std::string& path)
{
    if (not is_stitched_format(path))
        throw usage_error(path + ": tiles are written to .vtu or .ply, where every byte has its place");
}

tile_output::tile_output(const std::string& path, const whole_counts& counts, int level, bool with_origin,
                         const std::optional<journal_place>& journal)
    : path_(path), incomplete_(path + ".incomplete")
{
    require_stitched_format(path);
    if (extension_of(path) == ".ply")
        layout_ = std::make_unique<ply_file>(counts);
    else
        layout_ = std::make_unique<vtu_file>(counts, level, with_origin);
    if (not journal)
        return;
    journal_directory_ = journal->directory;
    incomplete_ = (std::filesystem::path(journal->directory) / "surface").string();
    journal_.emplace(layout_->size(), journal->tiles, journal->recipe);
}

void tile_output::begin()
{
    std::error_code failed;
    if (std::filesystem::is_directory(path_, failed))
        throw file_error(path_ + ": is a directory, not a file");
    if (journal_) {
        file_.emplace(offset_file::create_or_keep(incomplete_, journal_->end()));
    } else {
        file_.emplace(offset_file::create(incomplete_, layout_->size()));
    }
    layout_->write_frame(*file_);
}

void tile_output::open()
{
    if (not file_)
        file_.emplace(offset_file::open(incomplete_));
}

std::vector<std::optional<finished_tile>> tile_output::finished()
{
    return journal_ ? journal_->read(*file_) : std::vector<std::optional<finished_tile>>();
}

void tile_output::write(const tile_type& part, cell_origin origin)
{
    layout_->write_tile(*file_, part, origin);
    if (journal_)
        journal_->add(*file_, origin.tile, {owned_faces(part), checksum(part)});
}

void tile_output::close()
{
    file_->close();
    file_.reset();
}

void tile_output::commit()
{
    if (journal_) {
        auto file = offset_file::open(incomplete_);
        file.resize(layout_->size());
        file.close();
    }
    std::error_code failed;
    std::filesystem::rename(incomplete_, path_, failed);
    if (failed)
        throw file_error(path_ + ": cannot be written: " + failed.message());
    if (journal_)
        remove_journal(journal_directory_);
}

void tile_output::abandon() noexcept
{
    if (not journal_)
        std::remove(incomplete_.c_str());
}

} // namespace kith::tool
