// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/polygon_soup.hpp>

#include <string>

namespace kith::tool {

/// Returns a text on the first element in which two meshes differ, with its number in both, or an empty string if there
/// is none. The comparison begins with counts. Vertices follow, by the bits of their coordinates (so -0 is not 0), then
/// faces, by their vertices from the first on.
/// Cost: O(corners).
std::string first_difference(const io::polygon_soup& a, const io::polygon_soup& b);

} // namespace kith::tool
