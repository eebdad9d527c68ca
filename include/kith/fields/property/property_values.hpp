// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "typed_properties.hpp"

#include <kith/core/base/storage.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

namespace kith::detail {

/// The properties of a mesh on elements with such handles, independent of the mesh and of the types of their values.
/// Code that takes them to finer levels is compiled once for all types. At vertices and corners, for which half-edges
/// stand, values that can be averaged are kept as coordinates. All other values go from an element to its heirs.
template <class Handle, mesh_with_properties M>
class property_values {
    using access = property_access<M>;
    using base = property_base<M>;

public:
    using averaged = averaged_property<Handle, typename base::type>;
    using inherited = inherited_property<Handle, typename base::type>;
    using coordinates = typename averaged::coordinates;

    /// Reads the properties of these types. Cost: O(elements) per property.
    template <class... T>
    property_values(const M& mesh, unset_values<M>& unset, std::tuple<T...>* types) : handles_(handles_of<Handle>(mesh))
    {
        const std::vector<std::string> names = access::template names<Handle>(mesh);
        for (auto name = names.begin(); name != names.end(); ++name) {
            if (std::find(names.begin(), name, *name) != name)
                continue;
            // Several properties may have one name, each with another type or with none of its own.
            const auto properties = std::size_t(std::count(name, names.end(), *name));
            const std::size_t read = access::follows_from_points(*name)
                                         ? 0
                                         : this->read(mesh, *name, properties, unset, types);
            known_.insert(known_.end(), read, *name);
            unknown_.insert(unknown_.end(), properties - read, *name);
        }
    }

    [[nodiscard]] const std::vector<averaged>& means() const { return typed_.means; }
    [[nodiscard]] bool has_heirs() const { return not typed_.heirs.empty() or has_others_; }
    /// Notes that own_heirs() is needed for properties that are not here.
    void expect_others() { has_others_ = true; }
    /// Returns the elements of the control mesh, by number.
    [[nodiscard]] const std::vector<Handle>& handles() const { return handles_; }
    /// Returns the names of the properties that are here; unknown() returns the others: of other types, or made of the
    /// points.
    [[nodiscard]] const std::vector<std::string>& known() const { return known_; }
    [[nodiscard]] const std::vector<std::string>& unknown() const { return unknown_; }
    /// Returns the properties that are here, as their library knows them.
    [[nodiscard]] const std::vector<known_property>& found() const { return typed_.found; }

    /// Returns true if a property is here; `type` as in found().
    [[nodiscard]] bool has(const std::string& name, std::type_index type) const
    {
        return std::ranges::any_of(typed_.found,
                                   [&](const auto& each) { return each.name == name and each.type == type; });
    }
    /// Takes over properties of the same mesh from another object, except those that are here already.
    void add(property_values&& more)
    {
        for (const known_property& each : typed_.found)
            more.leave_out(each.name, each.type);
        const auto append = [](auto& to, auto& from) {
            to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
        };
        append(typed_.means, more.typed_.means);
        append(typed_.heirs, more.typed_.heirs);
        append(known_, more.known_);
        append(typed_.found, more.typed_.found);
    }
    /// Forgets a property if it is here; `type` as in found().
    void leave_out(const std::string& name, std::type_index type)
    {
        if (not has(name, type))
            return;
        const auto is_it = [&](const auto& each) { return each.name == name and each.type == type; };
        std::erase_if(typed_.means, is_it);
        std::erase_if(typed_.heirs, is_it);
        std::erase_if(typed_.found, is_it);
        known_.erase(std::ranges::find(known_, name));
    }
    /// Drops the values of all elements but these, whose numbers are increasing.
    void keep(std::span<const std::uint32_t> elements)
    {
        const auto keep_in = [&](auto& values) {
            for (std::size_t i = 0; i < elements.size(); ++i)
                values[i] = values[elements[i]];
        };
        keep_in(handles_);
        handles_.resize(elements.size());
        for (averaged& each : typed_.means) {
            storage<coordinates> kept(elements.size());
            for (std::size_t i = 0; i < kept.size(); ++i)
                kept[i] = each.values[elements[i]];
            each.values = std::move(kept);
        }
        for (inherited& each : typed_.heirs)
            each.values->keep(elements);
    }

    /// Moves properties without a name of their own to unknown(): in another mesh their name may stand for anything.
    void leave_out_unnamed()
    {
        const auto leave_out = [this](const auto& each) {
            if (not is_unnamed<M>(each.name, each.type))
                return false;
            known_.erase(std::ranges::find(known_, each.name));
            unknown_.push_back(each.name);
            return true;
        };
        std::erase_if(typed_.means, leave_out);
        std::erase_if(typed_.heirs, leave_out);
    }

    /// Returns the heirs of the control mesh, where each element inherits from itself.
    [[nodiscard]] storage<std::uint32_t> own_heirs() const
    {
        storage<std::uint32_t> result(handles_.size());
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = std::uint32_t(i + 1);
        return result;
    }
    /// Writes inherited values to places of a mesh. `swaps` gets the exchange of the values of each property.
    void write_heirs(M& fine, const written_places<Handle>& places, std::span<const std::uint32_t> heirs,
                     std::vector<std::unique_ptr<value_exchange>>* swaps = nullptr) const
    {
        for (const inherited& each : typed_.heirs) {
            request(fine, each.name, each.type);
            auto swap = each.write(base::of(fine), each, places, heirs);
            if (swaps != nullptr)
                swaps->push_back(std::move(swap));
        }
    }
    void write_heirs(M& fine, std::span<const std::uint32_t> heirs) const
    {
        if (not typed_.heirs.empty())
            write_heirs(fine, places_in<Handle>(fine), heirs);
    }
    /// Writes a property of means() to places of a mesh. Returns the exchange of its values.
    static std::unique_ptr<value_exchange>
    write_mean(M& fine, const averaged& mean, const written_places<Handle>& places, std::span<const coordinates> values)
    {
        request(fine, mean.name, mean.type);
        return mean.write(base::of(fine), mean, places, values);
    }
    static void write_mean(M& fine, const averaged& mean, std::span<const coordinates> values)
    {
        write_mean(fine, mean, places_in<Handle>(fine), values);
    }

private:
    /// Reads the properties of this name. Returns how many were read.
    template <class... T>
    std::size_t read(const M& mesh, const std::string& name, std::size_t properties, unset_values<M>& unset,
                     std::tuple<T...>* types)
    {
        using type = typename base::type;
        const auto read = [&](unset_values<type>& unset_there) {
            if constexpr (has_compiled_properties<type> and
                          std::same_as<std::tuple<T...>, typename property_access<type>::value_types>)
                return read_in_library(typed_, base::of(mesh), name, properties, handles_, unset_there);
            else
                return typed_.read(base::of(mesh), name, properties, handles_, unset_there, types);
        };
        if constexpr (std::same_as<type, M>) {
            return read(unset);
        } else {
            unset_values<type> unset_there(base::of(mesh));
            return read(unset_there);
        }
    }
    /// Prepares the mesh for a property that will be written.
    static void request([[maybe_unused]] M& mesh, [[maybe_unused]] const std::string& name,
                        [[maybe_unused]] std::type_index type)
    {
        if constexpr (requires { access::template request<Handle>(mesh, name, type); })
            access::template request<Handle>(mesh, name, type);
    }

    std::vector<Handle> handles_;
    typed_properties<Handle, typename base::type> typed_;
    std::vector<std::string> known_, unknown_;
    bool has_others_ = false;
};

} // namespace kith::detail
