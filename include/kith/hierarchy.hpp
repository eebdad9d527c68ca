// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine.hpp"

#include <kith/core/mask/stencil.hpp>
#include <kith/fields/field.hpp>
#include <kith/hierarchy/level_store.hpp>
#include <kith/hierarchy/moved_points.hpp>
#include <kith/hierarchy/relatives.hpp>
#include <kith/hierarchy/relatives_in_levels.hpp>
#include <kith/hierarchy/selection.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <limits>
#include <ranges>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// A surface with all its levels, each a mesh of the user's own type, and the associations between the levels: down by
/// `assoc`, up by `origin`, at any level, in handles of these meshes. Thesis 2.2: M(i) retained for all i. Reading is
/// safe on several threads at once; refining, dropping and restoring are not.
template <mesh M, scheme Scheme>
class hierarchy {
public:
    using traits = mesh_traits<M>;
    using level_type = level_of<M>;
    using index_type = typename level_type::index_type;

    /// Takes a copy of the control mesh as level 0. Errors: as `refine`.
    explicit hierarchy(M control, Scheme scheme = Scheme(), refine_options options = {})
        : options_(options), levels_(checked(control), std::move(scheme))
    {
        detail::require_control_level(this->scheme(0), elements(0), levels_.generation(0));
    }

    /// Adds n levels; refine(1) twice is refine(2), bit for bit. Levels that were undone are discarded. Errors: as the
    /// function `refine`. If this or another function throws, the hierarchy is as before the call.
    void refine(int n = 1)
    {
        static_cast<void>(refine(n, [](double) { return true; }));
    }

    /// Adds n levels and calls go_on(done) after each; `done` is the share of the work that is done, 0 to 1. If go_on
    /// returns false, the hierarchy becomes as before the call. Returns true if all n levels were added.
    template <std::predicate<double> GoOn>
    bool refine(int n, const GoOn& go_on)
    {
        detail::require_levels<Scheme>(n);
        if (n == 0)
            return true;
        require_room(n);
        const auto shares = shares_of_work(elements(depth()).counts(), scheme(depth()), n, levels_.generation(depth()));
        return levels_.add(n, [&](int level) { return go_on(shares[std::size_t(level)]); });
    }

    /// Adds a level in which some faces of the last level are refined and the mesh stays conforming; the scheme is
    /// `selected`. The faces are those for which chosen(face) holds, those in a list, or those with a flag, in the
    /// order of dense numbers. Errors: as above; mesh_error for handles of no face of the last level, and unless there
    /// is a flag per face.
    template <std::predicate<typename traits::face> Chosen>
        requires selecting_scheme<Scheme, level_type>
    void refine_if(const Chosen& chosen)
    {
        refine_flagged(flags_where(elements(depth()), chosen));
    }
    void refine_faces(std::span<const typename traits::face> faces)
        requires selecting_scheme<Scheme, level_type>
    {
        std::vector<unsigned char> flags(elements(depth()).face_count(), 0);
        for (const auto& f : faces)
            flags[levels_.at(depth(), f).index()] = 1;
        refine_flagged(flags);
    }
    void refine_flagged(std::span<const unsigned char> flags)
        requires selecting_scheme<Scheme, level_type>
    {
        levels_.add_by([&](Scheme& scheme, const level_type& last) { scheme.select(last, flags); });
    }

    /// Takes back the last n levels. The selections and moved points that made them are kept until the next change, so
    /// that `redo` makes the same levels again, bit for bit. Errors: mesh_error for negative n, and for more levels
    /// than there are.
    void undo(int n = 1)
    {
        detail::require_between(n, depth(), "taken back");
        levels_.undo(n);
    }
    void redo(int n = 1)
    {
        detail::require_between(n, undone(), "made again");
        levels_.redo(n);
    }
    /// Returns the number of levels that `redo` can make again.
    [[nodiscard]] int undone() const { return levels_.undone(); }

    /// Keeps level 0 and the last `count` levels in memory and drops the others, now and whenever levels are added. Of
    /// a dropped level the scheme with its state stays; `restore` makes the rest again. A level whose own points
    /// `move_points` has set stays, because no rule would make it again. Errors: mesh_error if count < 1.
    void keep_last(int count)
    {
        if (count < 1)
            throw mesh_error(std::to_string(count) + " levels cannot be kept; keep at least the last one");
        levels_.keep_last(count);
    }
    /// Returns true if a level is in memory. Errors: mesh_error for levels that do not exist.
    [[nodiscard]] bool holds(int level) const { return levels_.entry_at(level).here != nullptr; }
    /// Returns how many of the last levels are kept.
    [[nodiscard]] int kept_levels() const { return levels_.kept(); }
    /// Returns true if `move_points` has set the points of this level itself. Errors: mesh_error for unknown levels.
    [[nodiscard]] bool is_moved(int level) const { return levels_.entry_at(level).is_moved; }
    /// Makes a dropped level again, bit for bit; it stays until levels are added. Errors: mesh_error for levels that do
    /// not exist. Cost: that of refining from the last level before it that is in memory.
    void restore(int level) { levels_.restore(level); }

    /// Returns the number of the last level.
    [[nodiscard]] int depth() const { return levels_.depth(); }
    /// Returns the mesh of a level; level 0 is the control mesh. Errors, here and below: mesh_error for absent levels.
    [[nodiscard]] const M& operator[](int level) const { return levels_.at(level).here->mesh; }
    [[nodiscard]] const M& finest() const& { return levels_.at(depth()).here->mesh; }
    /// Returns the last mesh, moved out of a hierarchy that is no longer needed: std::move(levels).finest().
    [[nodiscard]] M finest() && { return std::move(levels_.mesh(depth())); }

    /// Returns the scheme of a level, with the state of that level (creases) and the selection for the step from there.
    /// The selection stays if the step has been undone: a refinement that begins with this scheme takes that step
    /// first.
    [[nodiscard]] const Scheme& scheme(int level) const { return levels_.entry_at(level).scheme; }

    /// Returns the elements of a level as schemes see them: coarse.vertices(), v.corners() and so on.
    [[nodiscard]] const level_type& elements(int level) const { return levels_.elements(level); }

    /// Returns the element of level+1 that the scheme made under a tuple of `level`, e.g. assoc(0, e, targets::V). The
    /// elements of the tuple need not touch. Errors: association_error if the scheme made none, and on the last level;
    /// mesh_error for handles of no element of this level. Cost: that of `retrieve`.
    template <handle_of<M> X, target Target>
    [[nodiscard]] auto assoc(int level, const X& x, Target target) const
    {
        return child_of(levels_, level, target, levels_.at(level, x));
    }
    template <handle_of<M> X, handle_of<M> Y, target Target>
    [[nodiscard]] auto assoc(int level, const X& x, const Y& y, Target target) const
    {
        return child_of(levels_, level, target, levels_.at(level, x), levels_.at(level, y));
    }
    template <handle_of<M> X, handle_of<M> Y, handle_of<M> Z, target Target>
    [[nodiscard]] auto assoc(int level, const X& x, const Y& y, const Z& z, Target target) const
    {
        return child_of(levels_, level, target, levels_.at(level, x), levels_.at(level, y), levels_.at(level, z));
    }

    /// Returns the elements of level-1 whose tuple made an element of `level`. Errors: mesh_error for level 0 and for
    /// handles of no element of this level. Cost: O(1), O(log n) if the scheme leaves tuples of that kind out.
    template <handle_of<M> X>
    [[nodiscard]] birth<M> origin(int level, const X& x) const
    {
        return birth_in(levels_, level, levels_.at(level, x));
    }

    /// Returns the element of a coarser level from which an element of `level` descends. Each new element has one
    /// parent: the vertex for tuples (v), the edge for (e) and (v,e), the face for all others. Tuples whose elements do
    /// not touch are described at parent_of_listed. An edge that was found by matching has as parent the element
    /// between the parents of its ends. If these do not touch, it is the parent of the face on its left. An element of
    /// `level` is its own ancestor on that level.
    /// Errors: mesh_error unless coarser <= level, and for handles of no element of this level. Cost: that of `origin`
    /// per level.
    template <handle_of<M> X>
    [[nodiscard]] ancestor_element<M> ancestor(int level, const X& x, int coarser) const
    {
        return ancestor_in(levels_, level, numbered(levels_.at(level, x)), coarser);
    }

    /// Returns the elements of a finer level that have this element of `level` as their ancestor. No element descends
    /// from two elements. The descendants of a face lie inside it: vertices and edges on its border descend from its
    /// vertices and edges. Errors: mesh_error unless level <= finer, and for handles of no element of this level. Cost:
    /// O(ranges of their numbers), few per level; if edges are found by matching, O(vertices of the dictionary + edges)
    /// per level.
    template <handle_of<M> X>
    [[nodiscard]] descendant_elements<level_type> descendants(int level, const X& x, int finer) const
    {
        return descendants_in(levels_, level, numbered(levels_.at(level, x)), finer);
    }

    /// Moves the vertices of a level to `points`, in the order of dense numbers, and those of all finer levels with
    /// them. The result is bit for bit that of refining a mesh with these points, but connectivity is not made again.
    /// State of the levels stays, because it does not depend on points. Errors: mesh_error unless there is a point per
    /// vertex, all finite. Cost: that of `carry`, and memory for the new points of all these levels.
    void move_points(int level, std::span<const typename traits::point> points)
        requires movable_mesh<M>
    {
        require_finite(level, points);
        std::vector moved{carry(level, level, points)};
        for (int finer = level; finer < depth(); ++finer)
            moved.push_back(carry(finer, finer + 1, moved.back()));
        static_cast<void>(elements(depth())); // allocates, as everything above does, before anything is moved
        levels_.forget_undone();
        for (std::size_t i = 0; i < moved.size(); ++i) {
            set_points(levels_.mesh(level + int(i)), elements(level + int(i)), moved[i]);
            levels_.set_moved(level + int(i), i == 0);
        }
    }

    /// Returns values at the vertices of level `from` carried to level `to` by the masks of the scheme, in the order of
    /// dense vertex numbers: colours, weights, hashes, any type with an `affine`. If points are plain bytes, the
    /// functions of `affine` may be called on several threads at once. Errors: mesh_error unless from <= to and there
    /// is a value per vertex. Cost: that of refining again, without connectivity.
    template <affine_value T>
    [[nodiscard]] storage<T> carry(int from, int to, std::span<const T> values) const
    {
        require_order(levels_, from, to);
        if (values.size() != elements(from).vertex_count())
            throw mesh_error("level " + std::to_string(from) + " has " + std::to_string(elements(from).vertex_count()) +
                             " vertices, " + std::to_string(values.size()) + " values were given; give one per vertex");
        return storage<T>(carry(from, to, on_vertices(values, by_mask())).values());
    }
    /// Returns the carried values for any array of values: a std::vector, a std::array, a `storage`.
    template <std::ranges::contiguous_range Values>
    [[nodiscard]] auto carry(int from, int to, const Values& values) const
    {
        using value = std::ranges::range_value_t<Values>;
        static_cast<void>(diagnostics::point_without_affine<not affine_value<value>>());
        if constexpr (affine_value<value>)
            return carry(from, to, std::span<const value>(values));
    }

    /// Returns a field of level `from`, carried by its rule in one pass over the levels to `to`. Errors: as above.
    template <field_on Where, class T, class Rule>
    [[nodiscard]] field<Where, T, Rule> carry(int from, int to, field<Where, T, Rule> values) const
    {
        require_order(levels_, from, to);
        values.require_one_each(elements(from));
        const auto by_levels = [&](int first, int last, auto each) {
            for (int level = first; level < last; ++level) {
                const auto &here = levels_.at(level), &next = levels_.at(level + 1);
                each = each.after(
                    step_result{here.scheme, elements(level), levels_.generation(level), here.ids, next.here->mesh});
            }
            return each;
        };
        return carry_in_patches<Scheme>(levels_, from, to, std::move(values), by_levels);
    }

    /// Returns the subdivision matrix from the vertices of a level to those of a finer one. Errors: mesh_error unless
    /// from <= to. Cost per level: for each row its number of operands times that of its entries; memory: the entries.
    [[nodiscard]] subdivision_matrix matrix(int from, int to) const
    {
        require_order(levels_, from, to);
        return matrix<field_on::vertices>(from, to, by_mask());
    }

    /// Returns the matrix of a rule of fields: a row for each element of that kind of level `to`, over those of level
    /// `from`. On faces `from_parent()` sends values down, and its transpose sums them up. On corners it is the matrix
    /// of texture coordinates, on edges that of values along edges. Rows of elements that inherit nothing are empty.
    /// Errors and cost: as above.
    template <field_on Where, class Rule>
    [[nodiscard]] subdivision_matrix matrix(int from, int to, const Rule& rule) const
    {
        const auto unit = unit_rows(element_values<Where, stencil_row>::count_on(elements(from)));
        return make_matrix(carry(from, to, field<Where, stencil_row, Rule>(unit, rule)).values(), unit.size());
    }

private:
    /// Returns the control mesh with its edges. Errors: mesh_error with everything that `validate` finds.
    static M&& checked(M& control)
    {
        validate(control).require_ok();
        if constexpr (requires { detail::with_edges(control); })
            control = detail::with_edges(control);
        return std::move(control);
    }

    /// Throws mesh_error if n more levels do not fit.
    void require_room(int n) const
    {
        if constexpr (countable_scheme<Scheme>) {
            const int last = depth() + std::min(n, std::numeric_limits<int>::max() - depth());
            const auto planned = plan(elements(0).counts(),
                                      scheme(0),
                                      last,
                                      levels_.generation(0),
                                      sizeof(typename traits::point),
                                      sizeof(index_type));
            detail::require_bytes(scheme_name<Scheme>(),
                                  peak_bytes_keeping_last(planned, levels_.kept(), depth()),
                                  last,
                                  options_.memory_limit);
        }
    }

    refine_options options_;
    level_store<M, Scheme> levels_;
};

} // namespace kith
