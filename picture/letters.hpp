// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace kith::picture {

/// A stroke of a text: a straight line from the first point to the second, in pixels with y downward.
using stroke = std::array<std::array<double, 2>, 2>;

/// Returns the width of a text in pixels. All letters have equal widths.
double width_of_text(std::string_view text, double size);

/// Returns the strokes of a text whose base line begins at (x, y). `size` is the height of a line in pixels. Bytes that
/// are no printable ASCII are drawn as '?', one for each character of UTF-8.
std::vector<stroke> strokes_of_text(std::string_view text, double x, double y, double size);

} // namespace kith::picture
