// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_numbers.hpp"

#include <kith/lane/lanes.hpp>
#include <kith/mesh/connectivity.hpp>
#include <kith/neighbourhood/coming_scheme.hpp>
#include <kith/neighbourhood/face_classes.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// A scheme whose last steps may be made patch by patch: its numbers follow from the tuples in one way everywhere, its
/// reach is known, and it takes parts of a mesh, which have a rim.
template <class Scheme, class Point, class Index>
concept patchable_scheme = fits_lanes<Point> and reaching_scheme<Scheme> and not needs_closed<Scheme> and
                           separable_scheme<Scheme, Index> and has_affine_numbers<Scheme>;

/// The rings around some faces that are enough on each level before a step, if there are to be `last` on the last
/// level. At least one, so that the fans of all their vertices are whole.
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

/// Which steps of a refinement are made patch by patch.
struct patch_plan {
    int first;                       ///< the first level that is like refined ones: in degrees, valences and marks
    int begin;                       ///< the level whose faces own patches of the last one
    int rings;                       ///< by which the class of a face says all of its patch
    int last_rings;                  ///< around a face of the last level that the values of its vertices follow from
    std::vector<counts> levels;      ///< from the control mesh to the last one
    std::vector<column_bases> bases; ///< of the steps from `begin` on

    [[nodiscard]] const counts& of_begin() const { return levels[std::size_t(begin)]; }
    [[nodiscard]] const counts& last() const { return levels.back(); }
    [[nodiscard]] double faces_of_patch() const { return double(last().faces) / double(of_begin().faces); }
    /// Returns true if the classes of the faces that own patches can be found.
    [[nodiscard]] bool has_room_for_classes() const
    {
        return 2 * of_begin().edges <= face_classes<std::uint32_t>::most_corners;
    }

    /// Returns true if these are the counts of a mesh where patches may begin, and of the next level. They are not if
    /// the state of the scheme says of which tuples elements are made, otherwise than it does of no elements at all.
    template <reaching_scheme Scheme, std::unsigned_integral Index>
    [[nodiscard]] bool has_counts_of(const connectivity<Index>& mesh, const Scheme& scheme, int generation) const
    {
        const counts& here = of_begin();
        return mesh.vertices == here.vertices and mesh.edges() == here.edges and mesh.faces == here.faces and
               next_counts(scheme, here, generation) == levels[std::size_t(begin) + 1] and
               bases_of_columns(scheme, here, generation) == bases.front();
    }

    /// Begins at a level. Precondition: it lies before the last one. Cost: O(levels).
    template <reaching_scheme Scheme>
    void begin_at(int level, const Scheme& scheme, int generation)
    {
        begin = level;
        bases.clear();
        coming_scheme of_level(scheme, generation);
        for (std::size_t i = 0; i + 1 < levels.size(); ++i, ++of_level)
            if (int(i) >= begin)
                bases.push_back(bases_of_columns(*of_level, levels[i], of_level.generation()));
        rings = rings_before_steps(scheme, bases.size(), last_rings).front();
    }
};

/// Returns which steps are made in patches of at most some hundred faces each. `degree` is that of all faces of the
/// control mesh, or 0 if they have several; `last_rings` is that of patch_plan. Returns nothing where there is no step
/// to make, and for a mesh that is empty or too large. Returns nothing either where the numbers of the scheme do not
/// follow in one way, or where it minds the order of elements without any state.
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
    coming_scheme of_level(scheme, generation);
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

/// When patches are worth while: what a final face costs in each of the ways to make it, level by level being 1.
/// Measured with the schemes of the library.
struct patch_costs {
    double in_patch = .45;           ///< .3 (Butterfly) to .6
    double in_patch_with_edges = .5; ///< with all connectivity: .5 (Butterfly) to .8 (Loop)
    double among_few = 6;            ///< of few faces with their rings, where making a template is not worth it
    double of_template = 600;        ///< of making one, in final faces: half of what it takes, since templates are kept
    double of_face_in_template = 20; ///< the same for each face of its patch: small ones, with fewer, gain more of them
    double of_look = 3;              ///< of finding the class of a face, per ring, in final faces
    double most_of_looks = .4;       ///< classes are not looked for where that costs more of the whole
    double share_if_alike = .3;      ///< so few classes has a sample of faces of a control mesh whose faces are alike
    double to_be_cheaper = .9;       ///< patches must come to less than so much
    double least_if_late = 12;    ///< smaller patches do not gain where they begin late since faces are unlike before
    double least_if_ordered = 32; ///< smaller patches do not gain on the order of the surface alone, faces only
    double least_if_ordered_with_edges = 16; ///< the same with all connectivity
    double least_faces = 12e6; ///< of the last level times those of a patch; fewer are not searched if one ring tells
    double least_faces_if_scattered = 40e6; ///< the same where they lie in no order and cannot be put into one
    double least_faces_again = .8e6; ///< the same where such levels have been made without templates again and again
    double of_class_again = 0;       ///< of finding the template of a class there
    double least_of_class = 1;       ///< filling fewer faces of a class takes as long as filling so many

    /// Returns the costs of who has no other way than patches: each class of some faces is worth a template.
    [[nodiscard]] static patch_costs without_choice()
    {
        patch_costs result;
        result.to_be_cheaper = std::numeric_limits<double>::infinity();
        return result;
    }
    /// Returns the faces of the last level below which classes are not sought. More rings tell more classes apart.
    [[nodiscard]] double least_to_look(const patch_plan& plan) const
    {
        return least_faces / plan.faces_of_patch() * (1 + plan.rings) / 2;
    }

    /// Returns the costs where the faces of the control mesh are unlike and lie in no order. Level by level takes two
    /// to three times as long there, making a template does not, and looking reads from all over the memory. Where
    /// patches begin late for that reason, there is much to look at, and there are many classes.
    [[nodiscard]] patch_costs if_unlike(bool is_late) const
    {
        patch_costs costs = *this;
        if (is_late)
            costs.least_faces *= 8;
        costs.of_template /= 2;
        costs.of_face_in_template /= 2;
        return costs;
    }
    /// Returns the costs of levels that are made so many times, and the templates once. Such levels have few faces, or
    /// templates were no gain for them before.
    [[nodiscard]] patch_costs if_again(double times) const
    {
        patch_costs costs = *this;
        costs.of_template /= times;
        costs.of_face_in_template /= times;
        costs.of_class_again = 250;
        return costs;
    }
    /// Returns the costs for one of so many tiles. Level by level a tile takes several times as long as a mesh: it
    /// refines faces of other tiles, too, and cuts them off after each step. What patches make is copied once.
    [[nodiscard]] patch_costs if_in_tiles(double tiles) const
    {
        constexpr double times_as_long = 6;
        patch_costs costs = if_again(tiles);
        for (double* cost :
             {&costs.in_patch, &costs.among_few, &costs.of_template, &costs.of_face_in_template, &costs.of_class_again})
            *cost /= times_as_long;
        costs.in_patch *= 2;
        costs.least_of_class = 8; // as many as most processors have lanes for
        return costs;
    }
};

/// The origin of the template of a class of faces.
enum class template_choice : unsigned char { none, made, kept };

/// The cost of a level patch by patch, in final faces level by level.
class patch_estimate {
public:
    /// Estimates it for classes of these sizes, which own patches with faces only or with all connectivity.
    patch_estimate(const patch_costs& costs, const patch_plan& plan, std::vector<std::size_t> sizes, bool with_edges)
        : costs_(costs)
        , sizes_(std::move(sizes))
        , of_patch_(plan.faces_of_patch())
        , in_patch_(with_edges ? costs.in_patch_with_edges : costs.in_patch)
        , of_template_(costs.of_template + costs.of_face_in_template * of_patch_)
    {
    }

    /// Returns true if making a template costs less than its class does without.
    [[nodiscard]] bool gains(std::size_t of_class) const
    {
        return alone(of_class) > filled(of_class) + of_template_ + costs_.of_class_again;
    }
    /// Returns true if patches are cheaper than going level by level, if each class does what is best.
    [[nodiscard]] bool is_gain_without_kept() const
    {
        std::vector<template_choice> choices(sizes_.size(), template_choice::none);
        for (std::size_t c = 0; c < sizes_.size(); ++c)
            if (gains(c))
                choices[c] = template_choice::made;
        return is_gain(choices);
    }
    /// Returns the same with these choices.
    [[nodiscard]] bool is_gain(std::span<const template_choice> choices) const
    {
        double cost = 0, faces = 0;
        for (std::size_t c = 0; c < sizes_.size(); ++c) {
            if (sizes_[c] == 0)
                continue;
            cost += choices[c] == template_choice::none ? alone(c) : filled(c) + costs_.of_class_again;
            cost += choices[c] == template_choice::made ? of_template_ : 0;
            faces += double(sizes_[c]) * of_patch_;
        }
        return cost <= costs_.to_be_cheaper * faces;
    }

private:
    /// Returns the cost of the patches of a class without a template.
    [[nodiscard]] double alone(std::size_t of_class) const
    {
        return double(sizes_[of_class]) * of_patch_ * costs_.among_few;
    }
    /// Returns the cost of filling the patches of a class from its template.
    [[nodiscard]] double filled(std::size_t of_class) const
    {
        return std::max(double(sizes_[of_class]), costs_.least_of_class) * of_patch_ * in_patch_;
    }

    patch_costs costs_;
    std::vector<std::size_t> sizes_;
    double of_patch_, in_patch_, of_template_;
};

} // namespace kith
