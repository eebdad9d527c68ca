// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_of_patches.hpp"
#include "whole_levels.hpp"

#include <kith/neighbourhood/affine_columns.hpp>
#include <kith/patch/patched_level.hpp>
#include <kith/step/children.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace kith {

/// A scheme whose last steps on a tile may be made in patches: its new faces come from faces, and its numbers follow in
/// one way from the first level on.
template <class Scheme, class Point, class Index>
concept patchable_in_tiles = patchable_scheme<Scheme, Point, Index> and faces_descend_from_faces<Scheme, Index>;

namespace detail {

/// Returns the plan of patches for the mesh of a tile, with the numbers of a closed mesh: what lies beyond its rim has
/// numbers, too. Returns nothing where there are no patches. Cost: O(levels).
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
std::optional<patch_plan> plan_for_tile(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels)
{
    const auto& t = mesh.topology();
    return plan_patches({t.vertices, t.edges(), t.faces}, t.degree, scheme, levels, mesh.generation());
}

} // namespace detail

/// Returns the level from which the remaining steps of a tile of level 0 may be made in patches; `levels` if there is
/// none. Cost: O(levels).
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
int first_in_patches([[maybe_unused]] const tile<Point, Index>& control, [[maybe_unused]] const Scheme& scheme,
                     int levels)
{
    if constexpr (patchable_in_tiles<Scheme, Point, Index>) {
        const auto plan = detail::plan_for_tile(control.mesh, scheme, levels);
        if (plan and not are_patches_ruled_out())
            return plan->begin;
    }
    return levels;
}

/// Returns when patches are worth while for a tile of this level: other tiles of the surface use the same templates.
/// Cost: O(faces of the tile).
template <tile_like Tile, reaching_scheme Scheme>
strategy_costs costs_in_tiles(const Tile& coarse, int level, const whole_levels<Scheme>& whole)
{
    const auto owned = std::max<std::uint64_t>(owned_count(coarse.face_marks), 1);
    return usual_costs(strategy_costs().if_in_tiles(double(whole.counts(level).faces) / double(owned)));
}

/// Makes the remaining steps of a tile of level `level` at once, in patches: returns the faces of the last level that
/// the tile owns with their vertices, without edges and ghosts, as refine_once and refine_last make them, to the bit.
/// Returns nothing where patches are no gain at these costs. `scheme` is that of the tile.
/// Errors: as refine_once. Cost: about that of `refine` with connect::faces, and of copying the level once.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
std::optional<tile<Point, Index>> last_in_patches([[maybe_unused]] const tile<Point, Index>& coarse,
                                                  [[maybe_unused]] const Scheme& scheme, [[maybe_unused]] int level,
                                                  [[maybe_unused]] const whole_levels<Scheme>& whole,
                                                  [[maybe_unused]] const strategy_costs& costs)
{
#ifdef KITH_HAS_LANES
    if constexpr (patchable_in_tiles<Scheme, Point, Index>) {
        constexpr std::size_t degree = numbering_of<Scheme, Index>::common_degree;
        const auto& t = coarse.mesh.topology();
        const int generation = coarse.mesh.generation(), steps = whole.levels() - level;
        auto plan = detail::plan_for_tile(coarse.mesh, scheme, steps);
        if (not plan or std::size_t(t.degree) != degree or
            not numbers_are_affine<Scheme>(whole.counts(level).as_counts().boundary_edges == 0))
            return {};
        if (plan->begin != 0)
            plan->begin_at(0, scheme, generation);
        if (degree * plan->last().faces >= connectivity<Index>::none)
            return {};
        std::vector<column_bases> there;
        for (int step = 0; step < steps; ++step)
            there.push_back(bases_of_columns(scheme, whole.counts(level + step).as_counts(), generation + step));
        detail::tile_of_patches<Point, Index> made(
            coarse, plan->bases, there, plan->last(), whole.counts(whole.levels()).vertices, degree);
        face_classes<Index> classes(t, plan->rings, state_marks<Index>(t, scheme));
        classes.keep_marked(made.is_patched());
        const auto patches = make_patches(coarse.mesh, classes, scheme, *plan, costs);
        if (not patches)
            return {};
        patches->fill(coarse.mesh, made.make_room());
        return made.take(generation + steps);
    }
#endif
    return {};
}

} // namespace kith
