// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace kith::tool {

/// Appends a word to a list: "kept" becomes "kept, smoothed".
inline void append_to_list(std::string& text, std::string_view word)
{
    if (not text.empty())
        text += ", ";
    text += word;
}

} // namespace kith::tool
