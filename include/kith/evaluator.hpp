// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace kith {

// Defined where there are lanes.
template <class Point, std::unsigned_integral Index>
    requires fits_lanes<Point>
class patched_level;

namespace detail {

/// The patches of a scheme, and the kinds of values that they make; for a scheme without patches the kinds alone.
template <class Point, class Index, class Scheme>
struct possible_patches {
    using kind = std::monostate;
    using type = std::monostate;
};
template <class Point, class Index, class Scheme>
    requires patchable_scheme<Scheme, Point, Index>
struct possible_patches<Point, Index, Scheme> {
    using kind = patch_output_kind<scalar_of<Point>, Index, Scheme>;
    using type = patched_level<Point, Index>;
};

/// The levels of a refinement up to where patches begin, and the patches of all that is made of the last level again
/// and again; all levels where there are no patches.
template <class Point, std::unsigned_integral Index, scheme Scheme>
class patched_levels {
public:
    using levels_type = hierarchy<basic_mesh<Point, Index>, Scheme>;
    using kind = typename possible_patches<Point, Index, Scheme>::kind;

    /// `kinds`: of the values that `make` makes. `last_rings`: around a face of the last level from which the values of
    /// its vertices follow. Errors and cost: as evaluator.
    patched_levels(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels,
                   const std::vector<kind>& kinds, int last_rings, const refine_options& options)
        : levels_(control, scheme, options), count_(levels)
    {
        require_levels<Scheme>(levels);
        require_room<Point, Index>(levels_.elements(0).counts(),
                                   scheme,
                                   levels,
                                   control.generation(),
                                   true,
                                   {connect::everything, options.memory_limit});
        find_patches(kinds, last_rings, control.generation());
        levels_.refine(has_patches() ? 0 : levels - levels_.depth());
    }

    [[nodiscard]] bool has_patches() const { return not patches_.empty(); }
    [[nodiscard]] levels_type& levels() { return levels_; }
    /// Of the last level. Precondition: there are patches.
    [[nodiscard]] std::size_t last_vertices() const { return last_vertices_; }

    /// Returns values of the kind with this place in the list of kinds, by the points that the levels have now.
    /// Precondition: there are patches.
    [[nodiscard]] storage<Point> make(std::size_t of_kind) const
    {
        storage<Point> result(last_vertices_);
        if constexpr (patchable_scheme<Scheme, Point, Index>)
            patches_[of_kind].fill(levels_.finest(), {result.data()});
        return result;
    }

private:
    using patches = typename possible_patches<Point, Index, Scheme>::type;

    void find_patches(const std::vector<kind>& kinds, int last_rings, int generation)
    {
        if constexpr (patchable_scheme<Scheme, Point, Index>) {
            const connectivity<Index>& control = levels_[0].topology();
            auto plan = plan_patches(count(control), control.degree, levels_.scheme(0), count_, generation, last_rings);
            if (not plan or are_patches_ruled_out())
                return;
            look(kinds, *plan);
            if (not has_patches() and plan->begin + 1 < count_) { // faces of the next level are more alike
                plan->begin_at(plan->begin + 1, levels_.scheme(0), generation);
                if (plan->has_room_for_classes())
                    look(kinds, *plan);
            }
            last_vertices_ = plan->last().vertices;
            for (auto& made : patches_)
                made.keep_what_is_found(levels_.finest());
        }
    }
    void look(const std::vector<kind>& kinds, const patch_plan& plan)
        requires patchable_scheme<Scheme, Point, Index>
    {
        levels_.refine(plan.begin - levels_.depth());
        const auto& mesh = levels_.finest();
        const auto& scheme = levels_.scheme(plan.begin);
        const face_classes<Index> classes(mesh.topology(), plan.rings, state_marks<Index>(mesh.topology(), scheme));
        const strategy_costs costs = usual_costs(strategy_costs::of_evaluations());
        for (const auto& kind : kinds) {
            auto made = make_patches(mesh, classes, scheme, plan, costs, false, kind);
            if (not made)
                return patches_.clear(); // templates may be kept of one kind alone
            patches_.push_back(std::move(*made));
        }
    }

    levels_type levels_;
    int count_;
    std::size_t last_vertices_ = 0;
    std::vector<patches> patches_; // by kinds; empty where there are no patches
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
        : levels_(control, scheme, levels, {{}}, 0, options)
    {
    }
    /// For a mesh of another library, whose points are told in the order of its vertices.
    template <refinable_mesh M>
    evaluator(const M& control, const Scheme& scheme, int levels, const refine_options& options = {})
        : evaluator(to_native_valid<M, Point>(control), scheme, levels, options)
    {
    }

    /// The points of the last level for these control points: the bits of refining a mesh that has them.
    /// Errors: mesh_error unless there is a point for each control vertex, all finite. Cost: that of the masks.
    [[nodiscard]] storage<Point> evaluate(std::span<const Point> control)
    {
        auto& levels = levels_.levels();
        if (levels_.has_patches()) {
            levels.move_points(0, control);
            return levels_.make(0);
        }
        require_finite(0, control);
        return levels.carry(0, levels.depth(), control);
    }

private:
    detail::patched_levels<Point, Index, Scheme> levels_;
};

template <refinable_mesh M, scheme Scheme>
evaluator(const M&, const Scheme&, int, const refine_options& = {})
    -> evaluator<typename mesh_traits<M>::point, std::uint32_t, Scheme>;
template <class Point, std::unsigned_integral Index, scheme Scheme>
evaluator(const basic_mesh<Point, Index>&, const Scheme&, int, const refine_options& = {})
    -> evaluator<Point, Index, Scheme>;

/// An evaluator of values at the vertices of level `from` of a hierarchy, of a type that masks combine. It makes what
/// `levels.carry(from, to, values)` makes, again and again. Where faces look alike, templates make colours, weights or
/// times, which are numbers or arrays of up to four; `evaluate` refuses those that are not finite. Errors: mesh_error
/// unless from <= to; those of the evaluator. Cost: that of the evaluator; the hierarchy need not stay.
template <affine_value T, mesh M, scheme Scheme>
    requires(not selecting_scheme<Scheme, level_of<M>>)
auto evaluator_of(const hierarchy<M, Scheme>& levels, int from, int to, const refine_options& options = {})
{
    detail::require_finer(to, from);
    const auto& here = native_of(levels[from], levels.elements(from), generation_of(levels[0]) + from);
    using index_type = typename std::remove_cvref_t<decltype(here)>::index_type;
    const basic_mesh<T, index_type> mesh(storage<T>(here.vertex_count(), T{}), here.topology(), here.generation());
    return evaluator<T, index_type, Scheme>(mesh, levels.scheme(from), to - from, options);
}

} // namespace kith
