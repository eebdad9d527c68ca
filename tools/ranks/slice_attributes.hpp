// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job/tile_attributes.hpp"

#include <kith/tiles/part/tile.hpp>
#include <kith/tiles/ply/ply_slice.hpp>

#include <array>
#include <string>
#include <vector>

namespace kith::tool {

/// The attributes of a control mesh that no rank reads as a whole. Each rank reads the attributes of the elements of
/// its tile.
class slice_attributes {
public:
    /// Sets the kinds of attributes of the request. Errors: mesh_error for a file that cannot be read in slices.
    slice_attributes(tile_request& request, const std::string& path);

    /// Returns the contents of the file that are not read, or that the output cannot hold.
    [[nodiscard]] const std::vector<std::string>& not_kept() const { return not_kept_; }
    /// Returns the attributes of a tile of level 0. Errors: mesh_error for label numbers that the file does not have.
    [[nodiscard]] attribute_fields of_tile(const tile<std::array<double, 3>>& part);

private:
    std::string path_;
    sliced_ply file_;
    io::mesh_attributes kinds_;
    std::vector<std::string> not_kept_;
};

} // namespace kith::tool
