// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "color.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
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

/// Returns the color of an image at texture coordinates, mixed from the four nearest pixels. (0, 0) is the lower left
/// corner and (1, 1) the upper right one; beyond them the image repeats. The color is gray where a coordinate is not
/// finite. Precondition: the image has pixels.
color color_at(const image& texture, double u, double v);

/// Returns true if this library was built with libpng.
bool writes_png();

/// Writes an image as PNG. Errors: std::runtime_error if the library was built without libpng or the stream fails.
void write_png(std::ostream& out, const image& image);

/// Reads an image from PNG. Errors: std::runtime_error if the library was built without libpng or the bytes are no PNG.
image read_png(std::istream& in);

} // namespace kith::picture
