// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "averaged_value.hpp"
#include "number_conversion.hpp"
#include "property_access.hpp"
#include "standard_property.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

namespace kith {

/// A report on the properties of a mesh that was converted, by the names they had there.
struct conversion_report {
    std::vector<std::string> carried;
    /// The carried properties, and "points", whose values the new mesh cannot all hold exactly, such as doubles in
    /// floats.
    std::vector<std::string> narrowed;
    std::vector<omission> left_out;
};

namespace detail {

/// Returns the elements of one kind in their order. Half-edges are in the order of the edges, first the side that
/// directs the edge or, if that has no face, the other one.
template <class Handle, mesh M>
std::vector<Handle> all_handles(const M& mesh)
{
    using traits = mesh_traits<M>;
    if constexpr (std::same_as<Handle, typename traits::halfedge>) {
        std::vector<Handle> result;
        for (const auto e : traits::edges(mesh)) {
            const Handle directs = traits::halfedge_of(mesh, e), other = traits::opposite(mesh, directs);
            const bool is_first = not traits::is_boundary(mesh, directs);
            result.push_back(is_first ? directs : other);
            result.push_back(is_first ? other : directs);
        }
        return result;
    } else {
        return handles_of<Handle>(mesh);
    }
}

/// A copier of the properties on elements of one kind to a mesh with the same elements.
template <class FromHandle, class ToHandle, mesh_with_properties From, mesh_with_properties To>
class property_copier {
    using from_access = property_access<From>;
    using to_access = property_access<To>;
    /// The type of numbers for the conversion: exact if one of the meshes has exact numbers.
    using number = std::conditional_t<std::floating_point<typename from_access::number>, typename to_access::number,
                                      typename from_access::number>;

public:
    property_copier(const From& from, To& to, conversion_report& report)
        : from_(from)
        , to_(to)
        , report_(report)
        , from_handles_(all_handles<FromHandle>(from))
        , to_handles_(all_handles<ToHandle>(to))
    {
    }

    template <class... T>
    void copy_all(std::tuple<T...>*)
    {
        const std::vector<std::string> names = from_access::template names<FromHandle>(from_);
        for (auto name = names.begin(); name != names.end(); ++name) {
            if (std::find(names.begin(), name, *name) != name)
                continue;
            const standard_property which = meaning_of(*name);
            const one_property one{*name, to_access::template standard_name<ToHandle>(which), which};
            // Several may have one name, each with another type.
            const auto properties = std::size_t(std::count(name, names.end(), *name));
            std::vector<std::type_index> copied;
            (copy_once<T>(one, properties, copied), ...);
            for (std::size_t left = copied.size(); left < properties; ++left)
                leave_out(*name,
                          is_unnamed<From>(*name)
                              ? "it has a default name, which may mean anything in the new mesh; give it a name"
                              : "kith does not know its type; name the type: convert<mesh, type>(...)");
        }
    }

private:
    struct one_property {
        std::string name;
        std::string standard_name; ///< what the new library calls it, if it does
        standard_property which;
    };
    static standard_property meaning_of(const std::string& name)
    {
        using enum standard_property;
        for (const standard_property which : {color, normal, texture_coordinates})
            if (from_access::template standard_name<FromHandle>(which) == name)
                return which;
        return none;
    }
    template <standard_property Which>
    using own_type = typename to_access::template standard_type<Which>;
    template <class T, standard_property Which>
    static constexpr bool is_own = std::is_void_v<own_type<Which>> or std::same_as<T, own_type<Which>>;

    /// Copies the property of this type, unless all properties of its name have been copied.
    template <class T>
    void copy_once(const one_property& one, std::size_t properties, std::vector<std::type_index>& copied)
    {
        const std::type_index type = typeid(T);
        if (copied.size() < properties and std::ranges::find(copied, type) == copied.end() and
            not is_unnamed<From>(one.name, type) and copy<T>(one))
            copied.push_back(type);
    }
    /// Copies a property if it has this type, and if is_free() does not leave it out. Returns true if it has this type.
    template <class T>
    bool copy(const one_property& one)
    {
        const auto from = from_access::template find<FromHandle, T>(from_, one.name);
        if (not from)
            return false;
        using enum standard_property;
        constexpr std::array own{is_own<T, color>, is_own<T, normal>, is_own<T, texture_coordinates>};
        const bool is_standard = not one.standard_name.empty();
        const bool keeps_type = not is_standard or own[std::size_t(one.which)];
        if constexpr (can_be_averaged<T> and not std::is_arithmetic_v<T>)
            if (not keeps_type) {
                numbers_of_values<number> values{{}, numbers_of_values<number>::template rounded<T>};
                for (const FromHandle x : from_handles_)
                    values.values.push_back(averaged_value<T>::template load<number>(from[x]));
                copy_numbers(values, one);
                return true;
            }
        const std::string& to_name = is_standard and keeps_type ? one.standard_name : one.name;
        if (is_free(one.name, to_name, bool(to_access::template find<ToHandle, T>(to_, to_name)))) {
            auto to = to_access::template add<ToHandle, T>(to_, to_name);
            for (std::size_t i = 0; i < from_handles_.size(); ++i)
                to[to_handles_[i]] = from[from_handles_[i]];
        }
        return true;
    }
    void copy_numbers(const numbers_of_values<number>& values, const one_property& one)
    {
        using enum standard_property;
        if (one.which == color)
            write<own_type<color>>(values, one);
        else if (one.which == normal)
            write<own_type<normal>>(values, one);
        else
            write<own_type<texture_coordinates>>(values, one);
    }
    template <class Own>
    void write(const numbers_of_values<number>& values, const one_property& one)
    {
        if (not is_free(
                one.name, one.standard_name, bool(to_access::template find<ToHandle, Own>(to_, one.standard_name))))
            return;
        const number_conversion<number> rule{
            one.which == standard_property::color, values.round, numbers_of_values<number>::template rounded<Own>};
        auto to = to_access::template add<ToHandle, Own>(to_, one.standard_name);
        bool is_exact = true;
        for (std::size_t i = 0; i < to_handles_.size(); ++i) {
            to[to_handles_[i]] = averaged_value<Own>::template store<number>(rule.convert(values.values[i]));
            is_exact = is_exact and rule.is_exact(values.values[i]);
        }
        if (not is_exact)
            report_.narrowed.push_back(one.name);
    }
    template <class Own>
        requires std::is_void_v<Own>
    void write(const numbers_of_values<number>&, const one_property&) // a mesh that takes any type
    {
    }
    /// Returns true if the new mesh has room for a property of this name, and notes it as carried. Otherwise notes it
    /// as left out.
    bool is_free(const std::string& name, const std::string& to_name, bool is_there_in_its_type)
    {
        const auto there = to_access::template names<ToHandle>(to_);
        const auto made = std::ranges::find(made_, to_name, &made_property::name);
        const bool is_shared = made != made_.end() and made->from == name and not is_there_in_its_type and
                               requires { requires to_access::types_share_names; };
        std::string why;
        if (to_access::is_reserved(to_name))
            why = "the new mesh reserves that name";
        else if (made != made_.end() and not is_shared)
            why = "another property is now named '" + to_name + "'";
        else if (std::ranges::find(there, to_name) != there.end() and not is_there_in_its_type and not is_shared)
            why = "the new mesh has '" + to_name + "' in another type";
        if (not why.empty()) {
            leave_out(name, std::move(why));
            return false;
        }
        made_.push_back({to_name, name});
        report_.carried.push_back(name);
        return true;
    }
    struct made_property {
        std::string name, from;
    };
    void leave_out(const std::string& name, std::string why) { report_.left_out.push_back({name, std::move(why)}); }

    const From& from_;
    To& to_;
    conversion_report& report_;
    std::vector<FromHandle> from_handles_;
    std::vector<ToHandle> to_handles_;
    std::vector<made_property> made_;
};

template <class... More, mesh From, mesh To>
void copy_properties(const From& from, To& to, conversion_report& report)
{
    using from_traits = mesh_traits<From>;
    using to_traits = mesh_traits<To>;
    const auto for_each_kind = [](const auto& f) {
        f(typename from_traits::vertex(), typename to_traits::vertex());
        f(typename from_traits::halfedge(), typename to_traits::halfedge());
        f(typename from_traits::edge(), typename to_traits::edge());
        f(typename from_traits::face(), typename to_traits::face());
    };
    for_each_kind([&]<class FromHandle, class ToHandle>(FromHandle, ToHandle) {
        if constexpr (mesh_with_properties<From> and mesh_with_properties<To>) {
            using types = decltype(std::tuple_cat(std::declval<typename property_access<From>::value_types>(),
                                                  std::declval<typename property_access<To>::value_types>(),
                                                  std::declval<std::tuple<More...>>()));
            property_copier<FromHandle, ToHandle, From, To>(from, to, report).copy_all(static_cast<types*>(nullptr));
        } else if constexpr (mesh_with_properties<From>) {
            for (const std::string& name : property_access<From>::template names<FromHandle>(from))
                report.left_out.push_back({name, "the new mesh has no properties; property_mesh has"});
        }
    });
    if constexpr (requires { property_access<From>::names_of_whole(from); }) {
        if constexpr (std::same_as<From, To>) {
            for (const std::string& name : property_access<From>::copy_of_whole(from, to, report.carried))
                report.left_out.push_back({name, "kith does not know its type; name the type"});
        } else {
            for (const std::string& name : property_access<From>::names_of_whole(from))
                report.left_out.push_back({name, "it belongs to the whole mesh, and the new mesh has another type"});
        }
    }
}

} // namespace detail

} // namespace kith
