// SPDX-License-Identifier: BSD-3-Clause
#include "layout.hpp"

#include "letters.hpp"

#include <kith/core/base/for_parts.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <ranges>
#include <stdexcept>

namespace kith::picture {

namespace {

constexpr double margin = .04; // of the smaller side of a panel

const point lamp = in_length_one({-.45, .65, .75}), halfway = in_length_one({lamp[0], lamp[1], lamp[2] + 1});

void require(bool condition, const char* what)
{
    if (not condition)
        throw std::invalid_argument(std::string("picture: ") + what);
}
bool is_one_each(std::size_t size, std::size_t elements)
{
    return size == 0 or size == elements;
}

void require_complete(const surface& s)
{
    require(not s.first.empty() and s.first.front() == 0 and s.first.back() == s.corners.size() and
                std::ranges::is_sorted(s.first),
            "`first` of a surface has to lead from 0 to the number of corners");
    require(std::ranges::all_of(s.corners, [&](auto v) { return v < s.points.size(); }),
            "a corner of a surface is none of its points");
    require(is_one_each(s.normals.size(), s.points.size()), "a surface needs a normal per point, or none");
    require(is_one_each(s.corner_normals.size(), s.corners.size()), "a surface needs a normal per corner, or none");
    require(is_one_each(s.vertex_colors.size(), s.points.size()), "a surface needs a color per point, or none");
    require(is_one_each(s.face_colors.size(), s.face_count()), "a surface needs a color per polygon, or none");
    if (s.texture == nullptr)
        return;
    require(s.texture->width > 0 and s.texture->pixels.size() == s.texture->width * s.texture->height,
            "a texture needs pixels in all of its rows");
    require(s.corner_textures.size() == s.corners.size(), "a texture needs texture coordinates per corner");
}
void require_complete(const lines& l)
{
    require(std::ranges::all_of(l.segments, [&](const auto& s) { return std::max(s[0], s[1]) < l.points.size(); }),
            "an end of a line is none of its points");
}

view_axes axes_of(const view& v)
{
    require(0 <= v.up and v.up < 3, "`up` of a view is 0, 1 or 2");
    const double azimuth = v.azimuth * std::numbers::pi / 180, elevation = v.elevation * std::numbers::pi / 180;
    const auto exact = [](double x) { return std::abs(x) < 1e-15 ? 0 : x; }; // of a right angle
    const double ca = exact(std::cos(azimuth)), sa = exact(std::sin(azimuth));
    const double ce = exact(std::cos(elevation)), se = exact(std::sin(elevation));
    const view_axes z_up{{{ca, sa, 0}, {-sa * se, ca * se, ce}, {sa * ce, -ca * ce, se}}}; // x is to the right
    view_axes result{};
    // For y upward, the viewer in front stands at +z; for x upward, at -z.
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const point& a = z_up[axis];
        result[axis] = v.up == 2 ? a : v.up == 1 ? point{a[0], a[2], -a[1]} : point{a[2], a[0], a[1]};
    }
    return result;
}

/// The extent of points along the axes of the view.
struct extent {
    point least{}, most{};
    bool is_empty = true;

    void add(const point& p)
    {
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = is_empty ? p[k] : std::min(least[k], p[k]);
            most[k] = is_empty ? p[k] : std::max(most[k], p[k]);
        }
        is_empty = false;
    }
};

point along(const view_axes& axes, const point& p)
{
    return {dot(axes[0], p), dot(axes[1], p), dot(axes[2], p)};
}

double largest_width(const sheet& sheet)
{
    double result = 0;
    for (const auto& panel : sheet.panels)
        for (const auto& item : panel.items) {
            const auto* of_lines = std::get_if<lines>(&item);
            result = std::max(result, of_lines != nullptr ? of_lines->width : std::get<surface>(item).edges.width);
        }
    return result;
}

} // namespace

point in_length_one(const point& v)
{
    const double length = std::sqrt(dot(v, v));
    return length > 0 ? point{v[0] / length, v[1] / length, v[2] / length} : v;
}

layout::layout(const sheet& sheet) : axes_(axes_of(sheet.view))
{
    constexpr int largest = 1 << 15;
    require(0 < sheet.width and sheet.width <= largest and 0 < sheet.height and sheet.height <= largest,
            "width and height are from 1 to 32768 pixels");
    require(0 < sheet.samples and sheet.samples <= 16, "the number of samples is from 1 to 16");
    extent whole;
    bool has_titles = false;
    for (const panel& panel : sheet.panels) {
        has_titles = has_titles or not panel.title.empty();
        for (const auto& item : panel.items)
            std::visit(
                [&](const auto& i) {
                    require_complete(i);
                    for (const point& p : i.points)
                        if (std::isfinite(p[0] + p[1] + p[2]))
                            whole.add(along(axes_, p));
                },
                item);
    }
    double legend_width = 0;
    const double em = sheet.text_size;
    if (not sheet.legend.entries.empty()) {
        legend_width = width_of_text(sheet.legend.title, em);
        for (const auto& entry : sheet.legend.entries)
            legend_width = std::max(legend_width, 1.6 * em + width_of_text(entry.text, em));
        legend_width += em;
    }
    const std::size_t count = std::max<std::size_t>(sheet.panels.size(), 1);
    const std::size_t columns = sheet.columns > 0 ? std::min(std::size_t(sheet.columns), count) : count;
    const std::size_t rows = (count + columns - 1) / columns;
    const double width = (sheet.width - legend_width) / double(columns), height = sheet.height / double(rows);
    const double title = has_titles ? 1.8 * em : 0;
    for (std::size_t i = 0; i < sheet.panels.size(); ++i) {
        const double left = width * double(i % columns), top = height * double(i / columns);
        centers_.push_back({left + width / 2, top + title + (height - title) / 2});
        if (not sheet.panels[i].title.empty())
            texts_.push_back({sheet.panels[i].title, left + width / 2, top + 1.3 * em, true});
    }
    place_legend(sheet, sheet.width - legend_width);

    const double border = 2 * margin * std::min(width, height - title) + largest_width(sheet);
    double scale = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k)
        middle_[k] = (whole.least[k] + whole.most[k]) / 2;
    const std::array room{width - border, height - title - border};
    for (std::size_t k = 0; k < 2; ++k)
        if (const double size = whole.most[k] - whole.least[k]; size > 0)
            scale = std::min(scale, std::max(room[k], 1.) / size);
    scale_ = std::isfinite(scale) ? scale : 1;
}

void layout::place_legend(const sheet& sheet, double left)
{
    const auto& [title, entries, is_scale] = sheet.legend;
    if (entries.empty())
        return;
    const double em = sheet.text_size, room = sheet.height - 5 * em;
    const double step = is_scale ? std::min(room, 14 * em) / double(std::max<std::size_t>(entries.size() - 1, 1))
                                 : std::min(1.5 * em, room / double(entries.size()));
    const double length = step * double(entries.size() - (is_scale ? 1 : 0));
    const double top = (sheet.height - length) / 2 + em;
    if (not title.empty())
        texts_.push_back({title, left, top - 1.2 * em, false});
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const color paint = entries[i].paint;
        if (is_scale) { // upward
            const double y = top + length - step * double(i);
            if (i + 1 < entries.size())
                bars_.push_back({left, y - step, em, step, entries[i + 1].paint, paint});
            texts_.push_back({entries[i].text, left + 1.6 * em, y + .3 * em, false});
        } else {
            const double y = top + step * double(i);
            bars_.push_back({left, y, em, .8 * step, paint, paint});
            texts_.push_back({entries[i].text, left + 1.6 * em, y + .4 * step + .3 * em, false});
        }
    }
}

std::vector<point> layout::placed(std::size_t panel, const std::vector<point>& points, double lift) const
{
    std::vector<point> result(points.size());
    detail::for_parts(points.size(), true, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const point p = along(axes_, points[i]);
            result[i] = {centers_[panel][0] + scale_ * (p[0] - middle_[0]),
                         centers_[panel][1] - scale_ * (p[1] - middle_[1]),
                         scale_ * (p[2] - middle_[2] + lift)};
        }
    });
    return result;
}

std::vector<point> layout::place_all(std::size_t panel, const surface& s) const
{
    return placed(panel, s.points, 0);
}

std::vector<point> layout::place_all(std::size_t panel, const lines& l) const
{
    return placed(panel, l.points, l.lift);
}

brightness brightness_of(shading light, const point& normal)
{
    if (light == shading::none)
        return {1, 0};
    const double facing = std::max(dot(normal, lamp), 0.);
    if (light == shading::lit) {
        double shine = std::max(dot(normal, halfway), 0.); // to the power of 32
        for (int i = 0; i < 5; ++i)
            shine *= shine;
        return {float(.5 + .5 * facing), float(.16 * shine)};
    }
    // The direction from which the viewer sees light, and its place on a ceiling of parallel lamps.
    const double across = 2 * normal[2] * normal[0], upward = 2 * normal[2] * normal[1];
    const double toward = 2 * normal[2] * normal[2] - 1;
    const double angle = std::atan2(across + upward, 1 + toward);
    constexpr double stripes = 24;
    const double wave = std::sin(stripes * angle);
    const double stripe = std::clamp(.5 + 3 * wave, 0., 1.); // soft edges
    return {float((.25 + .75 * stripe) * (.7 + .3 * facing)), 0};
}

} // namespace kith::picture
