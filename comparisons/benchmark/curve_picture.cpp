// SPDX-License-Identifier: BSD-3-Clause
#include "curve_picture.hpp"

#include "svg_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <utility>

namespace kith::comparison {

namespace {

constexpr double left = 60, top = 34, width = 520, height = 300, below = 46, names = 230;

struct point {
    double faces, first, again; ///< first and second run, in nanoseconds per face
};
using curve = std::vector<point>;

/// Returns the curves of all contestants of one scheme, in the order of their first appearance.
std::vector<std::pair<std::string, curve>> curves_of(const std::string& scheme, const std::vector<contest>& contests)
{
    std::vector<std::string> order;
    std::map<std::string, std::map<std::uint64_t, std::vector<measurement>>> runs; // kith has runs beside all peers
    for (const auto& contest : contests)
        if (contest.scheme == scheme)
            for (const auto& contestant : contest.contestants) {
                if (not runs.contains(contestant.name))
                    order.push_back(contestant.name);
                auto& all = runs[contestant.name][contest.faces];
                all.insert(all.end(), contestant.runs.begin(), contestant.runs.end());
            }
    std::vector<std::pair<std::string, curve>> result;
    for (const auto& name : order) {
        curve line;
        for (const auto& [faces, measured] : runs[name])
            line.push_back(
                {double(faces),
                 1e9 * median(measured, [](const measurement& run) { return run.seconds; }) / double(faces),
                 1e9 * median(measured, [](const measurement& run) { return run.seconds_again; }) / double(faces)});
        result.emplace_back(name, std::move(line));
    }
    return result;
}

/// A logarithmic axis over a range of values.
struct axis {
    double least = 1e300, most = 0, start = 0, length = 0;

    void take(double value) { least = std::min(least, value), most = std::max(most, value); }
    [[nodiscard]] double at(double value) const
    {
        return start + length * std::log(value / least) / std::max(1e-9, std::log(most / least));
    }
    /// Returns the ticks 1, 2, 5, 10, 20, ... that lie on the axis; only powers of ten on a long axis.
    [[nodiscard]] std::vector<double> ticks() const
    {
        std::vector<double> result;
        const std::vector<double> steps = most / least > 300 ? std::vector{1.} : std::vector{1., 2., 5.};
        for (double power = std::pow(10, std::floor(std::log10(least))); power <= most; power *= 10)
            for (const double step : steps)
                if (const double value = step * power; value >= least and value <= most)
                    result.push_back(value);
        return result;
    }
};

std::string short_number(double value)
{
    std::ostringstream text;
    if (value >= 1e6)
        text << value / 1e6 << " M";
    else if (value >= 1e3)
        text << value / 1e3 << " k";
    else
        text << value;
    return text.str();
}

void draw_text(std::ostream& out, double x, double y, const char* style, const std::string& text)
{
    out << "<text class=\"" << style << "\" x=\"" << x << "\" y=\"" << y << "\">" << text << "</text>\n";
}
void draw_line(std::ostream& out, const axis& x, const axis& y, const curve& line, double point::* time,
               const std::string& color, const char* more)
{
    out << "<polyline fill=\"none\" stroke=\"" << color << "\" " << more << " points=\"";
    for (const auto& p : line)
        out << x.at(p.faces) << ',' << y.at(p.*time) << ' ';
    out << "\"/>\n";
}

void draw(std::ostream& out, double from, const std::string& scheme, const std::vector<contest>& contests)
{
    static constexpr std::array theirs{"#888888", "#bb9944", "#44aa77", "#aa6688", "#bbbbbb", "#776655", "#c98a8a"};
    static constexpr std::array ours{"#1f77b4", "#d62728", "#7f3fbf", "#17a2b8", "#ff7f0e", "#2ca02c"};
    const auto curves = curves_of(scheme, contests);
    axis x{.start = left, .length = width}, y{.start = from + top + height, .length = -height};
    for (const auto& [name, line] : curves)
        for (const auto& p : line)
            x.take(p.faces), y.take(p.first), y.take(p.again);
    draw_text(out, left, from + 20, "title", scheme + ": nanoseconds per face of the last level over their number");
    for (const double value : y.ticks()) {
        out << "<line class=\"grid\" x1=\"" << left << "\" x2=\"" << left + width << "\" y1=\"" << y.at(value)
            << "\" y2=\"" << y.at(value) << "\"/>\n";
        draw_text(out, left - 6, y.at(value) + 4, "end", short_number(value));
    }
    for (const double value : x.ticks()) {
        out << "<line class=\"grid\" y1=\"" << from + top << "\" y2=\"" << from + top + height << "\" x1=\""
            << x.at(value) << "\" x2=\"" << x.at(value) << "\"/>\n";
        draw_text(out, x.at(value), from + top + height + 16, "middle", short_number(value));
    }
    std::size_t our_next = 0, their_next = 0;
    double at = from + top + 12;
    for (const auto& [name, line] : curves) {
        const std::string color = name.starts_with("kith") ? ours[our_next++ % ours.size()]
                                                           : theirs[their_next++ % theirs.size()];
        draw_line(out, x, y, line, &point::first, color, "stroke-dasharray=\"4 3\"");
        draw_line(out, x, y, line, &point::again, color, "stroke-width=\"2\"");
        out << "<rect x=\"" << left + width + 12 << "\" y=\"" << at - 8 << "\" width=\"10\" height=\"8\" fill=\""
            << color << "\"/>\n";
        draw_text(out, left + width + 28, at, "name", name);
        at += 18;
    }
    draw_text(out, left + width + 12, at + 8, "name", "dashed: first in a process");
    draw_text(out, left + width + 12, at + 26, "name", "solid: the same again");
}

} // namespace

void write_curves(const std::string& path, const std::map<std::string, std::string>& facts,
                  const std::vector<contest>& contests)
{
    std::vector<std::string> schemes;
    for (const auto& contest : contests)
        if (std::ranges::find(schemes, contest.scheme) == schemes.end())
            schemes.push_back(contest.scheme);
    std::ostringstream body;
    double y = 20;
    draw_text(body,
              10,
              16,
              "name",
              "Medians; " + facts.at("processor") + ", " + facts.at("compiler") + ' ' + facts.at("flags"));
    for (const auto& scheme : schemes) {
        draw(body, y, scheme, contests);
        y += top + height + below;
    }
    write_svg_file(path,
                   left + width + names,
                   y,
                   ".title{font-weight:bold}.end{text-anchor:end}.middle{text-anchor:middle}.name{fill:#444}"
                   ".grid{stroke:#ddd}",
                   body.str());
}

} // namespace kith::comparison
