// SPDX-License-Identifier: BSD-3-Clause
#include "tile_output.hpp"

#include "errors.hpp"
#include "mesh_format.hpp"
#include "output_file.hpp"

#include <kith/checksum.hpp>
#include <kith/vtu_pieces.hpp>

#include <cstdio>
#include <filesystem>
#include <system_error>

namespace kith::tool {

namespace fs = std::filesystem;

namespace {

/// What is replaced holds nothing but pieces. Errors: file_error.
void require_pieces_only(const std::string& directory)
{
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(directory, failed))
        if (entry.path().extension() != ".vtu")
            throw file_error(directory + ": would be replaced by the pieces, but holds " +
                             entry.path().filename().string() + "; remove it, or name another output");
}

} // namespace

void require_tile_format(const std::string& path)
{
    const std::string extension = extension_of(path);
    if (extension != ".vtu" and extension != ".ply" and extension != ".pvtu")
        throw usage_error(
            path + ": tiles are written to .vtu or .ply, where every byte has its place, or to .pvtu, a file each");
}

tile_output::tile_output(const std::string& path, const whole_counts& counts, std::uint64_t tiles, int level,
                         bool with_origin, const std::optional<journal_place>& journal, std::uint64_t process)
    : path_(path)
    , incomplete_(journal ? (fs::path(journal->directory) / "surface").string()
                          : path + ".incomplete-" + std::to_string(process))
{
    require_tile_format(path);
    if (extension_of(path) == ".pvtu") {
        pieces_ = fs::path(path).replace_extension(".pieces").string();
        const std::string source = fs::path(pieces_).filename().string();
        layout_ = std::make_unique<vtu_pieces>(incomplete_pieces(), source, tiles, level, with_origin);
    } else if (extension_of(path) == ".ply") {
        layout_ = std::make_unique<ply_file>(counts);
    } else {
        layout_ = std::make_unique<vtu_file>(counts, level, with_origin);
    }
    if (not journal)
        return;
    journal_directory_ = journal->directory;
    journal_.emplace(layout_->size(), tiles, journal->recipe);
}

void tile_output::begin()
{
    std::error_code failed;
    if (fs::is_directory(path_, failed))
        throw file_error(path_ + ": is a directory, not a file");
    if (not pieces_.empty())
        require_pieces_only(pieces_);
    if (not journal_) {
        is_ours_ = true;
        remove_when_interrupted(incomplete_);
    }
    if (not pieces_.empty()) {
        if (is_ours_)
            fs::remove_all(incomplete_pieces(), failed);
        fs::create_directory(incomplete_pieces(), failed);
        if (failed)
            throw file_error(incomplete_pieces() + ": cannot be made: " + failed.message());
    }
    file_.emplace(journal_ ? offset_file::create_or_keep(incomplete_, journal_->end())
                           : offset_file::create(incomplete_, layout_->size()));
    layout_->write_frame(*file_);
}

void tile_output::open()
{
    if (not file_)
        file_.emplace(offset_file::open(incomplete_));
}

std::vector<std::optional<finished_tile>> tile_output::finished()
{
    if (not journal_)
        return {};
    auto result = journal_->read(*file_);
    for (std::uint64_t tile = 0; tile < result.size(); ++tile)
        if (not layout_->is_there(tile))
            result[tile].reset();
    return result;
}

finished_tile tile_output::write(const tile_type& part, cell_origin origin)
{
    layout_->write_tile(*file_, part, origin);
    const finished_tile finished{owned_count(part.face_marks), checksum(part)};
    if (journal_)
        journal_->add(*file_, origin.tile, finished);
    return finished;
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
    if (not pieces_.empty()) { // an index that was there before must not find other pieces
        fs::remove(path_, failed);
        fs::remove_all(pieces_, failed);
        fs::rename(incomplete_pieces(), pieces_, failed);
        if (failed)
            throw file_error(pieces_ + ": cannot be written: " + failed.message());
    }
    fs::rename(incomplete_, path_, failed);
    if (failed)
        throw file_error(path_ + ": cannot be written: " + failed.message());
    if (journal_)
        remove_journal(journal_directory_);
    is_ours_ = false;
    keep_when_interrupted();
}

void tile_output::abandon() noexcept
{
    if (not is_ours_)
        return;
    std::remove(incomplete_.c_str());
    std::error_code ignored; // the error that led here is told
    if (not pieces_.empty())
        fs::remove_all(incomplete_pieces(), ignored);
    is_ours_ = false;
    keep_when_interrupted();
}

} // namespace kith::tool
