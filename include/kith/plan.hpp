// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>
#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/engine/neighbourhood/scheme_forecast.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith {

/// The counts of a level and the memory that it needs, before it is made.
struct planned_level {
    kith::counts counts;
    std::uint64_t bytes = 0;       ///< of the level itself with all its connectivity
    std::uint64_t least_bytes = 0; ///< of the level as the last one, with points and face-vertex lists only
};

/// Returns the counts and bytes of a native level; `degree` is the degree of all faces, or 0 if degrees differ.
inline planned_level plan_level(const counts& c, int degree, std::size_t point_bytes, std::size_t index_bytes)
{
    const std::uint64_t mixed = degree == 3 or degree == 4 ? 0 : (c.faces + 1 + c.corners()) * index_bytes;
    const std::uint64_t least = c.vertices * point_bytes + c.corners() * index_bytes + mixed;
    return {c, least + (c.corners() + 2 * c.edges + c.vertices) * index_bytes, least};
}

/// The levels of a plan that can be numbered. `problem` says what is wrong with the next one; it is empty if all are
/// there.
struct partial_plan {
    std::vector<planned_level> levels;
    std::string problem{}; ///< "level 14 has 1610612738 vertices ..., more than a 32-bit index can number"
};

namespace detail {

/// Throws mesh_error for a number of levels. This function and the next two need only the name of the scheme.
[[noreturn]] void refuse_levels(std::string_view scheme, int levels);
[[noreturn]] void refuse_boundary(std::string_view scheme, std::uint64_t boundary_edges);
[[noreturn]] void refuse_plan(std::string_view scheme, const partial_plan& plan, std::size_t index_bytes);
/// Returns true if the counts of the next level fit 64 bits; a step multiplies them by 16 at most. Else sets the
/// problem.
bool is_countable(partial_plan& plan);
/// Adds the next level to the plan. If the level cannot be numbered, sets the problem and returns false.
bool add_level(partial_plan& plan, const counts& next, int degree, std::size_t point_bytes, std::size_t index_bytes);

} // namespace detail

/// Returns levels 0 to n, or the levels before the first that has more elements than 64 bits count or `index_bytes`
/// number. Errors: mesh_error for negative n and for a boundary that the scheme refuses. Cost: O(n).
template <countable_scheme S>
partial_plan plan_what_fits(const counts& control, const S& scheme, int levels, int generation = 0,
                            std::size_t point_bytes = 3 * sizeof(double), std::size_t index_bytes = 4)
{
    constexpr auto degree = int(numbering<decltype(columns_of(scheme, 0)), std::uint64_t>::common_degree);
    if (levels < 0)
        detail::refuse_levels(scheme_name<S>(), levels);
    if constexpr (needs_closed<S>)
        if (control.boundary_edges != 0)
            detail::refuse_boundary(scheme_name<S>(), control.boundary_edges);
    partial_plan result{{plan_level(control, 0, point_bytes, index_bytes)}};
    scheme_forecast of_level(scheme, generation);
    for (int level = 1; level <= levels and detail::is_countable(result); ++level, ++of_level)
        if (not detail::add_level(
                result,
                next_counts(level == 1 ? scheme : *of_level, result.levels.back().counts, of_level.generation()),
                degree,
                point_bytes,
                index_bytes))
            break;
    return result;
}

/// Returns V, E, F and bytes of levels 0 to n before anything is allocated; thesis table 1.1.
/// Errors: mesh_error for negative n, for a boundary that the scheme refuses, and for a level with more elements than
/// 64 bits count or `index_bytes` number.
/// Cost: O(n).
template <countable_scheme S>
std::vector<planned_level> plan(const counts& control, const S& scheme, int levels, int generation = 0,
                                std::size_t point_bytes = 3 * sizeof(double), std::size_t index_bytes = 4)
{
    auto result = plan_what_fits(control, scheme, levels, generation, point_bytes, index_bytes);
    if (not result.problem.empty())
        detail::refuse_plan(scheme_name<S>(), result, index_bytes);
    return std::move(result.levels);
}

/// Returns the most memory that is in use at once while levels 0 to n are made: that of all levels if `keep_levels` is
/// true, else that of two consecutive levels. If `least_last` is true, the last level has face-vertex lists only.
inline std::uint64_t peak_bytes(const std::vector<planned_level>& plan, bool keep_levels, bool least_last = false)
{
    std::uint64_t peak = 0, kept = 0;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        const bool last = i + 1 == plan.size();
        const std::uint64_t here = last and least_last ? plan[i].least_bytes : plan[i].bytes;
        peak = std::max(peak, kept + here);
        kept = keep_levels ? kept + here : here;
    }
    return peak;
}

/// Returns the most memory that is in use at once if level 0 and the last `kept` levels are kept. An earlier level
/// stays until the next one is made. Levels up to `first` exist already; the last `kept` of these stay until all others
/// are made.
inline std::uint64_t peak_bytes_keeping_last(const std::vector<planned_level>& plan, int kept, int first = 0)
{
    std::uint64_t held = plan.front().bytes, peak = held;
    for (int level = 1; level < int(plan.size()); ++level) {
        held += plan[std::size_t(level)].bytes;
        peak = std::max(peak, held);
        if (level > kept and (level <= first or level - kept > first))
            held -= plan[std::size_t(level - kept)].bytes;
    }
    return peak;
}

/// Returns the share of the work that is done, 0 to 1, when level 0, 1, ... n has been made. Shares go by the faces of
/// the levels if these can be counted ahead, else they are equal. Errors: as `plan`. Cost: O(n).
template <scheme S>
std::vector<double> shares_of_work(const counts& control, const S& scheme, int levels, int generation = 0)
{
    std::vector<double> result{0};
    if constexpr (countable_scheme<S>) {
        // Only counts are asked for; they do not depend on the types of point and index.
        const auto planned = plan(control, scheme, levels, generation, sizeof(double), sizeof(std::uint64_t));
        for (int level = 1; level <= levels; ++level)
            result.push_back(result.back() + double(planned[std::size_t(level)].counts.faces));
    } else {
        for (int level = 1; level <= levels; ++level)
            result.push_back(level);
    }
    const double all = result.back();
    for (double& share : result)
        share = all == 0 ? 1 : share / all;
    return result;
}

#ifdef KITH_HAS_BODIES

namespace detail {

KITH_IN_LIBRARY void refuse_levels(std::string_view scheme, int levels)
{
    throw mesh_error(std::string(scheme) + ": " + std::to_string(levels) + " levels were asked for; ask for 0 or more");
}
KITH_IN_LIBRARY void refuse_boundary(std::string_view scheme, std::uint64_t boundary_edges)
{
    throw mesh_error(std::string(scheme) + ": the mesh has " + std::to_string(boundary_edges) +
                     " boundary edges; close it first, or take a scheme with a boundary rule");
}
KITH_IN_LIBRARY void refuse_plan(std::string_view scheme, const partial_plan& plan, std::size_t index_bytes)
{
    throw mesh_error(std::string(scheme) + ": " + plan.problem + "; refine at most " +
                     std::to_string(plan.levels.size() - 1) + " times" +
                     (index_bytes < 8 ? ", in tiles, or on a native mesh with a 64-bit index" : ""));
}
KITH_IN_LIBRARY bool is_countable(partial_plan& plan)
{
    const counts& last = plan.levels.back().counts; // twice the edges of the next level are counted, too
    if (std::max({last.vertices, last.edges, last.faces, last.boundary_corners}) > std::uint64_t(1) << 58)
        plan.problem = "level " + std::to_string(plan.levels.size()) + " has more elements than 64 bits can count";
    return plan.problem.empty();
}
KITH_IN_LIBRARY bool add_level(partial_plan& plan, const counts& next, int degree, std::size_t point_bytes,
                               std::size_t index_bytes)
{
    const std::string level = "level " + std::to_string(plan.levels.size()) + " has " + std::to_string(next.vertices) +
                              " vertices and " + std::to_string(next.edges) + " edges, ";
    const double indices = double(next.vertices) + 8 * double(next.edges) +
                           double(next.faces); // an upper bound; all levels together have at most twice as many
    if (index_bytes < 8 and std::max(next.vertices, 2 * next.edges) >= (std::uint64_t(1) << (8 * index_bytes)) - 1)
        plan.problem = level + "more than a " + std::to_string(8 * index_bytes) + "-bit index can number";
    else if (double(next.vertices) * double(point_bytes) + indices * double(index_bytes) >= 0x1p63)
        plan.problem = level + "whose size in bytes exceeds 64 bits";
    else
        plan.levels.push_back(plan_level(next, degree, point_bytes, index_bytes));
    return plan.problem.empty();
}

} // namespace detail

#endif

} // namespace kith
