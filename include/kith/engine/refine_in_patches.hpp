// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/engine/patch/patched_level.hpp>
#include <kith/engine/strategy/strategy_choice.hpp>
#include <kith/numbering/step/surface_order.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <utility>

namespace kith {

#ifdef KITH_HAS_LANES

/// The last steps of a refinement, made face by face. Each face of the level before these steps owns a patch of the
/// last level. Faces with alike neighbourhoods share a template, which is replayed in SIMD lanes. The few other faces
/// are refined as meshes of their own. Numbers and bits are the same as level by level.
template <class Point, std::unsigned_integral Index, scheme Scheme>
    requires patchable_scheme<Scheme, Point, Index>
class patch_refinement {
public:
    /// Plans `levels` steps from a control mesh that has its edges. `last_level` is the connectivity that the last
    /// level gets. Cost: O(levels), and that of a look at some faces of the mesh.
    patch_refinement(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels, connect last_level,
                     const strategy_costs& costs = usual_costs())
        : patch_refinement(control.topology(), control.generation(), scheme, levels, last_level, costs)
    {
    }
    /// Plans the steps for points, or values at vertices, of a control mesh with this connectivity and generation.
    patch_refinement(const connectivity<Index>& control, int generation, const Scheme& scheme, int levels,
                     connect last_level, const strategy_costs& costs = usual_costs())
        : choice_(costs, last_level)
        , last_level_(last_level)
        , plan_(plan_patches(count(control), control.degree, scheme, levels, generation))
    {
        if (not plan_) {
            choice_.refuse(strategy_reason::no_patches);
            return;
        }
        choice_.hear_sizes(plan_->sizes());
        if (not choice_.is_open())
            return;
        kept_ = templates::of(without_state(scheme), generation + plan_->begin, plan_->rings, plan_->bases.size());
        choice_.hear_demand(plan_->sizes(), kept_->demand(plan_->last().faces, last_level_));
        if (not choice_.is_open())
            return;
        const std::size_t looks = std::clamp<std::size_t>(plan_->last().faces / 1024, 128, 1024);
        if (share_of_classes(control, 1, looks) > choice_.costs().share_if_alike) // one ring is enough
            begin_where_faces_are_alike(scheme, levels, generation);
    }

    /// Returns true if patches may be worth while. The last level must be large, or such levels must have been made
    /// again and again. After a look in vain patches are not worth while for some time.
    [[nodiscard]] bool is_worth_looking() const { return choice_.is_open(); }
    /// Returns the level whose faces own patches, counted from the control mesh. Precondition: is_worth_looking().
    [[nodiscard]] int begin() const { return plan_->begin; }
    /// Returns which steps are made in patches. Precondition: is_worth_looking().
    [[nodiscard]] const patch_plan& plan() const { return *plan_; }
    /// Returns the strategy as far as it is decided.
    [[nodiscard]] const strategy& so_far() const { return choice_.so_far(); }

    /// Calls f() if patches may be worth while. Keeps for later refinements whether patches were a gain.
    template <class F>
    void look(const F& f)
    {
        if (is_worth_looking())
            f();
        if (kept_)
            kept_->keep(plan_->last().faces, last_level_, choice_.next_demand());
    }
    /// Returns true if patches may be a gain. If the faces lie in no order, small patches are no gain, and false closes
    /// the choice.
    bool gains_if(bool lies_in_no_order)
    {
        const double least = choice_.least_if_scattered(plan_->sizes(), orderable_scheme<Scheme, Index>);
        if (not lies_in_no_order or plan_->faces_of_patch() >= least)
            return true;
        choice_.refuse(strategy_reason::scattered_faces, least);
        return false;
    }
    /// Makes the last level from the level begin(). If that level is in another order, `numbers` are the numbers of its
    /// elements. Returns false if patches are no gain. Precondition: called by look(). Cost: that of `refine`.
    template <class LastLevel>
    bool fill(const basic_mesh<Point, Index>& level, const Scheme& scheme, const element_numbers<Index>* numbers,
              LastLevel& last)
    {
        const auto made = patches_of(level, scheme, numbers != nullptr);
        if (made)
            last.fill(level, *made, *plan_, numbers);
        return made.has_value();
    }
    /// Makes the last level from the level begin() in its own order. Returns false if patches are no gain.
    template <class LastLevel>
    [[nodiscard]] bool refine_from(const basic_mesh<Point, Index>& level, const Scheme& scheme, LastLevel& last)
    {
        bool is_made = false;
        look([&] { is_made = gains_if(is_scattered(level.topology())) and fill(level, scheme, nullptr, last); });
        return is_made;
    }

private:
    using patches = patched_level<Point, Index>;
    using templates = kept_templates<scalar_of<Point>, Index>;

    /// Moves the beginning of patches to a level with few classes. In many files edges run and fans start in no order;
    /// then nearly every face of a control mesh is a class of its own. After as many steps as a patch has rings there
    /// are few classes.
    void begin_where_faces_are_alike(const Scheme& scheme, int levels, int generation)
    {
        bool is_late = false;
        if (plan_->begin < plan_->rings and plan_->rings < levels) {
            is_late = plan_->rings > 1;
            plan_->begin_at(plan_->rings, scheme, generation);
        }
        if (plan_->begin < plan_->rings or not plan_->has_room_for_classes())
            choice_.refuse(strategy_reason::unlike_faces);
        else
            choice_.hear_unlike_faces(plan_->sizes(), is_late);
    }
    /// Returns the patches of the level with which the plan begins, or nothing if they are no gain. `is_ordered` says
    /// that the level is in the order of the surface.
    [[nodiscard]] std::optional<patches> patches_of(const basic_mesh<Point, Index>& level, const Scheme& scheme,
                                                    bool is_ordered)
    {
        if (not plan_->has_counts_of(level.topology(), scheme, level.generation())) {
            choice_.refuse(strategy_reason::state);
            return {};
        }
        const face_classes<Index> classes(level.topology(), plan_->rings, state_marks<Index>(level.topology(), scheme));
        auto made = make_patches(level, classes, scheme, *plan_, choice_.costs(), last_level_ == connect::everything);
        choice_.hear_classes(classes.count(), made ? made->template_count() : 0, made.has_value());
        if (made)
            choice_.take_patches(plan_->begin, is_ordered);
        return made;
    }

    strategy_choice choice_;
    connect last_level_;
    std::optional<patch_plan> plan_;
    std::optional<templates> kept_; // set if there are enough faces
};

#endif

} // namespace kith
