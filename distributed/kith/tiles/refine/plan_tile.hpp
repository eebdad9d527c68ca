// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "last_in_patches.hpp"
#include "global_levels.hpp"

#include <kith/core/base/error.hpp>
#include <kith/plan.hpp>
#include <kith/tiles/part/reach.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// The bytes for each vertex, face and corner of a level.
struct element_bytes {
    double vertex = 0, face = 0, corner = 0;

    [[nodiscard]] double of(const counts& level, double share) const
    {
        return share *
               (vertex * double(level.vertices) + face * double(level.faces) + corner * double(level.corners()));
    }
};

namespace detail {

/// Returns the bytes of a tile that has a share of a level, with its global numbers.
inline double bytes_of_tile(const planned_level& whole, double share)
{
    const counts& c = whole.counts;
    constexpr double vertex = 8 + 1, edge = 8 + 1, face = 8 + 4 + 8 + 1;
    return share *
           (double(whole.bytes) + vertex * double(c.vertices) + edge * double(c.edges) + face * double(c.faces));
}

/// Returns the bytes of a tile of the last level: points, face lists, and numbers of vertices and faces.
inline double bytes_of_last_tile(const planned_level& whole, double share)
{
    const counts& c = whole.counts;
    constexpr double vertex = 8 + 1, face = 8 + 4 + 1;
    return share * (double(whole.least_bytes) + vertex * double(c.vertices) + face * double(c.faces));
}

} // namespace detail

namespace detail {

/// Returns the share of each level that a tile keeps. The tile owns the share `owned` of level 0; `ghosts` is the share
/// of its ghosts there.
template <reaching_scheme Scheme>
std::vector<double> shares_of_tile(const std::vector<planned_level>& whole, const Scheme& scheme, double owned,
                                   double ghosts, std::optional<int> last_rings)
{
    const auto rings = ring_schedule(scheme, int(whole.size()) - 1, last_rings.value_or(0));
    std::vector<double> result;
    for (std::size_t level = 0; level < whole.size(); ++level) {
        const double finer = double(whole[level].counts.faces) / double(whole[0].counts.faces);
        result.push_back(
            std::min(1., owned + ghosts * double(rings[level]) / std::max(1, rings[0]) / std::sqrt(finer)));
    }
    return result;
}

/// Returns the largest number of bytes in use when the last steps of a tile are made in patches. They consist of the
/// level where patches begin, with points and faces of the last level for all its faces and ghosts; their numbers; and
/// the part that is kept.
template <reaching_scheme Scheme>
double bytes_in_patches(const std::vector<planned_level>& whole, const Scheme& scheme,
                        const std::vector<double>& shares, double owned)
{
    if constexpr (patchable_in_tiles<Scheme, std::array<double, 3>, std::uint32_t>) {
        if (const auto plan = plan_patches(whole[0].counts, 0, scheme, int(whole.size()) - 1, 0)) {
            const planned_level &begin = whole[std::size_t(plan->begin)], &last = whole.back();
            const double share = shares[std::size_t(plan->begin)];
            return bytes_of_tile(begin, share) + share * (double(last.least_bytes) + 5 * double(last.counts.vertices)) +
                   bytes_of_last_tile(last, owned);
        }
    }
    return 0;
}

} // namespace detail

/// Returns the largest number of bytes in use while a tile is refined to the last of these levels. They consist of
/// three parts: the tile before a step; the result of the step for the tile and its ghosts; and the part of the result
/// that is kept. An eighth is added for memory that is kept for reuse, or a third if the tile is one of several of
/// different sizes.
/// `whole` is the plan of the whole mesh with the tile's type of index, even if that index could not number it. `owned`
/// is the tile's share of the corners of level 0. `ghosts` is the number of its ghosts as a share of all faces. The
/// rings of ghosts stay while their faces get smaller, so their share falls with every level. With `last_rings` the
/// last level has its edges and `last_rings` rings of ghosts, and its finished elements take `last_more`; otherwise
/// only owned faces are kept. `state` is the size of the scheme's state, such as fields. It counts twice for each of
/// the two levels of a step, and once for the kept part of the second. Errors: as ring_schedule. Cost: O(levels).
template <reaching_scheme Scheme>
std::uint64_t tile_bytes(const std::vector<planned_level>& whole, const Scheme& scheme, double owned, double ghosts,
                         std::optional<int> last_rings = std::nullopt, const element_bytes& last_more = {},
                         const element_bytes& state = {})
{
    const auto shares = detail::shares_of_tile(whole, scheme, owned, ghosts, last_rings);
    const auto share = [&](std::size_t level) { return shares[level]; };
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
            most = std::max(most, detail::bytes_in_patches(whole, scheme, shares, owned));
        } else {
            const counts& c = next.counts; // marks, and old and new places of all kept elements
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

/// Returns the approximate number of faces in `rings` rings around a compact part of `faces` faces.
inline double ghosts_around(double faces, int rings)
{
    return rings * (6 * std::sqrt(faces) + 6 * rings);
}

/// The size of a tile of level 0, from which its memory follows.
struct tile_size {
    double faces = 0, corners = 0; ///< owned by the tile
    double ghosts = 0;             ///< faces around them
};

/// The memory that tiles of a refinement need, computed from the counts of its levels. It contains neither the state of
/// the scheme nor other data of the program.
template <reaching_scheme Scheme>
class tile_memory {
public:
    /// Takes the levels of a refinement and its `last_rings`.
    tile_memory(const global_levels_of<Scheme>& whole, const Scheme& scheme, std::size_t point_bytes,
                std::size_t index_bytes, std::optional<int> last_rings)
        : scheme_(scheme), last_rings_(last_rings), rings_(whole.rings(0))
    {
        constexpr std::uint64_t countable = std::uint64_t(1) << 50; // there are more bytes than elements
        for (int level = 0; level <= whole.levels(); ++level) {
            const global_counts& c = whole.counts(level);
            is_countable_ = is_countable_ and c.corners <= countable;
            const int degree = c.corners == 3 * c.faces ? 3 : c.corners == 4 * c.faces ? 4 : 0;
            levels_.push_back(plan_level(
                {.vertices = c.vertices, .edges = c.edges, .faces = c.faces, .boundary_edges = 2 * c.edges - c.corners},
                degree,
                point_bytes,
                index_bytes));
        }
    }

    /// Returns the size of a part with these owned faces and corners, with as many ghosts as a compact part has.
    [[nodiscard]] tile_size size_of(double faces, double corners) const
    {
        const auto all = double(levels_[0].counts.faces);
        return {faces, corners, std::min(all - faces, ghosts_around(faces, rings_))};
    }
    /// Returns the largest number of bytes in use while a tile is refined.
    [[nodiscard]] std::uint64_t refined(const tile_size& tile) const
    {
        return is_countable_ ? tile_bytes(levels_, scheme_, owned(tile), ghosts(tile), last_rings_)
                             : std::numeric_limits<std::uint64_t>::max();
    }
    /// Returns the bytes of all levels of a tile.
    [[nodiscard]] std::uint64_t kept(const tile_size& tile) const
    {
        const auto share = detail::shares_of_tile(levels_, scheme_, owned(tile), ghosts(tile), last_rings_);
        double result = 0;
        for (std::size_t level = 0; level < levels_.size(); ++level)
            result += detail::bytes_of_tile(levels_[level], share[level]);
        return is_countable_ ? std::uint64_t(std::min(result, 1e19)) : std::numeric_limits<std::uint64_t>::max();
    }

    /// Throws mesh_error unless `at_once` tiles of this size can be refined within `limit` bytes. The message names the
    /// number of tiles for which this is possible.
    void require(const tile_size& largest, std::size_t at_once, std::uint64_t limit) const
    {
        const std::uint64_t one = refined(largest);
        if (one <= limit / at_once)
            return;
        const std::string what = at_once == 1 ? "the largest tile needs " + std::to_string(one)
                                              : std::to_string(at_once) + " tiles need " + bytes_text(one, at_once);
        std::string ways;
        if (at_once != 1 and one <= limit)
            ways = "refine " + std::to_string(limit / one) + " at once, ";
        const std::uint64_t tiles = tiles_that_fit(limit / at_once);
        ways += tiles == 0
                    ? "no number of tiles would fit, "
                    : "cut it into " + std::to_string(tiles) + " tiles or more (read_tiles makes one per rank), ";
        throw mesh_error(std::string(scheme_name<Scheme>()) + ": " + what + " bytes at once, the limit of a rank is " +
                         std::to_string(limit) + "; " + ways + "or refine fewer times");
    }
    /// Throws mesh_error unless a rank can keep all levels of its share of `tiles` tiles within `limit` bytes. The
    /// message names the number of ranks for which this is possible.
    void require_levels(const tile_size& largest, std::uint64_t tiles, std::uint64_t ranks, std::uint64_t limit) const
    {
        const double each = double(kept(largest)), step = double(refined(largest));
        const std::uint64_t here = (tiles + ranks - 1) / ranks;
        if (each * double(here) + step <= double(limit))
            return;
        const auto most = std::uint64_t(std::max(0., (double(limit) - step) / each)); // tiles that one rank can keep
        const std::string ways = most == 0 ? "cut it into more tiles"
                                           : "use " + std::to_string((tiles + most - 1) / most) + " ranks or more";
        throw mesh_error(std::string(scheme_name<Scheme>()) + ": all levels of " + std::to_string(here) +
                         (here == 1 ? " tile" : " tiles") + " need " +
                         std::to_string(std::uint64_t(std::min(each * double(here) + step, 1e19))) +
                         " bytes, the limit of a rank is " + std::to_string(limit) + "; " + ways +
                         ", keep fewer levels by refine_levels, or refine fewer times");
    }

private:
    [[nodiscard]] double owned(const tile_size& tile) const
    {
        return tile.corners / std::max(1., double(levels_[0].counts.corners()));
    }
    [[nodiscard]] double ghosts(const tile_size& tile) const
    {
        return tile.ghosts / std::max(1., double(levels_[0].counts.faces));
    }
    static std::string bytes_text(std::uint64_t one, std::uint64_t times)
    {
        return one > std::numeric_limits<std::uint64_t>::max() / times ? "more than 2^64" : std::to_string(one * times);
    }
    /// Returns about the smallest number of tiles such that each fits, or 0 if there is none. Parts differ in size, by
    /// a tenth here.
    [[nodiscard]] std::uint64_t tiles_that_fit(std::uint64_t limit) const
    {
        const counts& control = levels_[0].counts;
        for (std::uint64_t tiles = 1;; tiles += 1 + tiles / 8) {
            tiles = std::min(tiles, std::max<std::uint64_t>(control.faces, 1));
            const double share = std::min(1.,
                                          std::ceil(1.1 * double(control.faces) / double(tiles)) /
                                              double(std::max<std::uint64_t>(control.faces, 1)));
            if (refined(size_of(share * double(control.faces), share * double(control.corners()))) <= limit)
                return tiles;
            if (tiles >= control.faces)
                return 0;
        }
    }

    Scheme scheme_;
    std::optional<int> last_rings_;
    int rings_;
    bool is_countable_ = true;
    std::vector<planned_level> levels_;
};

} // namespace kith
