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

// Defined only if there are lanes (KITH_HAS_LANES).
template <class Point, std::unsigned_integral Index>
    requires fits_lanes<Point>
class patched_level;

namespace detail {

/// The types of the patches of a scheme and of the kinds of values that they make; std::monostate if it has no patches.
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

/// The levels of a refinement up to the level at which patches begin, and patches that make values of the last level
/// repeatedly. Without patches it holds all levels.
template <class Point, std::unsigned_integral Index, scheme Scheme>
class patched_levels {
public:
    using levels_type = hierarchy<basic_mesh<Point, Index>, Scheme>;
    using kind = typename possible_patches<Point, Index, Scheme>::kind;

    /// Takes the `kinds` of the values that `make` makes. The values at the vertices of a face of the last level follow
    /// from `last_rings` rings around it. Errors and cost: as evaluator.
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
    /// Returns the number of vertices of the last level. Precondition: there are patches.
    [[nodiscard]] std::size_t last_vertices() const { return last_vertices_; }

    /// Returns the values of the kind at place `of_kind` in the list of kinds, computed from the current points of the
    /// levels. Precondition: there are patches.
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
                return patches_.clear(); // templates may exist for one kind only
            patches_.push_back(std::move(*made));
        }
    }

    levels_type levels_;
    int count_;
    std::size_t last_vertices_ = 0;
    std::vector<patches> patches_; // by kind; empty if there are no patches
};

} // namespace detail

/// An evaluator of the points of the last level of a refinement. It computes them repeatedly while the control points
/// move and the connectivity stays. Where faces look alike, the last steps are templates, which are made once and
/// replayed (docs/patches.md). One thread at a time may use an evaluator; it runs on the threads of OpenMP itself.
template <class Point, std::unsigned_integral Index, scheme Scheme>
class evaluator {
public:
    /// Makes an evaluator for the vertices of `refine(control, scheme, levels)`. Errors: those of `refine`. Cost: that
    /// of refining and, if there are patches, of looking around each face of a level in between. With patches it keeps
    /// the levels before them and some hundred bytes for each of their faces (more for faces of rare classes). Without
    /// patches it keeps all levels. Points of another library's types have no patches.
    evaluator(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels,
              const refine_options& options = {})
        : levels_(control, scheme, levels, {{}}, 0, options)
    {
    }
    /// Makes an evaluator for a mesh of another library. `evaluate` takes points in the order of the vertices of that
    /// mesh.
    template <refinable_mesh M>
    evaluator(const M& control, const Scheme& scheme, int levels, const refine_options& options = {})
        : evaluator(to_native_valid<M, Point>(control), scheme, levels, options)
    {
    }

    /// Returns the points of the last level for these control points, bit for bit those of refining a mesh that has
    /// them. Errors: mesh_error unless there is a point for each control vertex, all finite. Cost: that of the masks.
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

/// Returns an evaluator of values at the vertices of level `from` of a hierarchy, of a type that masks combine. It
/// makes the values that `levels.carry(from, to, values)` makes, repeatedly. Where faces look alike, templates make
/// colours, weights or times, which are numbers or arrays of up to four. `evaluate` refuses values that are not finite.
/// Errors: mesh_error unless from <= to; those of the evaluator. Cost: that of the evaluator, which does not need the
/// hierarchy any more.
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
