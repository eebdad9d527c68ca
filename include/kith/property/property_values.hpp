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

template <class Handle, mesh M>
std::vector<Handle> handles_of(const M& mesh)
{
    std::vector<Handle> result;
    for_each_handle<Handle>(mesh, [&](Handle x) { result.push_back(x); });
    return result;
}

/// The properties of a mesh on elements with such handles, apart from the mesh and from the types of their values, so that
/// whatever takes them to finer levels is compiled once for all types. At vertices and corners, which half-edges stand for,
/// what can be averaged is coordinates; the rest goes from an element to its heirs.
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
    /// What elements have from one element of the control mesh each.
    class inherited {
    public:
        virtual ~inherited() = default;
        /// heirs: one more than the number of the element that each has its value from, 0 for those that have T().
        virtual void write(M&, const std::vector<Handle>&, std::span<const std::uint32_t> heirs) const = 0;
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
            each->write(fine, handles, heirs);
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
        if constexpr (has_means and can_be_averaged<T>) {
            storage<coordinates> values(handles_.size());
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] = averaged_value<T>::template load<number>((*from)[handles_[i]]);
            means_.push_back({name, std::move(values), &write_as<T>});
        } else {
            auto values = std::make_unique<inherited_values<T>>(name, handles_.size());
            for (const Handle x : handles_)
                values->add((*from)[x]);
            heirs_.push_back(std::move(values));
        }
        return true;
    }
    template <class T>
    static void write_as(M& fine, const std::string& name, const std::vector<Handle>& handles,
                         std::span<const coordinates> values)
    {
        auto to = access::template add<Handle, T>(fine, name);
        for (std::size_t i = 0; i < handles.size(); ++i)
            to[handles[i]] = averaged_value<T>::template store<number>(values[i]);
    }
    template <class T>
    class inherited_values final : public inherited {
    public:
        inherited_values(std::string name, std::size_t count) : name_(std::move(name)) { values_.reserve(count); }
        void add(const T& value) { values_.push_back(value); }
        void write(M& fine, const std::vector<Handle>& handles, std::span<const std::uint32_t> heirs) const override
        {
            auto to = access::template add<Handle, T>(fine, name_);
            for (std::size_t i = 0; i < handles.size(); ++i)
                to[handles[i]] = heirs[i] == 0 ? value_of_nothing<T>() : T(values_[heirs[i] - 1]);
        }

    private:
        std::string name_;
        std::vector<T> values_;
    };

    std::vector<Handle> handles_;
    std::vector<averaged> means_;
    std::vector<std::unique_ptr<const inherited>> heirs_;
    std::vector<std::string> known_, unknown_;
};

} // namespace kith::detail
