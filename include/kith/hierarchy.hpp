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

/// A surface with all its levels on the user's own mesh type, and the associations between them: down by `assoc`, up by
/// `origin`, at any level, in handles of that mesh. Thesis 2.2: M(i) retained for all i.
/// Reading may be done from several threads; refining, dropping and restoring may not.
template <mesh M, scheme Scheme>
class hierarchy {
public:
    using traits = mesh_traits<M>;
    using level_type = level_of<M>;
    using index_type = typename level_type::index_type;

    /// Level 0 is a copy of the control mesh. Errors: as `refine`.
    explicit hierarchy(M control, Scheme scheme = Scheme(), refine_options options = {})
        : options_(options), levels_(checked(control), std::move(scheme))
    {
        detail::require_control_level(this->scheme(0), elements(0), levels_.generation(0));
    }

    /// Adds n levels; refine(1) twice is refine(2), bit for bit. Levels that were undone are given up. Errors: as the
    /// function `refine`. Where this or another function throws the hierarchy is as before the call.
    void refine(int n = 1)
    {
        static_cast<void>(refine(n, [](double) { return true; }));
    }

    /// Same, but calls go_on(done) after each level with the share of the work that is done, 0 to 1. Where it returns
    /// false the hierarchy becomes what it was before the call. Returns whether it went on to the end.
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
    /// `selected`. Which: those for which chosen(face) holds, those in a list, or those with a flag, in the order of
    /// dense numbers.
    /// Errors: as above; mesh_error for handles of no face of the last level, and unless there is a flag per face.
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

    /// Takes back the last n levels. What they were made by, selections and moved points, is kept until the next
    /// change, so that `redo` makes them again, the same bits. Errors: mesh_error for fewer than none, and for more
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
    /// How many levels `redo` can make again.
    [[nodiscard]] int undone() const { return levels_.undone(); }

    /// From now on level 0 and the last `count` levels stay in memory; the others are dropped, now and whenever levels
    /// are added. Of a dropped level the scheme with its state stays; `restore` makes the rest again. A level whose
    /// points `move_points` has moved itself stays, as no rule would make it again. Errors: mesh_error for less than
    /// one.
    void keep_last(int count)
    {
        if (count < 1)
            throw mesh_error(std::to_string(count) + " levels cannot be kept; keep at least the last one");
        levels_.keep_last(count);
    }
    /// Whether a level is in memory. Errors: mesh_error for levels that do not exist.
    [[nodiscard]] bool holds(int level) const { return levels_.entry_at(level).here != nullptr; }
    /// How many of the last levels are kept.
    [[nodiscard]] int kept_levels() const { return levels_.kept(); }
    /// Whether `move_points` has moved this level itself. Errors: mesh_error for levels that do not exist.
    [[nodiscard]] bool is_moved(int level) const { return levels_.entry_at(level).is_moved; }
    /// Makes a dropped level again, the same bits; it stays until levels are added. Errors: mesh_error for levels
    /// that do not exist. Cost: that of refining from the last level before it that is there.
    void restore(int level) { levels_.restore(level); }

    /// The number of the last level.
    [[nodiscard]] int depth() const { return levels_.depth(); }
    /// Level 0 is the control mesh. Errors, here and below: mesh_error for levels that are not there.
    [[nodiscard]] const M& operator[](int level) const { return levels_.at(level).here->mesh; }
    [[nodiscard]] const M& finest() const& { return levels_.at(depth()).here->mesh; }
    /// Taken out of a hierarchy that is given up: std::move(levels).finest().
    [[nodiscard]] M finest() && { return std::move(levels_.mesh(depth())); }

    /// The scheme as it is at a level, with the state of that level (creases), and with what was chosen for the step
    /// from there, also where that has been undone: what begins with it takes that step first.
    [[nodiscard]] const Scheme& scheme(int level) const { return levels_.entry_at(level).scheme; }

    /// The elements of a level as schemes see them: coarse.vertices(), v.corners() and so on.
    [[nodiscard]] const level_type& elements(int level) const { return levels_.elements(level); }

    /// The element of level+1 that belongs to elements of `level`, e.g. assoc(0, e, targets::V): what the scheme made
    /// under this tuple, which may be of elements that do not touch. Errors: association_error if it made none, and on
    /// the last level; mesh_error for handles of no element of this level. Cost: that of `retrieve`.
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

    /// The inverse: the elements of level-1 to which an element of `level` belongs. Errors: mesh_error for level 0 and
    /// for handles of no element of this level. Cost: O(1), O(log n) where the scheme leaves tuples of that kind out.
    template <handle_of<M> X>
    [[nodiscard]] birth<M> origin(int level, const X& x) const
    {
        return birth_in(levels_, level, levels_.at(level, x));
    }

    /// The element of a coarser level from which an element of `level` descends. Each new element has one parent: (v)
    /// is the parent of what is made under it, the edge of (e) and (v,e), the face of all others; of tuples whose
    /// elements do not touch see parent_of_listed. An edge that was found by matching has the element between the
    /// parents of its ends or, where these do not touch, the parent of the face on its left. An element of `level`
    /// itself is its own ancestor there.
    /// Errors: mesh_error unless coarser <= level, and for handles of no element of this level. Cost: that of `origin`
    /// per level.
    template <handle_of<M> X>
    [[nodiscard]] ancestor_element<M> ancestor(int level, const X& x, int coarser) const
    {
        return ancestor_in(levels_, level, numbered(levels_.at(level, x)), coarser);
    }

    /// Returns the elements of a finer level that have this element of `level` as their ancestor. No element descends
    /// from two elements. The descendants of a face are those inside it: vertices and edges on its border descend from
    /// its vertices and edges. Errors: mesh_error unless level <= finer, and for handles of no element of this level.
    /// Cost: O(their ranges), few per level; where edges are found by matching O(vertices of the dictionary + edges)
    /// per level.
    template <handle_of<M> X>
    [[nodiscard]] descendant_elements<level_type> descendants(int level, const X& x, int finer) const
    {
        return descendants_in(levels_, level, numbered(levels_.at(level, x)), finer);
    }

    /// Moves the vertices of a level, and those of all finer levels with them: the same bits as refining a mesh with
    /// these points, without making its connectivity again; state of the levels, which does not follow from places,
    /// stays. Points in the order of dense numbers.
    /// Errors: mesh_error unless there is a point per vertex, all finite. Cost: that of `carry`, and memory for the new
    /// points of all these levels.
    void move_points(int level, std::span<const typename traits::point> points)
        requires movable_mesh<M>
    {
        require_finite(level, points);
        std::vector moved{carry(level, level, points)};
        for (int finer = level; finer < depth(); ++finer)
            moved.push_back(carry(finer, finer + 1, moved.back()));
        static_cast<void>(elements(depth())); // as all that is allocated, before anything is moved
        levels_.forget_undone();
        for (std::size_t i = 0; i < moved.size(); ++i) {
            set_points(levels_.mesh(level + int(i)), elements(level + int(i)), moved[i]);
            levels_.set_moved(level + int(i), i == 0);
        }
    }

    /// Values at the vertices of level `from` carried to level `to` by the scheme's own text: colours, weights, hashes,
    /// anything with an `affine`, which may be called on several threads at once where points are plain bytes. In the
    /// order of the dense vertex numbers. Errors: mesh_error unless from <= to and there is a
    /// value per vertex. Cost: that of refining again, without connectivity.
    template <affine_value T>
    [[nodiscard]] storage<T> carry(int from, int to, std::span<const T> values) const
    {
        require_order(levels_, from, to);
        if (values.size() != elements(from).vertex_count())
            throw mesh_error("level " + std::to_string(from) + " has " + std::to_string(elements(from).vertex_count()) +
                             " vertices, " + std::to_string(values.size()) + " values were given; give one per vertex");
        return storage<T>(carry(from, to, on_vertices(values, by_mask())).values());
    }
    /// Same, but for any array of values: a std::vector, a std::array, a `storage`.
    template <std::ranges::contiguous_range Values>
    [[nodiscard]] auto carry(int from, int to, const Values& values) const
    {
        using value = std::ranges::range_value_t<Values>;
        static_cast<void>(diagnostics::point_without_affine<not affine_value<value>>());
        if constexpr (affine_value<value>)
            return carry(from, to, std::span<const value>(values));
    }

    /// A field of level `from` carried to level `to` by its rule: once over the levels between. Errors: as above.
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

    /// The subdivision matrix from the vertices of one level to those of a finer one. Errors: mesh_error unless from <=
    /// to. Cost per level: for each row the number of its operands times that of its entries; memory: the entries.
    [[nodiscard]] subdivision_matrix matrix(int from, int to) const
    {
        require_order(levels_, from, to);
        return matrix<field_on::vertices>(from, to, by_mask());
    }

    /// The matrix of a rule of fields: a row for each element of that kind of level `to`, over those of level `from`.
    /// On faces `from_parent()` sends values down, and its transpose sums them up; on corners it is that of texture
    /// coordinates, on edges that of what lies along them. Rows of elements that inherit nothing are empty. Errors and
    /// cost: as above.
    template <field_on Where, class Rule>
    [[nodiscard]] subdivision_matrix matrix(int from, int to, const Rule& rule) const
    {
        const auto unit = unit_rows(element_values<Where, stencil_row>::count_on(elements(from)));
        return make_matrix(carry(from, to, field<Where, stencil_row, Rule>(unit, rule)).values(), unit.size());
    }

private:
    /// The control mesh with its edges. Errors: mesh_error for all that is wrong with it.
    static M&& checked(M& control)
    {
        validate(control).require_ok();
        if constexpr (requires { detail::with_edges(control); })
            control = detail::with_edges(control);
        return std::move(control);
    }

    /// Errors: mesh_error if n more levels do not fit.
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
