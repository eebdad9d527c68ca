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

/// The data from which a surface in tiles is made, small compared with the surface. Together with the journal of
/// finished tiles they are a checkpoint, from which any number of ranks, or jobs without MPI, can continue.
struct recipe {
    std::vector<std::pair<std::string, std::string>> settings{}; ///< by name: version, scheme, its words, levels, ...
    std::vector<std::byte> control{}; ///< the mesh as it was read, with its creases and attributes
    partition parts{};                ///< the journal depends on it, the surface does not
    std::string output{};
};

recipe recipe_of(const tile_request& request, partition parts);

/// Returns the request of a recipe's settings, without its control mesh, as ranks other than 0 have it. Errors:
/// usage_error, and file_error for a setting that is missing.
tile_request request_from(const recipe& recipe);
/// Returns the request of a recipe, with its control mesh. This is the inverse of recipe_of, except for the partition.
/// Errors: those of request_from, and pack_error for bytes that end too early.
tile_request request_with_control(const recipe& recipe);

/// Writes the names, types and labels of attributes to a message (pack_kinds), or reads them from one (unpack_kinds).
/// Errors: pack_error.
std::vector<std::byte> pack_kinds(const io::mesh_attributes& kinds);
io::mesh_attributes unpack_kinds(const std::vector<std::byte>& bytes);

/// Returns the recipe as bytes, with their checksum. Cost: that of the control mesh.
std::vector<std::byte> pack_recipe(const recipe& recipe);
/// Returns the recipe that pack_recipe has written. Errors: pack_error.
recipe unpack_recipe(const std::vector<std::byte>& bytes);

/// Returns a checksum of the recipe, including the partition but not the name of the output.
std::uint64_t checksum_of(const recipe& recipe);

/// Returns the first difference of two recipes, or an empty string if there is none: "its levels is '3', not '4'".
/// Errors: file_error for a setting that is missing.
std::string difference(const recipe& kept, const recipe& asked);

} // namespace kith::tool
