// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/picture.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace kith::picture {

/// A corner of a triangle, in samples from the upper left corner of the picture.
struct placed_corner {
    double x, y;
    float depth;                 ///< toward the viewer, in samples
    std::array<float, 3> normal; ///< along the axes of the view
    color paint;
    std::array<float, 2> in_texture{};
};

/// The samples of some rows of a picture: colors, and the depth of what is nearest to the viewer.
class samples {
public:
    samples(std::size_t width, std::size_t rows, float line_reach)
        : width_(width)
        , line_reach_(line_reach)
        , pixels_(width * rows)
        , depths_(pixels_.size())
        , line_depths_(pixels_.size())
        , stamps_(pixels_.size())
    {
    }

    /// Begins the rows from `first` to `end - 1`, which are empty but for the background.
    void begin(std::size_t first, std::size_t end, const color& background)
    {
        first_ = std::int64_t(first), end_ = std::int64_t(end);
        std::ranges::fill(pixels_, transparent);
        blend(0, background, background.opacity);
        std::ranges::fill(pixels_, color(pixels_[0]));
        std::ranges::fill(depths_, nothing);
        std::ranges::fill(line_depths_, nothing);
    }

    /// Draws a triangle, whose sides belong to one of two neighbours. It has the colors of a texture if there is one.
    void draw(const std::array<placed_corner, 3>& corners, bool is_flat, shading light, const image* texture);

    /// Begins lines of one color; where they overlap, they are drawn once.
    void begin_lines() { std::ranges::fill(stamps_, 0); }
    /// Draws a line of this half width with round ends, in this color, with opacity `hidden` where a surface is nearer.
    void draw(const point& from, const point& to, double half_width, const color& ink, double hidden);

    /// Draws a rectangle from (x, y) on, whose color changes from its top to its bottom.
    void draw(double x, double y, double width, double height, const color& top, const color& bottom);

    /// Returns the color of a sample, whose red, green and blue are multiplied by its opacity.
    [[nodiscard]] const color& at(std::size_t x, std::size_t y) const
    {
        return pixels_[(y - std::size_t(first_)) * width_ + x];
    }

private:
    static constexpr float nothing = -std::numeric_limits<float>::infinity();

    void blend(std::size_t i, const color& paint, float opacity)
    {
        color& c = pixels_[i];
        const float rest = 1 - opacity;
        c = {paint.red * opacity + c.red * rest,
             paint.green * opacity + c.green * rest,
             paint.blue * opacity + c.blue * rest,
             opacity + c.opacity * rest};
    }
    [[nodiscard]] std::int64_t last_column() const { return std::int64_t(width_) - 1; }
    /// Returns the first and the last row of a range that are here.
    [[nodiscard]] std::array<std::int64_t, 2> rows(double least, double most) const
    {
        return {std::max(std::int64_t(std::ceil(std::max(least, 0.) - .5)), first_),
                std::min(std::int64_t(std::floor(std::max(most, 0.) - .5)), end_ - 1)};
    }

    std::size_t width_;
    std::int64_t first_ = 0, end_ = 0;
    float line_reach_; // half of the largest width of lines, in samples
    std::vector<color> pixels_;
    std::vector<float> depths_;
    std::vector<float> line_depths_; // lines are hidden if they lie farther
    std::vector<std::uint8_t> stamps_;
};

} // namespace kith::picture
