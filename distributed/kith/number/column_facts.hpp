// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/step/scheme.hpp>
#include <kith/association/columns.hpp>
#include <kith/association/numbering.hpp>
#include <kith/part/tile.hpp>

#include <concepts>

namespace kith {

namespace detail {

/// Picks tuples anywhere, by marks of edges, and says how many: `before(n, m)` is how many of the tuples before the
/// n-th of the whole mesh it picks, with m marked edges before that of the n-th.
template <class Where>
concept picks_by_marks = requires(const Where& where, global_id n) {
    { where.keep.before(n, n) } -> std::same_as<global_id>;
    { where.keep.picked(n, n) } -> std::same_as<global_id>;
};

template <class List>
struct column_facts;
template <template <class...> class List, class... C>
struct column_facts<List<C...>> {
    static constexpr bool any_by_marks = (picks_by_marks<decltype(C::where)> or ...);
    static constexpr bool any_at_boundary = (picks_at_boundary<decltype(C::where)> or ...);
    static constexpr bool any_of_faces_at_vertex = ((C::kind == tuple_kind::v and
                                                     fixed_degree_of<decltype(C::degree)> == 0) or
                                                    ...);
};

} // namespace detail

/// A scheme whose tiles need `tile::corners_before`: Doo-Sabin, mid-edge.
template <scheme Scheme>
inline constexpr bool numbers_corners_at_vertices =
    detail::column_facts<decltype(columns_type<Scheme>::faces)>::any_of_faces_at_vertex;

/// A scheme that tells marked edges from others, by `is_marked(edge)` of its traits(), and whose tiles need
/// `tile::marked_before`: 4-8. Its first column of edges has to be that of the unmarked ones, which are the marked ones
/// of the next level. So marks are counted on level 0 only, where tiles are cut; from then on the marked edges are
/// those that come first.
template <scheme Scheme>
inline constexpr bool marks_edges = detail::column_facts<decltype(columns_type<Scheme>::vertices)>::any_by_marks;

/// A scheme whose numbers depend on the boundary of the whole mesh.
template <scheme Scheme>
inline constexpr bool numbers_boundary =
    numbers_corners_at_vertices<Scheme> or
    detail::column_facts<decltype(columns_type<Scheme>::vertices)>::any_at_boundary or
    detail::column_facts<decltype(columns_type<Scheme>::edges)>::any_at_boundary or
    detail::column_facts<decltype(columns_type<Scheme>::faces)>::any_at_boundary;

} // namespace kith
