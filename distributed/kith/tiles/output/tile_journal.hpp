// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "offset_file.hpp"

#include <kith/tiles/part/checksum.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace kith {

/// The journal's record of a finished tile.
struct finished_tile {
    std::uint64_t faces = 0; ///< owned faces of the last level
    mesh_checksum checksum{};
    byte_sum bytes{}; ///< all bytes written for the tile
};

/// A journal of the finished tiles, stored behind the surface in the same file until the surface is complete. A journal
/// in a separate file could describe a surface that no longer exists. Every tile has its own place, so ranks and jobs
/// without MPI write records at the same time. A record that was torn by the end of a process damages no other. A
/// record is valid if its checksum is correct, which also covers what is refined (`recipe`).
class tile_journal {
public:
    /// Takes the byte `begin` at which the surface ends and the records begin, the number of tiles, and a checksum of
    /// what is refined.
    tile_journal(std::uint64_t begin, std::uint64_t tiles, std::uint64_t recipe)
        : begin_(begin), tiles_(tiles), recipe_(recipe)
    {
    }

    [[nodiscard]] std::uint64_t tiles() const { return tiles_; }
    /// Returns the offset at which the records end.
    [[nodiscard]] std::uint64_t end() const { return begin_ + tiles_ * sizeof(record); }

    /// Records that a tile is finished, after all bytes written to the file are on the disk. Local. Errors:
    /// write_error.
    void add(offset_file& file, std::uint64_t tile, const finished_tile& finished) const
    {
        file.flush();
        const record line{finished.faces, finished.checksum.bits, finished.bytes.bits, sum(tile, finished)};
        file.write(begin_ + tile * sizeof line, &line, sizeof line);
    }
    /// Returns for each tile its record, or nothing if it has no valid one. Local. Errors: write_error.
    [[nodiscard]] std::vector<std::optional<finished_tile>> read(offset_file& file) const
    {
        std::vector<record> lines(tiles_);
        file.read(begin_, lines.data(), lines.size() * sizeof(record));
        std::vector<std::optional<finished_tile>> result(tiles_);
        for (std::uint64_t tile = 0; tile < tiles_; ++tile)
            result[tile] = understood(tile, lines[tile]);
        return result;
    }
    /// Returns the record of one tile, or nothing if it has no valid one. Local. Errors: write_error.
    [[nodiscard]] std::optional<finished_tile> read(offset_file& file, std::uint64_t tile) const
    {
        record line{};
        file.read(begin_ + tile * sizeof line, &line, sizeof line);
        return understood(tile, line);
    }

private:
    struct record {
        std::uint64_t faces, checksum, bytes, sum;
    };

    [[nodiscard]] std::optional<finished_tile> understood(std::uint64_t tile, const record& line) const
    {
        const finished_tile finished{line.faces, {line.checksum}, {line.bytes}};
        return line.sum == sum(tile, finished) ? std::optional(finished) : std::nullopt;
    }
    [[nodiscard]] std::uint64_t sum(std::uint64_t tile, const finished_tile& finished) const
    {
        detail::word_hash hash(recipe_);
        for (const std::uint64_t word : {tile, finished.faces, finished.checksum.bits, finished.bytes.bits})
            hash.add(word);
        return hash.bits();
    }

    std::uint64_t begin_, tiles_, recipe_;
};

} // namespace kith
