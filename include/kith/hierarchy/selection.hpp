// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/scheme.hpp>

#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace kith {

/// A scheme whose steps refine chosen faces, such as `selected`; if none have been chosen, all faces.
template <class S, class Level>
concept selecting_scheme = scheme<S> and requires(S& scheme, const S& chosen_before, const Level& level,
                                                  std::span<const unsigned char> flags) {
    // Chooses faces by a flag for each; throws mesh_error unless there is one for each.
    scheme.select(level, flags);
    // The flags of the faces; none if all faces are chosen.
    { chosen_before.chosen() } -> std::convertible_to<std::span<const unsigned char>>;
};

/// Returns a flag for each face of a level: 1 if chosen(handle) holds, else 0. Cost: O(faces).
template <level Level, std::predicate<typename Level::face_handle> Chosen>
std::vector<unsigned char> flags_where(const Level& level, const Chosen& chosen)
{
    std::vector<unsigned char> result(level.face_count());
    for (std::size_t f = 0; f < result.size(); ++f)
        result[f] = chosen(level.face_at(f)) ? 1 : 0;
    return result;
}

} // namespace kith
