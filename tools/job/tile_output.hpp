// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "journal.hpp"
#include "tile_request.hpp"

#include <kith/output_file.hpp>
#include <kith/tiles/output/ply_file.hpp>
#include <kith/tiles/output/tile_journal.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace kith::tool {

/// The files that can be written tile by tile: .vtu and .ply, each one file whose bytes do not depend on the tiles, and
/// .pvtu, with the tiles in files of their own.
/// Errors: usage_error for other files.
void require_tile_format(const std::string& path);

/// What is written, and how.
struct output_request {
    std::string path;
    std::string journal{};            ///< the directory, or nothing
    std::vector<file_array> arrays{}; ///< of attributes
    std::vector<std::string> file_lines{};
    int levels = 0;
    bool with_origin = false;
    bool with_normals = false;
    bool with_corner_normals = false; ///< .ply only
    bool with_checksum = false;
    bool verify = false; ///< read back what has been written
};

/// What is written of a request; the rest is left as it is above.
[[nodiscard]] output_request output_of(const tile_request& request);

/// What the whole surface is: the same on all ranks.
struct output_surface {
    global_counts counts;
    std::uint64_t largest_degree = 4; ///< of its faces
    std::uint64_t tiles = 0;
    std::uint64_t recipe = 0;  ///< its checksum, for the journal
    std::uint64_t process = 0; ///< the id of the one that begins
};

/// The output of a refinement in tiles. One process begins and commits, all write, on several threads if they like.
/// With a journal, what is finished stays in its directory until all is.
class tile_output {
public:
    using tile_type = tile<std::array<double, 3>, std::uint32_t>;
    using tile_values = std::vector<std::vector<std::byte>>; ///< for each of the arrays

    /// Errors: mesh_error for what the format cannot hold, file_error.
    tile_output(const output_request& request, const output_surface& surface);

    /// Makes the file, under another name until it is complete; with a journal, unless it is there. Without one a
    /// signal that ends the program removes it again. False when another job has finished the journal meanwhile: the
    /// output is there. Errors: file_error, write_error.
    [[nodiscard]] bool begin(const found_recipe& recipe);
    void open();
    /// The bytes of the file, or of the index where each tile has a file of its own.
    [[nodiscard]] std::uint64_t size() const { return layout_->size(); }
    /// What is in the journal, of all tiles; nothing without a journal. Errors: write_error.
    [[nodiscard]] std::vector<std::optional<finished_tile>> finished();
    /// The same for one tile, now.
    [[nodiscard]] std::optional<finished_tile> finished(std::uint64_t tile);
    /// Gives what the journal then says of the tile; the checksum where it is asked for or there is a journal.
    /// Errors: write_error, file_error.
    finished_tile write(const tile_type& part, const tile_values& values, cell_origin origin);
    /// Whether a tile that is finished stands in the file as it should; else tells the byte that differs.
    /// Errors: write_error.
    [[nodiscard]] std::optional<std::string> damage(const tile_type& part, const tile_values& values,
                                                    std::uint64_t tile);
    /// Returns the sum of the bytes of one of so many shares of what a journal keeps: all shares together are what
    /// `commit` asks for. Without a journal there is nothing to read. Errors: write_error.
    [[nodiscard]] byte_sum sum_of_share(std::uint64_t share, std::uint64_t shares);
    void close();
    /// Gives the file its name, unless another job has done so; nothing of the journal is left then. `found` is the sum
    /// of all shares. When it fails, what is finished stays in the journal.
    /// Errors: file_error, also where the bytes are not those that were written; write_error.
    void commit(byte_sum found);

private:
    [[nodiscard]] std::string incomplete_pieces() const;
    void require_names() const;
    void require_bytes(byte_sum found);
    void cut_records();
    void restore_records();

    output_request request_;
    std::string target_, incomplete_;
    std::string pieces_; ///< the directory of the tiles that have files of their own, else empty
    std::unique_ptr<stitched_file> layout_;
    std::optional<tile_journal> journal_;
    std::optional<journal_share> share_;
    std::optional<io::unfinished_file> made_; ///< by this process, removed again unless committed
    std::optional<offset_file> file_;
};

} // namespace kith::tool
