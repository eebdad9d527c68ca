// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/polygon_soup.hpp>

#include <string>

namespace kith::tool {

/// The first element in which two meshes differ, by its number in both: counts, then vertices by the bits of their
/// coordinates (so -0 is not 0), then faces by their vertices from the first on. Empty if there is none.
/// Cost: O(corners).
std::string first_difference(const io::polygon_soup& a, const io::polygon_soup& b);

} // namespace kith::tool
