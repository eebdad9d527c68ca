// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "attribute_fields.hpp"
#include "schemes.hpp"

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/plan.hpp>
#include <kith/tiles/part/partition.hpp>

#include <boost/program_options/variables_map.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace kith::tool {

enum class mesh_kind : unsigned char { native, cgal, openmesh };

/// "native, cgal, openmesh"
std::string mesh_kind_names();

/// --mesh, or native. Errors: usage_error.
mesh_kind mesh_kind_from(const boost::program_options::variables_map& values);

/// What a job does with its levels, as far as memory goes.
struct job_kind {
    mesh_kind mesh = mesh_kind::native;
    bool limit = false;
    bool corner_normals = false; ///< with those of the corners
    bool holes = false;
    bool tags = false; ///< the sharpness that is left is written
    attribute_counts attributes{};
};

/// The same of a job in tiles.
struct tiling_kind {
    std::uint64_t threads = 1; ///< that may refine a tile each, see tiles_at_once
    bool limit = false;
    bool corner_normals = false;
    attribute_counts attributes{};
};

/// Whether `refine` goes along the surface, for a control mesh whose faces lie in no order; it does so only where there
/// is memory for it. Cost: O(edges).
bool is_reordered(const any_scheme& scheme, const basic_mesh<>& control, int levels);

/// The bytes that `kith refine` needs at once without tiles, beside the program itself: the levels, their copies on the
/// way from one type of mesh to another, limits, what is left when holes are out, and what a writer copies.
/// A twentieth more, for memory comes in whole pages.
std::uint64_t job_bytes(const std::vector<planned_level>& levels, const job_kind& kind, bool reordered = false);

/// The same in tiles: the control mesh with its attributes and its parts, and the largest tile (tile_bytes) as often as
/// tiles are refined at once; 0 for schemes that are not refined in tiles. Errors: mesh_error.
std::uint64_t tiled_job_bytes(const any_scheme& scheme, const basic_mesh<>& control, int levels, const partition& parts,
                              const tiling_kind& kind = {});

/// The least number of tiles, as far as a search tells, with which a job needs no more than `limit`; 0 where not even a
/// tile for every face does, and for schemes that are not refined in tiles. Errors: mesh_error. Cost: that of a few
/// partitions.
std::uint64_t tiles_that_fit(const any_scheme& scheme, const basic_mesh<>& control, int levels,
                             const std::string& partitioner, std::uint64_t limit, const tiling_kind& kind = {});

/// Returns how many tiles a job takes if nothing else is said: as many as make a tile so small that it is refined in
/// memory that the one before has left. Fresh memory must be cleared, which takes as long as the refinement.
/// Errors: mesh_error for counts beyond 64 bits. Cost: O(levels) for each number that is tried.
std::uint64_t usual_tiles(const any_scheme& scheme, const basic_mesh<>& control, int levels,
                          const tiling_kind& kind = {});

/// What a job may use.
struct memory_limit {
    std::uint64_t bytes = 0;
    bool was_given = false; ///< by the user; else it is nine tenths of what is available
};

/// --memory-limit, or what is available. Errors: usage_error.
memory_limit memory_limit_from(const boost::program_options::variables_map& values);

/// Throws mesh_error for a job that needs more than the limit, or whose levels no index numbers, with a number of tiles
/// that would fit.
void require_memory(const any_scheme& scheme, const basic_mesh<>& control, int levels, const job_kind& kind,
                    const memory_limit& limit);
/// The same for tiles. They are asked for by `option`, each of which stands for `times` tiles: "--tiles",
/// "--tiles-per-rank".
void require_memory(const any_scheme& scheme, const basic_mesh<>& control, int levels, const partition& parts,
                    const std::string& partitioner, const memory_limit& limit, const tiling_kind& kind,
                    const std::string& option, std::uint64_t times = 1);

} // namespace kith::tool
