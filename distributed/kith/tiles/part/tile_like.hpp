// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile.hpp"

#include <concepts>
#include <cstddef>
#include <ranges>

namespace kith {

/// Requirements of a readable array of T.
template <class R, class T>
concept array_of = std::ranges::contiguous_range<const R> and std::same_as<std::ranges::range_value_t<const R>, T> and
                   requires(const R& array, std::size_t i) {
                       { array[i] } -> std::convertible_to<T>;
                       { array.data() } -> std::same_as<const T*>;
                       { array.size() } -> std::convertible_to<std::size_t>;
                       { array.empty() } -> std::convertible_to<bool>;
                   };

/// Requirements of some faces of a whole mesh as a native mesh, with their global numbers and marks. `tile` is the
/// model and explains each member. Faces, edges and vertices are in the order of their global numbers, and start where
/// they start in the whole mesh.
template <class T>
concept tile_like = requires(const T& part, std::size_t i) {
    { part.mesh } -> std::same_as<const basic_mesh<typename T::point_type, typename T::index_type>&>;
} and requires(const T& part) {
    // The numbers of the elements in the whole mesh.
    requires array_of<std::remove_cvref_t<decltype(part.vertex_ids)>, global_id>;
    requires array_of<std::remove_cvref_t<decltype(part.edge_ids)>, global_id>;
    requires array_of<std::remove_cvref_t<decltype(part.face_ids)>, global_id>;
    // The number of the first corner of each face, the number of corners before each vertex, and the number of marked
    // edges before each edge; each array may be empty.
    requires array_of<std::remove_cvref_t<decltype(part.first_corner_ids)>, global_id>;
    requires array_of<std::remove_cvref_t<decltype(part.corners_before)>, global_id>;
    requires array_of<std::remove_cvref_t<decltype(part.marked_before)>, global_id>;
    // A tile_mark of each element.
    requires array_of<std::remove_cvref_t<decltype(part.vertex_marks)>, unsigned char>;
    requires array_of<std::remove_cvref_t<decltype(part.edge_marks)>, unsigned char>;
    requires array_of<std::remove_cvref_t<decltype(part.face_marks)>, unsigned char>;
    // For each face the index in `roots` of the face of level 0 from which it descends.
    requires array_of<std::remove_cvref_t<decltype(part.root_of)>, typename T::index_type>;
    requires array_of<std::remove_cvref_t<decltype(part.roots)>, global_id>;
} and requires(const T& part, std::size_t i) {
    // The marks as functions.
    { part.owns_vertex(i) } -> std::convertible_to<bool>;
    { part.owns_edge(i) } -> std::convertible_to<bool>;
    { part.owns_face(i) } -> std::convertible_to<bool>;
    { part.is_cut(i) } -> std::convertible_to<bool>;
    // The global numbers of a corner of a face, of an end of an edge, and of the ancestor of a face on level 0.
    { part.corner_id(i, i) } -> std::convertible_to<global_id>;
    { part.end_id(i, i) } -> std::convertible_to<global_id>;
    { part.root(i) } -> std::convertible_to<global_id>;
};

} // namespace kith
