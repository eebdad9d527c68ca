// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "native_shape.hpp"

#include <kith/refine_in_tiles.hpp>

#include <cstddef>
#include <utility>
#include <vector>

/// Returns the tiles of the last level, with their edges and schemes.
template <class Scheme>
std::vector<kith::kept_tile<kith::tile<shapes::point>, Scheme>> last_tiles(const mesh3d& mesh, const Scheme& scheme,
                                                                           int levels, const kith::partition& parts)
{
    std::vector<kith::kept_tile<kith::tile<shapes::point>, Scheme>> result;
    kith::tiled_refinement refinement(mesh, scheme, levels, parts);
    for (std::size_t part = 0; part < refinement.tiles(); ++part)
        refinement.refine_levels(part, [&](auto&& kept) {
            if (kept.level == levels)
                result.push_back(std::move(kept));
        });
    return result;
}

inline kith::global_counts counts_of(const mesh3d& mesh)
{
    return {mesh.vertex_count(), mesh.edge_count(), mesh.face_count(), mesh.corner_count()};
}
