// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "averaged_value.hpp"
#include "property_access.hpp"

#include <concepts>
#include <optional>
#include <string>

namespace kith::detail {

/// A type whose constructor without arguments leaves values uninitialized, and whose averaged_value says what is zero.
template <class T>
concept is_left_open = requires {
    { averaged_value<T>::nothing() } -> std::same_as<T>;
};

/// Returns T(), or zero if that is uninitialized, as for the vectors of OpenMesh and for the points and exact numbers
/// of CGAL.
template <class T>
const T& value_of_nothing()
{
    static const T value = [] {
        if constexpr (is_left_open<T>)
            return averaged_value<T>::nothing();
        else
            return T();
    }(); // static memory is cleared before it is constructed
    return value;
}

/// A mesh with a default value per property, which elements without an assigned value have, as in property maps of
/// CGAL.
template <class M>
concept mesh_with_unset_values = mesh_with_properties<M> and requires(const M& mesh) {
    { property_access<M>::with_one_element(mesh) } -> std::same_as<M>;
};

/// The values of elements that inherit nothing: the value of the property on new elements, else T(). If the mesh has to
/// be copied to find such a value, it is copied once for all properties.
template <class M>
class unset_values {
public:
    /// Takes a mesh, which must outlive this.
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

/// Returns a property to write to. Adds it if there is none; unassigned elements then have the value `nothing`, if the
/// mesh supports it.
template <class Handle, class T, class M>
auto add_unset(M& mesh, const std::string& name, const T& nothing)
{
    if constexpr (mesh_with_unset_values<M>)
        return property_access<M>::template add<Handle, T>(mesh, name, nothing);
    else
        return property_access<M>::template add<Handle, T>(mesh, name);
}

} // namespace kith::detail
