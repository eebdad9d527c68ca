// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/stitch.hpp>

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace kith::tool {

/// The files that can be written tile by tile: .vtu and .ply, each one file whose bytes do not depend on the tiles.
[[nodiscard]] bool is_stitched_format(const std::string& path);
/// Errors: usage_error for other files.
void require_stitched_format(const std::string& path);

/// The output of a refinement in tiles. One process begins and commits, all write.
class tile_output {
public:
    using tile_type = tile<std::array<double, 3>, std::uint32_t>;

    /// Errors: mesh_error for what the format cannot hold.
    tile_output(const std::string& path, const whole_counts& counts, int level, bool with_origin);
    tile_output(const tile_output&) = delete;
    tile_output& operator=(const tile_output&) = delete;

    /// Makes the file, under another name until it is complete. Errors: file_error.
    void begin();
    void open();
    /// Errors: write_error, mesh_error.
    void write(const tile_type& part, cell_origin origin) { layout_->write_tile(*file_, part, origin); }
    void close();
    void commit();
    /// Leaves nothing behind; nothing happens after commit.
    void abandon() noexcept;

private:
    std::string path_, incomplete_;
    std::unique_ptr<stitched_file> layout_;
    std::optional<offset_file> file_;
};

} // namespace kith::tool
