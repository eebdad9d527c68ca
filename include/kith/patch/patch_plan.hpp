// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_numbers.hpp"
#include "refine_part.hpp"

#include <kith/lane/lanes.hpp>
#include <kith/neighbourhood/face_classes.hpp>

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
    int first;                       ///< the first level whose faces all have the degree of refined ones
    int begin;                       ///< the level whose faces own patches of the last one
    int rings;                       ///< by which the class of a face says all of its patch
    std::vector<counts> levels;      ///< from the control mesh to the last one
    std::vector<column_bases> bases; ///< of the steps from `begin` on

    [[nodiscard]] const counts& of_begin() const { return levels[std::size_t(begin)]; }
    [[nodiscard]] const counts& last() const { return levels.back(); }
    [[nodiscard]] double faces_of_patch() const { return double(last().faces) / double(of_begin().faces); }

    /// Begins at a level. Precondition: it lies before the last one. Cost: O(levels).
    template <reaching_scheme Scheme>
    void begin_at(int level, const Scheme& scheme, int generation)
    {
        begin = level;
        bases.clear();
        for (std::size_t i = std::size_t(begin); i + 1 < levels.size(); ++i)
            bases.push_back(bases_of_columns(scheme, levels[i], generation + int(i)));
        rings = rings_before_steps(scheme, bases.size()).front();
    }
};

/// A patch has at most some hundred faces. Nothing for a mesh on which the numbers of the scheme do not follow in one way, whose
/// order it does not ignore even where its state says nothing, which is too large, or where there is no step to make. Precondition: the
/// levels can be counted. Cost: O(levels).
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
    if (plan.begin == levels or 2 * plan.of_begin().edges > face_classes<std::uint32_t>::most_corners)
        return {};
    plan.begin_at(plan.begin, scheme, generation);
    return plan;
}

} // namespace kith
