// SPDX-License-Identifier: BSD-3-Clause
#include <kith/picture/color.hpp>

#include <array>
#include <cmath>
#include <span>

namespace kith::picture {

namespace {

/// Returns the color at a share of the way through some colors.
color color_along(std::span<const color> colors, double share)
{
    if (std::isnan(share))
        return gray;
    const double at = std::fmin(std::fmax(share, 0), 1) * double(colors.size() - 1);
    const auto before = std::size_t(std::fmin(at, double(colors.size() - 2)));
    return mix(colors[before], colors[before + 1], float(at - double(before)));
}

} // namespace

color color_of_number(std::size_t number)
{
    // The golden angle takes hues far apart; lightness alternates for neighbours on the circle of hues.
    constexpr double golden_angle = 137.50776405003785 / 60;
    const double hue = std::fmod(.6 + golden_angle * double(number), 6);
    const float middle = number % 3 == 0 ? .66F : number % 3 == 1 ? .58F : .74F, reach = .2F;
    const auto channel = [&](double turn) {
        const double distance = std::abs(std::fmod(hue + turn, 6) - 3); // 3 at the channel's own hue
        return middle + reach * float(std::fmin(std::fmax(2 * distance - 3, -1), 1));
    };
    return {channel(0), channel(4), channel(2), 1};
}

color color_of_signed(double value)
{
    static constexpr std::array<color, 5> colors{{{.13F, .26F, .62F, 1},
                                                  {.45F, .62F, .88F, 1},
                                                  {.96F, .96F, .95F, 1},
                                                  {.93F, .52F, .41F, 1},
                                                  {.66F, .06F, .15F, 1}}};
    return color_along(colors, .5 + .5 * value);
}

color color_of_share(double value)
{
    static constexpr std::array<color, 5> colors{{{.24F, .07F, .38F, 1},
                                                  {.20F, .30F, .60F, 1},
                                                  {.13F, .57F, .55F, 1},
                                                  {.48F, .79F, .33F, 1},
                                                  {.98F, .91F, .18F, 1}}};
    return color_along(colors, value);
}

} // namespace kith::picture
