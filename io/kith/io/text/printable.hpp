// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace kith::io {

namespace detail {

/// The first character of a text in UTF-8: its code point and the number of its bytes.
struct utf8_character {
    char32_t code = 0;
    std::size_t bytes = 0; ///< 0: the text begins with bytes that are not UTF-8
};

inline utf8_character first_character(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80)
        return {byte(0), 1};
    const std::size_t bytes = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
    if (byte(0) < 0xc2 or byte(0) > 0xf4 or text.size() < bytes)
        return {};
    char32_t code = byte(0) & (0x7fU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if (byte(i) >> 6 != 2)
            return {};
        code = code << 6 | (byte(i) & 0x3fU);
    }
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = code >= 0xd800 and code <= 0xdfff;
    return code < least[bytes] or code > 0x10ffff or is_surrogate ? utf8_character{} : utf8_character{code, bytes};
}

/// Returns true if a terminal takes the character for a command, or shows the text around it in another order.
inline bool is_command(char32_t code)
{
    const bool is_control = (code < ' ' and code != '\n' and code != '\t') or (code >= 0x7f and code < 0xa0);
    const bool is_direction = code == 0x200e or code == 0x200f or (code >= 0x2028 and code <= 0x202e) or
                              (code >= 0x2066 and code <= 0x2069);
    return is_control or is_direction;
}

} // namespace detail

/// Returns a text that can be shown on a terminal. '?' replaces control characters except line ends and tabs,
/// characters that change the direction of text, and bytes that are not UTF-8. Cost: O(bytes).
inline std::string printable(std::string_view text)
{
    std::string result;
    result.reserve(text.size());
    while (not text.empty()) {
        const auto [code, bytes] = detail::first_character(text);
        if (bytes == 0 or detail::is_command(code))
            result += '?';
        else
            result += text.substr(0, bytes);
        text.remove_prefix(bytes == 0 ? 1 : bytes);
    }
    return result;
}

} // namespace kith::io
