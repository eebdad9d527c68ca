// SPDX-License-Identifier: BSD-3-Clause
#include "svg_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace kith::picture {

std::string number(double x, int digits)
{
    const double unit = std::pow(10., digits);
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*f", digits, std::round(unit * x) / unit + 0.); // no -0
    std::string result = text.data();
    while (digits > 0 and result.ends_with('0'))
        result.pop_back();
    if (result.ends_with('.'))
        result.pop_back();
    return result;
}

std::string hexadecimal(const color& paint)
{
    const auto byte = [](float x) { return unsigned(std::lround(255 * std::clamp(x, 0.F, 1.F))); };
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(paint.red), byte(paint.green), byte(paint.blue));
    return text.data();
}

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    return result;
}

} // namespace kith::picture
