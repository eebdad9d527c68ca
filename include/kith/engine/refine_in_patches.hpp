// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine_in_surface_order.hpp"

#include <kith/patch/patched_level.hpp>
#include <kith/step/step.hpp>

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
    /// `levels` steps from a control mesh that has its edges; of the last level what is asked for. Cost: O(levels), and
    /// that of a look at some of its faces.
    patch_refinement(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels, connect last_level,
                     const patch_costs& costs = {})
        : patch_refinement(control.topology(), control.generation(), scheme, levels, last_level, costs)
    {
    }
    /// Plans the same for points or values at the vertices of a control mesh of this connectivity and generation.
    patch_refinement(const connectivity<Index>& control, int generation, const Scheme& scheme, int levels,
                     connect last_level, const patch_costs& costs = {})
        : costs_(costs)
        , last_level_(last_level)
        , last_generation_(generation + levels)
        , plan_(plan_patches(count(control), control.degree, scheme, levels, generation))
    {
        if (not plan_)
            return;
        faces_ = double(plan_->last().faces);
        if (faces_ * plan_->faces_of_patch() < std::min(costs.least_faces, costs.least_faces_again))
            return;
        kept_ = templates::of(without_state(scheme), generation + plan_->begin, plan_->rings, plan_->bases.size());
        demand_ = kept_->demand(plan_->last().faces, last_level_);
        ask_whether_to_look(costs);
        if (not is_worth_looking_)
            return;
        const std::size_t looks = std::clamp<std::size_t>(plan_->last().faces / 1024, 128, 1024);
        if (share_of_classes(control, 1, looks) > costs_.share_if_alike) // one ring tells
            begin_where_faces_are_alike(scheme, levels, costs);
    }

    /// Returns true if patches may be worth while: there are so many faces, or there have been again and again. They
    /// must not just have been looked at in vain.
    [[nodiscard]] bool is_worth_looking() const { return is_worth_looking_ and plan_; }

    /// The level whose faces own patches, counted from the control mesh. Precondition: is_worth_looking().
    [[nodiscard]] int begin() const { return plan_->begin; }
    /// Returns which steps are made in patches. Precondition: is_worth_looking().
    [[nodiscard]] const patch_plan& plan() const { return *plan_; }

    /// Returns the last level, with the bits of refining level by level, or nothing if patches are no gain. Then
    /// `mesh`, which is the control mesh before the call, and its scheme are a level to go on from.
    [[nodiscard]] std::optional<basic_mesh<Point, Index>> refine(basic_mesh<Point, Index>& mesh, Scheme& scheme) const
    {
        std::optional<basic_mesh<Point, Index>> fine;
        const auto fill = [&](const auto& level, const patches& made, const numbers* given) {
            fine = filled(level, made, given);
        };
        look([&] { return with_patches(mesh, scheme, fill); });
        return fine;
    }
    /// Returns the same from the level begin(), which stays as it is. Precondition: is_worth_looking().
    [[nodiscard]] std::optional<basic_mesh<Point, Index>> refine_from(const basic_mesh<Point, Index>& level,
                                                                      const Scheme& scheme) const
    {
        std::optional<basic_mesh<Point, Index>> fine;
        look([&] {
            if (const auto made = patches_if_worth(level, scheme))
                fine = filled(level, *made, nullptr);
            return fine.has_value();
        });
        return fine;
    }
    /// Returns the values at the vertices of the last level, of which the points of `level` are those there. Returns
    /// nothing if that is no gain. Preconditions: is_worth_looking(), and connect::nothing was asked for.
    [[nodiscard]] std::optional<storage<Point>> values_from(const basic_mesh<Point, Index>& level,
                                                            const Scheme& scheme) const
    {
        std::optional<storage<Point>> values;
        look([&] {
            if (const auto made = patches_if_worth(level, scheme))
                made->fill(level, {values.emplace(plan_->last().vertices).data()});
            return values.has_value();
        });
        return values;
    }
    /// Writes it into a mesh of another library; false where it is no gain. Precondition: all connectivity is wanted.
    /// Errors: those of `make_room`.
    [[nodiscard]] bool refine_into(level_writer<Point, Index>& fine, basic_mesh<Point, Index>& mesh,
                                   Scheme& scheme) const
    {
        KITH_ASSERT(last_level_ == connect::everything);
        const auto into_fine = [&](const auto& level, const patches& made, const numbers* given) {
            const counts& last = plan_->last();
            fine.make_room(last.vertices, last.edges, last.faces, last.boundary_edges == 0);
            made.fill(level, {.points = fine.points(), .writer = &fine, .coarse_numbers = given});
            fine.finish(last_generation_);
        };
        return look([&] { return with_patches(mesh, scheme, into_fine); });
    }

private:
    using patches = patched_level<Point, Index>;
    using numbers = element_numbers<Index>;
    using templates = kept_templates<scalar_of<Point>, Index>;

    /// At which of these costs, and whether at all the classes of faces are worth a look, by the plan as it is now.
    void ask_whether_to_look(const patch_costs& costs)
    {
        least_to_look_ = costs.least_to_look(*plan_);
        const bool is_enough = faces_ >= least_to_look_;
        costs_ = is_enough and demand_.next_look <= 0 ? costs : costs.if_again(1 + demand_.made / faces_);
        is_worth_looking_ = costs.of_look * plan_->rings <= costs.most_of_looks * plan_->faces_of_patch() and
                            demand_.made + faces_ >= std::max(is_enough ? 0 : least_to_look_, demand_.next_look);
    }
    /// Calls fill() if patches are worth looking for, and keeps for the next time whether they were a gain, which fill
    /// and this function return.
    template <class Fill>
    bool look(const Fill& fill) const
    {
        const bool is_gain = is_worth_looking() and fill();
        if (not kept_)
            return false;
        template_demand demand = demand_;
        if (is_gain) {
            demand = {.made = least_to_look_};
        } else {
            demand.made += faces_;
            demand.next_look = is_worth_looking_ ? 2 * demand.made : std::max(demand.next_look, least_to_look_);
        }
        kept_->keep(std::size_t(faces_), last_level_, demand);
        return is_gain;
    }

    /// Begins where few classes are left. If edges run and fans start in no order, as in many files, nearly each face
    /// of a control mesh is of its own class. After as many steps as a patch has rings there are few classes.
    void begin_where_faces_are_alike(const Scheme& scheme, int levels, const patch_costs& costs)
    {
        if (plan_->begin < plan_->rings and plan_->rings < levels) {
            is_late_ = plan_->rings > 1;
            plan_->begin_at(plan_->rings, scheme, last_generation_ - levels);
        }
        if (plan_->begin < plan_->rings or not plan_->has_room_for_classes() or
            (is_late_ and plan_->faces_of_patch() < costs.least_if_late))
            plan_.reset();
        else
            ask_whether_to_look(costs.if_unlike(is_late_));
    }
    /// Returns true if patches gain where the faces of the control mesh lie in no order. Small ones gain less than the
    /// order of the surface alone or, for a scheme without such an order, than looking at a large level costs there.
    [[nodiscard]] bool is_worth_while_if_scattered() const
    {
        if constexpr (orderable_scheme<Scheme, Index>)
            return plan_->faces_of_patch() >=
                   (last_level_ == connect::faces ? costs_.least_if_ordered : costs_.least_if_ordered_with_edges);
        else
            return not is_late_ or faces_ * plan_->faces_of_patch() >= costs_.least_faces_if_scattered;
    }
    /// f(level, patches, numbers): the level whose faces own patches, and the numbers that its elements have where the
    /// control mesh is refined as it is, if that has been put into the order of its surface: then what is read around a
    /// face lies close together. False where patches are no gain; then the mesh is this level or the control mesh as
    /// it was, and the scheme that of it.
    template <class F>
    bool with_patches(basic_mesh<Point, Index>& mesh, Scheme& scheme, const F& f) const
    {
        if (not is_worth_while_if_scattered() and is_scattered(mesh.topology()))
            return false;
        if constexpr (orderable_scheme<Scheme, Index>)
            if (is_worth_ordering(mesh.topology(), scheme, plan_->begin + int(plan_->bases.size())) and
                plan_->bases.size() > 1) { // else the numbers take memory that no plan counts
                auto ordered = in_surface_order(mesh);
                Scheme of_level = scheme;
                refine_ordered(ordered, of_level, plan_->begin);
                const auto made = patches_of(ordered.mesh, of_level);
                if (made)
                    f(ordered.mesh, *made, &ordered.numbers);
                return made.has_value();
            }
        mesh = detail::refine_on(std::move(mesh), scheme, plan_->begin);
        const auto made = patches_of(mesh, scheme);
        if (made)
            f(mesh, *made, nullptr);
        return made.has_value();
    }
    /// Returns the patches of a level; nothing either for one whose faces lie in no order if those are no gain.
    [[nodiscard]] std::optional<patches> patches_if_worth(const basic_mesh<Point, Index>& level,
                                                          const Scheme& scheme) const
    {
        if (not is_worth_while_if_scattered() and is_scattered(level.topology()))
            return {};
        return patches_of(level, scheme);
    }
    /// Returns those of the level that the plan begins with and its scheme; nothing where they are no gain.
    [[nodiscard]] std::optional<patches> patches_of(const basic_mesh<Point, Index>& level, const Scheme& scheme) const
    {
        const face_classes<Index> classes(level.topology(), plan_->rings, state_marks<Index>(level.topology(), scheme));
        return make_patches(level, classes, scheme, *plan_, costs_, last_level_ == connect::everything);
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

    patch_costs costs_;
    connect last_level_;
    int last_generation_;
    std::optional<patch_plan> plan_;
    double faces_ = 0, least_to_look_ = 0; // of the last level; with fewer only who has templates gains by them
    std::optional<templates> kept_;        // where there are enough faces for these
    template_demand demand_;
    bool is_late_ = false; // patches begin after several steps for the sake of alike faces: at a level that is large
    bool is_worth_looking_ = false;
};

#endif

} // namespace kith
