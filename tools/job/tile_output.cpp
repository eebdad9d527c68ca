// SPDX-License-Identifier: BSD-3-Clause
#include "tile_output.hpp"

#include "tile_attributes.hpp"
#include "cli/errors.hpp"

#include <kith/io/format/mesh_format.hpp>
#include <kith/tiles/output/vtu_pieces.hpp>
#include <kith/tiles/part/checksum.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

namespace kith::tool {

namespace fs = std::filesystem;

namespace {

/// Throws file_error if a directory that would be replaced holds anything but pieces.
void require_pieces_only(const std::string& directory)
{
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(directory, failed))
        if (entry.path().extension() != ".vtu")
            throw file_error(directory + ": would be replaced by the pieces, but holds " +
                             entry.path().filename().string() + "; remove it, or name another output");
}

bool is_special(const std::string& target)
{
    std::error_code failed;
    const auto status = fs::status(target, failed);
    return fs::exists(status) and not fs::is_regular_file(status) and not fs::is_directory(status);
}

std::vector<value_bytes> as_bytes(const tile_output::tile_values& values)
{
    return {values.begin(), values.end()};
}

/// Throws file_error if a file or directory cannot get this name at the end. The directory around it must take new
/// names, and a file or directory that has the name already must be replaceable.
void require_nameable(const std::string& path, const std::string& target)
{
    const auto require = [&](const fs::path& place, int mode) {
        if (::access(place.c_str(), mode) != 0)
            throw file_error(path + ": cannot be written: " + std::strerror(errno));
    };
    std::error_code failed;
    if (fs::exists(target, failed))
        require(target, fs::is_directory(target, failed) ? W_OK | X_OK : W_OK);
    require(fs::absolute(target).parent_path(), W_OK | X_OK);
}

/// Throws file_error for an output such as a pipe, which has no positions; tiles are written at their positions.
void require_places(const output_request& request, const std::string& target, bool in_pieces)
{
    std::error_code failed;
    const auto status = fs::status(target, failed);
    if (fs::is_directory(status))
        throw file_error(request.path + ": is a directory, not a file");
    if (fs::is_fifo(status) or fs::is_socket(status))
        throw file_error(request.path + ": is a pipe, and tiles are written in any order; name a file");
    if (is_special(target) and (in_pieces or not request.journal.empty()))
        throw file_error(request.path + ": is not a regular file, but " +
                         (in_pieces ? "the index of pieces" : "the output of a journal") + " must be one; name a file");
}

/// Returns a number that distinguishes a directory from others that have its name later. The directory keeps the number
/// when it is renamed.
std::string file_number(const std::string& path)
{
    struct stat status{};
    return ::stat(path.c_str(), &status) == 0 ? std::to_string(status.st_ino) : "0";
}

} // namespace

output_request output_of(const tile_request& request)
{
    return {.path = request.output,
            .arrays = tile_attributes(request).arrays(),
            .file_lines = request.kinds.file_lines,
            .levels = request.levels,
            .with_origin = request.with_origin,
            .with_normals = request.limit,
            .with_corner_normals = has_corner_normals(request)};
}

void require_tile_format(const std::string& path)
{
    const std::string extension = extension_of(path);
    if (extension != ".vtu" and extension != ".ply" and extension != ".pvtu")
        throw usage_error(path + ": tiles are written to .vtu, .ply or .pvtu (one file per tile); name such an output");
}

tile_output::tile_output(const output_request& request, const output_surface& surface)
    : request_(request), target_(io::target_of(request.path))
{
    require_tile_format(request.path);
    incomplete_ = not request.journal.empty() ? journal_share::surface_in(request.journal)
                  : is_special(target_)       ? target_
                                              : io::unfinished_name(target_, surface.process);
    if (extension_of(request.path) == ".pvtu") {
        const std::string source = fs::path(target_).replace_extension(".pieces").string();
        pieces_ = io::target_of(source);
        layout_ = std::make_unique<vtu_pieces>(incomplete_pieces(),
                                               fs::path(source).filename().string(),
                                               surface.tiles,
                                               request.levels,
                                               request.with_origin,
                                               request.with_normals,
                                               request.arrays);
    } else if (extension_of(request.path) == ".ply") {
        layout_ = std::make_unique<ply_file>(surface.counts,
                                             request.with_normals,
                                             request.arrays,
                                             request.file_lines,
                                             surface.largest_degree,
                                             request.with_corner_normals);
    } else {
        std::optional<alike_cells> alike;
        if (surface.counts.corners == surface.largest_degree * surface.counts.faces)
            alike = {surface.largest_degree, surface.tiles};
        layout_ = std::make_unique<vtu_file>(
            surface.counts, request.levels, request.with_origin, request.with_normals, request.arrays, alike);
    }
    if (not request.journal.empty())
        journal_.emplace(layout_->size(), surface.tiles, surface.recipe);
}

/// Returns the directory that holds the pieces until the output is complete: next to their final place, or in the
/// journal.
std::string tile_output::incomplete_pieces() const
{
    const std::string name = incomplete_ + ".pieces";
    return request_.journal.empty() ? (fs::path(pieces_).parent_path() / fs::path(name).filename()).string() : name;
}

/// Throws file_error if `commit` cannot give the output its names; `begin` calls it before any work. Without a journal
/// the file is created next to its place, which is test enough.
void tile_output::require_names() const
{
    if (journal_)
        require_nameable(request_.path, target_);
    if (not pieces_.empty())
        require_nameable(pieces_, pieces_);
}

/// Cuts the records off the surface, which is then complete. Until the surface has its name, a separate file holds the
/// records, so that nothing is lost if naming fails or the process is killed. The file ends with the number of the
/// directory of pieces and the place where the directory goes.
void tile_output::cut_records()
{
    auto surface = offset_file::open(incomplete_);
    std::vector<char> bytes(journal_->end() - layout_->size());
    surface.read(layout_->size(), bytes.data(), bytes.size());
    const std::string place = pieces_.empty() ? ""
                                              : file_number(incomplete_pieces()) + " " + fs::absolute(pieces_).string();
    bytes.insert(bytes.end(), place.begin(), place.end());
    auto records = offset_file::create(journal_share::records_in(request_.journal), bytes.size());
    records.write(0, bytes.data(), bytes.size());
    records.flush();
    records.close();
    surface.resize(layout_->size());
    surface.close();
}

/// Restores the records that cut_records has cut off, if the surface has no name yet.
void tile_output::restore_records()
{
    const std::string path = journal_share::records_in(request_.journal);
    const std::uint64_t begin = layout_->size(), size = journal_->end() - begin;
    std::error_code failed;
    const std::uint64_t now = fs::file_size(incomplete_, failed);
    if (failed or now < begin or now >= journal_->end() or fs::file_size(path, failed) < size or failed)
        return;
    auto records = offset_file::open(path);
    std::vector<char> bytes(fs::file_size(path));
    records.read(0, bytes.data(), bytes.size());
    const std::string pieces(bytes.begin() + std::ptrdiff_t(size), bytes.end());
    const std::size_t space = pieces.find(' ');
    if (const std::string place = pieces.substr(space == pieces.npos ? pieces.size() : space + 1);
        not place.empty() and not fs::exists(incomplete_pieces()) and file_number(place) == pieces.substr(0, space))
        fs::rename(place, incomplete_pieces(), failed); // pieces that are lost are written again
    auto surface = offset_file::open(incomplete_);
    surface.write(begin, bytes.data(), size);
    surface.close();
}

bool tile_output::begin(const found_recipe& recipe)
{
    require_places(request_, target_, not pieces_.empty());
    for (const std::string& path : {target_, pieces_})
        if (journal_ and not path.empty())
            require_apart(path, request_.journal);
    if (not pieces_.empty())
        require_pieces_only(pieces_);
    require_names();
    if (not journal_) {
        made_.emplace(request_.path);
        if (not pieces_.empty())
            made_->make_directory(incomplete_pieces());
        file_.emplace(made_->is_direct() ? offset_file::open(incomplete_)
                                         : offset_file::create(incomplete_, layout_->size()));
    } else {
        if (not pieces_.empty())
            require_one_file_system(pieces_, request_.journal);
        share_.emplace(request_.journal, recipe, request_.path);
        if (share_->is_over())
            return false;
        restore_records();
        std::error_code failed;
        if (not pieces_.empty())
            fs::create_directory(incomplete_pieces(), failed);
        if (failed)
            throw file_error(incomplete_pieces() + ": cannot be created: " + failed.message());
        file_.emplace(offset_file::create_or_keep(incomplete_, journal_->end()));
    }
    layout_->write_frame(*file_);
    return true;
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

std::optional<finished_tile> tile_output::finished(std::uint64_t tile)
{
    return journal_ and layout_->is_there(tile) ? journal_->read(*file_, tile) : std::nullopt;
}

finished_tile tile_output::write(const tile_type& part, const tile_values& values, cell_origin origin)
{
    finished_tile finished{owned_count(part.face_marks)};
    try {
        if (journal_) {
            summed_bytes summed(&*file_);
            layout_->write_tile(summed, part, origin, as_bytes(values));
            finished.bytes = summed.sum();
            finished.bytes += layout_->sum_of_own_file(origin.tile);
        } else {
            layout_->write_tile(*file_, part, origin, as_bytes(values));
        }
    } catch (const mesh_error& error) {
        throw file_error(request_.path + ": " + error.what());
    }
    if (journal_ or request_.with_checksum)
        finished.checksum = checksum(part);
    if (journal_)
        journal_->add(*file_, origin.tile, finished);
    if (request_.verify)
        if (const auto differs = damage(part, values, origin.tile))
            throw file_error(*differs + " is not what was written; check the disk");
    return finished;
}

std::optional<std::string> tile_output::damage(const tile_type& part, const tile_values& values, std::uint64_t tile)
{
    return layout_->difference(*file_, part, std::uint32_t(tile), as_bytes(values));
}

byte_sum tile_output::sum_of_share(std::uint64_t share, std::uint64_t shares)
{
    if (not journal_)
        return {};
    const std::uint64_t size = layout_->size();
    byte_sum result = sum_of_bytes(
        *file_, begin_of_share(size, share, shares), begin_of_share(size, share + 1, shares));
    for (std::uint64_t tile = share; tile < journal_->tiles(); tile += shares)
        result += layout_->sum_of_own_file(tile);
    return result;
}

/// Throws file_error if `found` differs from the sum of the bytes of the journal's tiles and of the frame.
void tile_output::require_bytes(byte_sum found)
{
    summed_bytes frame(nullptr);
    layout_->write_frame(frame);
    byte_sum expected = frame.sum();
    auto surface = offset_file::open(incomplete_);
    for (const auto& tile : journal_->read(surface))
        if (tile)
            expected += tile->bytes;
    if (found != expected)
        throw file_error(incomplete_ +
                         ": is damaged, its bytes differ from those that were written; run again with --verify, "
                         "which rewrites damaged tiles, or remove " +
                         request_.journal + " and start again");
}

void tile_output::close()
{
    file_->close();
    file_.reset();
}

void tile_output::commit(byte_sum found)
{
    if (share_ and not share_->own())
        return;
    const auto lock = io::hold_interruptions();
    require_names();
    if (share_) {
        restore_records(); // another job may have found no way to name the surface
        require_bytes(found);
        cut_records();
    }
    if (not pieces_.empty()) {
        const std::string made = incomplete_pieces();
        std::error_code failed;
        if (fs::exists(pieces_, failed))
            fs::permissions(made, fs::status(pieces_).permissions(), failed);
        if (fs::exists(target_, failed)) { // an index that was there before must not find other pieces
            fs::permissions(incomplete_, fs::status(target_).permissions(), failed);
            fs::remove(target_, failed);
            if (failed)
                throw file_error(target_ + ": cannot be written: " + failed.message());
        }
        fs::remove_all(pieces_, failed);
        if (not failed)
            fs::rename(made, pieces_, failed);
        if (failed)
            throw file_error(pieces_ + ": cannot be written: " + failed.message());
    }
    if (share_) {
        io::give_name(incomplete_, target_);
        share_->remove();
    } else {
        made_->commit();
    }
}

} // namespace kith::tool
