// SPDX-License-Identifier: BSD-3-Clause
#include "layout.hpp"
#include "letters.hpp"
#include "samples.hpp"

#include <kith/picture.hpp>

#include <kith/core/base/for_parts.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <variant>

namespace kith::picture {

namespace {

constexpr std::size_t rows_of_band = 8; // of pixels; the samples of a band stay in a cache

/// Returns the area vector of a polygon, along the axes of the view; its z is positive if the polygon is seen from the
/// front.
point area_of(std::span<const std::uint32_t> corners, const std::vector<point>& places)
{
    point result{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const point &a = places[corners[i]], &b = places[corners[(i + 1) % corners.size()]];
        result[0] -= (a[1] - b[1]) * (a[2] + b[2]); // y is downward
        result[1] += (a[2] - b[2]) * (a[0] + b[0]);
        result[2] -= (a[0] - b[0]) * (a[1] + b[1]);
    }
    return result;
}

/// The parts of an item, by the bands of the picture that they touch.
struct bands {
    std::vector<std::uint32_t> first, parts;

    /// Makes the lists. `extent_of(part)` is the lowest and the highest coordinate of a part, in samples; parts without
    /// an extent are left out.
    template <class Extent>
    bands(std::size_t count, std::size_t size, double rows, const Extent& extent_of) : first(count + 1)
    {
        const auto range_of = [&](std::size_t part) -> std::pair<std::size_t, std::size_t> {
            const auto [least, most] = extent_of(part);
            if (not(least <= most) or most < 0 or least >= rows * double(count))
                return {0, 0};
            return {std::size_t(std::max(least, 0.) / rows), std::min(std::size_t(most / rows) + 1, count)};
        };
        std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges(size);
        detail::for_parts(size, true, [&](std::size_t begin, std::size_t end) {
            for (std::size_t part = begin; part < end; ++part)
                ranges[part] = range_of(part);
        });
        for (const auto& [begin, end] : ranges)
            for (std::size_t band = begin; band < end; ++band)
                ++first[band + 1];
        for (std::size_t band = 0; band < count; ++band)
            first[band + 1] += first[band];
        parts.resize(first.back());
        auto next = first;
        for (std::size_t part = 0; part < size; ++part)
            for (std::size_t band = ranges[part].first; band < ranges[part].second; ++band)
                parts[next[band]++] = std::uint32_t(part);
    }
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t band) const
    {
        return std::span(parts).subspan(first[band], first[band + 1] - first[band]);
    }
};

template <class Numbers>
std::pair<double, double> extent_of(const Numbers& numbers, const std::vector<point>& places, double reach)
{
    double least = INFINITY, most = -INFINITY;
    for (const auto v : numbers) {
        if (not std::isfinite(places[v][0] + places[v][1] + places[v][2]))
            return {INFINITY, -INFINITY};
        least = std::min(least, places[v][1]);
        most = std::max(most, places[v][1]);
    }
    return {least - reach, most + reach};
}

/// A surface in its place, in samples.
class placed_surface {
public:
    placed_surface(const surface& s, const view_axes& axes, std::vector<point> places, std::size_t count, double rows,
                   int per_pixel)
        : surface_(&s)
        , places_(std::move(places))
        , normals_(s.corner_normals.empty() ? s.normals.size() : s.corner_normals.size())
        , half_width_(s.edges.width * per_pixel / 2)
        , bands_(count, s.face_count(), rows,
                 [&](std::size_t f) { return extent_of(corners_of(f), places_, half_width_); })
    {
        const auto& normals = s.corner_normals.empty() ? s.normals : s.corner_normals;
        detail::for_parts(normals.size(), true, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    normals_[i][k] = float(dot(axes[k], normals[i]));
        });
    }

    void fill(samples& out, std::size_t band) const
    {
        for (const std::uint32_t f : bands_.of(band)) {
            const auto corners = corners_of(f);
            const point area = area_of(corners, places_);
            const bool is_back = area[2] < 0;
            if (is_back and surface_->closed)
                continue;
            const float sign = is_back ? -1 : 1;
            const point flat = in_length_one(area);
            const color& paint = surface_->face_colors.empty() ? surface_->paint : surface_->face_colors[f];
            const auto number = [&](std::size_t i) { // of a normal
                return surface_->corner_normals.empty() ? corners[i] : surface_->first[f] + i;
            };
            const auto corner = [&](std::size_t i) {
                const std::uint32_t v = corners[i];
                const point& p = places_[v];
                placed_corner result{p[0], p[1], float(p[2]), {}, paint};
                for (std::size_t k = 0; k < 3; ++k)
                    result.normal[k] = sign * (normals_.empty() ? float(flat[k]) : normals_[number(i)][k]);
                if (not surface_->vertex_colors.empty())
                    result.paint = surface_->vertex_colors[v];
                if (surface_->texture != nullptr)
                    result.in_texture = surface_->corner_textures[surface_->first[f] + i];
                return result;
            };
            for (std::size_t i = 2; i < corners.size(); ++i)
                out.draw(
                    {corner(0), corner(i - 1), corner(i)}, normals_.empty(), surface_->light, surface_->texture.get());
        }
    }
    void draw_edges(samples& out, std::size_t band) const
    {
        if (half_width_ <= 0)
            return;
        out.begin_lines();
        for (const std::uint32_t f : bands_.of(band)) {
            const auto corners = corners_of(f);
            if (surface_->closed and area_of(corners, places_)[2] < 0)
                continue;
            for (std::size_t i = 0; i < corners.size(); ++i)
                out.draw(places_[corners[i]],
                         places_[corners[(i + 1) % corners.size()]],
                         half_width_,
                         surface_->edges.ink,
                         0);
        }
    }

private:
    [[nodiscard]] std::span<const std::uint32_t> corners_of(std::size_t f) const
    {
        const std::size_t begin = surface_->first[f], end = surface_->first[f + 1];
        return std::span(surface_->corners).subspan(begin, end - begin);
    }

    const surface* surface_;
    std::vector<point> places_;
    std::vector<std::array<float, 3>> normals_; // of the points or of the corners
    double half_width_;
    bands bands_;
};

/// Lines in their place, in samples.
class placed_lines {
public:
    placed_lines(const lines& l, const view_axes&, std::vector<point> places, std::size_t count, double rows,
                 int per_pixel)
        : lines_(&l)
        , places_(std::move(places))
        , half_width_(l.width * per_pixel / 2)
        , bands_(count, l.segments.size(), rows,
                 [&](std::size_t s) { return extent_of(l.segments[s], places_, half_width_); })
    {
    }

    void fill(samples&, std::size_t) const {}
    void draw_edges(samples& out, std::size_t band) const
    {
        out.begin_lines();
        for (const std::uint32_t s : bands_.of(band))
            out.draw(places_[lines_->segments[s][0]],
                     places_[lines_->segments[s][1]],
                     half_width_,
                     lines_->ink,
                     lines_->hidden);
    }

private:
    const lines* lines_;
    std::vector<point> places_;
    double half_width_;
    bands bands_;
};

using placed_item = std::variant<placed_surface, placed_lines>;

placed_item placed(const surface& s, const view_axes& axes, std::vector<point> places, std::size_t count, double rows,
                   int per_pixel)
{
    return placed_surface(s, axes, std::move(places), count, rows, per_pixel);
}
placed_item placed(const lines& l, const view_axes& axes, std::vector<point> places, std::size_t count, double rows,
                   int per_pixel)
{
    return placed_lines(l, axes, std::move(places), count, rows, per_pixel);
}

/// Returns the mean color of the samples of a pixel, as bytes.
std::array<std::uint8_t, 4> pixel_of(const samples& from, std::size_t x, std::size_t y, std::size_t per_pixel)
{
    color sum = transparent;
    for (std::size_t j = 0; j < per_pixel; ++j)
        for (std::size_t i = 0; i < per_pixel; ++i) {
            const color& c = from.at(x * per_pixel + i, y * per_pixel + j);
            sum.red += c.red, sum.green += c.green, sum.blue += c.blue, sum.opacity += c.opacity;
        }
    if (sum.opacity <= 0)
        return {};
    const auto byte = [](float share) { return std::uint8_t(std::lround(255 * std::clamp(share, 0.F, 1.F))); };
    return {byte(sum.red / sum.opacity),
            byte(sum.green / sum.opacity),
            byte(sum.blue / sum.opacity),
            byte(sum.opacity / float(per_pixel * per_pixel))};
}

} // namespace

image draw(const sheet& sheet)
{
    const layout places(sheet);
    const auto width = std::size_t(sheet.width), height = std::size_t(sheet.height);
    const auto per_pixel = std::size_t(sheet.samples);
    const std::size_t count = (height + rows_of_band - 1) / rows_of_band;
    const double scale = sheet.samples, rows = double(rows_of_band * per_pixel);
    std::vector<placed_item> items;
    double widest = 0;
    for (std::size_t p = 0; p < sheet.panels.size(); ++p)
        for (const auto& item : sheet.panels[p].items)
            std::visit(
                [&](const auto& i) {
                    std::vector<point> points = places.place_all(p, i);
                    for (point& place : points)
                        for (double& x : place)
                            x *= scale;
                    items.push_back(placed(i, places.axes(), std::move(points), count, rows, sheet.samples));
                    if constexpr (requires { i.edges; })
                        widest = std::max(widest, i.edges.width);
                    else
                        widest = std::max(widest, i.width);
                },
                item);
    std::vector<stroke> strokes;
    for (const placed_text& text : places.texts()) {
        const double shift = text.is_centered ? width_of_text(text.text, sheet.text_size) / 2 : 0;
        for (const stroke& s : strokes_of_text(text.text, text.x - shift, text.y, sheet.text_size))
            strokes.push_back(s);
    }

    image result{width, height, std::vector<std::array<std::uint8_t, 4>>(width * height)};
    detail::for_shared_parts(count, 1, true, [&](auto parts) {
        samples band(width * per_pixel, rows_of_band * per_pixel, float(widest * scale / 2));
        parts.for_each([&](std::size_t number, std::size_t) {
            const std::size_t top = number * rows_of_band, bottom = std::min(top + rows_of_band, height);
            band.begin(top * per_pixel, bottom * per_pixel, sheet.background);
            for (const auto& item : items)
                std::visit([&](const auto& i) { i.fill(band, number); }, item);
            for (const auto& item : items)
                std::visit([&](const auto& i) { i.draw_edges(band, number); }, item);
            for (const placed_bar& bar : places.bars())
                band.draw(bar.x * scale, bar.y * scale, bar.width * scale, bar.height * scale, bar.top, bar.bottom);
            band.begin_lines();
            constexpr double nearest = 1e30, weight = .045;
            for (const auto& [from, to] : strokes)
                band.draw({from[0] * scale, from[1] * scale, nearest},
                          {to[0] * scale, to[1] * scale, nearest},
                          weight * sheet.text_size * scale,
                          sheet.ink,
                          0);
            for (std::size_t y = top; y < bottom; ++y)
                for (std::size_t x = 0; x < width; ++x)
                    result.pixels[y * width + x] = pixel_of(band, x, y, per_pixel);
        });
    });
    return result;
}

} // namespace kith::picture
