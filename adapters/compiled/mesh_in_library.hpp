// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/to_native.hpp>
#include <kith/core/level/named_level.hpp>
#include <kith/numbering/step/step.hpp>

#include <cstdint>

namespace kith::detail {

template <mesh M, class Point>
basic_mesh<Point, std::uint32_t> to_native_in_library(const M& mesh)
{
    static_assert(is_compiled_mesh<M>, "the adapter says which types of mesh are compiled");
    return to_native_here<M, Point>(mesh);
}

template <mesh M>
numbers_in_mesh read_numbers_in_library(const M& mesh)
{
    return read_numbers(mesh);
}

template <fillable_mesh M, class Point>
M make_in_library(const M& source, const level_source<Point>& write)
{
    return make_here<Point>(source, write);
}

} // namespace kith::detail

/// Instantiates, in namespace kith, the functions that read meshes of a type (KITH_READ_MESH_IN_LIBRARY), or the
/// functions that read and make such meshes (KITH_MESH_IN_LIBRARY).
#define KITH_READ_MESH_IN_LIBRARY(...)                                                                                 \
    template basic_mesh<lifted_point<__VA_ARGS__>::type> detail::to_native_in_library(const __VA_ARGS__&);             \
    template numbers_in_mesh detail::read_numbers_in_library(const __VA_ARGS__&);
#define KITH_MESH_IN_LIBRARY(...)                                                                                      \
    KITH_READ_MESH_IN_LIBRARY(__VA_ARGS__)                                                                             \
    template __VA_ARGS__ detail::make_in_library(const __VA_ARGS__&,                                                   \
                                                 const detail::level_source<lifted_point<__VA_ARGS__>::type>&);
