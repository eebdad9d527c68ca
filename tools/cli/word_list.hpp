// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kith::tool {

/// Appends a word to a list: "kept" becomes "kept, smoothed".
inline void append_to_list(std::string& text, std::string_view word)
{
    if (not text.empty())
        text += ", ";
    text += word;
}

/// Returns the words between separators: "0,1" has "0" and "1".
inline std::vector<std::string> parts_of(std::string_view text, char separator)
{
    std::vector<std::string> result{""};
    for (const char c : text)
        if (c == separator)
            result.emplace_back();
        else
            result.back() += c;
    return result;
}

} // namespace kith::tool
