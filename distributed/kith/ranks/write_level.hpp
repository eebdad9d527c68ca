// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "require_tiles.hpp"

#include <kith/base/error.hpp>
#include <kith/mpi/in_agreement.hpp>
#include <kith/number/whole_counts.hpp>
#include <kith/output/vtu_pieces.hpp>
#include <kith/tile/numbered_tile.hpp>
#include <kith/tile/tile_job.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace kith::mpi {

/// Collective: writes the tiles of `level` among those that are kept, and these of their fields as point data and cell
/// data:
///
///   write_level(comm, "fine.vtu", kept, 3, counts, field_named<0>("heat"), field_named<1>("material"));
///
/// into one file (.vtu), the same bytes for any number of tiles and ranks, or into a file per tile and an index (.pvtu)
/// with the tiles in NAME.pieces. `counts` are those of the level; the path is the same on all ranks, on a file system
/// that they share. Until the file is complete it is called NAME.incomplete; after an error it is removed, pieces that
/// are written already stay.
/// Errors: phase_error when tiles are missing, for a field without values, for two of one name, for a vertex that has
/// no finite place, for what the file system says and, with a file per tile, for tiles that are not numbered from 0 on,
/// each once. Cost: O(corners).
template <std::unsigned_integral Index, scheme Scheme, class... Find>
void write_level(communicator& comm, const std::string& path,
                 const std::vector<kept_tile<tile<std::array<double, 3>, Index>, Scheme>>& tiles, int level,
                 const whole_counts& counts, const named_field<Find>&... fields)
{
    namespace fs = std::filesystem;
    const std::string incomplete = path + ".incomplete", extension = fs::path(path).extension().string();
    const std::string pieces = fs::path(path).replace_extension(".pieces").string();
    std::uint64_t owned = 0;
    std::vector<numbered_tile<tile<std::array<double, 3>, Index>>> numbers;
    for (const auto& kept : tiles)
        if (kept.level == level) {
            owned += owned_count(kept.part.face_marks);
            numbers.push_back({kept.number, {}});
        }
    owned = comm.sum(std::array{owned})[0];
    in_agreement(comm, [&] {
        if (owned != counts.faces)
            throw mesh_error(path + ": the tiles of level " + std::to_string(level) + " own " + std::to_string(owned) +
                             " faces, the level has " + std::to_string(counts.faces) +
                             "; keep all tiles of it, each once");
    });
    // The index of pieces names them by these numbers.
    const std::uint64_t count = extension == ".pvtu" ? require_all_tiles(comm, numbers) : 0;
    std::unique_ptr<const stitched_file> layout;
    in_agreement(comm, [&] {
        auto arrays = arrays_of<Scheme>(fields...);
        if (extension == ".vtu")
            layout = std::make_unique<vtu_file>(counts, level, false, false, std::move(arrays));
        else if (extension == ".pvtu")
            layout = std::make_unique<vtu_pieces>(
                pieces, fs::path(pieces).filename().string(), count, level, false, false, std::move(arrays));
        else
            throw mesh_error(path + ": tiles with their fields are written to .vtu or to .pvtu; name such a file");
    });
    try {
        in_agreement(comm, [&] {
            if (not comm.is_root())
                return;
            if (extension == ".pvtu")
                fs::create_directory(pieces);
            auto file = offset_file::create(incomplete, layout->size());
            layout->write_frame(file);
            file.close();
        });
        in_agreement(comm, [&] {
            auto file = offset_file::open(incomplete);
            for (const auto& kept : tiles)
                if (kept.level == level)
                    layout->write_tile(file,
                                       kept.part,
                                       {std::uint32_t(kept.number), std::uint32_t(comm.rank())},
                                       values_of(kept.scheme, fields...));
            file.close();
        });
        in_agreement(comm, [&] { comm.is_root() ? fs::rename(incomplete, path) : void(); });
    } catch (const phase_error&) {
        std::error_code ignored;
        if (comm.is_root())
            fs::remove(incomplete, ignored);
        throw;
    }
}

} // namespace kith::mpi
