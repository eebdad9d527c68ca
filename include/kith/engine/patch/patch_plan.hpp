// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_numbers.hpp"

#include <kith/core/mesh/connectivity.hpp>
#include <kith/engine/lane/lanes.hpp>
#include <kith/engine/neighbourhood/scheme_forecast.hpp>
#include <kith/engine/neighbourhood/face_classes.hpp>
#include <kith/engine/strategy/strategy_costs.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace kith {

/// A scheme whose last steps may be made patch by patch. Its numbers follow from the tuples in one way everywhere, and
/// its reach is known. It can refine parts of a mesh, which have a cut boundary.
template <class Scheme, class Point, class Index>
concept patchable_scheme = fits_lanes<Point> and reaching_scheme<Scheme> and not needs_closed<Scheme> and
                           separable_scheme<Scheme, Index> and has_affine_numbers<Scheme>;

/// Returns the rings around some faces that each step needs on the level before it, if the last level is to have `last`
/// rings. There is at least one ring, so that the fans of all vertices of the faces are complete.
template <reaching_scheme Scheme>
std::vector<int> rings_before_steps(const Scheme& scheme, std::size_t steps, int last)
{
    std::vector<int> rings(steps + 1, last);
    for (std::size_t step = steps; step > 0; --step)
        rings[step - 1] = std::max(1,
                                   detail::says_reach_of_steps<Scheme, traits_type<Scheme>>
                                       ? reach_of(scheme, last, int(steps - step + 1))
                                       : reach_of(scheme, rings[step]));
    rings.pop_back();
    return rings;
}

/// The steps of a refinement that are made patch by patch.
struct patch_plan {
    int first;                       ///< the first level that is like refined ones: in degrees, valences and marks
    int begin;                       ///< the level whose faces own patches of the last one
    int rings;                       ///< around a face, by which its class determines its patch
    int last_rings;                  ///< around a face of the last level, on which values at its vertices depend
    std::vector<counts> levels;      ///< from the control mesh to the last one
    std::vector<column_bases> bases; ///< of the steps from `begin` on

    [[nodiscard]] const counts& of_begin() const { return levels[std::size_t(begin)]; }
    [[nodiscard]] const counts& last() const { return levels.back(); }
    [[nodiscard]] double faces_of_patch() const { return double(last().faces) / double(of_begin().faces); }
    /// Returns the sizes from which a strategy follows.
    [[nodiscard]] patch_sizes sizes() const { return {double(last().faces), faces_of_patch(), rings}; }
    /// Returns true if the classes of the faces that own patches can be found.
    [[nodiscard]] bool has_room_for_classes() const
    {
        return 2 * of_begin().edges <= face_classes<std::uint32_t>::most_corners;
    }

    /// Returns true if a mesh where patches may begin, and its next level, have the counts of the plan. They do not if
    /// the state of the scheme changes which tuples make elements, compared with the state of no elements at all.
    template <reaching_scheme Scheme, std::unsigned_integral Index>
    [[nodiscard]] bool has_counts_of(const connectivity<Index>& mesh, const Scheme& scheme, int generation) const
    {
        const counts& here = of_begin();
        return mesh.vertices == here.vertices and mesh.edges() == here.edges and mesh.faces == here.faces and
               next_counts(scheme, here, generation) == levels[std::size_t(begin) + 1] and
               bases_of_columns(scheme, here, generation) == bases.front();
    }

    /// Makes patches begin at this level. Precondition: it lies before the last one. Cost: O(levels).
    template <reaching_scheme Scheme>
    void begin_at(int level, const Scheme& scheme, int generation)
    {
        begin = level;
        bases.clear();
        scheme_forecast of_level(scheme, generation);
        for (std::size_t i = 0; i + 1 < levels.size(); ++i, ++of_level)
            if (int(i) >= begin)
                bases.push_back(bases_of_columns(*of_level, levels[i], of_level.generation()));
        rings = rings_before_steps(scheme, bases.size(), last_rings).front();
    }
};

/// Returns the steps that are made in patches of at most some hundred faces each. `degree` is that of all faces of the
/// control mesh, or 0 if they have several; `last_rings` is that of patch_plan. Returns nothing if there is no step to
/// make, or if the mesh is empty or too large. Returns nothing either if the numbers of the scheme do not follow in one
/// way. The scheme must also ignore the order of elements when it has no state, else nothing is returned.
/// Precondition: the levels can be counted. Cost: O(levels).
template <reaching_scheme Scheme>
std::optional<patch_plan> plan_patches(const counts& control, int degree, const Scheme& scheme, int levels,
                                       int generation, int last_rings = 0)
{
    constexpr std::uint64_t most_faces_of_patch = 100;
    if (levels < 1 or control.faces == 0 or not ignores_numbers(without_state(scheme)))
        return {};
    constexpr std::size_t degree_of_refined = numbering_of<Scheme, std::uint32_t>::common_degree;
    const bool is_like_refined = not has_faces_by_valence<Scheme> and not has_numbers_by_marks<Scheme> and
                                 (degree_of_refined == 0 or degree_of_refined == std::size_t(degree));
    patch_plan plan{is_like_refined ? 0 : 1, levels, 0, last_rings, {control}, {}};
    scheme_forecast of_level(scheme, generation);
    for (int level = 0; level < levels; ++level, ++of_level) {
        plan.levels.push_back(next_counts(*of_level, plan.last(), of_level.generation()));
        if (level >= plan.first and
            not agree_on_corners(*of_level, plan.levels[std::size_t(level)], plan.last(), of_level.generation()))
            return {};
    }
    const bool are_closed = std::ranges::all_of(plan.levels, [](const counts& c) { return c.boundary_edges == 0; });
    if (not numbers_are_affine<Scheme>(are_closed))
        return {};
    while (plan.begin > plan.first and levels - plan.begin < column_path::most_columns and
           plan.last().faces / plan.levels[std::size_t(plan.begin) - 1].faces <= most_faces_of_patch)
        --plan.begin;
    if (plan.begin == levels or not plan.has_room_for_classes())
        return {};
    plan.begin_at(plan.begin, scheme, generation);
    return plan;
}

} // namespace kith
