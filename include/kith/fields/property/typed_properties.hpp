// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "averaged_value.hpp"
#include "property_access.hpp"
#include "stored_values.hpp"
#include "unset_values.hpp"

#include <kith/core/base/storage.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <typeindex>
#include <vector>

// Only this is compiled for each type of values. It knows only the base that has the properties, which meshes of many
// types may have in common.

namespace kith::detail {

/// True if values on elements with such handles are averaged: at vertices and at corners.
template <class Handle, class M>
inline constexpr bool has_means = std::same_as<Handle, typename mesh_traits<M>::vertex> or
                                  std::same_as<Handle, typename mesh_traits<M>::halfedge>;

/// A property whose values are averaged, as up to four coordinates.
template <class Handle, class Base>
struct averaged_property {
    using coordinates = four_numbers<typename property_access<Base>::number>;

    std::string name;
    std::type_index type;
    storage<coordinates> values;
    coordinates nothing; ///< the value of elements that inherit nothing
    std::unique_ptr<value_exchange> (*write)(Base&, const averaged_property&, const written_places<Handle>&,
                                             std::span<const coordinates>);
};

/// A property whose values go from an element to its heirs.
template <class Handle, class Base>
struct inherited_property {
    std::string name;
    std::type_index type;
    std::unique_ptr<inherited_values> values;
    std::unique_ptr<value_exchange> (*write)(Base&, const inherited_property&, const written_places<Handle>&,
                                             std::span<const std::uint32_t> heirs);
};

/// The properties on elements with such handles that were read by their types.
template <class Handle, class Base>
class typed_properties {
    using access = property_access<Base>;
    using number = typename access::number;

public:
    using averaged = averaged_property<Handle, Base>;
    using inherited = inherited_property<Handle, Base>;

    /// Reads the properties of this name and of these types. Returns how many they are. `properties` is how many have
    /// the name; some of them may have other types. Cost: O(elements) for each.
    template <class... T>
    std::size_t read([[maybe_unused]] const Base& mesh, [[maybe_unused]] const std::string& name,
                     [[maybe_unused]] std::size_t properties, [[maybe_unused]] const std::vector<Handle>& handles,
                     [[maybe_unused]] unset_values<Base>& unset, std::tuple<T...>*)
    {
        std::vector<std::type_index> read;
        (read_one<T>(mesh, name, properties, handles, unset, read), ...);
        return read.size();
    }

    std::vector<averaged> means;
    std::vector<inherited> heirs;
    std::vector<known_property> found;

private:
    template <class T>
    void read_one(const Base& mesh, const std::string& name, std::size_t properties, const std::vector<Handle>& handles,
                  unset_values<Base>& unset, std::vector<std::type_index>& read)
    {
        const std::type_index type = typeid(T);
        if (read.size() == properties or std::ranges::find(read, type) != read.end())
            return;
        const auto from = access::template find<Handle, T>(mesh, name);
        if (not from)
            return;
        read.push_back(type);
        found.push_back({name, type, nullptr});
        if constexpr (requires { from.array(); })
            found.back().array = from.array();
        const T nothing = unset.template of<Handle, T>(name);
        if constexpr (has_means<Handle, Base> and can_be_averaged<T>)
            means.push_back({name,
                             type,
                             load_averaged<number, T>(from, handles),
                             averaged_value<T>::template load<number>(nothing),
                             &write_averaged<T>});
        else
            heirs.push_back({name, type, load_inherited<T>(from, handles, nothing), &write_inherited<T>});
    }
    template <class T>
    static std::unique_ptr<value_exchange> write_averaged(Base& fine, const averaged& mean,
                                                          const written_places<Handle>& places,
                                                          std::span<const typename averaged::coordinates> values)
    {
        const T nothing = averaged_value<T>::template store<number>(mean.nothing);
        auto to = add_unset<Handle>(fine, mean.name, nothing);
        store_averaged<number, T>(to, places.elements, values);
        store_nothing(to, places.beside_faces, nothing);
        return exchange_of<Base, Handle, T>(to);
    }
    template <class T>
    static std::unique_ptr<value_exchange> write_inherited(Base& fine, const inherited& each,
                                                           const written_places<Handle>& places,
                                                           std::span<const std::uint32_t> heirs)
    {
        const auto& all = static_cast<const inherited_values_of<T>&>(*each.values);
        auto to = add_unset<Handle>(fine, each.name, all.nothing);
        store_inherited<T>(to, places.elements, all, heirs);
        store_nothing(to, places.beside_faces, all.nothing);
        return exchange_of<Base, Handle, T>(to);
    }
};

/// True for bases whose properties of the usual types are compiled in a library, as their header tells.
template <class Base>
inline constexpr bool has_compiled_properties = false;

/// Reads properties as typed_properties::read does with the usual types, compiled in the library of the base.
template <class Handle, class Base>
std::size_t read_in_library(typed_properties<Handle, Base>& properties_read, const Base& mesh, const std::string& name,
                            std::size_t properties, const std::vector<Handle>& handles, unset_values<Base>& unset);

} // namespace kith::detail
