// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_request.hpp"

#include <kith/tiles/part/partition.hpp>

#include <cstdint>
#include <vector>

namespace kith::tool {

/// The predicted work of a rank; nothing is refined.
struct planned_rank {
    std::uint64_t tiles = 0;
    std::uint64_t faces = 0;         ///< owned faces of level 0
    std::uint64_t ghosts = 0;        ///< ghost faces of level 0, counted for each tile
    std::uint64_t message_bytes = 0; ///< bytes of its tiles of level 0 as they are sent; rank 0 keeps its own
    std::uint64_t last_faces = 0;    ///< owned faces of the last level
    std::uint64_t tile_bytes = 0;    ///< bytes of its largest tile on the last level
    std::uint64_t output_bytes = 0;  ///< bytes of its part of the .vtu file
};

struct planned_ranks {
    int rings = 0;                        ///< rings of ghosts on level 0
    std::uint64_t largest_tile_bytes = 0; ///< peak while it is refined, the control mesh included
    std::vector<planned_rank> ranks;
};

/// Predicts the work of each rank. Every tile is cut as `kith-mpi` would cut it, with its attributes; tile t is for
/// rank t modulo `ranks`. Faces of level 0 and messages are counted. The last level is divided by the corners that a
/// tile owns on level 0. This is exact if every new face comes from a corner. It is also exact if all faces have one
/// degree and every new face comes from a face.
/// Errors: usage_error for a scheme without reach, mesh_error. Cost: that of the control mesh and its ghosts.
planned_ranks plan_ranks(const tile_request& request, const partition& parts, std::uint64_t ranks);

} // namespace kith::tool
