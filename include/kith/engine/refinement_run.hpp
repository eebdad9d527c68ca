// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "last_level.hpp"
#include "refine_in_patches.hpp"
#include "refine_in_surface_order.hpp"

#include <kith/engine/neighbourhood/scheme_forecast.hpp>
#include <kith/engine/neighbourhood/sparse_state.hpp>
#include <kith/numbering/step/step.hpp>

#include <concepts>
#include <optional>
#include <type_traits>
#include <utility>

namespace kith {

/// Values that are carried along with a refinement, such as fields. Beside `advance` (see nothing_carried) their class
/// has
///
///   bool needs_scheme() const;           // true if the scheme must become that of the last level
///   bool may_go_in_patches() const;      // true if the values may go through several steps at once
///   bool enter_patches(level, scheme, plan, connect);
///                                        // true if they can do so from this level on, which lives until
///   bool leave_patches();                // advances them to the last level; false stops the refinement
template <class T>
concept carried_in_patches = requires(T& carried) {
    { carried.needs_scheme() } -> std::convertible_to<bool>;
    { carried.may_go_in_patches() } -> std::convertible_to<bool>;
    { carried.leave_patches() } -> std::convertible_to<bool>;
};

/// The refinement of a native mesh: the loop behind `refine`, `refine_with_fields` and calls in place. It goes level by
/// level, in the order of the surface or in patches, always to the same bits. It chooses its strategy on the way.
template <class Point, std::unsigned_integral Index, scheme Scheme, class Carried = const nothing_carried>
    requires std::same_as<Carried, const nothing_carried> or carried_in_patches<Carried>
class refinement_run {
public:
    /// Takes a mesh that is to be refined `levels` times. The scheme and the carried values become those of the last
    /// level; if nothing is carried, the scheme may stay behind. Preconditions: the mesh has its edges, and the scheme
    /// takes it.
    refinement_run(basic_mesh<Point, Index> control, Scheme& scheme, int levels, Carried& carried,
                   const strategy_costs& costs = usual_costs())
        : mesh_(std::move(control))
        , scheme_(scheme)
        , last_generation_(mesh_.generation() + levels)
        , carried_(carried)
        , costs_(costs)
    {
    }
    refinement_run(basic_mesh<Point, Index> control, Scheme& scheme, int levels,
                   const strategy_costs& costs = usual_costs())
        requires std::same_as<Carried, const nothing_carried>
        : refinement_run(std::move(control), scheme, levels, nothing, costs)
    {
    }

    /// Makes the last level. Returns false if `carried` stops the refinement. Errors: as `refine`.
    template <class LastLevel>
    bool make(LastLevel& last)
    {
        if (levels() > 0)
            if (const auto goes_on = make_in_patches(last))
                return *goes_on;
        return make_by_levels(last);
    }
    /// Makes the last level in patches or, if these are no gain, in the order of the surface. Errors: as `refine`.
    /// Precondition: there is at least one level to make.
    template <class LastLevel>
        requires std::same_as<Carried, const nothing_carried> and orderable_scheme<Scheme, Index>
    void make_in_order(LastLevel& last)
    {
        if (make_in_patches(last))
            return;
        if (levels() <= 1) {
            make_by_levels(last);
            return;
        }
        auto ordered = in_surface_order(std::exchange(mesh_, {}));
        refine_ordered(ordered, scheme_, last_generation_ - ordered.mesh.generation() - 1);
        step_to_last(ordered, scheme_, last);
    }
    /// Makes the last level in patches. Returns false if the carried values stop the refinement. Returns nothing if
    /// patches are no gain: mesh(), the scheme and the carried values then belong to a level from which to go on.
    template <class LastLevel>
    std::optional<bool> make_in_patches([[maybe_unused]] LastLevel& last)
    {
        std::optional<bool> goes_on;
#ifdef KITH_HAS_LANES
        if constexpr (patchable_scheme<Scheme, Point, Index>)
            if (may_go_in_patches()) {
                patch_refinement<Point, Index, Scheme> patches(mesh_, scheme_, levels(), last.wanted(), costs_);
                patches.look([&] { goes_on = go_in_patches(patches, last); });
                how_ = patches.so_far();
            }
#endif
        return goes_on;
    }

    /// Returns the level that has been made so far.
    [[nodiscard]] const basic_mesh<Point, Index>& mesh() const { return mesh_; }
    /// Returns how the last level is made, as far as it is decided, and why.
    [[nodiscard]] const strategy& so_far() const { return how_; }

private:
    static constexpr bool carries_nothing = std::same_as<Carried, const nothing_carried>;
    static constexpr nothing_carried nothing{};

    [[nodiscard]] int levels() const { return last_generation_ - mesh_.generation(); }
    template <class LastLevel>
    bool make_by_levels(LastLevel& last)
    {
        if (levels() == 0) {
            last.keep(std::move(mesh_));
            return true;
        }
        if constexpr (carries_nothing) {
            make_levels(mesh_, scheme_, levels() - 1);
            last.step(std::as_const(mesh_), scheme_);
            return true;
        } else {
            return make_levels(mesh_, scheme_, levels() - 1, carried_) and
                   last.step(std::move(mesh_), scheme_, carried_);
        }
    }

#ifdef KITH_HAS_LANES
    [[nodiscard]] bool may_go_in_patches() const
    {
        if constexpr (carries_nothing)
            return true;
        else
            return carried_.may_go_in_patches();
    }
    template <class Patches, class LastLevel>
    std::optional<bool> go_in_patches(Patches& patches, LastLevel& last)
    {
        const bool lies_in_no_order = is_scattered(mesh_.topology());
        if (not patches.gains_if(lies_in_no_order))
            return {};
        if constexpr (carries_nothing and orderable_scheme<Scheme, Index>)
            if (lies_in_no_order and patches.plan().bases.size() > 1 and // else the numbers take unplanned memory
                can_be_ordered(mesh_.topology(), scheme_, levels())) {
                // In this order the elements around a face lie close together.
                auto ordered = in_surface_order(mesh_);
                Scheme of_level = scheme_;
                refine_ordered(ordered, of_level, patches.begin());
                const bool is_made = patches.fill(ordered.mesh, of_level, &ordered.numbers, last);
                return is_made ? std::optional(true) : std::nullopt;
            }
        if (not make_levels(mesh_, scheme_, patches.begin(), carried_))
            return false;
        if (can_enter(patches, last) and patches.fill(mesh_, scheme_, nullptr, last))
            return leave();
        return {};
    }
    /// Returns true if all carried values can go through the steps of the patches at once.
    template <class Patches, class LastLevel>
    bool can_enter(const Patches& patches, const LastLevel& last)
    {
        if constexpr (carries_nothing)
            return true;
        else
            return is_last_scheme_known() and carried_.enter_patches(mesh_, scheme_, patches.plan(), last.wanted());
    }
    /// Returns false if the scheme of the last level is needed and depends on the steps between.
    [[nodiscard]] bool is_last_scheme_known() const
    {
        if constexpr (scheme_of_places<Scheme>)
            return not carried_.needs_scheme() or state_marks<Index>(mesh_.topology(), scheme_).empty();
        else
            return not carried_.needs_scheme();
    }
    bool leave()
    {
        if constexpr (carries_nothing) {
            return true;
        } else {
            if (carried_.needs_scheme())
                for (int generation = mesh_.generation(); generation < last_generation_; ++generation)
                    detail::advance_without_elements<basic_mesh<Point, Index>>(scheme_, generation);
            return carried_.leave_patches();
        }
    }
#endif

    basic_mesh<Point, Index> mesh_;
    Scheme& scheme_;
    int last_generation_;
    Carried& carried_;
    strategy_costs costs_;
    strategy how_;
};

template <class Point, std::unsigned_integral Index, scheme Scheme>
refinement_run(basic_mesh<Point, Index>, Scheme&, int) -> refinement_run<Point, Index, Scheme>;
template <class Point, std::unsigned_integral Index, scheme Scheme>
refinement_run(basic_mesh<Point, Index>, Scheme&, int, const strategy_costs&) -> refinement_run<Point, Index, Scheme>;

} // namespace kith
