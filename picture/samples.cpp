// SPDX-License-Identifier: BSD-3-Clause
#include "samples.hpp"

#include "layout.hpp"

#include <utility>

namespace kith::picture {

namespace {

/// Coordinates in whole parts of a sample, so that a sample on a side belongs to exactly one of two triangles.
constexpr double parts = 256;

struct side {
    std::int64_t to_right, downward, value; ///< of the function that is not negative inside

    side(const std::array<std::int64_t, 2>& a, const std::array<std::int64_t, 2>& b, std::int64_t x, std::int64_t y)
        : to_right(a[1] - b[1]), downward(b[0] - a[0])
    {
        value = to_right * (x - a[0]) + downward * (y - a[1]);
        const bool has_its_samples = to_right > 0 or (to_right == 0 and downward > 0);
        value -= has_its_samples ? 0 : 1;
        to_right *= std::int64_t(parts);
        downward *= std::int64_t(parts);
    }
};

color weighed_sum(const color& a, float w, const color& b, float u, const color& c, float v)
{
    return {a.red * w + b.red * u + c.red * v,
            a.green * w + b.green * u + c.green * v,
            a.blue * w + b.blue * u + c.blue * v,
            a.opacity * w + b.opacity * u + c.opacity * v};
}

} // namespace

void samples::draw(const std::array<placed_corner, 3>& corners, bool is_flat, shading light, const image* texture)
{
    std::array<std::array<std::int64_t, 2>, 3> at;
    for (std::size_t k = 0; k < 3; ++k)
        at[k] = {std::llround(parts * corners[k].x), std::llround(parts * corners[k].y)};
    const std::int64_t area = (at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) -
                              (at[1][1] - at[0][1]) * (at[2][0] - at[0][0]);
    if (area == 0)
        return;
    std::size_t b = 1, c = 2;
    if (area < 0)
        std::swap(b, c);
    const auto& first = corners[0];
    const auto &second = corners[b], &third = corners[c];
    const auto [left, right] = std::minmax({at[0][0], at[1][0], at[2][0]});
    const auto [top, bottom] = std::minmax({at[0][1], at[1][1], at[2][1]});
    const auto [first_row, last_row] = rows(double(top) / parts, double(bottom) / parts);
    const std::int64_t half = std::int64_t(parts) / 2, whole = std::int64_t(parts);
    const std::int64_t from = std::max<std::int64_t>((left + half - 1) / whole, 0);
    const std::int64_t to = std::min((right - half) / whole, last_column());
    if (from > to or first_row > last_row)
        return;
    const std::int64_t x = from * whole + half, y = first_row * whole + half;
    side of_third(at[0], at[b], x, y), of_first(at[b], at[c], x, y), of_second(at[c], at[0], x, y);
    const float share = 1 / float(std::abs(area));
    const float across = float(whole) * share *
                         (float(at[c][1] - at[0][1]) * (second.depth - first.depth) -
                          float(at[b][1] - at[0][1]) * (third.depth - first.depth));
    const float along = float(whole) * share *
                        (float(at[b][0] - at[0][0]) * (third.depth - first.depth) -
                         float(at[c][0] - at[0][0]) * (second.depth - first.depth));
    constexpr float steepest = 8;
    const float behind = line_reach_ * std::min(std::abs(across) + std::abs(along), steepest) + 1;
    brightness bright = is_flat ? brightness_of(light, {first.normal[0], first.normal[1], first.normal[2]})
                                : brightness{1, 0};
    for (std::int64_t row = first_row; row <= last_row; ++row) {
        std::int64_t one = of_first.value, two = of_second.value, three = of_third.value;
        std::size_t i = std::size_t(row - first_) * width_ + std::size_t(from);
        for (std::int64_t column = from; column <= to; ++column, ++i) {
            if ((one | two | three) >= 0) {
                const float u = float(two) * share, v = float(three) * share, w = 1 - u - v;
                const float depth = w * first.depth + u * second.depth + v * third.depth;
                if (depth >= depths_[i]) {
                    if (not is_flat) {
                        point normal{};
                        for (std::size_t k = 0; k < 3; ++k)
                            normal[k] = w * first.normal[k] + u * second.normal[k] + v * third.normal[k];
                        bright = brightness_of(light, in_length_one(normal));
                    }
                    const auto in_texture = [&](std::size_t k) {
                        return w * first.in_texture[k] + u * second.in_texture[k] + v * third.in_texture[k];
                    };
                    const color own = texture != nullptr ? color_at(*texture, in_texture(0), in_texture(1))
                                                         : weighed_sum(first.paint, w, second.paint, u, third.paint, v);
                    const color paint = lit(own, bright);
                    blend(i, paint, paint.opacity);
                    depths_[i] = depth;
                    line_depths_[i] = depth - behind;
                }
            }
            one += of_first.to_right, two += of_second.to_right, three += of_third.to_right;
        }
        of_first.value += of_first.downward;
        of_second.value += of_second.downward;
        of_third.value += of_third.downward;
    }
}

void samples::draw(const point& from, const point& to, double half_width, const color& ink, double hidden)
{
    const double dx = to[0] - from[0], dy = to[1] - from[1], square = dx * dx + dy * dy;
    const auto [first_row, last_row] = rows(std::min(from[1], to[1]) - half_width,
                                            std::max(from[1], to[1]) + half_width);
    for (std::int64_t row = first_row; row <= last_row; ++row) {
        const double y = double(row) + .5 - from[1];
        double begin = 0, end = 1; // of the line, at the height of this row
        if (dy != 0) {
            const auto [a, b] = std::minmax({(y - half_width) / dy, (y + half_width) / dy});
            begin = std::clamp(a, 0., 1.), end = std::clamp(b, 0., 1.);
        }
        const double left = from[0] + std::min(begin * dx, end * dx) - half_width;
        const double right = from[0] + std::max(begin * dx, end * dx) + half_width;
        const auto first = std::max<std::int64_t>(std::int64_t(std::ceil(std::max(left, 0.) - .5)), 0);
        const auto last = std::min(std::int64_t(std::floor(std::max(right, 0.) - .5)), last_column());
        for (std::int64_t column = first; column <= last; ++column) {
            const double x = double(column) + .5 - from[0];
            const double t = square > 0 ? std::clamp((x * dx + y * dy) / square, 0., 1.) : 0;
            if ((x - t * dx) * (x - t * dx) + (y - t * dy) * (y - t * dy) > half_width * half_width)
                continue;
            const std::size_t i = std::size_t(row - first_) * width_ + std::size_t(column);
            const float depth = float(from[2] + t * (to[2] - from[2]));
            const bool is_seen = depth >= line_depths_[i];
            constexpr std::uint8_t hidden_stamp = 1, seen_stamp = 2;
            const std::uint8_t stamp = is_seen ? seen_stamp : hidden_stamp;
            if (stamps_[i] >= stamp)
                continue;
            stamps_[i] = stamp;
            blend(i, ink, ink.opacity * (is_seen ? 1 : float(hidden)));
        }
    }
}

void samples::draw(double x, double y, double width, double height, const color& top, const color& bottom)
{
    const auto [first_row, last_row] = rows(y, y + height);
    const auto first = std::int64_t(std::ceil(std::max(x, 0.) - .5));
    const auto last = std::min(std::int64_t(std::floor(std::max(x + width, 0.) - .5)), last_column());
    for (std::int64_t row = first_row; row <= last_row; ++row) {
        const color paint = mix(top, bottom, float((double(row) + .5 - y) / height));
        for (std::int64_t column = first; column <= last; ++column)
            blend(std::size_t(row - first_) * width_ + std::size_t(column), paint, paint.opacity);
    }
}

} // namespace kith::picture
