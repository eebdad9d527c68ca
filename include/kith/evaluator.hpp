// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

namespace kith {

namespace detail {

/// Patches, or nothing where a scheme has none.
template <class Point, class Index, class Scheme>
struct possible_patches {
    using type = std::optional<std::monostate>;
};
template <class Point, class Index, class Scheme>
    requires patchable_scheme<Scheme, Point, Index>
struct possible_patches<Point, Index, Scheme> {
    using type = std::optional<patched_level<Point, Index, Scheme>>;
};

} // namespace detail

/// The points of the last level of a refinement, made again and again while the control points move and what is
/// connected stays. Where faces look alike the last steps are templates, made once and replayed (docs/design.md,
/// Patches). It may be used by one thread at a time; it works on those of OpenMP itself.
template <class Point, std::unsigned_integral Index, scheme Scheme>
class evaluator {
public:
    /// For the vertices of `refine(control, scheme, levels)`. Errors: those of `refine`. Cost: that of refining and,
    /// where there are patches, of looking around each face of a level in between; keeps the levels before the patches
    /// and some hundred bytes for each of their faces (more for those of rare classes), else all levels. Points of
    /// another library's types have no patches.
    evaluator(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels,
              const refine_options& options = {})
        : levels_(control, scheme, options), generation_(control.generation()), count_(levels)
    {
        detail::require_levels<Scheme>(levels);
        detail::require_room<Point, Index>(levels_.elements(0).counts(),
                                           scheme,
                                           levels,
                                           generation_,
                                           true,
                                           {connect::everything, options.memory_limit});
        make_patches();
        levels_.refine(patches_ ? 0 : levels - levels_.depth());
    }
    /// For a mesh of another library, whose points are told in the order of its vertices.
    template <refinable_mesh M>
    evaluator(const M& control, const Scheme& scheme, int levels, const refine_options& options = {})
        : evaluator(lift_valid<M, Point>(control), scheme, levels, options)
    {
    }

    /// The points of the last level for these control points: the bits of refining a mesh that has them.
    /// Errors: mesh_error unless there is a point for each control vertex, all finite. Cost: that of the masks.
    [[nodiscard]] storage<Point> evaluate(std::span<const Point> control)
    {
        if constexpr (patchable_scheme<Scheme, Point, Index>)
            if (patches_) {
                levels_.move_points(0, control);
                storage<Point> result(last_vertices_);
                patches_->fill(levels_.finest(), {result.data()});
                return result;
            }
        require_finite(0, control);
        return levels_.carry(0, count_, control);
    }

private:
    /// A template pays when it saves more than a few evaluations of the faces that it is for.
    static constexpr patch_costs costs{
        .in_patch = .2, .of_template = 100, .of_face_in_template = 5, .to_be_cheaper = .5, .least_faces = 1};

    void make_patches()
    {
        if constexpr (patchable_scheme<Scheme, Point, Index>) {
            const connectivity<Index>& control = levels_[0].topology();
            auto plan = plan_patches(count(control), control.degree, levels_.scheme(0), count_, generation_);
            if (not plan)
                return;
            const auto look = [&] {
                levels_.refine(plan->begin - levels_.depth());
                const auto& mesh = levels_.finest();
                const auto& scheme = levels_.scheme(plan->begin);
                const face_classes<Index> classes(
                    mesh.topology(), plan->rings, state_marks<Index>(mesh.topology(), scheme));
                if (auto made = patched_level<Point, Index, Scheme>::make(mesh, classes, scheme, *plan, costs))
                    patches_.emplace(std::move(*made));
            };
            look();
            if (not patches_ and plan->begin + 1 < count_) { // faces of the next level are more alike
                plan->begin_at(plan->begin + 1, levels_.scheme(0), generation_);
                if (plan->has_room_for_classes())
                    look();
            }
            last_vertices_ = plan->last().vertices;
            if (patches_)
                patches_->keep_what_is_found(levels_.finest());
        }
    }

    hierarchy<basic_mesh<Point, Index>, Scheme> levels_; // all, or those before the patches
    int generation_, count_;
    std::size_t last_vertices_ = 0;
    typename detail::possible_patches<Point, Index, Scheme>::type patches_;
};

template <refinable_mesh M, scheme Scheme>
evaluator(const M&, const Scheme&, int, const refine_options& = {})
    -> evaluator<typename mesh_traits<M>::point, std::uint32_t, Scheme>;
template <class Point, std::unsigned_integral Index, scheme Scheme>
evaluator(const basic_mesh<Point, Index>&, const Scheme&, int, const refine_options& = {})
    -> evaluator<Point, Index, Scheme>;

} // namespace kith
