// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_request.hpp"

#include <kith/tiles/part/partition.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace kith::tool {

/// All that a surface in tiles is made of, small next to the surface: with the journal of finished tiles a checkpoint
/// that any number of ranks, or jobs without MPI, can go on from.
struct recipe {
    std::vector<std::pair<std::string, std::string>> settings{}; ///< by name: version, scheme, its words, levels, ...
    std::vector<std::byte> control{}; ///< the mesh as it was read, its creases and attributes
    partition parts{};                ///< the journal depends on it, the surface does not
    std::string output{};
};

recipe recipe_of(const tile_request& request, partition parts);

/// Settings only: a request without its control mesh, as ranks other than 0 have it. Errors: usage_error, and
/// file_error for a setting that is missing.
tile_request request_from(const recipe& recipe);
/// The inverse of recipe_of, but for the partition. Errors: as request_from, and pack_error for bytes that end too
/// early.
tile_request request_with_control(const recipe& recipe);

/// Names, types and labels of attributes, as a message and from one. Errors: pack_error.
std::vector<std::byte> pack_kinds(const io::mesh_attributes& kinds);
io::mesh_attributes unpack_kinds(const std::vector<std::byte>& bytes);

/// As bytes, with their checksum. Cost: that of the control mesh.
std::vector<std::byte> pack_recipe(const recipe& recipe);
/// Errors: pack_error.
recipe unpack_recipe(const std::vector<std::byte>& bytes);

/// Stands for the recipe, the partition included, but not for the name of the output.
std::uint64_t checksum_of(const recipe& recipe);

/// The setting in which two recipes differ first, or nothing: "its levels is '3', not '4'". Errors: file_error for a
/// setting that is missing.
std::string difference(const recipe& kept, const recipe& asked);

} // namespace kith::tool
