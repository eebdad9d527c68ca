// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "association_faults.hpp"
#include "numbering.hpp"
#include "vertex_dictionary.hpp"

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/core/mesh/connect.hpp>

#include <concepts>
#include <cstddef>
#include <utility>

namespace kith {

template <level Level, level_numbering Numbering, values_of_step<Level> Values, bool Checked> class pass_space;

/// The association space of one refinement step: `assoc(f, V)`, `assoc(v, e, E)`, `assoc(c, F)`. Thesis 4.1. A tuple is
/// an index, and the new element's id is the base of its column plus that index. A table is needed only if a column
/// leaves out single tuples. Elements are written straight into the arrays of the new level, native or not.
template <level Level, level_numbering Numbering, values_of_step<Level> Values, connect Connect, bool Checked,
          class Fine = connectivity<typename Numbering::index_type>>
    requires level_sink<Fine> or std::same_as<Fine, connectivity<typename Numbering::index_type>>
class association_space {
public:
    using index_type = typename Numbering::index_type;
    using scalar = typename Values::scalar;
    using sum = typename Values::sum;
    static constexpr index_type none = connectivity<index_type>::none;

    association_space(const Level& coarse, const Numbering& ids, Values& values, Fine& fine)
        : coarse_(&coarse), ids_(ids), values_(&values), fine_(&fine)
    {
        if constexpr (Checked)
            made_ = {ids.vertices.total(), ids.faces.total(), none};
    }

    /// Returns the association assoc(elements..., target); the elements are given in any order.
    template <element X, target Target>
    auto operator()(const X& x, Target to) const
    {
        return associate(to, x);
    }
    template <element X, element Y, target Target>
    auto operator()(const X& x, const Y& y, Target to) const
    {
        return associate(to, x, y);
    }
    template <element X, element Y, element Z, target Target>
    auto operator()(const X& x, const Y& y, const Z& z, Target to) const
    {
        return associate(to, x, y, z);
    }
    /// Returns a lazy range of associations: assoc(v.faces(), V) and assoc(f, f.vertices(), V).
    template <class Range, target Target>
        requires requires(const Range& r) { r.map([](const auto& x) { return x; }); }
    auto operator()(const Range& range, Target to) const
    {
        return range.map([this, to](const auto& x) { return (*this)(x, to); });
    }
    template <element X, class Range, target Target>
        requires requires(const Range& r) { r.map([](const auto& x) { return x; }); }
    auto operator()(const X& x, const Range& range, Target to) const
    {
        return range.map([this, x, to](const auto& y) { return (*this)(x, y, to); });
    }
    /// Reports while compiling that all other arguments are mistakes.
    template <class... Other>
    auto operator()(const Other&...) const
    {
        static_cast<void>(diagnostics::no_target<(sizeof...(Other) < 100)>());
        return diagnostics::any_association();
    }

    /// Returns a pass: a space between the coarse level and the next one, with vertices under the tuples of these
    /// columns. Schemes use it to average several times in a step. A pass lives as long as the scheme keeps it. Cost:
    /// that of its values.
    template <class... Columns>
    [[nodiscard]] auto pass(const new_vertices<Columns...>& vertices) const
    {
        return pass(columns(vertices, new_edges(), new_faces()));
    }
    /// Returns a pass with all columns of a scheme, which may run in it. It makes vertices, but no edges and faces.
    template <declared_columns Columns>
    [[nodiscard]] auto pass(const Columns& columns) const
    {
        return pass_space<Level, numbering<Columns, index_type>, Values, Checked>(*coarse_, columns, *values_);
    }

    /// Returns the value of a mask without making a vertex, such as a sum that several masks have in common.
    [[nodiscard]] sum evaluate(const mask auto& mask) const { return mask.evaluate(*values_); }

    /// Returns the vertices that are in no column, moved out of this space.
    [[nodiscard]] vertex_dictionary<index_type> take_dictionary() { return std::move(dictionary_); }

    /// Returns the record of the elements that have been made; it is empty unless Checked.
    [[nodiscard]] const made_elements<index_type>& made() const { return made_; }

protected:
    void forget_what_is_set() const
    {
        made_.forget_vertices();
        dictionary_.clear();
    }

private:
    template <mask_evaluator, tuple_kind> friend class vertex_association;
    template <mask_evaluator, tuple_kind> friend class edge_association;
    template <mask_evaluator, tuple_kind> friend class face_association;
    template <mask_evaluator> friend class dictionary_association;

    static constexpr bool is_foreign = not std::same_as<Fine, connectivity<index_type>>;

    template <element... X>
    static constexpr tuple_kind kind_of = decltype(index_tuple(std::declval<const X&>()...))::kind;

    /// Returns the index of a tuple. Errors: association_error if its elements do not touch (only if Checked).
    template <element... X>
    static std::size_t incident(const char* target, const X&... x)
    {
        const auto tuple = index_tuple<not Checked>(x...);
        if constexpr (Checked)
            if (tuple.value == tuple.not_incident) [[unlikely]]
                faults::not_incident(target, x...);
        return tuple.value;
    }

    template <element... X>
    auto associate(targets::to_vertex, const X&... x) const
    {
        // Only at run time is it known if two elements of one kind are neighbours, so they always have the general
        // form.
        constexpr tuple_kind kind = kind_of<X...>;
        constexpr bool pair_of_one_kind = sizeof...(X) == 2 and kind == tuple_kind::e;
        if constexpr (pair_of_one_kind or not has_vertices<kind>) {
            const auto tuple = index_tuple(x...);
            const bool incident = tuple.value != tuple.not_incident;
            return dictionary_association<const association_space>(
                *this,
                listed_tuple(*coarse_, tuple, x...),
                incident and has_vertices<kind> ? tuple.value
                                                : dictionary_association<const association_space>::no_edge);
        } else {
            return vertex_association<const association_space, kind>(*this, incident("V", x...));
        }
    }
    template <element... X>
    auto associate(targets::to_edge, const X&... x) const
    {
        return edge_association<const association_space, kind_of<X...>>(*this, incident("E", x...));
    }
    template <element... X>
    auto associate(targets::to_face, const X&... x) const
    {
        return face_association<const association_space, kind_of<X...>>(*this, incident("F", x...));
    }

    // Operations of associations.

    /// Returns the id of a tuple. Errors: association_error if its column leaves the tuple out (only if Checked).
    template <tuple_kind Kind, element_ids Ids>
    index_type present(const Ids& ids, std::size_t tuple, const char* absent) const
    {
        if constexpr (Checked and not Ids::template is_full<Kind>)
            if (ids.template id<Kind>(tuple) == none) [[unlikely]]
                faults::refuse(*coarse_, Kind, tuple, absent);
        return ids.template known_id<Kind>(tuple);
    }
    template <tuple_kind Kind>
    index_type vertex_id(std::size_t tuple) const
    {
        return present<Kind>(ids_.vertices, tuple, faults::absent_vertex);
    }
    // A mask reads each association in its own space, so one mask may combine associations of several passes.
    template <tuple_kind Kind>
    decltype(auto) vertex_value(std::size_t tuple) const
    {
        const index_type id = vertex_id<Kind>(tuple);
        if constexpr (Checked)
            if (not made_.has_vertex(id)) [[unlikely]]
                faults::refuse(*coarse_, Kind, tuple, faults::vertex_read_early);
        return values_->fine(id);
    }
    template <tuple_kind Kind, mask Mask>
    void make_vertex(std::size_t tuple, const Mask& mask) const
    {
        const index_type id = vertex_id<Kind>(tuple);
        values_->assign(id, mask.evaluate(*values_));
        if constexpr (Checked)
            if (made_.make_vertex(id)) [[unlikely]]
                faults::refuse(*coarse_, Kind, tuple, faults::vertex_set_twice);
    }
    [[nodiscard]] decltype(auto) listed_value(const tuple_elements& tuple) const
    {
        const index_type id = dictionary_.at(tuple);
        if constexpr (Checked)
            if (id < made_.vertices().size() and not made_.vertices()[id]) // it refers to a vertex of a column
                faults::refuse(tuple, faults::vertex_read_early);
        return values_->listed(id);
    }

    template <tuple_kind Kind>
    index_type edge_id(std::size_t tuple) const
    {
        return present<Kind>(ids_.edges, tuple, faults::absent_edge);
    }
    template <tuple_kind Kind>
    index_type face_id(std::size_t tuple) const
    {
        return present<Kind>(ids_.faces, tuple, faults::absent_face);
    }
    template <tuple_kind Kind, face_sides Lines>
    void make_face(std::size_t tuple, const Lines& lines) const
    {
        if constexpr (Connect != connect::nothing) {
            const index_type id = face_id<Kind>(tuple);
            if constexpr (Checked)
                if (made_.make_face(id)) [[unlikely]]
                    faults::refuse(*coarse_, Kind, tuple, faults::face_set_twice);
            if constexpr (is_foreign) {
                static_assert(not Checked, "what is checked is looked up in a native level");
                fine_->set_face(id, lines);
            } else {
                write_face<Kind>(tuple, id, lines);
            }
        }
    }
    template <tuple_kind Kind, face_sides Lines>
    void write_face(std::size_t tuple, index_type id, const Lines& lines) const
    {
        const index_type first = first_corner(id);
        index_type corner = first;
        for (const face_line<index_type>& line : lines) {
            if constexpr (Checked) {
                if (corner >= first_corner(id + 1))
                    faults::wrong_degree(*coarse_, Kind, tuple, corner - first + 1, first_corner(id + 1) - first);
                const std::size_t vertices = ids_.vertices.total() + values_->listed_count();
                faults::require_vertex(*coarse_, Kind, tuple, line.vertex, vertices);
                if constexpr (Connect == connect::everything and Numbering::has_edges)
                    faults::require_free_side(*coarse_, Kind, tuple, line.halfedge, *fine_);
            }
            fine_->corner_vertex[corner] = line.vertex;
            if constexpr (Connect == connect::everything and Numbering::has_edges)
                fine_->set_side(corner, line.halfedge);
            if constexpr (Numbering::common_degree == 0)
                if (fine_->degree == 0)
                    fine_->corner_face[corner] = id;
            ++corner;
        }
        if constexpr (Checked)
            faults::require_degree(*coarse_, Kind, tuple, corner - first, first_corner(id + 1) - first);
    }
    [[nodiscard]] index_type first_corner(std::size_t face) const
    {
        if constexpr (Connect == connect::nothing or is_foreign) // where corners have no numbers
            return 0;
        else if constexpr (Numbering::common_degree != 0)
            return index_type(face * Numbering::common_degree);
        else
            return fine_->first_corner(face);
    }
    void start_fan(index_type vertex, index_type corner, index_type halfedge) const
    {
        if constexpr (Connect == connect::everything and Numbering::has_edges) {
            if constexpr (is_foreign)
                fine_->set_start(vertex, halfedge);
            else
                fine_->vertex_corner[vertex] = corner;
            if constexpr (Checked)
                made_.start_fan(vertex, halfedge);
        }
    }

    // The dictionary.

    template <mask Mask>
    [[gnu::noinline]] void make_listed_vertex(const tuple_elements& tuple, const Mask& mask) const
    {
        if constexpr (Numbering::has_edges) {
            faults::undeclared(tuple);
        } else {
            auto value = mask.evaluate(*values_);
            dictionary_.add(tuple, index_type(ids_.vertices.total() + values_->listed_count()));
            values_->append(std::move(value));
        }
    }
    template <tuple_kind Kind>
    static constexpr bool has_vertices = decltype(Numbering::vertices)::template has<Kind>;

    const Level* coarse_;
    const Numbering& ids_;
    Values* values_;
    Fine* fine_;
    mutable made_elements<index_type> made_; // Checked only
    mutable vertex_dictionary<index_type> dictionary_;
};

} // namespace kith
