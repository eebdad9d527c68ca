// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/scheme.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <tuple>

namespace kith {

/// Returns the kind of the elements from whose numbers those of tuples follow: v, e or f. If faces have several degrees
/// (`degree` 0), tuples at corners follow from the first corners of faces, vf.
constexpr tuple_kind numbered_elements(tuple_kind kind, std::size_t degree)
{
    switch (kind) {
    case tuple_kind::v: return tuple_kind::v;
    case tuple_kind::e:
    case tuple_kind::ve: return tuple_kind::e;
    case tuple_kind::f: return tuple_kind::f;
    default: return degree == 0 ? tuple_kind::vf : tuple_kind::f;
    }
}
/// Returns by how much the indices of tuples grow with the number of such an element, if faces have this degree.
constexpr std::size_t tuples_of_each(tuple_kind kind, std::size_t degree)
{
    const bool of_faces = kind != tuple_kind::f and numbered_elements(kind, degree) == tuple_kind::f;
    return tuples_per_element(kind) * (of_faces ? degree : 1);
}

/// The numbering of a step of a whole mesh by columns. The new element of a tuple has the number base + of_each * x +
/// i. Here x is the number of the element to which the tuple belongs, and i counts the tuples of that element.
struct column_bases {
    using by_kind = std::array<std::uint64_t, 7>;
    by_kind vertices{}, edges{}, faces{};
    by_kind vertices_of_each{}, edges_of_each{}, faces_of_each{};
    by_kind corners{}; ///< the first corner of the faces of a column
    by_kind degrees{}; ///< of these faces; 0: each has the degree of the face from which it comes
    by_kind vertex_counts{}, edge_counts{}, face_counts{}; ///< how many elements a column makes

    friend bool operator==(const column_bases&, const column_bases&) = default;

    /// Returns the number where a column begins: of its vertices, edges or faces (`made` is v, e or f), or of the
    /// corners of its faces (vf).
    [[nodiscard]] std::uint64_t base(tuple_kind made, tuple_kind kind) const
    {
        switch (made) {
        case tuple_kind::v: return vertices[std::size_t(kind)];
        case tuple_kind::e: return edges[std::size_t(kind)];
        case tuple_kind::f: return faces[std::size_t(kind)];
        default: return corners[std::size_t(kind)];
        }
    }
    /// Returns the factor `of_each` of a column; `made` as in base().
    [[nodiscard]] std::uint64_t of_each(tuple_kind made, tuple_kind kind) const
    {
        switch (made) {
        case tuple_kind::v: return vertices_of_each[std::size_t(kind)];
        case tuple_kind::e: return edges_of_each[std::size_t(kind)];
        case tuple_kind::f: return faces_of_each[std::size_t(kind)];
        default: return has_corners_of_face(kind) ? 1 : degrees[std::size_t(kind)] * faces_of_each[std::size_t(kind)];
        }
    }
    /// Returns how many vertices, edges or faces (v, e, f) a column makes.
    [[nodiscard]] std::uint64_t count(tuple_kind made, tuple_kind kind) const
    {
        const by_kind& counts = made == tuple_kind::v   ? vertex_counts
                                : made == tuple_kind::e ? edge_counts
                                                        : face_counts;
        return counts[std::size_t(kind)];
    }
    /// Returns true if the new faces of a column have the degrees of the faces from which they come.
    [[nodiscard]] bool has_corners_of_face(tuple_kind kind) const { return degrees[std::size_t(kind)] == 0; }
};

namespace detail {

/// Returns true if the numbers of a column are a base plus a multiple of the element's number, on closed meshes or on
/// all meshes. They are if all tuples are picked, or if marks pick equally many edges or corners of each face.
template <class Column>
constexpr bool is_affine(bool closed)
{
    using where = decltype(Column::where);
    if constexpr (numbers_by_marks<where>)
        return numbered_elements(Column::kind, 1) == tuple_kind::e or
               (Column::kind == tuple_kind::vf or Column::kind == tuple_kind::ef);
    else
        return picks_without_condition<where>(closed);
}
/// True if the numbers of the corners of a column's new faces are affine, too. Then all these faces have one fixed
/// degree, or the degree of their parent face. Faces at vertices, one per vertex, may have the one valence that the
/// scheme states.
template <class Column, bool HasValence>
inline constexpr bool has_affine_corners = fixed_degree_of<decltype(Column::degree)> != 0 or
                                           (Column::kind == tuple_kind::f and
                                            std::same_as<decltype(Column::degree), same_degree>) or
                                           (Column::kind == tuple_kind::v and HasValence);

template <class List>
struct affine_columns;
template <template <class...> class List, class... C>
struct affine_columns<List<C...>> {
    static constexpr bool affine([[maybe_unused]] bool closed) { return (is_affine<C>(closed) and ...); }
    template <bool HasValence>
    static constexpr bool corners = (has_affine_corners<C, HasValence> and ...);
    static constexpr bool by_valence = ((C::kind == tuple_kind::v and fixed_degree_of<decltype(C::degree)> == 0) or
                                        ...);
    static constexpr bool by_marks = (numbers_by_marks<decltype(C::where)> or ...);
};
template <scheme Scheme>
using affine_vertices = affine_columns<decltype(columns_type<Scheme>::vertices)>;
template <scheme Scheme>
using affine_edges = affine_columns<decltype(columns_type<Scheme>::edges)>;
template <scheme Scheme>
using affine_faces = affine_columns<decltype(columns_type<Scheme>::faces)>;

/// Calls f(numbers, i, column) for the i-th of some columns. `numbers` are those of all these columns.
template <class List, class F>
void for_each_base(const List& columns, const counts& coarse, int generation, const F& f)
{
    const auto numbers = counted_columns<List>::count(columns, coarse, generation);
    std::size_t i = 0;
    std::apply([&](const auto&... column) { (f(numbers, i++, column), ...); }, columns.list);
}

} // namespace detail

/// Returns true if the number of each new element is an affine function of the number of an element from which it
/// comes: on meshes without a boundary (`closed`), or on all meshes.
template <scheme Scheme>
constexpr bool numbers_are_affine(bool closed)
{
    return detail::affine_vertices<Scheme>::affine(closed) and detail::affine_edges<Scheme>::affine(closed) and
           detail::affine_faces<Scheme>::affine(closed);
}
/// True if the numbers of all elements and corners are affine functions on meshes without a boundary.
template <scheme Scheme>
inline constexpr bool has_affine_numbers =
    numbers_are_affine<Scheme>(true) and detail::affine_faces<Scheme>::template corners<traits_of<Scheme>.valence != 0>;
/// True if the valences of vertices are the degrees of some new faces.
template <scheme Scheme>
inline constexpr bool has_faces_by_valence = detail::affine_faces<Scheme>::by_valence;
/// True if marks decide which tuples are picked, from the first refined level on. There the marked edges come first.
template <scheme Scheme>
inline constexpr bool has_numbers_by_marks = detail::affine_vertices<Scheme>::by_marks or
                                             detail::affine_edges<Scheme>::by_marks or
                                             detail::affine_faces<Scheme>::by_marks;

/// Returns the numbering of a step from a mesh with these counts. Precondition: numbers are affine there. Cost: O(1).
template <countable_scheme Scheme>
column_bases bases_of_columns(const Scheme& scheme, const counts& coarse, int generation)
{
    const auto columns = columns_of(scheme, generation);
    constexpr std::size_t degree = numbering_of<Scheme, std::uint32_t>::common_degree;
    column_bases result;
    const auto to = [&](column_bases::by_kind& bases, column_bases::by_kind& of_each, column_bases::by_kind& counts) {
        return [&]<tuple_kind Kind, class W, class D>(const auto& numbers, std::size_t i, const column<Kind, W, D>& c) {
            const auto kind = std::size_t(Kind);
            bases[kind] = numbers.base(i);
            counts[kind] = numbers.count(i);
            of_each[kind] = tuples_of_each(Kind, degree);
            if constexpr (detail::numbers_by_marks<W>) {
                const std::uint64_t marked = c.where.keep.marked(coarse, generation);
                if constexpr (numbered_elements(Kind, 1) == tuple_kind::e)
                    bases[kind] -= c.where.keep.picked(0, marked); // the picked ones follow one another
                else
                    of_each[kind] = c.where.keep.before(tuples_of_each(Kind, degree), marked);
            }
        };
    };
    detail::for_each_base(
        columns.vertices, coarse, generation, to(result.vertices, result.vertices_of_each, result.vertex_counts));
    detail::for_each_base(
        columns.edges, coarse, generation, to(result.edges, result.edges_of_each, result.edge_counts));
    detail::for_each_base(
        columns.faces, coarse, generation, to(result.faces, result.faces_of_each, result.face_counts));
    detail::for_each_base(
        columns.faces,
        coarse,
        generation,
        [&]<tuple_kind Kind, class W, class D>(const auto& numbers, std::size_t i, const column<Kind, W, D>&) {
            const auto kind = std::size_t(Kind);
            const bool by_valence = Kind == tuple_kind::v and detail::fixed_degree_of<D> == 0;
            result.corners[kind] = numbers.first_corner_in(i);
            result.degrees[kind] = by_valence ? std::uint64_t(traits_of<Scheme>.valence) : detail::fixed_degree_of<D>;
        });
    return result;
}

/// Returns true if the next level has as many corners as its columns say. If valences are degrees of new faces, this
/// level must also be closed and have the valence that the scheme states. Precondition: `fine` are the counts of the
/// next level.
template <countable_scheme Scheme>
bool agree_on_corners(const Scheme& scheme, const counts& coarse, const counts& fine, int generation)
{
    const auto columns = columns_of(scheme, generation);
    const auto faces = detail::counted_columns<decltype(columns.faces)>::count(columns.faces, coarse, generation);
    if constexpr (has_faces_by_valence<Scheme>)
        if (coarse.boundary_edges != 0 or coarse.corners() != traits_of<Scheme>.valence * coarse.vertices)
            return false;
    return faces.total_corners() == fine.corners();
}

} // namespace kith
