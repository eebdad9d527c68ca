// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine_in_surface_order.hpp"

#include <kith/patch/patched_level.hpp>
#include <kith/step/step.hpp>
#include <kith/strategy/strategy_choice.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <utility>

namespace kith {

#ifdef KITH_HAS_LANES

/// The last steps of a refinement, face by face: a face of the level before them owns a patch of the last
/// level. Faces with alike neighbourhoods share a template, which is replayed in SIMD lanes; the few others are refined
/// as meshes of their own. The numbers and the bits are those of refining level by level.
template <class Point, std::unsigned_integral Index, scheme Scheme>
    requires patchable_scheme<Scheme, Point, Index>
class patch_refinement {
public:
    /// Plans `levels` steps from a control mesh that has its edges; of the last level what is asked for. Cost:
    /// O(levels), and that of a look at some of its faces.
    patch_refinement(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels, connect last_level,
                     const strategy_costs& costs = usual_costs())
        : patch_refinement(control.topology(), control.generation(), scheme, levels, last_level, costs)
    {
    }
    /// Plans the same for points or values at the vertices of a control mesh of this connectivity and generation.
    patch_refinement(const connectivity<Index>& control, int generation, const Scheme& scheme, int levels,
                     connect last_level, const strategy_costs& costs = usual_costs())
        : choice_(costs, last_level)
        , last_level_(last_level)
        , last_generation_(generation + levels)
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
        if (share_of_classes(control, 1, looks) > choice_.costs().share_if_alike) // one ring tells
            begin_where_faces_are_alike(scheme, levels);
    }

    /// Returns true if patches may be worth while: there are so many faces, or there have been again and again. They
    /// must not just have been looked at in vain.
    [[nodiscard]] bool is_worth_looking() const { return choice_.is_open(); }
    /// The level whose faces own patches, counted from the control mesh. Precondition: is_worth_looking().
    [[nodiscard]] int begin() const { return plan_->begin; }
    /// Returns which steps are made in patches. Precondition: is_worth_looking().
    [[nodiscard]] const patch_plan& plan() const { return *plan_; }

    /// Returns the last level, with the bits of refining level by level, or nothing if patches are no gain. Then
    /// `mesh`, which is the control mesh before the call, and its scheme are a level to go on from.
    [[nodiscard]] std::optional<basic_mesh<Point, Index>> refine(basic_mesh<Point, Index>& mesh, Scheme& scheme)
    {
        std::optional<basic_mesh<Point, Index>> fine;
        look([&] {
            with_patches(mesh, scheme, [&](const auto& level, const patches& made, const numbers* given) {
                fine = filled(level, made, given);
            });
        });
        return fine;
    }
    /// Returns the same from the level begin(), which stays as it is. Precondition: is_worth_looking().
    [[nodiscard]] std::optional<basic_mesh<Point, Index>> refine_from(const basic_mesh<Point, Index>& level,
                                                                      const Scheme& scheme)
    {
        std::optional<basic_mesh<Point, Index>> fine;
        look([&] {
            if (const auto made = patches_if_gain(level, scheme))
                fine = filled(level, *made, nullptr);
        });
        return fine;
    }
    /// Returns the values at the vertices of the last level, of which the points of `level` are those there. Returns
    /// nothing if that is no gain. Preconditions: is_worth_looking(), and connect::nothing was asked for.
    [[nodiscard]] std::optional<storage<Point>> values_from(const basic_mesh<Point, Index>& level, const Scheme& scheme)
    {
        std::optional<storage<Point>> values;
        look([&] {
            if (const auto made = patches_if_gain(level, scheme))
                made->fill(level, {values.emplace(plan_->last().vertices).data()});
        });
        return values;
    }
    /// Writes it into a mesh of another library; false where it is no gain. Precondition: all connectivity is wanted.
    /// Errors: those of `make_room`.
    [[nodiscard]] bool refine_into(level_writer<Point, Index>& fine, basic_mesh<Point, Index>& mesh, Scheme& scheme)
    {
        KITH_ASSERT(last_level_ == connect::everything);
        bool is_made = false;
        look([&] {
            with_patches(mesh, scheme, [&](const auto& level, const patches& made, const numbers* given) {
                const counts& last = plan_->last();
                fine.make_room(last.vertices, last.edges, last.faces, last.boundary_edges == 0);
                made.fill(level, {.points = fine.points(), .writer = &fine, .coarse_numbers = given});
                fine.finish(last_generation_);
                is_made = true;
            });
        });
        return is_made;
    }
    /// Returns how refine() would make the last level. Makes templates and the level begin(), which `mesh` may become.
    [[nodiscard]] strategy decide(basic_mesh<Point, Index>& mesh, Scheme& scheme)
    {
        if (choice_.is_open())
            with_patches(mesh, scheme, [](const auto&...) {});
        return choice_.so_far();
    }

private:
    using patches = patched_level<Point, Index>;
    using numbers = element_numbers<Index>;
    using templates = kept_templates<scalar_of<Point>, Index>;

    /// Calls fill() if patches are worth looking for, and keeps for the next time whether they were a gain.
    template <class Fill>
    void look(const Fill& fill)
    {
        if (choice_.is_open())
            fill();
        if (kept_)
            kept_->keep(plan_->last().faces, last_level_, choice_.next_demand());
    }

    /// Begins where few classes are left. If edges run and fans start in no order, as in many files, nearly each face
    /// of a control mesh is of its own class. After as many steps as a patch has rings there are few classes.
    void begin_where_faces_are_alike(const Scheme& scheme, int levels)
    {
        bool is_late = false;
        if (plan_->begin < plan_->rings and plan_->rings < levels) {
            is_late = plan_->rings > 1;
            plan_->begin_at(plan_->rings, scheme, last_generation_ - levels);
        }
        if (plan_->begin < plan_->rings or not plan_->has_room_for_classes())
            choice_.refuse(strategy_reason::unlike_faces);
        else
            choice_.hear_unlike_faces(plan_->sizes(), is_late);
    }
    /// Calls f(level, patches, numbers): the level whose faces own patches, and the numbers that its elements have
    /// where the control mesh is refined as it is, if that has been put into the order of its surface: then what is
    /// read around a face lies close together. If patches are no gain, the mesh is this level or the control mesh as it
    /// was, and the scheme that of it.
    template <class F>
    void with_patches(basic_mesh<Point, Index>& mesh, Scheme& scheme, const F& f)
    {
        const bool lies_in_no_order = is_scattered(mesh.topology());
        if (not gains_if(lies_in_no_order))
            return;
        if constexpr (orderable_scheme<Scheme, Index>)
            if (lies_in_no_order and plan_->bases.size() > 1 and // else the numbers take memory that no plan counts
                can_be_ordered(mesh.topology(), scheme, plan_->begin + int(plan_->bases.size()))) {
                auto ordered = in_surface_order(mesh);
                Scheme of_level = scheme;
                refine_ordered(ordered, of_level, plan_->begin);
                if (const auto made = patches_of(ordered.mesh, of_level, true))
                    f(ordered.mesh, *made, &ordered.numbers);
                return;
            }
        mesh = detail::refine_on(std::move(mesh), scheme, plan_->begin);
        if (const auto made = patches_of(mesh, scheme))
            f(mesh, *made, nullptr);
    }
    /// Returns true if patches may gain where faces lie in no order, or else if they lie in one.
    bool gains_if(bool lies_in_no_order)
    {
        const double least = choice_.least_if_scattered(plan_->sizes(), orderable_scheme<Scheme, Index>);
        if (not lies_in_no_order or plan_->faces_of_patch() >= least)
            return true;
        choice_.refuse(strategy_reason::scattered_faces, least);
        return false;
    }
    /// Returns the patches of the level that the plan begins with, which may be in the order of the surface; nothing
    /// where they are no gain.
    [[nodiscard]] std::optional<patches> patches_of(const basic_mesh<Point, Index>& level, const Scheme& scheme,
                                                    bool is_ordered = false)
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
    /// Returns the same of a level as it is; nothing either if its faces lie in no order and patches are small.
    [[nodiscard]] std::optional<patches> patches_if_gain(const basic_mesh<Point, Index>& level, const Scheme& scheme)
    {
        return gains_if(is_scattered(level.topology())) ? patches_of(level, scheme) : std::nullopt;
    }
    [[nodiscard]] basic_mesh<Point, Index> filled(const basic_mesh<Point, Index>& mesh, const patches& made,
                                                  const numbers* given) const
    {
        const counts& last = plan_->last();
        storage<Point> points(last.vertices);
        connectivity<Index> fine;
        fine.vertices = last.vertices;
        allocate_faces(fine, mesh.topology(), plan_->bases);
        if (last_level_ == connect::everything) {
            fine.corner_halfedge = storage<Index>(fine.corners());
            fine.halfedge_corner = storage<Index>(2 * last.edges);
            fine.vertex_corner = storage<Index>(last.vertices);
        }
        made.fill(mesh,
                  {.points = points.data(),
                   .corner_vertex = fine.corner_vertex.data(),
                   .corner_halfedge = fine.corner_halfedge.data(),
                   .halfedge_corner = fine.halfedge_corner.data(),
                   .vertex_corner = fine.vertex_corner.data(),
                   .coarse_numbers = given});
        return basic_mesh<Point, Index>(std::move(points), std::move(fine), last_generation_);
    }

    strategy_choice choice_;
    connect last_level_;
    int last_generation_;
    std::optional<patch_plan> plan_;
    std::optional<templates> kept_; // where there are enough faces for these
};

#endif

} // namespace kith
