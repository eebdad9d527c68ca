// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/fields/property/property_access.hpp>

#include <string>
#include <vector>

/// Returns the names of properties that were left out.
inline std::vector<std::string> names_of(const std::vector<kith::omission>& left_out)
{
    std::vector<std::string> result;
    for (const kith::omission& each : left_out)
        result.push_back(each.name);
    return result;
}
