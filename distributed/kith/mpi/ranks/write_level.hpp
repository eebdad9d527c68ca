// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "require_tiles.hpp"

#include <kith/core/base/error.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/tiles/number/global_counts.hpp>
#include <kith/tiles/output/vtu_pieces.hpp>
#include <kith/tiles/part/checksum.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>
#include <kith/tiles/refine/tile_job.hpp>

#include <array>
#include <chrono>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

namespace kith::mpi {

namespace detail {

/// The names of a file that ranks write together, and of its pieces: the final names, and temporary names that no other
/// job has.
struct names_of_level {
    std::string path, unfinished, pieces, unfinished_pieces;

    names_of_level(std::string given, std::uint64_t job)
        : path(std::move(given)), unfinished(path + ".incomplete-" + std::to_string(job))
    {
        if (std::filesystem::path(path).extension() == ".pvtu") {
            pieces = std::filesystem::path(path).replace_extension(".pieces").string();
            unfinished_pieces = unfinished + ".pieces";
        }
    }
    void remove() const
    {
        std::error_code ignored;
        std::filesystem::remove(unfinished, ignored);
        if (not unfinished_pieces.empty())
            std::filesystem::remove_all(unfinished_pieces, ignored);
    }
    /// Throws mesh_error if the directory for the pieces holds anything but pieces.
    void require_pieces_only() const
    {
        std::error_code failed;
        if (not pieces.empty())
            for (const auto& entry : std::filesystem::directory_iterator(pieces, failed))
                if (entry.path().extension() != ".vtu")
                    throw mesh_error(pieces + ": would be replaced by the pieces, but holds " +
                                     entry.path().filename().string() + "; remove it, or name another output");
    }
    /// Gives the file and the pieces their final names. Errors: std::filesystem::filesystem_error.
    void commit() const
    {
        namespace fs = std::filesystem;
        if (not pieces.empty()) {
            const std::string former = unfinished + ".former";
            std::error_code failed;
            for (int tries = 0; tries < 100; ++tries) { // another job may give its pieces this name meanwhile
                fs::rename(pieces, former, failed);
                fs::rename(unfinished_pieces, pieces, failed);
                if (not failed)
                    break;
                fs::remove_all(former, failed);
            }
            if (fs::exists(unfinished_pieces))
                fs::rename(unfinished_pieces, pieces);
            fs::remove_all(former, failed);
        }
        fs::rename(unfinished, path);
    }
};

/// Returns a number that other jobs do not have, the same on all ranks. Collective.
inline std::uint64_t number_of_job(communicator& comm)
{
    const auto now = std::uint64_t(std::chrono::system_clock::now().time_since_epoch().count());
    const std::uint64_t here = mix_bits(mix_bits(std::uint64_t(getpid())) ^ now);
    return comm.sum(std::array{comm.is_root() ? here : std::uint64_t(0)})[0];
}

} // namespace detail

/// Writes the tiles of `level` among `tiles`, and fields of theirs as point data and cell data:
///
///   write_level(comm, "fine.vtu", kept, 3, counts, field_named<0>("heat"), field_named<1>("material"));
///
/// The output is one file (.vtu), with the same bytes for any number of tiles and ranks. Or it is a file per tile in
/// NAME.pieces and an index of them (.pvtu). `counts` are those of the level. The path is the same on all ranks, on a
/// file system that they share. Until all is complete the file is called NAME.incomplete-NUMBER, with a number of this
/// call alone, and its pieces NAME.incomplete-NUMBER.pieces; both are removed after an error. Collective.
/// Errors: phase_error when tiles are missing; for a field without values; for two fields of one name; for a vertex
/// without finite coordinates; for an error of the file system; and, with a file per tile, for tiles that are not
/// numbered from 0 on, each once. Cost: O(corners).
template <std::unsigned_integral Index, scheme Scheme, class... Find>
void write_level(communicator& comm, const std::string& path,
                 const std::vector<kept_tile<tile<std::array<double, 3>, Index>, Scheme>>& tiles, int level,
                 const global_counts& counts, const named_field<Find>&... fields)
{
    namespace fs = std::filesystem;
    kith::detail::word_hash hash{std::uint64_t(level)};
    for (const char c : path)
        hash.add(std::uint64_t(static_cast<unsigned char>(c)));
    require_same_on_ranks(comm, hash.bits(), "the path or the level to write");
    const std::uint64_t job = detail::number_of_job(comm);
    std::uint64_t owned = 0;
    std::vector<numbered_tile<tile<std::array<double, 3>, Index>>> numbers;
    const auto names = collective_phase(comm, [&] {
        for (const auto& kept : tiles)
            if (kept.level == level) {
                owned += owned_count(kept.part.face_marks);
                numbers.push_back({kept.number, {}});
            }
        return detail::names_of_level(path, job);
    });
    owned = comm.sum(std::array{owned})[0];
    collective_phase(comm, [&] {
        if (owned != counts.faces)
            throw mesh_error(path + ": the tiles of level " + std::to_string(level) + " own " + std::to_string(owned) +
                             " faces, the level has " + std::to_string(counts.faces) +
                             "; keep all tiles of it, each once");
    });
    // The index of pieces names them by these numbers.
    const std::uint64_t count = names.pieces.empty() ? 0 : require_all_tiles(comm, numbers);
    std::unique_ptr<const stitched_file> layout;
    collective_phase(comm, [&] {
        auto arrays = arrays_of<Scheme>(fields...);
        if (fs::path(path).extension() == ".vtu")
            layout = std::make_unique<vtu_file>(counts, level, false, false, std::move(arrays));
        else if (not names.pieces.empty())
            layout = std::make_unique<vtu_pieces>(names.unfinished_pieces,
                                                  fs::path(names.pieces).filename().string(),
                                                  count,
                                                  level,
                                                  false,
                                                  false,
                                                  std::move(arrays));
        else
            throw mesh_error(path + ": tiles with their fields are written to .vtu or to .pvtu; name such a file");
        if (comm.is_root())
            names.require_pieces_only();
    });
    try {
        collective_phase(comm, [&] {
            if (not comm.is_root())
                return;
            if (not names.pieces.empty())
                fs::create_directory(names.unfinished_pieces);
            auto file = offset_file::create(names.unfinished, layout->size());
            layout->write_frame(file);
            file.close();
        });
        collective_phase(comm, [&] {
            auto file = offset_file::open(names.unfinished);
            for (const auto& kept : tiles)
                if (kept.level == level)
                    layout->write_tile(file,
                                       kept.part,
                                       {std::uint32_t(kept.number), std::uint32_t(comm.rank())},
                                       values_of(kept.scheme, fields...));
            file.close();
        });
        collective_phase(comm, [&] { comm.is_root() ? names.commit() : void(); });
    } catch (...) {
        if (comm.is_root())
            names.remove();
        throw;
    }
}

} // namespace kith::mpi
