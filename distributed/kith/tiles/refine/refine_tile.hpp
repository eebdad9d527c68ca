// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "last_in_patches.hpp"
#include "refine_last.hpp"
#include "tile_job.hpp"
#include "tile_step.hpp"
#include "global_levels.hpp"

#include <kith/refine.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace kith {

/// Refines a tile of level `level` once with the unchanged scheme, over its ghosts, and cuts off ghosts beyond the
/// rings that later levels need. `scheme` is the scheme of this tile and becomes that of the next. There is no
/// communication. The result has the bits of the whole mesh's next level. Errors: as `refine`. Cost: that of the step.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
tile<Point, Index> refine_once(const tile<Point, Index>& coarse, Scheme& scheme, int level,
                               const global_levels_of<Scheme>& whole)
{
    Scheme next = scheme;
    auto step = detail::refined_tile(coarse, next, whole.numbering(level));
    auto result = step.trim(whole.rings(level + 1),
                            [&](const auto& part) { detail::restrict_state(scheme, next, part); });
    if constexpr (numbers_corners_at_vertices<Scheme>)
        whole.corners(level + 1).number(result);
    return result;
}

namespace detail {

/// Makes the remaining steps of a tile in patches of the next level, which is not trimmed. Returns nothing if the
/// numbering does not allow it or patches do not pay. Errors and cost: as last_in_patches.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
std::optional<tile<Point, Index>> last_in_patches_of_next(const tile<Point, Index>& coarse, Scheme scheme, int level,
                                                          const global_levels_of<Scheme>& whole)
{
    if constexpr (faces_descend_from_faces<Scheme, Index>)
        if (numbers_are_affine<Scheme>(false) and
            std::size_t(coarse.mesh.topology().degree) == numbering_of<Scheme, Index>::common_degree) {
            const auto next = refine_untrimmed(coarse, scheme, whole.counts(level).as_counts());
            return last_in_patches(next, scheme, level + 1, whole, costs_in_tiles(next, level + 1, whole));
        }
    return {};
}

} // namespace detail

/// Refines a tile of level 0, and its scheme, through all levels of `whole`. With `connect::faces` the last level has
/// neither edges nor ghosts. Its last steps may then be made at once, in patches, and the scheme stays that of the
/// level before them. `each(tile)` is called with every level that is made, but not with level 0.
template <tile_like Tile, reaching_scheme Scheme, class Each>
void refine(tile_job<Tile, Scheme>& job, const global_levels_of<Scheme>& whole, connect last, const Each& each)
{
    const auto& plain = plain_scheme(job.scheme);
    const int patches = last == connect::faces ? first_in_patches(job.part, plain, whole.levels()) : -1;
    for (int level = 0; level < whole.levels(); ++level) {
        std::optional<Tile> made;
        if (level == patches)
            made = last_in_patches(job.part, plain, level, whole, costs_in_tiles(job.part, level, whole));
        else if (level + 1 == patches and patches < whole.levels())
            made = detail::last_in_patches_of_next(job.part, plain, level, whole);
        if (made) {
            job.part = std::move(*made);
            each(std::as_const(job.part));
            return;
        }
        const bool is_last = level + 1 == whole.levels();
        job.part = is_last and last == connect::faces ? refine_last(job.part, job.scheme, level, whole)
                                                      : refine_once(job.part, job.scheme, level, whole);
        each(std::as_const(job.part));
    }
}
/// Refines tile `number` of level 0 through all levels, and hands over each level with its scheme, from level 0 to the
/// last: keep(kept_tile). All levels have their edges, and as many rings of ghosts as `whole` says. Two levels are in
/// memory, and the levels that `keep` stores.
template <tile_like Tile, reaching_scheme Scheme, std::invocable<kept_tile<Tile, Scheme>> Keep>
void refine_levels(std::uint64_t number, tile_job<Tile, Scheme> job, const global_levels_of<Scheme>& whole,
                   const Keep& keep)
{
    kept_tile<Tile, Scheme> here{number, 0, std::move(job.part), std::move(job.scheme)};
    for (int level = 0; level < whole.levels(); ++level) {
        Scheme scheme = here.scheme;
        Tile next = refine_once(here.part, scheme, level, whole);
        swap_states(here.scheme, scheme);
        here.level = level + 1;
        keep(kept_tile<Tile, Scheme>{number, level, std::exchange(here.part, std::move(next)), std::move(scheme)});
    }
    keep(std::move(here));
}
/// Returns the last level of a tile of level 0. `last` and `each` are those of `refine` for a tile_job.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme, class Each>
tile<Point, Index> refine(tile<Point, Index> part, Scheme scheme, const global_levels_of<Scheme>& whole, connect last,
                          const Each& each)
{
    tile_job<tile<Point, Index>, Scheme> job{std::move(part), std::move(scheme)};
    refine(job, whole, last, each);
    return std::move(job.part);
}
/// Returns the last level of a tile of level 0, without calls for the levels between.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
tile<Point, Index> refine(tile<Point, Index> part, Scheme scheme, const global_levels_of<Scheme>& whole,
                          connect last = connect::everything)
{
    return refine(std::move(part), std::move(scheme), whole, last, [](const auto&) {});
}

} // namespace kith
