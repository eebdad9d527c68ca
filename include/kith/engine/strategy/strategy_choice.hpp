// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "strategy_costs.hpp"

#include <algorithm>
#include <cstddef>

namespace kith {

/// The number of faces that some steps have made without templates, for levels of one size. A caller that refines a
/// small level once would spend more on templates than they save. A caller that does it again and again gets templates
/// after having spent about as much without them as they cost. This is never more than twice the best possible cost
/// (the ski rental problem: Karlin, Manasse, Rudolph & Sleator 1988).
struct template_demand {
    double made = 0;      ///< final faces
    double next_look = 0; ///< after how many faces in all; twice as many as at a last look in vain
};

/// A choice whether the last steps of a refinement are made in patches. It hears facts, the cheapest first. It is open
/// until a fact speaks against patches; later facts do not count.
class strategy_choice {
public:
    /// Begins open, or closed if another way is forced.
    strategy_choice(const strategy_costs& costs, connect last_level)
        : usual_(costs), costs_(costs), last_level_(last_level)
    {
        if (are_patches_ruled_out())
            refuse(strategy_reason::forced);
    }

    [[nodiscard]] bool is_open() const { return is_open_; }
    /// Returns the costs at which classes of faces are looked at.
    [[nodiscard]] const strategy_costs& costs() const { return costs_; }
    /// Returns the strategy as far as it is known: level by level, for the first reason that was heard, until patches
    /// are chosen.
    [[nodiscard]] const strategy& so_far() const { return how_; }

    /// Hears a reason against patches. `needed` faces would have been enough for them.
    void refuse(strategy_reason reason, double needed = 0)
    {
        if (not is_open_)
            return;
        is_open_ = false;
        how_.reason = reason;
        how_.needed = needed;
    }
    /// Hears the sizes of the patches that would be made.
    void hear_sizes(const patch_sizes& sizes)
    {
        how_.faces = sizes.faces;
        const double least = std::min(usual_.least_faces, usual_.least_faces_again) / sizes.faces_of_patch;
        if (sizes.faces < least)
            refuse(strategy_reason::few_faces, least);
    }
    /// Hears how many faces were made without templates. Precondition: it is open.
    void hear_demand(const patch_sizes& sizes, const template_demand& demand)
    {
        demand_ = demand;
        weigh(sizes, usual_);
    }
    /// Hears that the faces of the control mesh are unlike, and whether patches begin late for that reason.
    /// Precondition: it is open.
    void hear_unlike_faces(const patch_sizes& sizes, bool begins_late)
    {
        begins_late_ = begins_late;
        if (begins_late and sizes.faces_of_patch < usual_.least_if_late)
            refuse(strategy_reason::unlike_faces);
        else
            weigh(sizes, usual_.if_unlike(begins_late));
    }
    /// Returns the faces of a patch below which patches gain nothing if faces lie in no order. Smaller patches gain
    /// less than the order of the surface alone. If that order cannot be had, they gain less than looking at a large
    /// level costs there.
    [[nodiscard]] double least_if_scattered(const patch_sizes& sizes, bool can_be_ordered) const
    {
        if (can_be_ordered)
            return last_level_ == connect::faces ? costs_.least_if_ordered : costs_.least_if_ordered_with_edges;
        return begins_late_ ? costs_.least_faces_if_scattered / sizes.faces : 0;
    }
    /// Hears the number of classes and templates, and whether these are a gain. This is the last fact. Precondition: it
    /// is open.
    void hear_classes(std::size_t classes, std::size_t templates, bool are_gain)
    {
        how_.classes = classes;
        how_.templates = templates;
        if (not are_gain)
            refuse(strategy_reason::many_classes);
    }
    /// Chooses patches that begin at this level, which may be in the order of the surface.
    void take_patches(int begin, bool is_ordered)
    {
        how_.way = refinement_way::in_patches;
        how_.reason = strategy_reason::gain;
        how_.begin = begin;
        how_.is_ordered = is_ordered;
    }

    /// Returns the demand to be kept for the next refinement.
    [[nodiscard]] template_demand next_demand() const
    {
        if (how_.way == refinement_way::in_patches)
            return {.made = least_to_look_};
        const double made = demand_.made + how_.faces;
        return {made, was_worth_looking_ ? 2 * made : std::max(demand_.next_look, least_to_look_)};
    }

private:
    /// Compares what looking for classes costs with what it may save.
    void weigh(const patch_sizes& sizes, const strategy_costs& costs)
    {
        least_to_look_ = costs.least_to_look(sizes);
        const bool is_enough = sizes.faces >= least_to_look_;
        costs_ = is_enough and demand_.next_look <= 0 ? costs : costs.if_again(1 + demand_.made / sizes.faces);
        was_worth_looking_ = false;
        if (costs.of_look * sizes.rings > costs.most_of_looks * sizes.faces_of_patch)
            refuse(strategy_reason::small_patches);
        else if (demand_.made + sizes.faces < demand_.next_look)
            refuse(strategy_reason::looked_in_vain, demand_.next_look - demand_.made);
        else if (not is_enough and demand_.made + sizes.faces < least_to_look_)
            refuse(strategy_reason::few_faces, least_to_look_);
        else
            was_worth_looking_ = true;
    }

    strategy_costs usual_, costs_;
    connect last_level_;
    template_demand demand_;
    double least_to_look_ = 0; // of the last level; with fewer faces only kept templates are a gain
    bool is_open_ = true, was_worth_looking_ = false;
    bool begins_late_ = false; // several steps late, where faces are alike: at a large level
    strategy how_;
};

} // namespace kith
