// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace kith::tool {

/// A value in JSON, whose objects keep their members in the order in which they were added.
using json = nlohmann::ordered_json;

/// Returns the value in one line. Bytes that are not UTF-8, which file names may contain, become U+FFFD.
inline std::string text_of(const json& value)
{
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace kith::tool
