// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "association.hpp"
#include "basic_mesh.hpp"
#include "for_each.hpp"
#include "match.hpp"
#include "numbering.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// How much of a new level's connectivity is wanted: none (only values are computed), face-vertex lists, or all.
enum class connect : unsigned char { nothing, faces, everything };

template <class Level, class Numbering, class Values, bool Checked> class pass_space;

/// The association space of one refinement step: `assoc(f, V)`, `assoc(v, e, E)`, `assoc(c, F)`. Thesis 4.1.
/// It holds no table: a tuple is an index, and the new element's id is the base of its column plus that index. What is
/// written goes straight into the arrays of the new level.
template <class Level, class Numbering, class Values, connect Connect, bool Checked>
class association_space {
public:
    using index_type = typename Numbering::index_type;
    static constexpr index_type none = connectivity<index_type>::none;

    association_space(const Level& coarse, const Numbering& ids, Values& values, connectivity<index_type>& fine)
        : coarse_(&coarse), ids_(ids), values_(&values), fine_(&fine)
    {
        if constexpr (Checked) {
            vertex_is_set_.assign(ids.vertices.total(), 0);
            face_is_set_.assign(ids.faces.total(), 0);
        }
    }

    /// assoc(elements..., target): the elements in any order.
    template <element X>
    auto operator()(const X& x, targets::to_vertex) const
    {
        return vertex(index_tuple(x), x);
    }
    template <element X, element Y>
    auto operator()(const X& x, const Y& y, targets::to_vertex) const
    {
        return vertex(index_tuple(x, y), x, y);
    }
    template <element X, element Y, element Z>
    auto operator()(const X& x, const Y& y, const Z& z, targets::to_vertex) const
    {
        return vertex(index_tuple(x, y, z), x, y, z);
    }
    template <element X>
    auto operator()(const X& x, targets::to_edge) const
    {
        return edge(index_tuple(x), x);
    }
    template <element X, element Y>
    auto operator()(const X& x, const Y& y, targets::to_edge) const
    {
        return edge(index_tuple(x, y), x, y);
    }
    template <element X, element Y, element Z>
    auto operator()(const X& x, const Y& y, const Z& z, targets::to_edge) const
    {
        return edge(index_tuple(x, y, z), x, y, z);
    }
    template <element X>
    auto operator()(const X& x, targets::to_face) const
    {
        return face(index_tuple(x), x);
    }
    template <element X, element Y>
    auto operator()(const X& x, const Y& y, targets::to_face) const
    {
        return face(index_tuple(x, y), x, y);
    }
    template <element X, element Y, element Z>
    auto operator()(const X& x, const Y& y, const Z& z, targets::to_face) const
    {
        return face(index_tuple(x, y, z), x, y, z);
    }
    /// List forms, lazy: assoc(v.faces(), V) and assoc(f, f.vertices(), V).
    template <class Range, class Target>
        requires requires(const Range& r) { r.map([](const auto& x) { return x; }); }
    auto operator()(const Range& range, Target target) const
    {
        return range.map([this, target](const auto& x) { return (*this)(x, target); });
    }
    template <element X, class Range, class Target>
        requires requires(const Range& r) { r.map([](const auto& x) { return x; }); }
    auto operator()(const X& x, const Range& range, Target target) const
    {
        return range.map([this, x, target](const auto& y) { return (*this)(x, y, target); });
    }

    /// A space between the coarse level and the next one, with vertices under the tuples of these columns, for schemes
    /// that average several times in a step. It lives as long as the scheme keeps it. Cost: that of its values.
    template <class... Columns>
    [[nodiscard]] auto pass(const new_vertices<Columns...>& vertices) const
    {
        using ids = numbering<columns<new_vertices<Columns...>, new_edges<>, new_faces<>>, index_type>;
        return pass_space<Level, ids, Values, Checked>(*coarse_, {vertices, new_edges(), new_faces()}, *values_);
    }

    /// Which elements have been made; empty unless Checked.
    [[nodiscard]] const std::vector<unsigned char>& vertex_is_set() const { return vertex_is_set_; }
    [[nodiscard]] const std::vector<unsigned char>& face_is_set() const { return face_is_set_; }

protected:
    void forget_what_is_set() const
    {
        vertex_is_set_.assign(vertex_is_set_.size(), 0);
        dictionary_.clear();
    }

private:
    template <class, tuple_kind> friend class vertex_association;
    template <class, tuple_kind> friend class edge_association;
    template <class, tuple_kind> friend class face_association;
    template <class> friend class dictionary_association;

    template <tuple_kind Kind, element... X>
    auto vertex(tuple_index<Kind> tuple, const X&... x) const
    {
        // Two elements of one kind may be neighbours or not, which only running tells, so they always have the
        // general form; other tuples are incident unless the scheme is wrong.
        constexpr bool pair_of_one_kind = sizeof...(X) == 2 and Kind == tuple_kind::e;
        if constexpr (pair_of_one_kind or not has_vertices<Kind>) {
            const bool incident = tuple.value != tuple.not_incident;
            return dictionary_association<const association_space>(
                *this,
                incident ? list_tuple(*coarse_, Kind, tuple.value) : list_tuple(x...),
                incident and has_vertices<Kind> ? tuple.value
                                                : dictionary_association<const association_space>::no_edge);
        } else {
            if (tuple.value == tuple.not_incident) [[unlikely]]
                refuse_not_incident("V", list_tuple(x...));
            return vertex_association<const association_space, Kind>(*this, tuple.value);
        }
    }
    template <tuple_kind Kind, element... X>
    auto edge(tuple_index<Kind> tuple, const X&... x) const
    {
        if (tuple.value == tuple.not_incident) [[unlikely]]
            refuse_not_incident("E", list_tuple(x...));
        return edge_association<const association_space, Kind>(*this, tuple.value);
    }
    template <tuple_kind Kind, element... X>
    auto face(tuple_index<Kind> tuple, const X&... x) const
    {
        if (tuple.value == tuple.not_incident) [[unlikely]]
            refuse_not_incident("F", list_tuple(x...));
        return face_association<const association_space, Kind>(*this, tuple.value);
    }

    // What associations do.

    template <tuple_kind Kind>
    index_type vertex_id(std::size_t tuple) const
    {
        const index_type id = ids_.vertices.template id<Kind>(tuple);
        if constexpr (not decltype(Numbering::vertices)::template is_full<Kind>)
            if (id == none) [[unlikely]]
                refuse_absent(Kind, tuple, "V");
        if constexpr (Checked)
            if (not std::atomic_ref(vertex_is_set_[id]).load(std::memory_order_relaxed)) [[unlikely]]
                throw association_error("assoc" + to_string(list_tuple(*coarse_, Kind, tuple)) +
                                        " -> V is read before it is set");
        return id;
    }
    template <tuple_kind Kind, class Mask>
    void make_vertex(std::size_t tuple, const Mask& mask) const
    {
        const index_type id = ids_.vertices.template id<Kind>(tuple);
        if constexpr (not decltype(Numbering::vertices)::template is_full<Kind>)
            if (id == none) [[unlikely]]
                refuse_absent(Kind, tuple, "V");
        values_->assign(id, mask.evaluate(*values_));
        if constexpr (Checked)
            if (std::atomic_ref(vertex_is_set_[id]).exchange(1, std::memory_order_relaxed)) [[unlikely]]
                throw association_error("assoc" + to_string(list_tuple(*coarse_, Kind, tuple)) + " -> V is set twice");
    }
    // Masks read each association in its own space, so that they may join those of several passes.
    [[nodiscard]] decltype(auto) vertex_value(index_type id) const { return values_->fine(id); }
    [[nodiscard]] decltype(auto) listed_value(index_type id) const { return values_->listed(id); }

    template <tuple_kind Kind>
    index_type edge_id(std::size_t tuple) const
    {
        const index_type id = ids_.edges.template id<Kind>(tuple);
        if constexpr (not decltype(Numbering::edges)::template is_full<Kind>)
            if (id == none) [[unlikely]]
                refuse_absent(Kind, tuple, "E");
        return id;
    }
    template <tuple_kind Kind>
    index_type face_id(std::size_t tuple) const
    {
        const index_type id = ids_.faces.template id<Kind>(tuple);
        if constexpr (not decltype(Numbering::faces)::template is_full<Kind>)
            if (id == none) [[unlikely]]
                refuse_absent(Kind, tuple, "F");
        return id;
    }
    template <tuple_kind Kind, class Lines>
    void make_face(std::size_t tuple, const Lines& lines) const
    {
        if constexpr (Connect != connect::nothing) {
            const index_type id = face_id<Kind>(tuple);
            if constexpr (Checked)
                if (std::atomic_ref(face_is_set_[id]).exchange(1, std::memory_order_relaxed)) [[unlikely]]
                    throw association_error("assoc" + to_string(list_tuple(*coarse_, Kind, tuple)) +
                                            " -> F is set twice");
            const index_type first = first_corner(id);
            index_type corner = first;
            for (const face_line<index_type>& line : lines) {
                if constexpr (Checked)
                    check_line(Kind, tuple, id, corner, line);
                fine_->corner_vertex[corner] = line.vertex;
                if constexpr (Connect == connect::everything and Numbering::has_edges) {
                    fine_->corner_halfedge[corner] = line.halfedge;
                    fine_->halfedge_corner[line.halfedge] = corner;
                }
                if constexpr (Numbering::common_degree == 0)
                    if (fine_->degree == 0)
                        fine_->corner_face[corner] = id;
                ++corner;
            }
            if constexpr (Checked)
                if (corner != first_corner(id + 1))
                    refuse_degree(Kind, tuple, corner - first, first_corner(id + 1) - first);
        }
    }
    [[nodiscard]] index_type first_corner(std::size_t face) const
    {
        if constexpr (Numbering::common_degree != 0)
            return index_type(face * Numbering::common_degree);
        else if constexpr (Connect == connect::nothing)
            return 0;
        else
            return fine_->first_corner(face);
    }
    void start_fan(index_type vertex, index_type corner) const
    {
        if constexpr (Connect == connect::everything and Numbering::has_edges)
            fine_->vertex_corner[vertex] = corner;
    }

    // The dictionary.

    template <class Mask>
    void make_listed_vertex(const tuple_elements& tuple, const Mask& mask) const
    {
        const auto id = index_type(ids_.vertices.total() + values_->listed_count());
        auto value = mask.evaluate(*values_);
        list_vertex(tuple, id);
        values_->append(std::move(value));
    }
    void list_vertex(const tuple_elements& tuple, index_type id) const
    {
        if (not dictionary_.emplace(tuple, id).second)
            throw association_error("assoc" + to_string(tuple) + " -> V is set twice");
    }
    [[nodiscard]] index_type listed_vertex(const tuple_elements& tuple) const
    {
        const auto found = dictionary_.find(tuple);
        if (found == dictionary_.end())
            throw association_error("assoc" + to_string(tuple) + " -> V is read before it is set");
        return found->second;
    }

    // Errors, out of the way of the loops.

    template <tuple_kind Kind>
    static constexpr bool has_vertices = decltype(Numbering::vertices)::template has<Kind>;

    [[noreturn, gnu::noinline]] static void refuse_not_incident(const char* target, const tuple_elements& tuple)
    {
        throw association_error("assoc" + to_string(tuple) + " -> " + target + ": the elements do not touch");
    }
    [[noreturn, gnu::noinline]] void refuse_absent(tuple_kind kind, std::size_t tuple, const char* target) const
    {
        throw association_error("assoc" + to_string(list_tuple(*coarse_, kind, tuple)) + " -> " + target +
                                ": the columns of the scheme leave this tuple out");
    }
    [[noreturn, gnu::noinline]] void refuse_degree(tuple_kind kind, std::size_t tuple, std::size_t has,
                                                   std::size_t declared) const
    {
        throw association_error("assoc" + to_string(list_tuple(*coarse_, kind, tuple)) + " -> F has " +
                                std::to_string(has) + " vertices, its column says " + std::to_string(declared));
    }
    [[gnu::noinline]] void check_line(tuple_kind kind, std::size_t tuple, index_type id, index_type corner,
                                      const face_line<index_type>& line) const
    {
        if (corner >= first_corner(id + 1))
            refuse_degree(kind, tuple, corner - first_corner(id) + 1, first_corner(id + 1) - first_corner(id));
        if constexpr (Connect == connect::everything and Numbering::has_edges) {
            if (line.halfedge == none)
                throw association_error("assoc" + to_string(list_tuple(*coarse_, kind, tuple)) +
                                        " -> F: the scheme declares edges, so each line needs its side: v >> side");
            if (fine_->halfedge_corner[line.halfedge] != none)
                throw association_error("assoc" + to_string(list_tuple(*coarse_, kind, tuple)) + " -> F: side " +
                                        std::to_string(line.halfedge % 2) + " of new edge " +
                                        std::to_string(line.halfedge / 2) + " has a face already");
        }
    }

    const Level* coarse_;
    const Numbering& ids_;
    Values* values_;
    connectivity<index_type>* fine_;
    mutable std::vector<unsigned char> vertex_is_set_, face_is_set_; // Checked only
    mutable std::map<tuple_elements, index_type> dictionary_;
};

namespace detail {

/// What a pass has of its own; a base, so that it is there before the space that refers to it.
template <class Numbering, class Values>
struct pass_parts {
    Numbering ids;
    Values values;
    connectivity<typename Numbering::index_type> nothing;
};

} // namespace detail

/// The association space of one of the passes of a step; thesis 4.1, chained. Its vertices are of no level: they are set
/// and read as others are and go with it.
template <class Level, class Numbering, class Values, bool Checked>
class pass_space : detail::pass_parts<Numbering, Values>,
                   public association_space<Level, Numbering, Values, connect::nothing, Checked> {
    using parts = detail::pass_parts<Numbering, Values>;
    using space = association_space<Level, Numbering, Values, connect::nothing, Checked>;

public:
    pass_space(const Level& coarse, const typename Numbering::columns_type& columns, const Values& step)
        : parts{{coarse, columns}, step.another(), {}}, space(coarse, parts::ids, parts::values, parts::nothing)
    {
        parts::values.allocate(parts::ids.vertices.total());
    }
    pass_space(const pass_space&) = delete;
    pass_space& operator=(const pass_space&) = delete;

    /// The same space to be written anew, in the same memory.
    const pass_space& again() const
    {
        space::forget_what_is_set();
        return *this;
    }
};

namespace detail {
template <class Index>
Index index_of_line(const face_line<Index>&);
template <class Association>
typename Association::index index_of_line(const Association&);
} // namespace detail

/// A new face: its vertices counter-clockwise, each with the side that leaves it (`assoc(v, V) >> side`); the sides may
/// be left out where the scheme declares no edges.
template <class First, class... More>
    requires(sizeof...(More) >= 2)
auto polygon(const First& first, const More&... more)
{
    using line = face_line<decltype(detail::index_of_line(first))>;
    return std::array<line, 1 + sizeof...(More)>{line(first), line(more)...};
}

/// The same from a range of elements and the line that each of them gives.
template <class Range, class LineOf>
auto polygon(const Range& range, const LineOf& line_of)
{
    using line = face_line<decltype(detail::index_of_line(line_of(*range.begin())))>;
    return range.map([&line_of](const auto& x) { return line(line_of(x)); });
}

/// The same from a range of associations: polygon(assoc(f, f.vertices(), V)).
template <class Range>
    requires mask_range<Range>
auto polygon(const Range& range)
{
    using line = face_line<typename decltype(*range.begin())::index>;
    return range.map([](const auto& association) { return line(association); });
}

} // namespace kith
