// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/level/named_level.hpp>
#include <kith/level/lift.hpp>
#include <kith/property/property_values.hpp>
#include <kith/step/step.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kith::detail {

template <mesh M, class Point>
basic_mesh<Point, std::uint32_t> lift_in_library(const M& mesh)
{
    static_assert(is_compiled_mesh<M>, "the adapter says which types of mesh are compiled");
    return lift_here<M, Point>(mesh);
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

template <class Handle, class Base>
std::size_t read_in_library(typed_properties<Handle, Base>& properties_read, const Base& mesh, const std::string& name,
                            std::size_t properties, const std::vector<Handle>& handles, unset_values<Base>& unset)
{
    static_assert(has_compiled_properties<Base>, "the adapter says which of them are compiled");
    using types = typename property_access<Base>::value_types;
    return properties_read.read(mesh, name, properties, handles, unset, static_cast<types*>(nullptr));
}

} // namespace kith::detail

/// KITH_READ_MESH_IN_LIBRARY(mesh): in namespace kith, compiles how meshes of this type are read.
/// KITH_MESH_IN_LIBRARY(mesh): also how such meshes are made.
/// KITH_PROPERTIES_IN_LIBRARY(mesh, base): how properties are read that such a base has on the elements of this mesh.
#define KITH_READ_MESH_IN_LIBRARY(...)                                                                                 \
    template basic_mesh<lifted_point<__VA_ARGS__>::type> detail::lift_in_library(const __VA_ARGS__&);                  \
    template numbers_in_mesh detail::read_numbers_in_library(const __VA_ARGS__&);
#define KITH_MESH_IN_LIBRARY(...)                                                                                      \
    KITH_READ_MESH_IN_LIBRARY(__VA_ARGS__)                                                                             \
    template __VA_ARGS__ detail::make_in_library(const __VA_ARGS__&,                                                   \
                                                 const detail::level_source<lifted_point<__VA_ARGS__>::type>&);
#define KITH_PROPERTIES_IN_LIBRARY(mesh, base)                                                                         \
    KITH_PROPERTIES_ON(vertex, mesh, base)                                                                             \
    KITH_PROPERTIES_ON(halfedge, mesh, base)                                                                           \
    KITH_PROPERTIES_ON(edge, mesh, base)                                                                               \
    KITH_PROPERTIES_ON(face, mesh, base)
#define KITH_PROPERTIES_ON(element, mesh, base)                                                                        \
    template std::size_t detail::read_in_library(typed_properties<mesh_traits<mesh>::element, base>&,                  \
                                                 const base&,                                                          \
                                                 const std::string&,                                                   \
                                                 std::size_t,                                                          \
                                                 const std::vector<mesh_traits<mesh>::element>&,                       \
                                                 unset_values<base>&);
