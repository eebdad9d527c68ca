// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/picture/scene.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace kith::picture {

/// A text whose base line passes (x, y), in pixels from the upper left corner of the picture.
struct placed_text {
    std::string text;
    double x, y;
    bool is_centered; ///< around x; otherwise the text begins there
};

/// A rectangle whose color changes from its top to its bottom, in pixels.
struct placed_bar {
    double x, y, width, height;
    color top, bottom;
};

/// Axes of the view: to the right, upward and toward the viewer.
using view_axes = std::array<point, 3>;

/// The places of everything in a picture, in pixels.
class layout {
public:
    /// Places the parts of a picture. Errors: std::invalid_argument, as `draw`.
    explicit layout(const sheet& sheet);

    /// Returns the places of all points of an item; those of lines are lifted.
    [[nodiscard]] std::vector<point> place_all(std::size_t panel, const surface& s) const;
    [[nodiscard]] std::vector<point> place_all(std::size_t panel, const lines& l) const;

    [[nodiscard]] const view_axes& axes() const { return axes_; }
    [[nodiscard]] const std::vector<placed_text>& texts() const { return texts_; }
    [[nodiscard]] const std::vector<placed_bar>& bars() const { return bars_; }

private:
    /// Returns points of a panel in pixels: from the left, from the top, and toward the viewer.
    [[nodiscard]] std::vector<point> placed(std::size_t panel, const std::vector<point>& points, double lift) const;
    void place_legend(const sheet& sheet, double left);

    view_axes axes_;
    double scale_ = 1;
    point middle_{};                             // of all panels, along the axes
    std::vector<std::array<double, 2>> centers_; // of each panel
    std::vector<placed_text> texts_;
    std::vector<placed_bar> bars_;
};

/// Returns the brightness of a surface, and the part of it that is added as a white highlight. The normal points toward
/// the viewer, and has length one along the axes of the view.
struct brightness {
    float diffuse, highlight;
};
brightness brightness_of(shading light, const point& normal);

/// Returns the color of a surface in this light.
inline color lit(const color& paint, const brightness& light)
{
    const auto channel = [&](float x) {
        const float sum = x * light.diffuse + light.highlight;
        return sum < 1 ? sum : 1;
    };
    return {channel(paint.red), channel(paint.green), channel(paint.blue), paint.opacity};
}

inline double dot(const point& a, const point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Returns the vector in length one, or itself if it is zero.
point in_length_one(const point& v);

} // namespace kith::picture
