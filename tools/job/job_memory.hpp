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

/// Returns the names of the mesh kinds: "native, cgal, openmesh".
std::string mesh_kind_names();

/// Returns the value of --mesh, or native if it is not given. Errors: usage_error.
mesh_kind mesh_kind_from(const boost::program_options::variables_map& values);

/// The properties of a job on which its memory depends.
struct job_kind {
    mesh_kind mesh = mesh_kind::native;
    bool limit = false;
    bool corner_normals = false; ///< also with normals of corners
    bool holes = false;
    bool tags = false; ///< the remaining sharpness is written
    attribute_counts attributes{};
};

/// The properties of a job in tiles on which its memory depends.
struct tiling_kind {
    std::uint64_t threads = 1; ///< threads that may refine a tile each, see tiles_at_once
    bool limit = false;
    bool corner_normals = false;
    attribute_counts attributes{};
};

/// Returns true if `refine` puts the faces of the control mesh, which lie in no order, in an order along the surface.
/// `refine` does so only if there is memory for it. Cost: O(edges).
bool is_reordered(const any_scheme& scheme, const basic_mesh<>& control, int levels);

/// Returns the bytes that `kith refine` needs at once without tiles, besides the program itself. They hold the levels,
/// their copies in conversions between types of mesh, limits, the faces left without holes, and the copies of a writer.
/// The result is a twentieth more, since memory comes in whole pages.
std::uint64_t job_bytes(const std::vector<planned_level>& levels, const job_kind& kind, bool reordered = false);

/// Returns the bytes that a job in tiles needs at once. They hold the control mesh with its attributes and parts, and
/// the largest tile (tile_bytes) as often as tiles are refined at once. Returns 0 for schemes that are not refined in
/// tiles. Errors: mesh_error.
std::uint64_t tiled_job_bytes(const any_scheme& scheme, const basic_mesh<>& control, int levels, const partition& parts,
                              const tiling_kind& kind = {});

/// Returns the smallest number of tiles that a search finds with which a job needs no more than `limit` bytes. Returns
/// 0 if a tile for every face is still too large, and for schemes that are not refined in tiles. Errors: mesh_error.
/// Cost: that of a few partitions.
std::uint64_t tiles_that_fit(const any_scheme& scheme, const basic_mesh<>& control, int levels,
                             const std::string& partitioner, std::uint64_t limit, const tiling_kind& kind = {});

/// Returns the default number of tiles of a job. With it a tile is so small that it is refined in memory that the one
/// before has left. Fresh memory must be cleared, which takes as long as the refinement.
/// Errors: mesh_error for counts beyond 64 bits. Cost: O(levels) for each number that is tried.
std::uint64_t usual_tiles(const any_scheme& scheme, const basic_mesh<>& control, int levels,
                          const tiling_kind& kind = {});

/// The memory that a job may use.
struct memory_limit {
    std::uint64_t bytes = 0;
    bool was_given = false; ///< given by the user; otherwise nine tenths of the available memory
};

/// Returns the value of --memory-limit, or nine tenths of the available memory. Errors: usage_error.
memory_limit memory_limit_from(const boost::program_options::variables_map& values);

/// Throws mesh_error for a job that needs more than the limit, or whose levels no index can number. The message names a
/// number of tiles that would fit.
void require_memory(const any_scheme& scheme, const basic_mesh<>& control, int levels, const job_kind& kind,
                    const memory_limit& limit);
/// Throws mesh_error for a job in tiles that needs more than the limit. `option`, "--tiles" or "--tiles-per-rank", sets
/// the number of tiles; each unit of its value stands for `times` tiles.
void require_memory(const any_scheme& scheme, const basic_mesh<>& control, int levels, const partition& parts,
                    const std::string& partitioner, const memory_limit& limit, const tiling_kind& kind,
                    const std::string& option, std::uint64_t times = 1);

} // namespace kith::tool
