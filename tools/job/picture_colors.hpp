// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pictured_surface.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace kith::tool {

/// The meaning of the colors of a picture. An attribute is named by `name`; checker and texture are images that lie on
/// the surface by its texture coordinates.
enum class coloring : unsigned char {
    plain,
    parent,
    tile,
    rank,
    level,
    mean,
    gaussian,
    reflection,
    checker,
    texture,
    attribute
};

struct color_request {
    coloring by = coloring::plain;
    std::string name{};
    std::vector<std::uint32_t> part_of{};            ///< the tile or the rank of each face of the control mesh
    std::size_t tiles = 0, ranks = 0;                ///< tile t lies on rank t modulo `ranks`
    std::shared_ptr<const picture::image> texture{}; ///< of checker and texture
};

/// Returns the coloring that a word such as "parent", "attribute:NAME" or "texture:FILE" names. The file of a texture
/// is read. Errors: usage_error; file_error.
color_request coloring_named(std::string_view word);

/// Removes all attributes but those that give the colors. Errors: usage_error if there is none of this name, whose
/// message lists the names, or if there are no texture coordinates.
void keep_colored(io::mesh_attributes& attributes, const color_request& request);

/// Gives surfaces their colors, in one scale for all of them, and returns its legend.
picture::legend give_colors(std::vector<pictured_surface>& surfaces, const color_request& request);

} // namespace kith::tool
