// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limit_surface.hpp"
#include "tile_request.hpp"

#include <kith/fields/with_fields.hpp>
#include <kith/tiles/output/file_array.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace kith::tool {

/// Whether there are attributes that tiles carry.
inline bool has_attributes(const tile_request& request)
{
    return not request.kinds.empty();
}

/// Calls f with the scheme and, where there are attributes, with these beside it.
template <scheme Scheme, class F>
auto with_attributes(const Scheme& scheme, const tile_request& request, const F& f)
{
    return has_attributes(request) ? f(with_fields(scheme, request.attributes)) : f(scheme);
}

/// The scheme without attributes.
template <scheme Scheme>
const auto& plain(const Scheme& scheme)
{
    if constexpr (wrapped_scheme<Scheme>)
        return scheme.plain();
    else
        return scheme;
}

/// As rings_of_last_level.
inline std::optional<int> last_rings(const tile_request& request)
{
    return rings_of_last_level(request.scheme, request.limit, has_attributes(request));
}

/// The attributes of a level as arrays of a file of tiles.
class tile_attributes {
public:
    /// The values that a tile has for these arrays.
    using values = std::vector<std::vector<std::byte>>;

    /// Precondition: the output has room for what is of these kinds (settle_tile_attributes).
    explicit tile_attributes(const tile_request& request);

    [[nodiscard]] const std::vector<file_array>& arrays() const { return arrays_; }
    /// In the types of the file.
    [[nodiscard]] values values_of(const attribute_fields& fields) const;
    /// Those of the fields beside a scheme; none where there are no attributes.
    template <scheme Scheme>
    [[nodiscard]] values values_beside(const Scheme& scheme) const
    {
        if constexpr (wrapped_scheme<Scheme>)
            return values_of(scheme.field());
        else
            return {};
    }

private:
    io::mesh_attributes kinds_;
    std::vector<file_array> arrays_;
    bool is_ply_; ///< in which values that are missing are 0, as without tiles
};

} // namespace kith::tool
