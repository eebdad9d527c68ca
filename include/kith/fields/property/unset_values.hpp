// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "averaged_value.hpp"
#include "property_access.hpp"

#include <concepts>
#include <optional>
#include <string>

namespace kith::detail {

/// Values that a constructor without arguments leaves open, and that say themselves what is zero.
template <class T>
concept is_left_open = requires {
    { averaged_value<T>::nothing() } -> std::same_as<T>;
};

/// T(), zero where its constructor leaves it open, as those of OpenMesh's vectors and of CGAL's points and exact
/// numbers do.
template <class T>
const T& value_of_nothing()
{
    static const T value = [] {
        if constexpr (is_left_open<T>)
            return averaged_value<T>::nothing();
        else
            return T();
    }(); // what is static is cleared before it is constructed
    return value;
}

/// Meshes whose properties have a default value each for elements without an assigned one, as property maps of CGAL
/// have.
template <class M>
concept mesh_with_unset_values = mesh_with_properties<M> and requires(const M& mesh) {
    { property_access<M>::with_one_element(mesh) } -> std::same_as<M>;
};

/// What elements have that inherit nothing: what the property has on new elements, else T(). Where the mesh has to be
/// copied to find that out, once for all properties.
template <class M>
class unset_values {
public:
    /// The mesh must outlive it.
    explicit unset_values(const M& mesh) : mesh_(&mesh) {}

    template <class Handle, class T>
    [[nodiscard]] T of(const std::string& name)
    {
        if constexpr (mesh_with_unset_values<M>)
            if constexpr (property_access<M>::template starts_with_a_value<T>) {
                if (not one_of_each_)
                    one_of_each_ = property_access<M>::with_one_element(*mesh_);
                return property_access<M>::template find<Handle, T>(*one_of_each_, name)[Handle(0)];
            }
        return value_of_nothing<T>();
    }

private:
    const M* mesh_;
    std::optional<M> one_of_each_;
};

/// Returns a property to write to. Adds it if there is none; `nothing` is then the value of unassigned elements.
template <class Handle, class T, class M>
auto add_unset(M& mesh, const std::string& name, const T& nothing)
{
    if constexpr (mesh_with_unset_values<M>)
        return property_access<M>::template add<Handle, T>(mesh, name, nothing);
    else
        return property_access<M>::template add<Handle, T>(mesh, name);
}

} // namespace kith::detail
