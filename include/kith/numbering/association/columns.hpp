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

/// The kinds of tuples of incident elements; thesis table 4.1. Each such tuple has an index: the number of the element
/// for (v), (e) and (f); a corner for (v,f) and (e,f); an end of an edge (2e+s) for (v,e); a corner and a side of it
/// (2c+s) for (v,f,e). Adjacent vertices (v1,v2) and adjacent faces (f1,f2) are the edge between them.
enum class tuple_kind : unsigned char { v, e, f, vf, ve, ef, vfe };

/// The numbers of elements of each kind on a level.
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

/// Returns the number of tuples of a kind on a level.
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

/// Returns the elements to which conditions and degrees of a column refer: the vertex, edge or face itself; the corner
/// of (v,f), (e,f) and (v,f,e); the edge of (v,e).
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

/// Returns the number of tuples of a kind that share such an element.
constexpr std::size_t tuples_per_element(tuple_kind kind)
{
    return kind == tuple_kind::ve or kind == tuple_kind::vfe ? 2 : 1;
}

/// Returns the element of the tuple with this index. Precondition: index < tuple_count(level, Kind).
template <tuple_kind Kind, level Level>
auto tuple_element(const Level& level, std::size_t index)
{
    return tuple_elements_of<Kind>(level)[index / tuples_per_element(Kind)];
}

/// A stand-in for a count that is not declared; see next_counts.
struct uncounted {};
/// The condition of a column of which all tuples make an element.
struct everywhere {};
/// The condition of a column of which all tuples make an element or none, by the form of the scheme.
struct all_or_none {
    bool all;
};
/// The condition of a column of which inner tuples make an element, and the boundary tuples that `keep` picks.
/// how_many(counts) is the number of boundary tuples that are left out on a level with these counts.
template <class Keep, class HowMany = uncounted>
struct inside_or {
    static constexpr bool inner = true;
    Keep keep;
    HowMany how_many;
};
/// The condition of a column of which the boundary tuples that `keep` picks make an element, how_many(counts) in all.
template <class Keep, class HowMany = uncounted>
struct boundary_where {
    static constexpr bool inner = false;
    Keep keep;
    HowMany how_many;
};
/// The condition of a column of which the tuples that `keep` picks make an element, how_many(counts) in all.
template <class Keep, class HowMany = uncounted>
struct only_where {
    Keep keep;
    HowMany how_many;
};

/// Returns the number of boundary tuples. Faces are excluded: fewer of them than edges may lie at the boundary.
template <tuple_kind Kind>
    requires(Kind != tuple_kind::f)
constexpr std::uint64_t boundary_tuples(const counts& c)
{
    return tuples_per_element(Kind) * (Kind == tuple_kind::v ? c.boundary_vertices() : c.boundary_edges);
}

/// A column: the tuples of one kind that make new elements of one kind, and for faces their degree. The id of a new
/// element is the base of its column plus the index of its tuple. No column tells how many tuples a condition picks. A
/// function of the counts of a level, or a pointer to one of them, can state it. Then levels can be counted before they
/// are made (countable_scheme).
template <tuple_kind Kind, class Where = everywhere, class Degree = int>
struct column {
    static constexpr tuple_kind kind = Kind;
    Where where;
    Degree degree;

    /// Returns a column with all tuples if the condition holds, else with none.
    [[nodiscard]] constexpr auto when(bool condition) const
    {
        return column<Kind, all_or_none, Degree>{{condition}, degree};
    }
    /// Returns a column with inner tuples only.
    [[nodiscard]] constexpr auto inside() const
    {
        const auto never = [](const auto&) { return false; };
        if constexpr (Kind == tuple_kind::f)
            return inside_or(never);
        else
            return inside_or(never, &boundary_tuples<Kind>);
    }
    /// Returns a column with inner tuples and boundary tuples that `keep` accepts; `left_out` counts the others.
    template <class Keep, class LeftOut = uncounted>
    [[nodiscard]] constexpr auto inside_or(Keep keep, LeftOut left_out = {}) const
    {
        return column<Kind, kith::inside_or<Keep, LeftOut>, Degree>{{keep, left_out}, degree};
    }
    /// Returns a column with the boundary tuples that `keep` accepts; `picked` says how many.
    template <class Keep, class Picked = uncounted>
    [[nodiscard]] constexpr auto on_boundary(Keep keep, Picked picked = {}) const
    {
        return column<Kind, kith::boundary_where<Keep, Picked>, Degree>{{keep, picked}, degree};
    }
    /// Returns a column with the tuples that `keep` accepts; `picked` says how many.
    template <class Keep, class Picked = uncounted>
    [[nodiscard]] constexpr auto only(Keep keep, Picked picked = {}) const
    {
        return column<Kind, only_where<Keep, Picked>, Degree>{{keep, picked}, degree};
    }
    /// Returns a column with the degree of its faces as a function of the tuple's element, called on several threads.
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

/// A degree known at compile time.
template <std::size_t N>
struct fixed_degree {
    static constexpr std::size_t value = N;

    constexpr std::size_t operator()(const auto& /*element*/) const { return N; }
};
/// The degree of the face from which a new face comes.
struct same_degree {
    constexpr std::size_t operator()(const face_element auto& f) const { return f.degree(); }
};
/// Returns a column whose new faces are triangles; quads() returns one whose new faces are quads.
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

/// The columns that make vertices, in the order of their numbers; new_edges and new_faces are those of edges and faces.
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

/// A list of columns of one kind: new_vertices ('v'), new_edges ('e') or new_faces ('f').
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

/// The columns of a scheme: the tuples that make vertices, edges and faces. The lists stand in any order. If a scheme
/// declares no edges, they are found by matching, which is slower and needs nothing else.
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

    /// Returns these columns with a function that computes the boundary counts of the next level from the counts of a
    /// level. It is needed if vertices determine the degree of new faces, see next_counts.
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

/// The columns that a scheme declares: `columns`.
template <class C>
concept declared_columns = requires(const C& columns) {
    std::tuple_size<std::remove_cvref_t<decltype(columns.vertices.list)>>::value; // of new vertices
    std::tuple_size<std::remove_cvref_t<decltype(columns.edges.list)>>::value; // of new edges; none: they are matched
    std::tuple_size<std::remove_cvref_t<decltype(columns.faces.list)>>::value; // of new faces, each with its degree
};

} // namespace kith
