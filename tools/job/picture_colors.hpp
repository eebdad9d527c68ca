// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pictured_surface.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kith::tool {

/// The meaning of the colors of a picture. An attribute is named by `name`.
enum class coloring : unsigned char { plain, parent, tile, mean, gaussian, reflection, attribute };

struct color_request {
    coloring by = coloring::plain;
    std::string name{};
    std::vector<std::uint32_t> tile_of{}; ///< for each face of the control mesh
    std::size_t tiles = 0;
};

/// Returns the coloring that a word such as "parent" or "attribute:NAME" names. Errors: usage_error.
color_request coloring_named(std::string_view word);

/// Removes all attributes but the one that gives the colors. Errors: usage_error if there is none of this name; the
/// message lists the names.
void keep_colored(io::mesh_attributes& attributes, const color_request& request);

/// Gives surfaces their colors, in one scale for all of them, and returns its legend.
picture::legend give_colors(std::vector<pictured_surface>& surfaces, const color_request& request);

} // namespace kith::tool
