// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "averaged_value.hpp"
#include "property_access.hpp"
#include "stored_values.hpp"
#include "unset_values.hpp"

#include <kith/base/storage.hpp>

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

/// Whether there are means of values on elements with such handles: at vertices and at corners.
template <class Handle, mesh M>
inline constexpr bool has_means = std::same_as<Handle, typename mesh_traits<M>::vertex> or
                                  std::same_as<Handle, typename mesh_traits<M>::halfedge>;

/// The properties of a mesh on elements with such handles, apart from the mesh and from the types of their values, so
/// that whatever takes them to finer levels is compiled once for all types, and little for each type of mesh and of
/// values. At vertices and corners, which half-edges stand for, what can be averaged is coordinates; the rest goes from
/// an element to its heirs.
template <class Handle, mesh_with_properties M>
class property_values {
    using access = property_access<M>;
    using number = typename access::number;

public:
    using coordinates = four_numbers<number>;

    struct averaged {
        std::string name;
        std::type_index type;
        bool is_unnamed;
        storage<coordinates> values;
        coordinates nothing; ///< which elements have that inherit nothing
        std::unique_ptr<value_exchange> (*write)(M&, const averaged&, const written_places<Handle>&,
                                                 std::span<const coordinates>);
    };
    struct inherited {
        std::string name;
        std::type_index type;
        bool is_unnamed;
        std::unique_ptr<inherited_values> values;
        std::unique_ptr<value_exchange> (*write)(M&, const std::string& name, const written_places<Handle>&,
                                                 const inherited_values&, std::span<const std::uint32_t> heirs);
    };

    /// Cost: O(elements) per property.
    template <class... T>
    property_values(const M& mesh, unset_values<M>& unset, std::tuple<T...>* types)
    {
        if constexpr (is_compiled_mesh<M> and std::same_as<std::tuple<T...>, typename access::value_types>)
            *this = read_in_library(mesh, unset);
        else
            *this = read_here(mesh, unset, types);
    }
    template <class... T>
    static property_values read_here(const M& mesh, unset_values<M>& unset, std::tuple<T...>*)
    {
        property_values result;
        result.handles_ = handles_of<Handle>(mesh);
        const std::vector<std::string> names = access::template names<Handle>(mesh);
        for (auto name = names.begin(); name != names.end(); ++name) {
            if (std::find(names.begin(), name, *name) != name)
                continue;
            // Several properties may have one name, each with another type or with none of its own.
            const auto properties = std::size_t(std::count(name, names.end(), *name));
            std::vector<std::type_index> read;
            if (not access::follows_from_points(*name))
                (result.read<T>(mesh, *name, unset, properties, read), ...);
            result.known_.insert(result.known_.end(), read.size(), *name);
            result.unknown_.insert(result.unknown_.end(), properties - read.size(), *name);
        }
        return result;
    }

    [[nodiscard]] const std::vector<averaged>& means() const { return means_; }
    [[nodiscard]] bool has_heirs() const { return not heirs_.empty() or has_others_; }
    /// Says that own_heirs() is needed for properties that are not here.
    void expect_others() { has_others_ = true; }
    /// The elements of the control mesh, by number.
    [[nodiscard]] const std::vector<Handle>& handles() const { return handles_; }
    /// The names of the properties that are here, and of those that are not: of other types, or made of the points.
    [[nodiscard]] const std::vector<std::string>& known() const { return known_; }
    [[nodiscard]] const std::vector<std::string>& unknown() const { return unknown_; }
    /// The properties that are here, as their library knows them.
    [[nodiscard]] const std::vector<known_property>& found() const { return found_; }

    /// Whether a property is here; `type` as in found().
    [[nodiscard]] bool has(const std::string& name, std::type_index type) const
    {
        return std::ranges::any_of(found_, [&](const auto& each) { return each.name == name and each.type == type; });
    }
    /// Takes the properties of others of the same mesh, too, but those that are here already.
    void add(property_values&& more)
    {
        for (const known_property& each : found_)
            more.leave_out(each.name, each.type);
        const auto append = [](auto& to, auto& from) {
            to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
        };
        append(means_, more.means_);
        append(heirs_, more.heirs_);
        append(known_, more.known_);
        append(found_, more.found_);
    }
    /// Forgets a property if it is here; `type` as in found().
    void leave_out(const std::string& name, std::type_index type)
    {
        if (not has(name, type))
            return;
        const auto is_it = [&](const auto& each) { return each.name == name and each.type == type; };
        std::erase_if(means_, is_it);
        std::erase_if(heirs_, is_it);
        std::erase_if(found_, is_it);
        known_.erase(std::ranges::find(known_, name));
    }
    /// Drops the values of all elements but these, whose numbers ascend.
    void keep(std::span<const std::uint32_t> elements)
    {
        const auto keep_in = [&](auto& values) {
            for (std::size_t i = 0; i < elements.size(); ++i)
                values[i] = values[elements[i]];
        };
        keep_in(handles_);
        handles_.resize(elements.size());
        for (averaged& each : means_) {
            storage<coordinates> kept(elements.size());
            for (std::size_t i = 0; i < kept.size(); ++i)
                kept[i] = each.values[elements[i]];
            each.values = std::move(kept);
        }
        for (inherited& each : heirs_)
            each.values->keep(elements);
    }

    /// Those without a name of their own become unknown ones: in another mesh that name may stand for anything.
    void leave_out_unnamed()
    {
        const auto leave_out = [this](const auto& each) {
            if (not each.is_unnamed)
                return false;
            known_.erase(std::ranges::find(known_, each.name));
            unknown_.push_back(each.name);
            return true;
        };
        std::erase_if(means_, leave_out);
        std::erase_if(heirs_, leave_out);
    }

    /// For the elements of the control mesh: that each inherits from itself.
    [[nodiscard]] storage<std::uint32_t> own_heirs() const
    {
        storage<std::uint32_t> result(handles_.size());
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = std::uint32_t(i + 1);
        return result;
    }
    /// Writes to places of a mesh what they inherit; `swaps` gets how values there are exchanged with others.
    void write_heirs(M& fine, const written_places<Handle>& places, std::span<const std::uint32_t> heirs,
                     std::vector<std::unique_ptr<value_exchange>>* swaps = nullptr) const
    {
        for (const auto& each : heirs_) {
            auto swap = each.write(fine, each.name, places, *each.values, heirs);
            if (swaps != nullptr)
                swaps->push_back(std::move(swap));
        }
    }
    void write_heirs(M& fine, std::span<const std::uint32_t> heirs) const
    {
        if (not heirs_.empty())
            write_heirs(fine, places_in<Handle>(fine), heirs);
    }
    static void write_mean(M& fine, const averaged& mean, std::span<const coordinates> values)
    {
        mean.write(fine, mean, places_in<Handle>(fine), values);
    }

private:
    property_values() = default;
    /// With the usual types, compiled in the library that `is_compiled_mesh` tells of.
    static property_values read_in_library(const M& mesh, unset_values<M>& unset);

    /// Reads the property of this name and type if there is one, and unless as many have been read as there are.
    template <class T>
    void read(const M& mesh, const std::string& name, unset_values<M>& unset, std::size_t properties,
              std::vector<std::type_index>& read_so_far)
    {
        const std::type_index type = typeid(T);
        if (read_so_far.size() == properties or std::ranges::find(read_so_far, type) != read_so_far.end())
            return;
        const auto from = access::template find<Handle, T>(mesh, name);
        if (not from)
            return;
        read_so_far.push_back(type);
        found_.push_back({name, type, nullptr});
        if constexpr (requires { from.array(); })
            found_.back().array = from.array();
        const T nothing = unset.template of<Handle, T>(name);
        if constexpr (has_means<Handle, M> and can_be_averaged<T>)
            means_.push_back({name,
                              type,
                              detail::is_unnamed<M, T>(name),
                              load_averaged<number, T>(from, handles_),
                              averaged_value<T>::template load<number>(nothing),
                              &write_averaged<T>});
        else
            heirs_.push_back({name,
                              type,
                              detail::is_unnamed<M, T>(name),
                              load_inherited<T>(from, handles_, nothing),
                              &write_inherited<T>});
    }
    template <class T>
    static std::unique_ptr<value_exchange> write_averaged(M& fine, const averaged& mean,
                                                          const written_places<Handle>& places,
                                                          std::span<const coordinates> values)
    {
        const T nothing = averaged_value<T>::template store<number>(mean.nothing);
        auto to = add_unset<Handle>(fine, mean.name, nothing);
        store_averaged<number, T>(to, places.elements, values);
        store_nothing(to, places.beside_faces, nothing);
        return exchange_of<T>(to);
    }
    template <class T>
    static std::unique_ptr<value_exchange>
    write_inherited(M& fine, const std::string& name, const written_places<Handle>& places,
                    const inherited_values& values, std::span<const std::uint32_t> heirs)
    {
        const auto& all = static_cast<const inherited_values_of<T>&>(values);
        auto to = add_unset<Handle>(fine, name, all.nothing);
        store_inherited<T>(to, places.elements, all, heirs);
        store_nothing(to, places.beside_faces, all.nothing);
        return exchange_of<T>(to);
    }
    template <class T, class To>
    static std::unique_ptr<value_exchange> exchange_of(To to)
    {
        if constexpr (mesh_with_other_properties<M>)
            return std::make_unique<value_exchange_in<M, Handle, T, To>>(to);
        else
            return nullptr;
    }

    std::vector<Handle> handles_;
    std::vector<averaged> means_;
    std::vector<inherited> heirs_;
    std::vector<std::string> known_, unknown_;
    std::vector<known_property> found_;
    bool has_others_ = false;
};

} // namespace kith::detail
