// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Pictures of surfaces, without a display: `picture::sheet` describes one, `picture::draw` makes its pixels, and
/// `picture::write_png` and `picture::write_svg` write it. `picture::plot` and `picture::bar_chart` show numbers.

#include <kith/picture/color.hpp>
#include <kith/picture/plot.hpp>
#include <kith/picture/scene.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

namespace kith::picture {

/// Pixels, row by row from the top: red, green, blue and opacity, from 0 to 255.
struct image {
    std::size_t width = 0, height = 0;
    std::vector<std::array<std::uint8_t, 4>> pixels{};

    [[nodiscard]] const std::array<std::uint8_t, 4>& at(std::size_t x, std::size_t y) const
    {
        return pixels[y * width + x];
    }
};

/// Draws the pixels of a picture. Nearer surfaces hide farther ones; colors of points and normals vary linearly within
/// polygons. The bytes do not depend on threads. Errors: std::invalid_argument for a size or a number of samples out of
/// range, and for points, normals or colors that are missing. Cost: O(polygons + samples).
image draw(const sheet& sheet);

/// Returns true if this library was built with libpng.
bool writes_png();

/// Writes an image as PNG. Errors: std::runtime_error if the library was built without libpng or the stream fails.
void write_png(std::ostream& out, const image& image);

/// Writes a picture as SVG: polygons from back to front by their mean depth, so it suits small scenes. Colors are those
/// of the middle of each polygon. Errors: std::invalid_argument, as draw.
void write_svg(std::ostream& out, const sheet& sheet);

} // namespace kith::picture
