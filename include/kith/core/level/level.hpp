// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace kith {

/// The handle of an element of a level: a small value. Equal handles name the same element.
template <class H>
concept element_handle = std::copyable<H> and std::equality_comparable<H>;

/// A mesh on which elements walk: oriented polygons that form a manifold with or without a boundary. The mesh must not
/// change during a walk. All functions may be called by several threads, and take O(1).
/// This concept is a single requires-expression, as are other concepts that many templates use: the compiler then
/// caches its result as one.
template <class L>
concept walkable_level = requires(const L& level, typename L::vertex_handle v, typename L::edge_handle e,
                                  typename L::face_handle f, typename L::corner_handle c, std::size_t i) {
    // The coordinates of a vertex, and the type of the indices of the next level.
    requires affine_value<typename L::point_type>;
    requires std::unsigned_integral<typename L::index_type>;
    requires element_handle<typename L::vertex_handle> and element_handle<typename L::edge_handle>;
    requires element_handle<typename L::face_handle> and element_handle<typename L::corner_handle>;
    // True if arithmetic on points may run on several threads.
    { L::parallel } -> std::convertible_to<bool>;
    // The handle that stands for no corner; equal to no other handle.
    { L::no_corner } -> std::convertible_to<typename L::corner_handle>;
    // The elements of each kind are numbered from 0, without gaps.
    { level.vertex_count() } -> std::convertible_to<std::size_t>;
    { level.edge_count() } -> std::convertible_to<std::size_t>;
    { level.face_count() } -> std::convertible_to<std::size_t>;
    { level.corner_count() } -> std::convertible_to<std::size_t>;
    // True if there is no boundary, so that each edge has two corners.
    { level.is_closed() } -> std::convertible_to<bool>;
    // The elements of a kind are those at 0, 1, ... below their count.
    { level.vertex_at(i) } -> std::convertible_to<typename L::vertex_handle>;
    { level.edge_at(i) } -> std::convertible_to<typename L::edge_handle>;
    { level.face_at(i) } -> std::convertible_to<typename L::face_handle>;
    { level.corner_at(i) } -> std::convertible_to<typename L::corner_handle>;
    // The number of an element. The corners of a face have consecutive numbers, face after face.
    { level.index(v) } -> std::convertible_to<std::size_t>;
    { level.index(e) } -> std::convertible_to<std::size_t>;
    { level.index(f) } -> std::convertible_to<std::size_t>;
    { level.index(c) } -> std::convertible_to<std::size_t>;
    // The half-edge that leaves the vertex of a corner inside its face: 2e on the left side of edge e, 2e+1 on its
    // right.
    { level.halfedge(c) } -> std::convertible_to<std::size_t>;
    // The corner at which a fan starts; at the boundary, the corner without a neighbour clockwise.
    { level.first(v) } -> std::convertible_to<typename L::corner_handle>;
    // The corners at which the half-edges of an edge start, on its left and on its right. At the boundary the second is
    // no_corner.
    { level.first(e) } -> std::convertible_to<typename L::corner_handle>;
    { level.second(e) } -> std::convertible_to<typename L::corner_handle>;
    // The first corner of a face, and the number of its corners.
    { level.first(f) } -> std::convertible_to<typename L::corner_handle>;
    { level.degree(f) } -> std::convertible_to<std::size_t>;
    // The next corner of the face, counter-clockwise, and the previous one.
    { level.next(c) } -> std::convertible_to<typename L::corner_handle>;
    { level.prev(c) } -> std::convertible_to<typename L::corner_handle>;
    // The corner of the opposite half-edge, on the edge from c to the next corner; no_corner at the boundary.
    { level.across(c) } -> std::convertible_to<typename L::corner_handle>;
    // The elements to which a corner belongs. Its edge is the one to the next corner.
    { level.vertex_of(c) } -> std::convertible_to<typename L::vertex_handle>;
    { level.edge_of(c) } -> std::convertible_to<typename L::edge_handle>;
    { level.face_of(c) } -> std::convertible_to<typename L::face_handle>;
    { level.point(v) } -> std::convertible_to<typename L::point_type>;
};

template <walkable_level Level> class vertex;
template <walkable_level Level> class edge;
template <walkable_level Level> class face;
template <walkable_level Level> class corner;

/// The letter of the type of an element: v, e, f or c.
template <class T>
inline constexpr char element_letter = '?';
template <walkable_level L>
inline constexpr char element_letter<vertex<L>> = 'v';
template <walkable_level L>
inline constexpr char element_letter<edge<L>> = 'e';
template <walkable_level L>
inline constexpr char element_letter<face<L>> = 'f';
template <walkable_level L>
inline constexpr char element_letter<corner<L>> = 'c';

/// An element of some level.
template <class T>
concept element = element_letter<std::remove_cvref_t<T>> != '?';
template <class T>
concept vertex_element = element_letter<T> == 'v';
template <class T>
concept edge_element = element_letter<T> == 'e';
template <class T>
concept face_element = element_letter<T> == 'f';
template <class T>
concept corner_element = element_letter<T> == 'c';

template <walkable_level Level, element Element> class all_elements;

/// A level as schemes use it, under the name `coarse`: it has ranges of all elements of each kind, for loops.
/// `level_elements` makes a `level` from any walkable level.
template <class L>
concept level = walkable_level<L> and requires(const L& level) {
    { level.vertices() } -> std::same_as<all_elements<L, vertex<L>>>;
    { level.edges() } -> std::same_as<all_elements<L, edge<L>>>;
    { level.faces() } -> std::same_as<all_elements<L, face<L>>>;
    { level.corners() } -> std::same_as<all_elements<L, corner<L>>>;
};

} // namespace kith
