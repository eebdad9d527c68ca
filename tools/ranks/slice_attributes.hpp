// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job/tile_attributes.hpp"

#include <kith/tiles/part/tile.hpp>
#include <kith/tiles/ply/ply_slice.hpp>

#include <array>
#include <string>
#include <vector>

namespace kith::tool {

/// The attributes of a control mesh that no rank reads as a whole: each reads those of the elements that its tile has.
class slice_attributes {
public:
    /// Tells the request what is carried. Errors: mesh_error for a file that cannot be read in slices.
    slice_attributes(tile_request& request, const std::string& path);

    /// What else the file holds, or the output has no room for.
    [[nodiscard]] const std::vector<std::string>& not_kept() const { return not_kept_; }
    /// Those of a tile of level 0. Errors: mesh_error for numbers of words that the file does not have.
    [[nodiscard]] attribute_fields of_tile(const tile<std::array<double, 3>>& part);

private:
    std::string path_;
    sliced_ply file_;
    io::mesh_attributes kinds_;
    std::vector<std::string> not_kept_;
};

} // namespace kith::tool
