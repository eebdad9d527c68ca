// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/association/columns.hpp>
#include <kith/association/numbering.hpp>
#include <kith/neighbourhood/affine_columns.hpp>
#include <kith/step/scheme.hpp>

namespace kith {

namespace detail {

template <class List>
inline constexpr bool has_columns_at_boundary = false;
template <template <class...> class List, class... C>
inline constexpr bool has_columns_at_boundary<List<C...>> = (picks_at_boundary<decltype(C::where)> or ...);

} // namespace detail

/// A scheme whose tiles need `tile::corners_before`: Doo-Sabin, mid-edge.
template <scheme Scheme>
inline constexpr bool numbers_corners_at_vertices = has_faces_by_valence<Scheme>;

/// A scheme that tells marked edges from others, by `is_marked(edge)` of its traits(), and whose tiles need
/// `tile::marked_before`: 4-8. Its first column of edges has to be that of the unmarked ones, which are the marked ones
/// of the next level. So marks are counted on level 0 only, where tiles are cut; from then on the marked edges are
/// those that come first.
template <scheme Scheme>
inline constexpr bool marks_edges = detail::affine_vertices<Scheme>::by_marks;

/// A scheme whose numbers depend on the boundary of the whole mesh.
template <scheme Scheme>
inline constexpr bool numbers_boundary = numbers_corners_at_vertices<Scheme> or
                                         detail::has_columns_at_boundary<decltype(columns_type<Scheme>::vertices)> or
                                         detail::has_columns_at_boundary<decltype(columns_type<Scheme>::edges)> or
                                         detail::has_columns_at_boundary<decltype(columns_type<Scheme>::faces)>;

} // namespace kith
