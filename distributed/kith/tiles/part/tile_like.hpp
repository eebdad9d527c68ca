// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile.hpp"

#include <concepts>
#include <cstddef>
#include <ranges>

namespace kith {

/// An array of T that is read.
template <class R, class T>
concept array_of = std::ranges::contiguous_range<const R> and std::same_as<std::ranges::range_value_t<const R>, T> and
                   requires(const R& array, std::size_t i) {
                       { array[i] } -> std::convertible_to<T>;
                       { array.data() } -> std::same_as<const T*>;
                       { array.size() } -> std::convertible_to<std::size_t>;
                       { array.empty() } -> std::convertible_to<bool>;
                   };

/// Some faces of a whole mesh as a native mesh, with what is said of them there: `tile`, which tells what each word
/// means. Faces, edges and vertices are in the order of their numbers in the whole mesh, and start where they start in
/// it.
template <class T>
concept tile_like = requires(const T& part, std::size_t i) {
    { part.mesh } -> std::same_as<const basic_mesh<typename T::point_type, typename T::index_type>&>;
} and requires(const T& part) {
    // The numbers of the elements in the whole mesh.
    requires array_of<std::remove_cvref_t<decltype(part.vertex_ids)>, global_id>;
    requires array_of<std::remove_cvref_t<decltype(part.edge_ids)>, global_id>;
    requires array_of<std::remove_cvref_t<decltype(part.face_ids)>, global_id>;
    // Of the first corner of each face, of the corners before each vertex, and of the marked edges before each edge;
    // each may be empty.
    requires array_of<std::remove_cvref_t<decltype(part.first_corner_ids)>, global_id>;
    requires array_of<std::remove_cvref_t<decltype(part.corners_before)>, global_id>;
    requires array_of<std::remove_cvref_t<decltype(part.marked_before)>, global_id>;
    // Of each element a tile_mark.
    requires array_of<std::remove_cvref_t<decltype(part.vertex_marks)>, unsigned char>;
    requires array_of<std::remove_cvref_t<decltype(part.edge_marks)>, unsigned char>;
    requires array_of<std::remove_cvref_t<decltype(part.face_marks)>, unsigned char>;
    // Of each face the place, among the faces of level 0 from which those here descend, of its own.
    requires array_of<std::remove_cvref_t<decltype(part.root_of)>, typename T::index_type>;
    requires array_of<std::remove_cvref_t<decltype(part.roots)>, global_id>;
} and requires(const T& part, std::size_t i) {
    // The marks in words.
    { part.owns_vertex(i) } -> std::convertible_to<bool>;
    { part.owns_edge(i) } -> std::convertible_to<bool>;
    { part.owns_face(i) } -> std::convertible_to<bool>;
    { part.is_cut(i) } -> std::convertible_to<bool>;
    // The numbers in the whole mesh of a corner of a face, an end of an edge and the face of level 0 above one.
    { part.corner_id(i, i) } -> std::convertible_to<global_id>;
    { part.end_id(i, i) } -> std::convertible_to<global_id>;
    { part.root(i) } -> std::convertible_to<global_id>;
};

} // namespace kith
