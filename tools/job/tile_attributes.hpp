// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limit_surface.hpp"
#include "tile_request.hpp"

#include <kith/tiles/output/file_array.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace kith::tool {

/// Returns true if there are attributes that tiles carry.
inline bool has_attributes(const tile_request& request)
{
    return not request.kinds.empty();
}

/// Returns the result of rings_of_last_level for a request.
inline std::optional<int> last_rings(const tile_request& request)
{
    return rings_of_last_level(request.scheme, request.limit, has_attributes(request));
}

/// The attributes of a level as arrays of a file of tiles.
class tile_attributes {
public:
    /// The bytes of the values of a tile, for each of these arrays.
    using values = std::vector<std::vector<std::byte>>;

    /// Creates the arrays for the attributes of a request. Precondition: the output can hold attributes of these kinds
    /// (settle_tile_attributes).
    explicit tile_attributes(const tile_request& request);

    [[nodiscard]] const std::vector<file_array>& arrays() const { return arrays_; }
    /// Returns the values of the fields, in the types of the file.
    [[nodiscard]] values values_of(const attribute_fields& fields) const;

private:
    io::mesh_attributes kinds_;
    std::vector<file_array> arrays_;
    bool is_ply_; ///< the output is .ply, where missing values are 0, as without tiles
};

} // namespace kith::tool
