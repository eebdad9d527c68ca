// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "offset_file.hpp"

#include <kith/tiles/part/checksum.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace kith {

/// What the journal says of a tile that is finished.
struct finished_tile {
    std::uint64_t faces = 0; ///< of the last level, owned
    mesh_checksum checksum{};
    byte_sum bytes{}; ///< that were written
};

/// The tiles that are finished, kept behind the surface in the file that they are written to, until it is complete: a
/// journal in a file of its own could speak of a surface that is no longer there. Every tile has its place, so that
/// ranks and jobs without MPI write their records at the same time, and a record that was torn by the end of a process
/// spoils no other. A record counts when its sum is right, which stands for what is refined as well (`recipe`).
class tile_journal {
public:
    /// The records begin where the surface ends, at byte `begin`.
    tile_journal(std::uint64_t begin, std::uint64_t tiles, std::uint64_t recipe)
        : begin_(begin), tiles_(tiles), recipe_(recipe)
    {
    }

    [[nodiscard]] std::uint64_t tiles() const { return tiles_; }
    /// Where the records end.
    [[nodiscard]] std::uint64_t end() const { return begin_ + tiles_ * sizeof(record); }

    /// Records that a tile is finished, after all that was written to the file is on the disk. Local. Errors:
    /// write_error.
    void add(offset_file& file, std::uint64_t tile, const finished_tile& finished) const
    {
        file.flush();
        const record line{finished.faces, finished.checksum.bits, finished.bytes.bits, sum(tile, finished)};
        file.write(begin_ + tile * sizeof line, &line, sizeof line);
    }
    /// What is known of each tile. Local. Errors: write_error.
    [[nodiscard]] std::vector<std::optional<finished_tile>> read(offset_file& file) const
    {
        std::vector<record> lines(tiles_);
        file.read(begin_, lines.data(), lines.size() * sizeof(record));
        std::vector<std::optional<finished_tile>> result(tiles_);
        for (std::uint64_t tile = 0; tile < tiles_; ++tile)
            result[tile] = understood(tile, lines[tile]);
        return result;
    }
    /// The same of one tile.
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
