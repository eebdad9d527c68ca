// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace kith::tool {

/// Returns the shortest text from which the same number can be read back.
template <class Number>
std::string shortest_text(Number value)
{
    std::array<char, 32> digits;
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

} // namespace kith::tool
