// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace kith::io {

/// Returns a number with its noun: "1 face", "2 faces", "1 vertex", "0 vertices".
inline std::string counted(std::uint64_t number, std::string_view noun)
{
    std::string result = std::to_string(number) + " ";
    if (number == 1)
        return result.append(noun);
    if (noun.ends_with("ex"))
        return result.append(noun.substr(0, noun.size() - 2)) + "ices";
    return result.append(noun) + "s";
}

} // namespace kith::io
