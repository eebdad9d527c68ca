// SPDX-License-Identifier: BSD-3-Clause
#include "bitwise_compare.hpp"

#include "cli/shortest_text.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kith::tool {

namespace {

std::string differing(const std::string& what, const std::string& a, const std::string& b)
{
    return what + ": " + a + " and " + b;
}

std::string text_of(std::span<const std::size_t> face)
{
    std::string result;
    for (const std::size_t v : face)
        result += (result.empty() ? "" : " ") + std::to_string(v);
    return result;
}

} // namespace

std::string first_difference(const io::polygon_soup& a, const io::polygon_soup& b)
{
    if (a.points.size() != b.points.size())
        return differing("vertices", std::to_string(a.points.size()), std::to_string(b.points.size()));
    if (a.faces.size() != b.faces.size())
        return differing("faces", std::to_string(a.faces.size()), std::to_string(b.faces.size()));
    for (std::size_t v = 0; v < a.points.size(); ++v)
        for (std::size_t i = 0; i < 3; ++i)
            if (const double x = a.points[v][i], y = b.points[v][i];
                std::bit_cast<std::uint64_t>(x) != std::bit_cast<std::uint64_t>(y))
                return differing("vertex " + std::to_string(v) + ", " + "xyz"[i], shortest_text(x), shortest_text(y));
    for (std::size_t f = 0; f < a.faces.size(); ++f)
        if (not std::ranges::equal(a.faces[f], b.faces[f]))
            return differing("face " + std::to_string(f), text_of(a.faces[f]), text_of(b.faces[f]));
    return {};
}

} // namespace kith::tool
