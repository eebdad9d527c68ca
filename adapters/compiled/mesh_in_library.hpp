// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/level/validate.hpp>
#include <kith/step/step.hpp>

namespace kith::detail {

template <class M, class Point>
basic_mesh<Point, std::uint32_t> lift_in_library(const M& mesh)
{
    static_assert(is_compiled_mesh<M>, "the adapter says which types of mesh are compiled");
    return lift_here<M, Point>(mesh);
}

template <class M, class Point>
M make_in_library(const M& source, const level_source<Point>& write)
{
    return make_here<Point>(source, write);
}

} // namespace kith::detail

/// KITH_MESH_IN_LIBRARY(mesh): in namespace kith, compiles how meshes of this type are read and made.
#define KITH_MESH_IN_LIBRARY(...)                                                                                      \
    template basic_mesh<lifted_point<__VA_ARGS__>::type> detail::lift_in_library(const __VA_ARGS__&);                  \
    template __VA_ARGS__ detail::make_in_library(const __VA_ARGS__&,                                                   \
                                                 const detail::level_source<lifted_point<__VA_ARGS__>::type>&);
