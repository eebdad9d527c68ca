// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/fields/property/property_values.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace kith::detail {

template <class Handle, class Base>
std::size_t read_in_library(typed_properties<Handle, Base>& properties_read, const Base& mesh, const std::string& name,
                            std::size_t properties, const std::vector<Handle>& handles, unset_values<Base>& unset)
{
    static_assert(has_compiled_properties<Base>, "the adapter says which of them are compiled");
    using types = typename property_access<Base>::value_types;
    return properties_read.read(mesh, name, properties, handles, unset, static_cast<types*>(nullptr));
}

} // namespace kith::detail

/// Instantiates, in namespace kith, the functions that read properties which the class `base` holds on the elements of
/// `mesh`: vertices, half-edges, edges and faces.
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
