// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/native_shape.hpp"
#include "support/tiles.hpp"

#include <kith/mpi/communicator.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/mpi/session.hpp>
#include <kith/refine_on_ranks.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// Returns the communicator of all ranks of the test program. Rank 0 prints the failures that any rank finds.
kith::mpi::communicator& world();

using tile3d = kith::tile<std::array<double, 3>, std::uint32_t>;
using tiles3d = std::vector<kith::numbered_tile<tile3d>>;

/// Returns the refined tiles of this rank, with ghosts. Every rank has the mesh, so that tests can compare. Collective.
template <class Scheme>
tiles3d refined_tiles(const mesh3d& mesh, const Scheme& scheme, int levels, const kith::partition& parts, int rings,
                      kith::mpi::sharing how = kith::mpi::sharing::spmd)
{
    kith::mpi::rank_refinement refinement(world(), mesh, scheme, levels, parts, rings);
    tiles3d result;
    refinement.refine(how, [&](std::uint64_t number, tile3d&& part) { result.push_back({number, std::move(part)}); });
    return result;
}

/// Cuts the tiles of this rank, with rings of ghosts: every n-th tile on n ranks. Every rank has the mesh. Local.
template <class Cutter>
tiles3d cut_tiles_of_rank(Cutter& cutter, std::uint64_t tiles, int rings)
{
    tiles3d result;
    for (auto t = std::uint64_t(world().rank()); t < tiles; t += std::uint64_t(world().size()))
        result.push_back({t, cutter.cut(t, rings).part});
    return result;
}

inline kith::partition scattered(const mesh3d& mesh, std::size_t parts, std::uint32_t seed)
{
    return {partitions::scattered(mesh.face_count(), parts, seed), parts};
}

inline kith::partition in_blocks(const mesh3d& mesh, std::size_t parts)
{
    return {partitions::blocks(mesh.face_count(), parts), parts};
}

/// Compares every element of every tile of all ranks with the mesh that was refined as a whole. Expects exactly one
/// owner per element. Collective.
inline void expect_same(std::span<const kith::numbered_tile<tile3d>> tiles, const mesh3d& whole)
{
    std::vector<int> vertices(whole.vertex_count()), edges(whole.edge_count()), faces(whole.face_count());
    for (const auto& [number, part] : tiles)
        EXPECT_EQ(difference(part, whole, vertices, edges, faces), "") << "tile " << number;
    for (const auto n : world().sum(std::vector<std::uint64_t>(faces.begin(), faces.end())))
        EXPECT_EQ(n, 1U);
}
