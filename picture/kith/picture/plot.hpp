// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "color.hpp"

#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace kith::picture {

/// A line through points of a plot. Curves of one name share an entry beside the plot, with the color of the first.
struct curve {
    std::string name{};
    std::vector<std::array<double, 2>> points{};
    color paint = gray;
    bool is_dashed = false;
};

/// An axis of a plot. It reaches from the least value to the largest one.
struct axis {
    std::string title{};
    bool is_logarithmic = false;
};

/// Curves over two axes. `band` is a range of y that is shaded, such as a tolerance.
struct plot {
    std::string title{};
    axis x{}, y{};
    std::vector<curve> curves{};
    std::optional<std::array<double, 2>> band{};
    std::vector<std::string> notes{}; ///< lines of text below the names of the curves
    double width = 520, height = 300; ///< of the area between the axes, in pixels
};

/// Bars of numbers that begin at 0, from top to bottom.
struct bar_chart {
    struct bar {
        std::string name;
        double value;
        color paint = gray;
    };
    std::string title{};
    std::string unit{}; ///< behind each number
    std::vector<bar> bars{};
};

using diagram = std::variant<plot, bar_chart>;

/// Writes diagrams below one another as SVG, under a line of text. Errors: std::invalid_argument if a number is not
/// finite, a number on a logarithmic axis is not positive, or a bar is negative.
void write_svg(std::ostream& out, const std::vector<diagram>& diagrams, const std::string& note = {});

} // namespace kith::picture
