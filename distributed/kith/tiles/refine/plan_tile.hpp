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

namespace detail {

/// The share of each level that a tile keeps, which has `owned` of level 0 and ghosts for the last level.
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

/// Returns the bytes that are in use at most where the last steps of a tile are made in patches: the level where they
/// begin, points and faces of the last level with all ghosts of that one, their numbers, and what is kept.
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

/// The bytes that are in use at most while a tile is refined to the last of these levels, of which the owned faces are
/// kept: the tile before a step, what the step makes of it and of its ghosts, and what is kept of that; an eighth more
/// for memory that is kept to be used again, a third if there were tiles before, of other sizes. With `last_rings` the
/// last level has its edges and as many rings of ghosts, and its elements take `last_more` when it is done. `state` is
/// what the scheme keeps of each level, such as fields: it is there twice of the level before a step and of
/// the next, and then of the part of this that is kept.
/// `whole` is the plan of the whole mesh with the tile's type of index, although that index could not number it.
/// `owned` is the tile's share of the corners of level 0, `ghosts` are the faces around it as a share of all. Of
/// ghosts the rings stay and their faces get smaller, so that their share falls with every level.
/// Errors: as ring_schedule. Cost: O(levels).
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
inline double ghosts_around(double faces, int rings)
{
    return rings * (6 * std::sqrt(faces) + 6 * rings);
}

/// A tile of level 0, as its memory depends on it.
struct tile_size {
    double faces = 0, corners = 0; ///< that it owns
    double ghosts = 0;             ///< faces around them
};

/// What tiles of a refinement need, by the counts of its levels. State of the scheme is not counted, nor what a program
/// keeps beside the tiles.
template <reaching_scheme Scheme>
class tile_memory {
public:
    /// `last_rings` as for the refinement.
    tile_memory(const global_levels<Scheme>& whole, const Scheme& scheme, std::size_t point_bytes,
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

    /// A part of so many faces with that many corners, with as many ghosts as a compact part has.
    [[nodiscard]] tile_size size_of(double faces, double corners) const
    {
        const auto all = double(levels_[0].counts.faces);
        return {faces, corners, std::min(all - faces, ghosts_around(faces, rings_))};
    }
    /// The bytes that are in use at most while a tile is refined.
    [[nodiscard]] std::uint64_t refined(const tile_size& tile) const
    {
        return is_countable_ ? tile_bytes(levels_, scheme_, owned(tile), ghosts(tile), last_rings_)
                             : std::numeric_limits<std::uint64_t>::max();
    }
    /// The bytes of all levels of a tile.
    [[nodiscard]] std::uint64_t kept(const tile_size& tile) const
    {
        const auto share = detail::shares_of_tile(levels_, scheme_, owned(tile), ghosts(tile), last_rings_);
        double result = 0;
        for (std::size_t level = 0; level < levels_.size(); ++level)
            result += detail::bytes_of_tile(levels_[level], share[level]);
        return is_countable_ ? std::uint64_t(std::min(result, 1e19)) : std::numeric_limits<std::uint64_t>::max();
    }

    /// Errors: mesh_error unless `at_once` tiles of this size can be refined within so many bytes; the text says of how
    /// many tiles that is true.
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
    /// Errors: mesh_error unless a rank can keep all levels of so many tiles within so many bytes; the text says on how
    /// many ranks that is true.
    void require_levels(const tile_size& largest, std::uint64_t tiles, std::uint64_t ranks, std::uint64_t limit) const
    {
        const double each = double(kept(largest)), step = double(refined(largest));
        const std::uint64_t here = (tiles + ranks - 1) / ranks;
        if (each * double(here) + step <= double(limit))
            return;
        const auto most = std::uint64_t(std::max(0., (double(limit) - step) / each)); // tiles of a rank
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
    /// The fewest tiles, about, of which each fits; parts are not of one size. 0 if there are none.
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
