// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace kith {

/// Names an element of a level: a small value. Equal handles name the same element.
template <class H>
concept element_handle = std::copyable<H> and std::equality_comparable<H>;

/// What elements walk on: a mesh of oriented polygons, a manifold with or without a boundary, which stays as it is
/// while it is walked on. All functions may be called by several threads, and take O(1).
/// One requires-expression, here and in other concepts that many templates ask for: the compiler looks its answer up as
/// one.
template <class L>
concept walkable_level = requires(const L& level, typename L::vertex_handle v, typename L::edge_handle e,
                                  typename L::face_handle f, typename L::corner_handle c, std::size_t i) {
    // The coordinates of a vertex; what numbers the elements of the next level.
    requires affine_value<typename L::point_type>;
    requires std::unsigned_integral<typename L::index_type>;
    requires element_handle<typename L::vertex_handle> and element_handle<typename L::edge_handle>;
    requires element_handle<typename L::face_handle> and element_handle<typename L::corner_handle>;
    // Whether arithmetic on points may run on several threads.
    { L::parallel } -> std::convertible_to<bool>;
    // In place of a corner where there is none; equal to no other.
    { L::no_corner } -> std::convertible_to<typename L::corner_handle>;
    // Each kind of elements is numbered from 0, without gaps.
    { level.vertex_count() } -> std::convertible_to<std::size_t>;
    { level.edge_count() } -> std::convertible_to<std::size_t>;
    { level.face_count() } -> std::convertible_to<std::size_t>;
    { level.corner_count() } -> std::convertible_to<std::size_t>;
    // There is no boundary: each edge has two corners.
    { level.is_closed() } -> std::convertible_to<bool>;
    // All elements of a kind are those at 0, 1, ... below its count.
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
    // Where a fan starts: at the boundary where nothing lies clockwise.
    { level.first(v) } -> std::convertible_to<typename L::corner_handle>;
    // The corners on the left and on the right of an edge, from which it leaves; at the boundary the second is
    // no_corner.
    { level.first(e) } -> std::convertible_to<typename L::corner_handle>;
    { level.second(e) } -> std::convertible_to<typename L::corner_handle>;
    // Where a face starts, and how many corners it has.
    { level.first(f) } -> std::convertible_to<typename L::corner_handle>;
    { level.degree(f) } -> std::convertible_to<std::size_t>;
    // Counter-clockwise around the face, and back.
    { level.next(c) } -> std::convertible_to<typename L::corner_handle>;
    { level.prev(c) } -> std::convertible_to<typename L::corner_handle>;
    // The other corner of the edge from c to the next; no_corner at the boundary.
    { level.across(c) } -> std::convertible_to<typename L::corner_handle>;
    // The elements that a corner belongs to; its edge is the one to the next corner.
    { level.vertex_of(c) } -> std::convertible_to<typename L::vertex_handle>;
    { level.edge_of(c) } -> std::convertible_to<typename L::edge_handle>;
    { level.face_of(c) } -> std::convertible_to<typename L::face_handle>;
    { level.point(v) } -> std::convertible_to<typename L::point_type>;
};

template <walkable_level Level> class vertex;
template <walkable_level Level> class edge;
template <walkable_level Level> class face;
template <walkable_level Level> class corner;

/// v, e, f or c.
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

/// What a scheme calls `coarse`: a level that says its elements, for loops over all of one kind. `level_elements` makes
/// one of any walkable level.
template <class L>
concept level = walkable_level<L> and requires(const L& level) {
    { level.vertices() } -> std::same_as<all_elements<L, vertex<L>>>;
    { level.edges() } -> std::same_as<all_elements<L, edge<L>>>;
    { level.faces() } -> std::same_as<all_elements<L, face<L>>>;
    { level.corners() } -> std::same_as<all_elements<L, corner<L>>>;
};

} // namespace kith
