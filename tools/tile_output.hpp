// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "journal.hpp"

#include <kith/stitch.hpp>
#include <kith/tile_journal.hpp>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace kith::tool {

/// The files that can be written tile by tile: .vtu and .ply, each one file whose bytes do not depend on the tiles, and
/// .pvtu, with the tiles in files of their own.
/// Errors: usage_error for other files.
void require_tile_format(const std::string& path);

/// The output of a refinement in tiles. One process begins and commits, all write. With a journal, what is finished stays
/// in its directory until all is.
class tile_output {
public:
    using tile_type = tile<std::array<double, 3>, std::uint32_t>;

    /// `process` is the id of the one that begins, so that no other job writes under the same name until it is complete.
    /// Errors: mesh_error for what the format cannot hold.
    tile_output(const std::string& path, const whole_counts& counts, std::uint64_t tiles, int level, bool with_origin,
                const std::optional<journal_place>& journal, std::uint64_t process);
    tile_output(const tile_output&) = delete;
    tile_output& operator=(const tile_output&) = delete;

    /// Makes the file, under another name until it is complete; with a journal, unless it is there. Without one a signal
    /// that ends the program removes the file again, though not the pieces of .pvtu.
    /// Errors: file_error, write_error.
    void begin();
    void open();
    /// What is in the journal, of all tiles; nothing without a journal. Errors: write_error.
    [[nodiscard]] std::vector<std::optional<finished_tile>> finished();
    /// Gives what the journal then says of the tile. Errors: write_error, mesh_error.
    finished_tile write(const tile_type& part, cell_origin origin);
    void close();
    /// Gives the file its name; nothing of the journal is left then. Errors: file_error, write_error.
    void commit();
    /// Leaves nothing behind of what this process has begun but what is in a journal; nothing happens after commit.
    void abandon() noexcept;

private:
    [[nodiscard]] std::string incomplete_pieces() const { return incomplete_ + ".pieces"; }

    std::string path_, incomplete_;
    std::string pieces_; ///< the directory of the tiles that have files of their own, else empty
    std::unique_ptr<stitched_file> layout_;
    std::string journal_directory_;
    std::optional<tile_journal> journal_;
    std::optional<offset_file> file_;
    bool is_ours_ = false; ///< what stands under the other name, to be removed
};

} // namespace kith::tool
