// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "averaged_value.hpp"
#include "property_access.hpp"

#include <kith/base/storage.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace kith::detail {

/// T(), which elements have that inherit nothing; zero where its constructor leaves it open, as those of OpenMesh's vectors do.
template <class T>
const T& value_of_nothing()
{
    static const T value = T(); // what is static is cleared before it is constructed
    return value;
}

/// What elements have from one element of the control mesh each, of any type.
struct inherited_values {
    virtual ~inherited_values() = default;
};
template <class T>
struct inherited_values_of final : inherited_values {
    std::vector<T> values;
};

template <class T, class From, class Handle>
std::unique_ptr<const inherited_values> load_inherited(const From& from, const std::vector<Handle>& handles)
{
    auto* const result = new inherited_values_of<T>();
    std::unique_ptr<const inherited_values> owned(result);
    result->values.reserve(handles.size());
    for (const Handle x : handles)
        result->values.push_back(from[x]);
    return owned;
}
/// heirs: one more than the number of the element that each has its value from, 0 for those that have T().
template <class T, class To, class Handle>
void store_inherited(To to, const std::vector<Handle>& handles, const inherited_values& all,
                     std::span<const std::uint32_t> heirs)
{
    const std::vector<T>& values = static_cast<const inherited_values_of<T>&>(all).values;
    for (std::size_t i = 0; i < handles.size(); ++i)
        to[handles[i]] = heirs[i] == 0 ? value_of_nothing<T>() : T(values[heirs[i] - 1]);
}

template <class Number, class T, class From, class Handle>
storage<four_numbers<Number>> load_averaged(const From& from, const std::vector<Handle>& handles)
{
    storage<four_numbers<Number>> result(handles.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = averaged_value<T>::template load<Number>(from[handles[i]]);
    return result;
}
template <class Number, class T, class To, class Handle>
void store_averaged(To to, const std::vector<Handle>& handles, std::span<const four_numbers<Number>> values)
{
    for (std::size_t i = 0; i < handles.size(); ++i)
        to[handles[i]] = averaged_value<T>::template store<Number>(values[i]);
}

template <class Handle, mesh M>
std::vector<Handle> handles_of(const M& mesh)
{
    std::vector<Handle> result;
    for_each_handle<Handle>(mesh, [&](Handle x) { result.push_back(x); });
    return result;
}

/// The properties of a mesh on elements with such handles, apart from the mesh and from the types of their values, so that
/// whatever takes them to finer levels is compiled once for all types, and little for each type of mesh and of values. At
/// vertices and corners, which half-edges stand for, what can be averaged is coordinates; the rest goes from an element to its
/// heirs.
template <class Handle, mesh_with_properties M>
class property_values {
    using traits = mesh_traits<M>;
    using access = property_access<M>;
    using number = typename access::number;
    static constexpr bool has_means = std::same_as<Handle, typename traits::halfedge> or
                                      std::same_as<Handle, typename traits::vertex>;

public:
    using coordinates = four_numbers<number>;

    struct averaged {
        std::string name;
        storage<coordinates> values;
        void (*write)(M&, const std::string& name, const std::vector<Handle>&, std::span<const coordinates>);
    };
    struct inherited {
        std::string name;
        std::unique_ptr<const inherited_values> values;
        void (*write)(M&, const std::string& name, const std::vector<Handle>&, const inherited_values&,
                      std::span<const std::uint32_t> heirs);
    };

    /// Cost: O(elements) per property.
    template <class... T>
    property_values(const M& mesh, std::tuple<T...>* types)
    {
        if constexpr (is_compiled_mesh<M> and std::same_as<std::tuple<T...>, typename access::value_types>)
            *this = read_in_library(mesh);
        else
            *this = read_here(mesh, types);
    }
    template <class... T>
    static property_values read_here(const M& mesh, std::tuple<T...>*)
    {
        property_values result;
        result.handles_ = handles_of<Handle>(mesh);
        for (const std::string& name : access::template names<Handle>(mesh)) {
            const bool is_known = not access::follows_from_points(name) and (result.read<T>(mesh, name) or ...);
            (is_known ? result.known_ : result.unknown_).push_back(name);
        }
        return result;
    }

    [[nodiscard]] const std::vector<averaged>& means() const { return means_; }
    [[nodiscard]] bool has_heirs() const { return not heirs_.empty(); }
    /// The names of the properties that are here, and of those that are not: of other types, or made of the points.
    [[nodiscard]] const std::vector<std::string>& known() const { return known_; }
    [[nodiscard]] const std::vector<std::string>& unknown() const { return unknown_; }

    /// For the elements of the control mesh: that each inherits from itself.
    [[nodiscard]] storage<std::uint32_t> own_heirs() const
    {
        storage<std::uint32_t> result(handles_.size());
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = std::uint32_t(i + 1);
        return result;
    }
    void write_heirs(M& fine, std::span<const std::uint32_t> heirs) const
    {
        if (not has_heirs())
            return;
        const auto handles = handles_of<Handle>(fine);
        for (const auto& each : heirs_)
            each.write(fine, each.name, handles, *each.values, heirs);
    }
    static void write_mean(M& fine, const averaged& mean, std::span<const coordinates> values)
    {
        mean.write(fine, mean.name, handles_of<Handle>(fine), values);
    }

private:
    property_values() = default;
    /// With the usual types, compiled in the library that `is_compiled_mesh` tells of.
    static property_values read_in_library(const M& mesh);

    /// Whether the property is of this type.
    template <class T>
    bool read(const M& mesh, const std::string& name)
    {
        const auto from = access::template find<Handle, T>(mesh, name);
        if (not from)
            return false;
        if constexpr (has_means and can_be_averaged<T>)
            means_.push_back({name, load_averaged<number, T>(from, handles_), &write_averaged<T>});
        else
            heirs_.push_back({name, load_inherited<T>(from, handles_), &write_inherited<T>});
        return true;
    }
    template <class T>
    static void write_averaged(M& fine, const std::string& name, const std::vector<Handle>& handles,
                               std::span<const coordinates> values)
    {
        store_averaged<number, T>(access::template add<Handle, T>(fine, name), handles, values);
    }
    template <class T>
    static void write_inherited(M& fine, const std::string& name, const std::vector<Handle>& handles,
                                const inherited_values& values, std::span<const std::uint32_t> heirs)
    {
        store_inherited<T>(access::template add<Handle, T>(fine, name), handles, values, heirs);
    }

    std::vector<Handle> handles_;
    std::vector<averaged> means_;
    std::vector<inherited> heirs_;
    std::vector<std::string> known_, unknown_;
};

} // namespace kith::detail
