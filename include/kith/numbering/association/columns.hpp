// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/counts.hpp>
#include <kith/core/base/diagnostics.hpp>
#include <kith/core/level/level_elements.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kith {

/// The kinds of tuples of incident elements; thesis table 4.1. Every such tuple is an index: (v), (e), (f) their own
/// number, (v,f) and (e,f) a corner, (v,e) an end of an edge (2e+s), (v,f,e) a corner and a side of it (2c+s).
/// (v1,v2) adjacent and (f1,f2) adjacent are an edge.
enum class tuple_kind : unsigned char { v, e, f, vf, ve, ef, vfe };

/// How many elements of each kind a level has.
struct element_counts {
    std::uint64_t vertices = 0, edges = 0, faces = 0, corners = 0;
};
/// A level, or a part of one, that knows its counts.
template <class L>
concept counts_elements = requires(const L& level) {
    { level.vertex_count() } -> std::convertible_to<std::size_t>;
    { level.edge_count() } -> std::convertible_to<std::size_t>;
    { level.face_count() } -> std::convertible_to<std::size_t>;
    { level.corner_count() } -> std::convertible_to<std::size_t>;
};
template <counts_elements Level>
element_counts count_elements(const Level& level)
{
    return {level.vertex_count(), level.edge_count(), level.face_count(), level.corner_count()};
}

/// How many tuples of a kind a level has.
constexpr std::uint64_t tuple_count(const element_counts& level, tuple_kind kind)
{
    switch (kind) {
    case tuple_kind::v: return level.vertices;
    case tuple_kind::e: return level.edges;
    case tuple_kind::f: return level.faces;
    case tuple_kind::ve: return 2 * level.edges;
    case tuple_kind::vfe: return 2 * level.corners;
    default: return level.corners;
    }
}
template <counts_elements Level>
std::size_t tuple_count(const Level& level, tuple_kind kind)
{
    return tuple_count(count_elements(level), kind);
}

/// The elements by which conditions and degrees of a column speak of tuples: the vertex, edge or face itself, the
/// corner of (v,f), (e,f) and (v,f,e), the edge of (v,e).
template <tuple_kind Kind, level Level>
auto tuple_elements_of(const Level& level)
{
    if constexpr (Kind == tuple_kind::v)
        return level.vertices();
    else if constexpr (Kind == tuple_kind::e or Kind == tuple_kind::ve)
        return level.edges();
    else if constexpr (Kind == tuple_kind::f)
        return level.faces();
    else
        return level.corners();
}

/// How many tuples of a kind share such an element.
constexpr std::size_t tuples_per_element(tuple_kind kind)
{
    return kind == tuple_kind::ve or kind == tuple_kind::vfe ? 2 : 1;
}

/// That of the tuple with this index. Precondition: index < tuple_count(level, Kind).
template <tuple_kind Kind, level Level>
auto tuple_element(const Level& level, std::size_t index)
{
    return tuple_elements_of<Kind>(level)[index / tuples_per_element(Kind)];
}

/// In place of a count that is not declared; see next_counts.
struct uncounted {};
/// All tuples of a column give birth.
struct everywhere {};
/// All tuples of a column give birth or none, by the form of the scheme.
struct all_or_none {
    bool all;
};
/// All inner tuples give birth, and those at the boundary that a condition picks. how_many(counts): of a level with
/// these counts, how many at the boundary are left out.
template <class Keep, class HowMany = uncounted>
struct inside_or {
    static constexpr bool inner = true;
    Keep keep;
    HowMany how_many;
};
/// Those tuples at the boundary give birth that a condition picks, how_many(counts).
template <class Keep, class HowMany = uncounted>
struct boundary_where {
    static constexpr bool inner = false;
    Keep keep;
    HowMany how_many;
};
/// Those tuples give birth that a condition picks, how_many(counts).
template <class Keep, class HowMany = uncounted>
struct only_where {
    Keep keep;
    HowMany how_many;
};

/// How many tuples lie at the boundary. Of faces there may be fewer than edges.
template <tuple_kind Kind>
    requires(Kind != tuple_kind::f)
constexpr std::uint64_t boundary_tuples(const counts& c)
{
    return tuples_per_element(Kind) * (Kind == tuple_kind::v ? c.boundary_vertices() : c.boundary_edges);
}

/// A column: the tuples of one kind that give birth to new elements of one kind, and for faces their degree.
/// The id of a new element is the base of its column plus the index of its tuple.
/// What a condition picks follows from no column; said by a function of the counts of a level, or a pointer to one of
/// them, it lets levels be counted before they are made (countable_scheme).
template <tuple_kind Kind, class Where = everywhere, class Degree = int>
struct column {
    static constexpr tuple_kind kind = Kind;
    Where where;
    Degree degree;

    /// All tuples if the condition holds, else none.
    [[nodiscard]] constexpr auto when(bool condition) const
    {
        return column<Kind, all_or_none, Degree>{{condition}, degree};
    }
    /// Only inner tuples.
    [[nodiscard]] constexpr auto inside() const
    {
        const auto never = [](const auto&) { return false; };
        if constexpr (Kind == tuple_kind::f)
            return inside_or(never);
        else
            return inside_or(never, &boundary_tuples<Kind>);
    }
    /// Inner tuples, and those at the boundary that `keep` accepts; `left_out` says how many it does not.
    template <class Keep, class LeftOut = uncounted>
    [[nodiscard]] constexpr auto inside_or(Keep keep, LeftOut left_out = {}) const
    {
        return column<Kind, kith::inside_or<Keep, LeftOut>, Degree>{{keep, left_out}, degree};
    }
    /// Tuples at the boundary that `keep` accepts; `picked` says how many.
    template <class Keep, class Picked = uncounted>
    [[nodiscard]] constexpr auto on_boundary(Keep keep, Picked picked = {}) const
    {
        return column<Kind, kith::boundary_where<Keep, Picked>, Degree>{{keep, picked}, degree};
    }
    /// Tuples that `keep` accepts; `picked` says how many.
    template <class Keep, class Picked = uncounted>
    [[nodiscard]] constexpr auto only(Keep keep, Picked picked = {}) const
    {
        return column<Kind, only_where<Keep, Picked>, Degree>{{keep, picked}, degree};
    }
    /// The degree of the new faces as a function of the tuple's element; it may be asked on several threads.
    template <class Of>
    [[nodiscard]] constexpr auto of_degree(Of of) const
    {
        return column<Kind, Where, Of>{where, of};
    }
};

inline constexpr column<tuple_kind::v> per_vertex{};
inline constexpr column<tuple_kind::e> per_edge{};
inline constexpr column<tuple_kind::f> per_face{};
inline constexpr column<tuple_kind::vf> per_corner{};       ///< (v,f)
inline constexpr column<tuple_kind::ve> per_end{};          ///< (v,e)
inline constexpr column<tuple_kind::ef> per_side{};         ///< (e,f)
inline constexpr column<tuple_kind::vfe> per_corner_side{}; ///< (v,f,e)

/// A degree known while compiling.
template <std::size_t N>
struct fixed_degree {
    static constexpr std::size_t value = N;

    constexpr std::size_t operator()(const auto& /*element*/) const { return N; }
};
/// The degree of the face that a new one comes from.
struct same_degree {
    constexpr std::size_t operator()(const face_element auto& f) const { return f.degree(); }
};
/// A column whose new faces are triangles; quads.
template <tuple_kind Kind, class Where, class Degree>
[[nodiscard]] constexpr auto triangles(const column<Kind, Where, Degree>& c)
{
    return c.of_degree(fixed_degree<3>{});
}
template <tuple_kind Kind, class Where, class Degree>
[[nodiscard]] constexpr auto quads(const column<Kind, Where, Degree>& c)
{
    return c.of_degree(fixed_degree<4>{});
}

/// The columns that give birth to vertices, in the order of their numbers; those to edges and to faces.
template <class... Columns>
struct new_vertices {
    static constexpr char makes = 'v';
    std::tuple<Columns...> list;
    constexpr explicit new_vertices(Columns... c) : list(c...) {}
};
template <class... Columns>
struct new_edges {
    static constexpr char makes = 'e';
    std::tuple<Columns...> list;
    constexpr explicit new_edges(Columns... c) : list(c...) {}
};
template <class... Columns>
struct new_faces {
    static constexpr char makes = 'f';
    std::tuple<Columns...> list;
    constexpr explicit new_faces(Columns... c) : list(c...) {}
};

namespace detail {

/// Whether List is new_vertices ('v'), new_edges ('e') or new_faces ('f').
template <class List, char Kind>
concept list_that_makes = requires { requires List::makes == Kind; };

/// Returns the first list of a kind, or `otherwise`.
template <char Kind, class Otherwise>
constexpr auto list_that(Otherwise otherwise)
{
    return otherwise;
}
template <char Kind, class Otherwise, class List, class... Lists>
constexpr auto list_that(Otherwise otherwise, List list, Lists... lists)
{
    if constexpr (list_that_makes<List, Kind>)
        return list;
    else
        return list_that<Kind>(otherwise, lists...);
}
template <char Kind, class Otherwise, class... Lists>
using list_type = decltype(list_that<Kind>(std::declval<Otherwise>(), std::declval<Lists>()...));
template <char Kind, class... Lists>
inline constexpr std::size_t lists_that_make = (std::size_t(list_that_makes<Lists, Kind>) + ... + 0);

} // namespace detail

/// The columns of a scheme: which tuples give birth to vertices, to edges and to faces. The lists stand in any order. A
/// scheme that declares no edges has them found by matching, which is slower and needs nothing else.
template <class Vertices, class Edges, class Faces, class Boundary = uncounted>
struct columns {
    Vertices vertices;
    Edges edges;
    Faces faces;
    Boundary boundary;

    template <class... Lists>
    constexpr explicit columns(Lists... lists)
        : vertices(detail::list_that<'v'>(new_vertices<>(), lists...))
        , edges(detail::list_that<'e'>(new_edges<>(), lists...))
        , faces(detail::list_that<'f'>(new_faces<>(), lists...))
        , boundary()
    {
        using namespace detail;
        constexpr std::size_t v = lists_that_make<'v', Lists...>, e = lists_that_make<'e', Lists...>;
        constexpr std::size_t f = lists_that_make<'f', Lists...>;
        constexpr bool is_mistake = v != 1 or e > 1 or f != 1 or v + e + f != sizeof...(Lists);
        static_cast<void>(diagnostics::columns_of_other_things<is_mistake>());
    }
    constexpr columns(Vertices v, Edges e, Faces f, Boundary b) : vertices(v), edges(e), faces(f), boundary(b) {}

    /// Returns these columns with a function of the counts of a level that says those of the next level's boundary. It
    /// is needed where vertices tell the degree of new faces, see next_counts.
    template <class Of>
    [[nodiscard]] constexpr auto with_boundary(Of of) const
    {
        return columns<Vertices, Edges, Faces, Of>(vertices, edges, faces, of);
    }
};
template <class... Lists>
columns(Lists...)
    -> columns<detail::list_type<'v', new_vertices<>, Lists...>, detail::list_type<'e', new_edges<>, Lists...>,
               detail::list_type<'f', new_faces<>, Lists...>>;

/// What a scheme declares: `columns`.
template <class C>
concept declared_columns = requires(const C& columns) {
    std::tuple_size<std::remove_cvref_t<decltype(columns.vertices.list)>>::value; // of new vertices
    std::tuple_size<std::remove_cvref_t<decltype(columns.edges.list)>>::value; // of new edges; none: they are matched
    std::tuple_size<std::remove_cvref_t<decltype(columns.faces.list)>>::value; // of new faces, each with its degree
};

} // namespace kith
