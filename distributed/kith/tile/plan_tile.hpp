// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/part/reach.hpp>
#include <kith/plan.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace kith {

/// Bytes for each vertex, face and corner of a level.
struct element_bytes {
    double vertex = 0, face = 0, corner = 0;

    [[nodiscard]] double of(const counts& level, double share) const
    {
        return share *
               (vertex * double(level.vertices) + face * double(level.faces) + corner * double(level.corners()));
    }
};

namespace detail {

/// A tile with its numbers in the whole mesh, of a share of a level.
inline double bytes_of_tile(const planned_level& whole, double share)
{
    const counts& c = whole.counts;
    constexpr double vertex = 8 + 1, edge = 8 + 1, face = 8 + 4 + 8 + 1;
    return share *
           (double(whole.bytes) + vertex * double(c.vertices) + edge * double(c.edges) + face * double(c.faces));
}

/// The same of the last level: points, face lists, and numbers of vertices and faces.
inline double bytes_of_last_tile(const planned_level& whole, double share)
{
    const counts& c = whole.counts;
    constexpr double vertex = 8 + 1, face = 8 + 4 + 1;
    return share * (double(whole.least_bytes) + vertex * double(c.vertices) + face * double(c.faces));
}

} // namespace detail

/// The bytes that are in use at most while a tile is refined to the last of these levels, of which the owned faces are
/// kept: the tile before a step, what the step makes of it and of its shadows, and what is kept of that; an eighth more
/// for memory that is kept to be used again, a third if there were tiles before, of other sizes. With `last_rings` the
/// last level has its edges and as many rings of shadows, and its elements take `last_more` when it is done. `state` is
/// what the scheme keeps of each level, such as fields: it is there twice of the level before a step and of
/// the next, and then of the part of this that is kept.
/// `whole` is the plan of the whole mesh with the tile's type of index, although that index could not number it.
/// `owned` is the tile's share of the corners of level 0, `shadows` are the faces around it as a share of all. Of
/// shadows the rings stay and their faces get smaller, so that their share falls with every level.
/// Errors: as ring_schedule. Cost: O(levels).
template <reaching_scheme Scheme>
std::uint64_t tile_bytes(const std::vector<planned_level>& whole, const Scheme& scheme, double owned, double shadows,
                         std::optional<int> last_rings = std::nullopt, const element_bytes& last_more = {},
                         const element_bytes& state = {})
{
    const auto rings = ring_schedule(scheme, int(whole.size()) - 1, last_rings.value_or(0));
    const auto share = [&](std::size_t level) {
        const double finer = double(whole[level].counts.faces) / double(whole[0].counts.faces);
        return std::min(1., owned + shadows * double(rings[level]) / std::max(1, rings[0]) / std::sqrt(finer));
    };
    double most = detail::bytes_of_tile(whole[0], share(0));
    for (std::size_t level = 0; level + 1 < whole.size(); ++level) {
        const planned_level& next = whole[level + 1];
        const double before = detail::bytes_of_tile(whole[level], share(level)) +
                              2 * state.of(whole[level].counts, share(level)) +
                              2 * state.of(next.counts, share(level)) + state.of(next.counts, share(level + 1));
        if (level + 2 == whole.size() and not last_rings) {
            const double marks = 5 * double(next.counts.faces) + 9 * double(next.counts.vertices);
            most = std::max(most,
                            before + share(level) * (double(next.least_bytes) + marks) +
                                detail::bytes_of_last_tile(next, owned));
        } else {
            const counts& c = next.counts; // marks, and for all that is kept where it was and where it is
            const double marks = 9 * double(c.vertices) + 11 * double(c.edges) + 9 * double(c.faces);
            most = std::max(most,
                            before + share(level) * (double(next.bytes) + marks) +
                                detail::bytes_of_tile(next, share(level + 1)));
        }
    }
    if (last_rings)
        most = std::max(most,
                        detail::bytes_of_tile(whole.back(), share(whole.size() - 1)) +
                            state.of(whole.back().counts, share(whole.size() - 1)) +
                            last_more.of(whole.back().counts, share(whole.size() - 1)));
    return std::uint64_t(std::min(owned < 1 ? most * 4 / 3 : most * 9 / 8, 1e19));
}

/// About so many faces lie in the rings around that many faces of a surface.
inline double shadows_around(double faces, int rings)
{
    return rings * (6 * std::sqrt(faces) + 6 * rings);
}

} // namespace kith
