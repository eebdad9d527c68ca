// SPDX-License-Identifier: BSD-3-Clause
#include "layout.hpp"
#include "svg_text.hpp"

#include <kith/picture.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>

namespace kith::picture {

namespace {

/// A part of a picture that is painted over those that lie farther from the viewer: a polygon, as an element, or a
/// line, as a part of a path. Parts of one style that follow each other are written together.
struct painted {
    double depth;
    bool is_line;
    std::string style; ///< attributes
    std::string text;
};

void write(std::ostream& out, std::span<const painted> parts)
{
    for (std::size_t i = 0; i < parts.size();) {
        const painted& first = parts[i];
        out << (first.is_line ? "<path" : "<g") << first.style << (first.is_line ? " d='" : ">\n");
        for (; i < parts.size() and parts[i].is_line == first.is_line and parts[i].style == first.style; ++i)
            out << parts[i].text;
        out << (first.is_line ? "'/>\n" : "</g>\n");
    }
}

std::string opacity(const char* name, const color& paint)
{
    return paint.opacity == 1 ? "" : " " + std::string(name) + "='" + number(paint.opacity, 2) + "'";
}

point mean(std::span<const point> points)
{
    point sum{};
    for (const point& p : points)
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += p[k] / double(points.size());
    return sum;
}
bool is_finite(const point& p)
{
    return std::isfinite(p[0] + p[1] + p[2]);
}

/// Paints polygons. Returns twice the mean distance between the nearest corner of a polygon and its middle, in depth.
double paint(std::vector<painted>& out, const surface& s, const layout& places, std::size_t panel)
{
    const std::vector<point> all = places.place_all(panel, s);
    double reach = 0;
    const bool is_smooth = not s.normals.empty() or not s.corner_normals.empty();
    for (std::size_t f = 0; f < s.face_count(); ++f) {
        std::vector<point> corners;
        point normal{}, area{};
        color mixed{0, 0, 0, 0};
        std::array<double, 2> in_texture{};
        const float share = 1 / float(s.first[f + 1] - s.first[f]);
        for (std::size_t c = s.first[f]; c < s.first[f + 1]; ++c) {
            const std::uint32_t v = s.corners[c];
            corners.push_back(all[v]);
            if (is_smooth)
                for (std::size_t k = 0; k < 3; ++k)
                    normal[k] += dot(places.axes()[k], s.corner_normals.empty() ? s.normals[v] : s.corner_normals[c]);
            if (s.texture != nullptr)
                for (std::size_t k = 0; k < 2; ++k)
                    in_texture[k] += double(share * s.corner_textures[c][k]);
            if (not s.vertex_colors.empty()) {
                const color& at = s.vertex_colors[v];
                mixed.red += share * at.red, mixed.green += share * at.green;
                mixed.blue += share * at.blue, mixed.opacity += share * at.opacity;
            }
        }
        const point middle = mean(corners);
        if (corners.size() < 3 or not is_finite(middle))
            continue;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const point &a = corners[i], &b = corners[(i + 1) % corners.size()];
            area[0] -= (a[1] - b[1]) * (a[2] + b[2]);
            area[1] += (a[2] - b[2]) * (a[0] + b[0]);
            area[2] -= (a[0] - b[0]) * (a[1] + b[1]);
        }
        if (s.closed and area[2] <= 0)
            continue;
        normal = in_length_one(is_smooth ? normal : area);
        if (area[2] < 0)
            for (double& x : normal)
                x = -x;
        const color own = s.texture != nullptr          ? color_at(*s.texture, in_texture[0], in_texture[1])
                          : not s.vertex_colors.empty() ? mixed
                          : s.face_colors.empty()       ? s.paint
                                                        : s.face_colors[f];
        const color fill = lit(own, brightness_of(s.light, normal));
        std::string style, path = "<path fill='" + hexadecimal(fill) + "'";
        if (s.edges.width > 0)
            style = " stroke='" + hexadecimal(s.edges.ink) + "' stroke-width='" + number(s.edges.width) + "'";
        else if (fill.opacity == 1) { // else the background is seen between neighbours
            style = " stroke-width='.5'";
            path += " stroke='" + hexadecimal(fill) + "'";
        }
        style += opacity("fill-opacity", fill);
        path += " d='M";
        for (const point& p : corners)
            path += number(p[0]) + ' ' + number(p[1]) + ' ';
        path += "z'/>\n";
        out.push_back({middle[2], false, style, std::move(path)});
        const auto depth_of = [](const point& p) { return p[2]; };
        reach += 2 * (depth_of(std::ranges::max(corners, {}, depth_of)) - middle[2]) / double(s.face_count());
    }
    return reach;
}

/// Paints lines. Each is as much nearer to the viewer as the polygons around it may be before their middles.
void paint(std::vector<painted>& out, const lines& l, const layout& places, std::size_t panel, double reach)
{
    const std::vector<point> all = places.place_all(panel, l);
    const std::string style = " stroke='" + hexadecimal(l.ink) + "'" + opacity("stroke-opacity", l.ink) +
                              " stroke-width='" + number(l.width) + "'";
    for (const auto& [from, to] : l.segments) {
        const point &a = all[from], &b = all[to];
        if (not is_finite(a) or not is_finite(b))
            continue;
        // Short pieces, so that each has one depth.
        constexpr double longest = 24;
        const double length = std::sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]));
        const bool is_flat = a[2] == b[2];
        const auto pieces = is_flat ? 1 : std::size_t(std::ceil(std::clamp(length / longest, 1., 1000.)));
        for (std::size_t i = 0; i < pieces; ++i) {
            const auto at = [&](double t) {
                return point{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
            };
            const point p = at(double(i) / double(pieces)), q = at(double(i + 1) / double(pieces));
            out.push_back({std::max(p[2], q[2]) + reach,
                           true,
                           style,
                           'M' + number(p[0]) + ' ' + number(p[1]) + 'L' + number(q[0]) + ' ' + number(q[1])});
        }
    }
}

} // namespace

void write_svg(std::ostream& out, const sheet& sheet)
{
    const layout places(sheet);
    out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << sheet.width << ' ' << sheet.height
        << "' stroke-linejoin='round' stroke-linecap='round' font-family='sans-serif' font-size='"
        << number(sheet.text_size) << "'>\n";
    if (sheet.background.opacity > 0)
        out << "<rect width='" << sheet.width << "' height='" << sheet.height << "' fill='"
            << hexadecimal(sheet.background) << "'" << opacity("fill-opacity", sheet.background) << "/>\n";
    for (std::size_t i = 0; i < sheet.panels.size(); ++i) {
        std::vector<painted> parts;
        double reach = 0;
        for (const auto& item : sheet.panels[i].items)
            if (const auto* const of_surface = std::get_if<surface>(&item))
                reach = std::max(reach, paint(parts, *of_surface, places, i));
        for (const auto& item : sheet.panels[i].items)
            if (const auto* const of_lines = std::get_if<lines>(&item))
                paint(parts, *of_lines, places, i, reach);
        std::ranges::stable_sort(parts, {}, &painted::depth);
        write(out, parts);
    }
    std::size_t number_of_bar = 0;
    for (const placed_bar& bar : places.bars()) {
        std::string fill = hexadecimal(bar.top);
        if (not(bar.top == bar.bottom)) {
            const std::string name = "bar" + std::to_string(number_of_bar++);
            out << "<linearGradient id='" << name << "' x2='0' y2='1'><stop stop-color='" << fill
                << "'/><stop offset='1' stop-color='" << hexadecimal(bar.bottom) << "'/></linearGradient>\n";
            fill = "url(#" + name + ")";
        }
        out << "<rect x='" << number(bar.x) << "' y='" << number(bar.y) << "' width='" << number(bar.width)
            << "' height='" << number(bar.height) << "' fill='" << fill << "'/>\n";
    }
    for (const placed_text& text : places.texts())
        out << "<text x='" << number(text.x) << "' y='" << number(text.y) << "' fill='" << hexadecimal(sheet.ink) << "'"
            << (text.is_centered ? " text-anchor='middle'" : "") << '>' << escaped(text.text) << "</text>\n";
    out << "</svg>\n";
}

} // namespace kith::picture
