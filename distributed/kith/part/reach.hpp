// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/error.hpp>
#include <kith/step/scheme.hpp>

#include <string>
#include <vector>

namespace kith {

/// The rings of shadow faces that a tile needs on level 0, 1, ..., `levels`, if it is to have `last` rings at the end.
/// One coarse ring becomes several refined ones, so that the numbers stay bounded whatever the number of levels.
/// Errors: mesh_error for negative numbers and for more than 1000 levels.
template <reaching_scheme S>
std::vector<int> ring_schedule(const S& scheme, int levels, int last = 0)
{
    if (levels < 0 or last < 0)
        throw mesh_error(std::string(scheme_name<S>()) + ": levels and rings are counted from 0");
    constexpr int most = 1000; // far beyond what 64 bits can number, and little to allocate
    if (levels > most)
        throw mesh_error(std::string(scheme_name<S>()) + ": " + std::to_string(levels) +
                         " levels were asked for; no surface has so many, ask for at most " + std::to_string(most));
    std::vector<int> rings(std::size_t(levels) + 1);
    rings.back() = last;
    for (std::size_t level = rings.size() - 1; level > 0; --level)
        rings[level - 1] = reach_of(scheme, rings[level]);
    return rings;
}

} // namespace kith
