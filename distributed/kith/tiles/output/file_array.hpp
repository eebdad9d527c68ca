// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/fields/field.hpp>
#include <kith/numbering/step/level_state.hpp>
#include <kith/tiles/part/checksum.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// An array of values at the elements of a file: vertices, faces or, if the format can hold them, corners.
struct file_array {
    std::string name;
    field_on on;
    std::string type;                 ///< of its numbers, in VTK's notation
    std::size_t numbers;              ///< per value
    std::size_t bytes;                ///< per value
    std::vector<std::string> words{}; ///< the words that the values stand for, if they are numbers of words
};

/// The values of a tile for one array: of all its elements, in their order.
using value_bytes = std::span<const std::byte>;

/// A field of a scheme with its name in files. `find(scheme)` returns the field of any scheme of the type.
template <class Find>
struct named_field {
    std::string name;
    Find find;
};
/// Returns field number I of a scheme with_fields, named `name`.
template <std::size_t I>
auto field_named(std::string name)
{
    const auto find = [](const auto& scheme) -> const auto& { return scheme.template field<I>(); };
    return named_field<decltype(find)>{std::move(name), find};
}

namespace detail {

template <class T>
inline constexpr std::size_t numbers_of = std::is_arithmetic_v<T> ? 1 : 0;
template <class T, std::size_t N>
inline constexpr std::size_t numbers_of<std::array<T, N>> = std::is_arithmetic_v<T> ? N : 0;

template <class T>
struct number_type {
    using type = T;
};
template <class T, std::size_t N>
struct number_type<std::array<T, N>> {
    using type = T;
};

template <class T>
std::string vtk_word()
{
    const std::string bits = std::to_string(8 * sizeof(T));
    return (std::floating_point<T> ? "Float" : std::unsigned_integral<T> ? "UInt" : "Int") + bits;
}

template <scheme Scheme, class Find>
file_array array_of(const named_field<Find>& named)
{
    using field_type = std::remove_cvref_t<std::invoke_result_t<const Find&, const Scheme&>>;
    using value = typename field_type::value_type;
    constexpr bool has_place = field_type::where == field_on::vertices or field_type::where == field_on::faces;
    static_assert(
        has_place,
        "a VTU file has room for values at points and at cells; fields on edges and corners have no place there");
    static_assert(numbers_of<value> != 0 and sizeof(value) <= 8 * numbers_of<value>,
                  "a VTU file holds numbers of up to eight bytes and std::array of them; make such a field of others");
    return {
        named.name, field_type::where, vtk_word<typename number_type<value>::type>(), numbers_of<value>, sizeof(value)};
}

} // namespace detail

/// Returns the arrays of a file to which fields of schemes of this type are written.
template <scheme Scheme, class... Find>
std::vector<file_array> arrays_of(const named_field<Find>&... fields)
{
    return {detail::array_of<Scheme>(fields)...};
}
/// Returns the values of a scheme for these arrays.
template <scheme Scheme, class... Find>
std::vector<value_bytes> values_of(const Scheme& scheme, const named_field<Find>&... fields)
{
    return {std::as_bytes(fields.find(scheme).values())...};
}

namespace detail {

/// Returns the number of the elements of a tile on which a field may have values, and their name in the plural.
template <tile_like Tile>
std::pair<std::size_t, const char*> elements_of(const Tile& part, field_on where)
{
    if (where == field_on::vertices)
        return {part.mesh.vertex_count(), "vertices"};
    return where == field_on::faces ? std::pair(part.mesh.face_count(), "faces")
                                    : std::pair(part.mesh.corner_count(), "corners");
}

/// Calls f(global number, first byte of the value) for each element that the tile owns.
template <tile_like Tile, class F>
void for_each_owned_value(const Tile& part, const file_array& array, value_bytes values, const F& f)
{
    const auto at = [&](std::size_t element) { return values.data() + array.bytes * element; };
    if (array.on == field_on::vertices) {
        for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v)
            if (part.owns_vertex(v))
                f(part.vertex_ids[v], at(v));
        return;
    }
    for (std::size_t face = 0, corner = 0; face < part.mesh.face_count(); ++face) {
        const std::size_t degree = part.mesh.face(face).size();
        if (part.owns_face(face) and array.on == field_on::faces)
            f(part.face_ids[face], at(face));
        else if (part.owns_face(face))
            for (std::size_t k = 0; k < degree; ++k)
                f(part.corner_id(face, k), at(corner + k));
        corner += degree;
    }
}

} // namespace detail

/// Throws mesh_error unless there is a value for each vertex, face or corner of the tile in each array.
template <tile_like Tile>
void require_values(const Tile& part, const std::vector<file_array>& arrays, std::span<const value_bytes> values)
{
    if (values.size() != arrays.size())
        throw mesh_error("a file has " + std::to_string(arrays.size()) + " arrays of values, a tile has " +
                         std::to_string(values.size()) + "; give those of all arrays, in their order");
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        const auto [elements, name] = detail::elements_of(part, arrays[i].on);
        if (values[i].size() != arrays[i].bytes * elements)
            throw mesh_error("the field \"" + arrays[i].name + "\" has " +
                             std::to_string(values[i].size() / arrays[i].bytes) + " values in a tile of " +
                             std::to_string(elements) + " " + name +
                             "; give it values on the control mesh, and refine the last level with its edges");
    }
}

/// Returns the checksum of the values at all elements that a tile owns. It is a sum over the elements, as that of a
/// mesh, so the sum over all tiles does not depend on the tiles.
template <tile_like Tile>
mesh_checksum checksum_of_values(const Tile& part, const std::vector<file_array>& arrays,
                                 std::span<const value_bytes> values)
{
    mesh_checksum sum;
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        const std::size_t size = arrays[i].bytes;
        detail::for_each_owned_value(part, arrays[i], values[i], [&](global_id id, const std::byte* value) {
            detail::word_hash hash(id);
            hash.add(i);
            for (std::size_t at = 0; at < size; at += 8) {
                std::uint64_t word = 0;
                std::memcpy(&word, value + at, std::min<std::size_t>(8, size - at));
                hash.add(word);
            }
            sum += {hash.bits()};
        });
    }
    return sum;
}

} // namespace kith
