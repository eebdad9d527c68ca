// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/engine/neighbourhood/affine_columns.hpp>
#include <kith/engine/neighbourhood/descents.hpp>
#include <kith/numbering/association/columns.hpp>
#include <kith/numbering/association/numbering.hpp>
#include <kith/numbering/step/scheme.hpp>

#include <algorithm>
#include <tuple>

namespace kith {

namespace detail {

template <class List>
inline constexpr bool has_columns_at_boundary = false;
template <template <class...> class List, class... C>
inline constexpr bool has_columns_at_boundary<List<C...>> = (picks_at_boundary<decltype(C::where)> or ...);

} // namespace detail

/// The trait of schemes, and of their columns, whose tiles need `tile::corners_before`: Doo-Sabin, mid-edge.
template <class T>
inline constexpr bool numbers_corners_at_vertices = false;
template <declared_columns Columns>
inline constexpr bool numbers_corners_at_vertices<Columns> =
    detail::affine_columns<decltype(Columns::faces)>::by_valence;
template <scheme Scheme>
inline constexpr bool numbers_corners_at_vertices<Scheme> = numbers_corners_at_vertices<columns_type<Scheme>>;

/// The trait of schemes that mark some edges, by `is_marked(edge)` of their traits(), and whose tiles need
/// `tile::marked_before`: 4-8. The first column of edges must be that of the unmarked edges, whose new edges are the
/// marked ones of the next level. So marks are counted on level 0 only, where tiles are cut. On later levels the marked
/// edges come first.
template <scheme Scheme>
inline constexpr bool marks_edges = detail::affine_vertices<Scheme>::by_marks;

/// The trait of schemes whose numbers depend on the boundary of the whole mesh.
template <scheme Scheme>
inline constexpr bool numbers_boundary = numbers_corners_at_vertices<Scheme> or
                                         detail::has_columns_at_boundary<decltype(columns_type<Scheme>::vertices)> or
                                         detail::has_columns_at_boundary<decltype(columns_type<Scheme>::edges)> or
                                         detail::has_columns_at_boundary<decltype(columns_type<Scheme>::faces)>;

namespace detail {

/// Returns the rank of the parents of a column's elements in closed meshes: 0 faces and corners, 1 edges, 2 vertices,
/// -1 if the column makes nothing there.
template <class Column>
constexpr int rank_of_parents()
{
    if constexpr (requires { decltype(Column::where)::inner; })
        if constexpr (not decltype(Column::where)::inner)
            return -1;
    switch (parent_kind(Column::kind)) {
    case element_kind::face: return 0;
    case element_kind::edge: return 1;
    default: return 2;
    }
}
template <class... Columns>
constexpr bool come_from_faces_first(const std::tuple<Columns...>*)
{
    int before = 0;
    bool result = true;
    for (const int rank : {rank_of_parents<Columns>()..., 2}) {
        result = result and (rank < 0 or rank >= before);
        before = std::max(before, rank);
    }
    return result;
}
template <class... Columns>
constexpr bool come_from_no_vertices(const std::tuple<Columns...>*)
{
    return ((rank_of_parents<Columns>() != 2) and ...);
}

} // namespace detail

/// Requirements of a scheme by which, in closed meshes, the owner of an element owns its descendants. It holds if all
/// new faces come from faces. Otherwise two conditions must hold. No new edges and vertices come from vertices. Faces
/// that come from faces have the smallest numbers, then those from edges. The first face around an element then has the
/// element's own ancestor.
template <class Scheme>
concept owners_keep_descendants =
    detail::come_from_faces(static_cast<const decltype(columns_type<Scheme>::faces.list)*>(nullptr)) or
    (detail::come_from_faces_first(static_cast<const decltype(columns_type<Scheme>::faces.list)*>(nullptr)) and
     detail::come_from_no_vertices(static_cast<const decltype(columns_type<Scheme>::vertices.list)*>(nullptr)) and
     detail::come_from_no_vertices(static_cast<const decltype(columns_type<Scheme>::edges.list)*>(nullptr)));

} // namespace kith
