// SPDX-License-Identifier: BSD-3-Clause
#include "svg_text.hpp"

#include <kith/picture/plot.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <array>
#include <cstdio>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace kith::picture {

namespace {

constexpr double left = 70, top = 34, below = 56, beside = 28;           // around the area of a plot
constexpr double least_names = 250, longest_bar = 420, bar_numbers = 90; // columns of bars
constexpr double row = 18;                                               // height of a bar or a name

/// Returns the width of a text in pixels, or somewhat more.
double width_of(const std::string& words)
{
    return 6.6 * double(words.size());
}
double width_of_names(const bar_chart& chart)
{
    double result = least_names;
    for (const auto& bar : chart.bars)
        result = std::max(result, 20 + width_of(bar.name));
    return result;
}

/// An axis of a plot that lies in a picture, from its least value at `start` to its largest at `start + length`.
class placed_axis {
public:
    placed_axis(const axis& of, double start, double length) : of_(of), start_(start), length_(length) {}

    void take(double value)
    {
        if (not std::isfinite(value))
            throw std::invalid_argument("plot: a number on the axis '" + of_.title + "' is not finite");
        if (of_.is_logarithmic and value <= 0)
            throw std::invalid_argument("plot: the axis '" + of_.title +
                                        "' is logarithmic, so its numbers are positive");
        least_ = std::min(least_, value);
        most_ = std::max(most_, value);
    }
    [[nodiscard]] double at(double value) const
    {
        const double range = scaled(most_) - scaled(least_);
        return start_ + length_ * (range > 0 ? (scaled(value) - scaled(least_)) / range : .5);
    }
    /// Returns the round numbers on the axis that have a line.
    [[nodiscard]] std::vector<double> ticks() const
    {
        std::vector<double> result;
        if (of_.is_logarithmic and most_ / least_ > 10) {
            const std::vector<double> steps = most_ / least_ > 300 ? std::vector{1.} : std::vector{1., 2., 5.};
            for (double exponent = std::floor(std::log10(least_)); exponent <= std::log10(most_); ++exponent)
                for (const double step : steps)
                    if (const double value = step * std::pow(10, exponent); value >= least_ and value <= most_)
                        result.push_back(value);
            return result;
        }
        constexpr double rounding = 1e-9; // numbers that differ by less have one place
        if (most_ - least_ <= rounding * std::max(std::abs(least_), std::abs(most_)))
            return {least_};
        double step = std::pow(10, std::floor(std::log10(most_ - least_)) - 1);
        for (const double factor : {2., 2.5, 2., 2.}) // 2, 5, 10, 20
            if ((most_ - least_) / step > 5)
                step *= factor;
        for (double i = std::ceil(least_ / step); i * step <= most_ * (1 + 1e-12); ++i)
            result.push_back(i * step);
        return result;
    }

private:
    [[nodiscard]] double scaled(double value) const { return of_.is_logarithmic ? std::log(value) : value; }

    const axis& of_;
    double start_, length_;
    double least_ = std::numeric_limits<double>::max(), most_ = std::numeric_limits<double>::lowest();
};

/// Returns a number as people write it: 20 k, 5 M, 0.01, 1e-05.
std::string short_number(double value)
{
    const double size = std::abs(value);
    const double unit = size >= 1e6 ? 1e6 : size >= 1e4 ? 1e3 : 1;
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value / unit);
    return text.data() + std::string(unit == 1e6 ? " M" : unit == 1e3 ? " k" : "");
}

void text(std::ostream& out, double x, double y, const char* style, const std::string& words)
{
    out << "<text class='" << style << "' x='" << number(x) << "' y='" << number(y) << "'>" << escaped(words)
        << "</text>\n";
}
void line(std::ostream& out, double x1, double y1, double x2, double y2)
{
    out << "<path class='grid' d='M" << number(x1) << ' ' << number(y1) << 'L' << number(x2) << ' ' << number(y2)
        << "'/>\n";
}
void box(std::ostream& out, double x, double y, double width, double height, const color& paint)
{
    out << "<rect x='" << number(x) << "' y='" << number(y) << "' width='" << number(width) << "' height='"
        << number(height) << "' fill='" << hexadecimal(paint) << "'/>\n";
}

void draw_curve(std::ostream& out, const curve& curve, const placed_axis& x, const placed_axis& y)
{
    const std::string paint = hexadecimal(curve.paint);
    out << "<polyline fill='none' stroke='" << paint << "' stroke-width='"
        << (curve.is_dashed ? "1.5' stroke-dasharray='5 3" : "2") << "' points='";
    for (const auto& [a, b] : curve.points)
        out << number(x.at(a)) << ',' << number(y.at(b)) << ' ';
    out << "'/>\n";
    if (not curve.is_dashed)
        for (const auto& [a, b] : curve.points)
            out << "<circle cx='" << number(x.at(a)) << "' cy='" << number(y.at(b)) << "' r='2.5' fill='" << paint
                << "'/>\n";
}

/// Draws a diagram from height `from` on. Returns the height that it takes.
double draw(std::ostream& out, double from, const plot& plot)
{
    const double right = left + plot.width, bottom = from + top + plot.height;
    placed_axis x(plot.x, left, plot.width), y(plot.y, bottom, -plot.height);
    for (const curve& curve : plot.curves)
        for (const auto& [a, b] : curve.points)
            x.take(a), y.take(b);
    if (plot.band)
        for (const double edge : *plot.band)
            y.take(edge);
    text(out, left, from + 20, "title", plot.title);
    if (plot.curves.empty())
        return top + plot.height + below;
    if (plot.band) {
        const auto [low, high] = std::minmax({y.at((*plot.band)[0]), y.at((*plot.band)[1])});
        box(out, left, low, plot.width, high - low, {.84F, .96F, .89F});
    }
    for (const double value : y.ticks()) {
        line(out, left, y.at(value), right, y.at(value));
        text(out, left - 6, y.at(value) + 4, "end", short_number(value));
    }
    for (const double value : x.ticks()) {
        line(out, x.at(value), from + top, x.at(value), bottom);
        text(out, x.at(value), bottom + 16, "middle", short_number(value));
    }
    text(out, left + plot.width / 2, bottom + 34, "middle", plot.x.title);
    if (not plot.y.title.empty())
        out << "<text class='middle' transform='translate(16 " << number(from + top + plot.height / 2)
            << ") rotate(-90)'>" << escaped(plot.y.title) << "</text>\n";

    std::vector<std::string> named;
    double at = from + top + 12;
    for (const curve& curve : plot.curves) {
        draw_curve(out, curve, x, y);
        if (curve.name.empty() or std::ranges::find(named, curve.name) != named.end())
            continue;
        named.push_back(curve.name);
        box(out, right + 12, at - 8, 10, 8, curve.paint);
        text(out, right + 28, at, "name", curve.name);
        at += row;
    }
    for (const std::string& note : plot.notes)
        text(out, right + 12, at += 8, "name", note), at += row - 8;
    return std::max(top + plot.height + below, at - from);
}
double draw(std::ostream& out, double from, const bar_chart& chart)
{
    double most = 0, at = from + top;
    for (const auto& bar : chart.bars) {
        if (not(bar.value >= 0) or not std::isfinite(bar.value))
            throw std::invalid_argument("bar_chart: the bar '" + bar.name + "' has no length");
        most = std::max(most, bar.value);
    }
    const double names = width_of_names(chart);
    text(out, 10, from + 22, "title", chart.title);
    for (const auto& bar : chart.bars) {
        const double length = most > 0 ? longest_bar * bar.value / most : 0;
        text(out, names - 8, at + 13, "end", bar.name);
        box(out, names, at + 2, std::max(1., length), row - 4, bar.paint);
        text(out, names + length + 6, at + 13, "name", number(bar.value) + chart.unit);
        at += row;
    }
    return at - from;
}

double width_of(const plot& plot)
{
    double names = 0;
    for (const curve& curve : plot.curves)
        names = std::max(names, width_of(curve.name));
    for (const std::string& note : plot.notes)
        names = std::max(names, width_of(note));
    return left + plot.width + beside + names;
}
double width_of(const bar_chart& chart)
{
    return width_of_names(chart) + longest_bar + bar_numbers;
}

} // namespace

void write_svg(std::ostream& out, const std::vector<diagram>& diagrams, const std::string& note)
{
    std::ostringstream body;
    double width = 20 + width_of(note), height = note.empty() ? 0 : 20;
    if (not note.empty())
        text(body, 10, 16, "name", note);
    for (const diagram& diagram : diagrams) {
        height += std::visit([&](const auto& of_kind) { return draw(body, height, of_kind); }, diagram);
        width = std::max(width, std::visit([](const auto& of_kind) { return width_of(of_kind); }, diagram));
    }
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << number(width) << "' height='" << number(height)
        << "' viewBox='0 0 " << number(width) << ' ' << number(height)
        << "' font-family='sans-serif' font-size='12'>\n"
           "<style>.title{font-weight:bold}.end{text-anchor:end}.middle{text-anchor:middle}.name{fill:#444}"
           ".grid{stroke:#ddd}</style>\n<rect width='100%' height='100%' fill='#ffffff'/>\n"
        << body.str() << "</svg>\n";
}

} // namespace kith::picture
