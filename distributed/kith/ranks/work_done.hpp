// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/part/phase_seconds.hpp>

#include <cstdint>

namespace kith::mpi {

/// How tiles come to ranks. Spmd: dealt out at the beginning, the t-th to rank t modulo ranks. Manager: rank 0 hands them
/// out, the largest first, to whoever is free; it refines only when it is alone.
enum class sharing : unsigned char { spmd, manager };

/// What a rank did.
struct work_done {
    std::uint64_t tiles = 0;
    std::uint64_t owned_faces = 0;  ///< of the last level
    std::uint64_t kept_faces = 0;   ///< on all levels, shadows and what was cut off included
    std::uint64_t useful_faces = 0; ///< on all levels, owned
    phase_seconds seconds{};        ///< to cut, refine and use tiles; to send and wait in communicator::seconds

    work_done& operator+=(const work_done& more)
    {
        tiles += more.tiles;
        owned_faces += more.owned_faces;
        kept_faces += more.kept_faces;
        useful_faces += more.useful_faces;
        seconds += more.seconds;
        return *this;
    }
};

} // namespace kith::mpi
