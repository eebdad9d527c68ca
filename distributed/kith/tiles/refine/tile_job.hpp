// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/level_state.hpp>
#include <kith/numbering/step/step.hpp>
#include <kith/tiles/part/tile_like.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kith {

/// A tile of level 0 and its scheme, whose state (creases) is numbered as the tile is.
template <tile_like Tile, scheme Scheme>
struct tile_job {
    Tile part;
    Scheme scheme;
};

/// A tile of any level and its scheme. The state of the scheme (creases, fields) is that of this level, numbered as the
/// tile is.
template <tile_like Tile, scheme Scheme>
struct kept_tile {
    std::uint64_t number = 0; ///< number of the tile among all tiles
    int level = 0;
    Tile part;
    Scheme scheme;
};

namespace detail {

/// A scheme that makes nothing, for tiles that are moved without a scheme.
struct no_scheme {
    static constexpr auto columns() { return kith::columns(new_vertices(), new_faces()); }
};

/// Returns the scheme of a tile of level 0: `scheme` with its state, which is that of the whole mesh, restricted to the
/// tile.
template <scheme Scheme, tile_like Tile>
Scheme scheme_of_tile(const Scheme& scheme, const Tile& part)
{
    using part_type = part_numbers<global_id>;
    const auto numbers = [](const auto& ids) { return std::span<const global_id>(ids.data(), ids.size()); };
    std::vector<part_type::face_corners> corners;
    for (std::size_t f = 0; f < part.first_corner_ids.size(); ++f)
        corners.push_back({part.first_corner_ids[f], part.mesh.face(f).size()});
    return scheme_of_part(scheme,
                          part_type{numbers(part.vertex_ids),
                                    numbers(part.edge_ids),
                                    numbers(part.face_ids),
                                    corners.empty() ? std::size_t(part.mesh.topology().degree) : 0,
                                    corners});
}

} // namespace detail

} // namespace kith
