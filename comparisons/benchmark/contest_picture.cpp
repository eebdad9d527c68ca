// SPDX-License-Identifier: BSD-3-Clause
#include "contest_picture.hpp"

#include "svg_file.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <string_view>

namespace kith::comparison {

namespace {

constexpr int row = 18, title = 30, names = 250, bars = 420, right = 90;

double nanoseconds_per_face(const contest& contest, const contestant& contestant)
{
    return 1e9 * median(contestant.runs, [](const measurement& run) { return run.seconds; }) / double(contest.faces);
}

std::string escaped(std::string_view text)
{
    std::string result;
    for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    return result;
}

void draw(std::ostream& out, int y, std::string_view style, int x, std::string_view text)
{
    out << "<text class=\"" << style << "\" x=\"" << x << "\" y=\"" << y << "\">" << escaped(text) << "</text>\n";
}

/// Draws the bars of one contest from height `y` on. Returns the height that they take.
int draw(std::ostream& out, int y, const contest& contest)
{
    double most = 0;
    for (const auto& contestant : contest.contestants)
        most = std::max(most, nanoseconds_per_face(contest, contestant));
    draw(out,
         y + title - 9,
         "title",
         10,
         contest.scheme + ", " + contest.mesh + ", " + std::to_string(contest.faces) + " faces");
    int at = y + title;
    for (const auto& contestant : contest.contestants) {
        const double time = nanoseconds_per_face(contest, contestant);
        const bool ours = contestant.name.starts_with("kith");
        std::ostringstream label;
        label << std::fixed << std::setprecision(1) << time << " ns";
        draw(out, at + 13, "name", names - 8, contestant.name);
        out << "<rect class=\"" << (ours ? "ours" : "theirs") << "\" x=\"" << names << "\" y=\"" << at + 2
            << "\" width=\"" << std::max(1., bars * time / most) << "\" height=\"" << row - 4 << "\"/>\n";
        draw(out, at + 13, "value", names + int(bars * time / most) + 6, label.str());
        at += row;
    }
    return at - y;
}

} // namespace

void write_svg(const std::string& path, const std::map<std::string, std::string>& facts,
               const std::vector<contest>& contests)
{
    std::ostringstream body;
    int y = 10;
    draw(body,
         y + 12,
         "note",
         10,
         "Nanoseconds per face of the last level, medians; " + facts.at("processor") + ", " + facts.at("compiler") +
             ' ' + facts.at("flags"));
    y += 16;
    for (const auto& contest : contests)
        y += draw(body, y, contest);
    write_svg_file(path,
                   names + bars + right,
                   y + 10,
                   ".title{font-weight:bold}.name{text-anchor:end}.note,.value{fill:#444}.ours{fill:#1f77b4}"
                   ".theirs{fill:#bbb}",
                   body.str());
}

} // namespace kith::comparison
