// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Pictures of surfaces, without a display: `picture::sheet` describes one, `picture::draw` makes its pixels, and
/// `picture::write_png` and `picture::write_svg` write it. `picture::plot` and `picture::bar_chart` show numbers.

#include <kith/picture/color.hpp>
#include <kith/picture/image.hpp>
#include <kith/picture/plot.hpp>
#include <kith/picture/scene.hpp>

#include <ostream>

namespace kith::picture {

/// Draws the pixels of a picture. Nearer surfaces hide farther ones; colors of points and normals vary linearly within
/// polygons. The bytes do not depend on threads. Errors: std::invalid_argument for a size or a number of samples out of
/// range, and for points, normals or colors that are missing. Cost: O(polygons + samples).
image draw(const sheet& sheet);

/// Writes a picture as SVG: polygons from back to front by their mean depth, so it suits small scenes. Colors are those
/// of the middle of each polygon. Errors: std::invalid_argument, as draw.
void write_svg(std::ostream& out, const sheet& sheet);

} // namespace kith::picture
