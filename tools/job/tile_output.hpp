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

/// Throws usage_error for a file that cannot be written tile by tile. Files .vtu and .ply can; each is one file whose
/// bytes do not depend on the tiles. Files .pvtu can, with the tiles in files of their own.
void require_tile_format(const std::string& path);

/// The contents of an output, and the options for writing it.
struct output_request {
    std::string path;
    std::string journal{};            ///< the directory, or empty
    std::vector<file_array> arrays{}; ///< arrays of attributes
    std::vector<std::string> file_lines{};
    int levels = 0;
    bool with_origin = false;
    bool with_normals = false;
    bool with_corner_normals = false; ///< .ply only
    bool with_checksum = false;
    bool verify = false; ///< read back what has been written
};

/// Returns the output of a request; members that the request does not determine keep their defaults.
[[nodiscard]] output_request output_of(const tile_request& request);

/// The facts about the whole surface, the same on all ranks.
struct output_surface {
    global_counts counts;
    std::uint64_t largest_degree = 4; ///< the largest degree of its faces
    std::uint64_t tiles = 0;
    std::uint64_t recipe = 0;  ///< checksum of the recipe, for the journal
    std::uint64_t process = 0; ///< id of the process that begins the output
};

/// The output of a refinement in tiles. One process begins and commits it; all processes write, on several threads if
/// they like. With a journal, finished tiles stay in its directory until all tiles are finished.
class tile_output {
public:
    using tile_type = tile<std::array<double, 3>, std::uint32_t>;
    using tile_values = std::vector<std::vector<std::byte>>; ///< bytes for each of the arrays

    /// Prepares the layout of the output. Errors: mesh_error for contents that the format cannot hold, file_error.
    tile_output(const output_request& request, const output_surface& surface);

    /// Creates the file, under another name until it is complete; with a journal, only if it does not exist. Without a
    /// journal, a signal that ends the program removes the file again. Returns false if another job has finished the
    /// journal meanwhile; the output then exists. Errors: file_error, write_error.
    [[nodiscard]] bool begin(const found_recipe& recipe);
    void open();
    /// Returns the number of bytes of the file, or of the index if each tile has a file of its own.
    [[nodiscard]] std::uint64_t size() const { return layout_->size(); }
    /// Returns the records of all tiles in the journal, or an empty list without a journal. Errors: write_error.
    [[nodiscard]] std::vector<std::optional<finished_tile>> finished();
    /// Returns the current record of one tile in the journal, if there is one.
    [[nodiscard]] std::optional<finished_tile> finished(std::uint64_t tile);
    /// Writes a tile and returns its record, as the journal then has it. The record has the checksum if one is
    /// requested or there is a journal.
    /// Errors: write_error, file_error.
    finished_tile write(const tile_type& part, const tile_values& values, cell_origin origin);
    /// Compares a finished tile with the file. Returns nothing if they agree, otherwise a text that names the byte that
    /// differs.
    /// Errors: write_error.
    [[nodiscard]] std::optional<std::string> damage(const tile_type& part, const tile_values& values,
                                                    std::uint64_t tile);
    /// Returns the sum of the bytes in one of `shares` shares of what a journal keeps. `commit` needs the sum of all
    /// shares. Without a journal there is nothing to read. Errors: write_error.
    [[nodiscard]] byte_sum sum_of_share(std::uint64_t share, std::uint64_t shares);
    void close();
    /// Gives the file its name, unless another job has done so, and leaves nothing of the journal. `found` is the sum
    /// of all shares. If this fails, finished tiles stay in the journal.
    /// Errors: file_error, also if the bytes are not those that were written; write_error.
    void commit(byte_sum found);

private:
    [[nodiscard]] std::string incomplete_pieces() const;
    void require_names() const;
    void require_bytes(byte_sum found);
    void cut_records();
    void restore_records();

    output_request request_;
    std::string target_, incomplete_;
    std::string pieces_; ///< the directory of tiles with files of their own, or empty
    std::unique_ptr<stitched_file> layout_;
    std::optional<tile_journal> journal_;
    std::optional<journal_share> share_;
    std::optional<io::unfinished_file> made_; ///< the file that this process has made; removed unless committed
    std::optional<offset_file> file_;
};

} // namespace kith::tool
