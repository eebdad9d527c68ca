// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_numbers.hpp"
#include "refine_part.hpp"

#include <kith/lane/lanes.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// New faces come from faces and corners: then each face has its own descendants.
template <class... Columns>
constexpr bool faces_come_from_faces(const std::tuple<Columns...>*)
{
    return ((Columns::kind == tuple_kind::f or Columns::kind == tuple_kind::vf or Columns::kind == tuple_kind::ef or
             Columns::kind == tuple_kind::vfe) and
            ...);
}

template <scheme Scheme>
inline constexpr bool has_patches = faces_come_from_faces(
    static_cast<const decltype(columns_of(std::declval<const Scheme&>(), 0).faces.list)*>(nullptr));

} // namespace detail

/// A scheme whose last steps may be made patch by patch: its numbers follow from the tuples in one way everywhere, and its
/// reach is known.
template <class Scheme, class Point, class Index>
concept patchable_scheme = fits_lanes<Point> and reaching_scheme<Scheme> and orderable_scheme<Scheme, Index> and
                           detail::has_patches<Scheme>;

/// Which steps of a refinement are made patch by patch.
struct patch_plan {
    int first; ///< the first level whose faces all have the degree of refined ones
    int begin; ///< the level whose faces own patches of the last one
    int rings; ///< by which the class of a face says all of its patch, and of the classes of the next level
    std::vector<counts> levels;      ///< from the control mesh to the last one
    std::vector<column_bases> bases; ///< of the steps from `begin` on

    [[nodiscard]] const counts& of_begin() const { return levels[std::size_t(begin)]; }
    [[nodiscard]] const counts& last() const { return levels.back(); }
    /// The faces within the rings around one, where the mesh of faces of this degree is regular.
    [[nodiscard]] std::size_t faces_of_walk(std::size_t degree) const
    {
        const auto r = std::size_t(rings);
        return degree == 3 ? 1 + 6 * r * (r + 1) : (2 * r + 1) * (2 * r + 1);
    }
};

/// A patch has at most some hundred faces. Nothing for a mesh on which the numbers of the scheme do not follow in one way, whose
/// order it does not ignore even where its state says nothing, or where there is no step to make. Precondition: the levels can be counted.
/// Cost: O(levels).
template <reaching_scheme Scheme>
std::optional<patch_plan> plan_patches(const counts& control, bool has_degree, const Scheme& scheme, int levels,
                                       int generation)
{
    constexpr std::uint64_t most_faces_of_patch = 100;
    if (levels < 1 or not detail::is_free_of_order<Scheme>(control.boundary_edges == 0) or
        not ignores_numbers(without_state(scheme)))
        return {};
    patch_plan plan{has_degree ? 0 : 1, levels, 0, {control}, {}};
    for (int level = 0; level < levels; ++level)
        plan.levels.push_back(next_counts(scheme, plan.last(), generation + level));
    while (plan.begin > plan.first and
           plan.last().faces / plan.levels[std::size_t(plan.begin) - 1].faces <= most_faces_of_patch)
        --plan.begin;
    if (plan.begin == levels)
        return {};
    for (int level = plan.begin; level < levels; ++level)
        plan.bases.push_back(bases_of_columns(scheme, plan.levels[std::size_t(level)], generation + level));
    plan.rings = rings_before_steps(scheme, plan.bases.size()).front();
    while (reach_of(scheme, plan.rings) > plan.rings)
        plan.rings = reach_of(scheme, plan.rings);
    return plan;
}

} // namespace kith
