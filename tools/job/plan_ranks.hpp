// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_request.hpp"

#include <kith/tiles/part/partition.hpp>

#include <cstdint>
#include <vector>

namespace kith::tool {

/// What a rank of a job would do; nothing is refined.
struct planned_rank {
    std::uint64_t tiles = 0;
    std::uint64_t faces = 0;         ///< of level 0, owned
    std::uint64_t ghosts = 0;        ///< faces of level 0 around them, once per tile
    std::uint64_t message_bytes = 0; ///< of its tiles of level 0 as they are sent; rank 0 keeps its own
    std::uint64_t last_faces = 0;    ///< of the last level, owned
    std::uint64_t tile_bytes = 0;    ///< of the last level of its largest tile
    std::uint64_t output_bytes = 0;  ///< of the .vtu file, its part
};

struct planned_ranks {
    int rings = 0;                        ///< of ghosts on level 0
    std::uint64_t largest_tile_bytes = 0; ///< in use at most while it is refined, the control mesh included
    std::vector<planned_rank> ranks;
};

/// Cuts every tile as `kith-mpi` would, with its attributes, tile t for rank t modulo `ranks`. Faces of level 0 and
/// messages are counted; what the last level has is shared out by the corners that a tile owns on level 0, which is
/// exact where every new face comes from a corner, or all faces have one degree and every new one comes from a face.
/// Errors: usage_error for a scheme without reach, mesh_error. Cost: that of the control mesh and its ghosts.
planned_ranks plan_ranks(const tile_request& request, const partition& parts, std::uint64_t ranks);

} // namespace kith::tool
