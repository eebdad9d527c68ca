// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_elements.hpp"
#include "native_level.hpp"

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/core/mesh/mesh_traits.hpp>

#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith {

/// The numbers that a mesh itself gives to its elements, in the order of the elements. Removed elements may be counted
/// in them.
struct numbers_in_mesh {
    std::vector<std::size_t> vertices, edges, faces;
};

namespace detail {

template <mesh M>
numbers_in_mesh read_numbers(const M& mesh)
{
    const auto read = [&mesh](auto&& range, std::vector<std::size_t>& numbers) {
        for (const auto x : range)
            numbers.push_back(std::size_t(mesh_traits<M>::index(mesh, x)));
    };
    numbers_in_mesh result;
    read(mesh_traits<M>::vertices(mesh), result.vertices);
    read(mesh_traits<M>::edges(mesh), result.edges);
    read(mesh_traits<M>::faces(mesh), result.faces);
    return result;
}

/// Returns read_numbers(mesh); it is compiled in the library that `is_compiled_mesh` stands for.
template <mesh M>
numbers_in_mesh read_numbers_in_library(const M& mesh);

template <mesh M>
numbers_in_mesh handle_numbers_of(const M& mesh)
{
    if constexpr (is_compiled_mesh<M>)
        return read_numbers_in_library(mesh);
    else if constexpr (mesh_with_compiled_view<M>)
        return handle_numbers_of(static_cast<const typename compiled_view<M>::type&>(compiled_view<M>::of(mesh)));
    else
        return read_numbers(mesh);
}

} // namespace detail

/// The level of a native mesh that was made from another mesh. In messages, it names elements by their numbers in that
/// other mesh. So functions over levels are compiled for native levels only.
template <class Point, std::unsigned_integral Index>
class level_with_numbers : public native_level<Point, Index, 0> {
    using native = native_level<Point, Index, 0>;

public:
    /// Takes the native mesh and the numbers of its elements. Preconditions: those of native_level, and one number for
    /// each element.
    level_with_numbers(const basic_mesh<Point, Index>& lifted, numbers_in_mesh numbers)
        : native(lifted), numbers_(std::move(numbers))
    {
    }

    [[nodiscard]] std::size_t number_in_mesh(typename native::vertex_handle v) const
    {
        return numbers_.vertices[v.value];
    }
    [[nodiscard]] std::size_t number_in_mesh(typename native::edge_handle e) const { return numbers_.edges[e.value]; }
    [[nodiscard]] std::size_t number_in_mesh(typename native::face_handle f) const { return numbers_.faces[f.value]; }

private:
    numbers_in_mesh numbers_;
};
template <class Point, std::unsigned_integral Index>
using named_level = level_elements<level_with_numbers<Point, Index>>;

} // namespace kith
