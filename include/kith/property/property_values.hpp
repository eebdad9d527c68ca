// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "averaged_value.hpp"
#include "property_access.hpp"
#include "unset_values.hpp"

#include <kith/base/storage.hpp>

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

namespace kith::detail {

/// What elements have from one element of the control mesh each, of any type.
struct inherited_values {
    virtual ~inherited_values() = default;
};
template <class T>
struct inherited_values_of final : inherited_values {
    explicit inherited_values_of(const T& unset) : nothing(unset) {}

    T nothing; ///< which elements have that inherit nothing
    std::vector<T> values;
};

template <class T, class From, class Handle>
std::unique_ptr<const inherited_values> load_inherited(const From& from, const std::vector<Handle>& handles,
                                                       const T& nothing)
{
    auto* const result = new inherited_values_of<T>(nothing);
    std::unique_ptr<const inherited_values> owned(result);
    result->values.reserve(handles.size());
    for (const Handle x : handles)
        result->values.push_back(from[x]);
    return owned;
}
/// heirs: one more than the number of the element that each has its value from, 0 for those that inherit nothing.
template <class T, class To, class Handle>
void store_inherited(To to, const std::vector<Handle>& handles, const inherited_values_of<T>& all,
                     std::span<const std::uint32_t> heirs)
{
    for (std::size_t i = 0; i < handles.size(); ++i)
        to[handles[i]] = heirs[i] == 0 ? all.nothing : T(all.values[heirs[i] - 1]);
}

/// Half-edges that no face has inherit nothing.
template <class Handle, mesh M, class T, class To>
void store_beside_faces(const M& mesh, To& to, const T& nothing)
{
    using traits = mesh_traits<M>;
    if constexpr (std::same_as<Handle, typename traits::halfedge>)
        for (const auto e : traits::edges(mesh))
            for (const Handle h : {traits::halfedge_of(mesh, e), traits::opposite(mesh, traits::halfedge_of(mesh, e))})
                if (traits::is_boundary(mesh, h))
                    to[h] = nothing;
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
        bool is_unnamed;
        storage<coordinates> values;
        coordinates nothing; ///< which elements have that inherit nothing
        void (*write)(M&, const averaged&, const std::vector<Handle>&, std::span<const coordinates>);
    };
    struct inherited {
        std::string name;
        bool is_unnamed;
        std::unique_ptr<const inherited_values> values;
        void (*write)(M&, const std::string& name, const std::vector<Handle>&, const inherited_values&,
                      std::span<const std::uint32_t> heirs);
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
    [[nodiscard]] bool has_heirs() const { return not heirs_.empty(); }
    /// The names of the properties that are here, and of those that are not: of other types, or made of the points.
    [[nodiscard]] const std::vector<std::string>& known() const { return known_; }
    [[nodiscard]] const std::vector<std::string>& unknown() const { return unknown_; }

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
        mean.write(fine, mean, handles_of<Handle>(fine), values);
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
        const T nothing = unset.template of<Handle, T>(name);
        if constexpr (has_means<Handle, M> and can_be_averaged<T>)
            means_.push_back({name,
                              detail::is_unnamed<M, T>(name),
                              load_averaged<number, T>(from, handles_),
                              averaged_value<T>::template load<number>(nothing),
                              &write_averaged<T>});
        else
            heirs_.push_back({name,
                              detail::is_unnamed<M, T>(name),
                              load_inherited<T>(from, handles_, nothing),
                              &write_inherited<T>});
    }
    template <class T>
    static void write_averaged(M& fine, const averaged& mean, const std::vector<Handle>& handles,
                               std::span<const coordinates> values)
    {
        const T nothing = averaged_value<T>::template store<number>(mean.nothing);
        auto to = add_unset<Handle>(fine, mean.name, nothing);
        store_averaged<number, T>(to, handles, values);
        store_beside_faces<Handle>(fine, to, nothing);
    }
    template <class T>
    static void write_inherited(M& fine, const std::string& name, const std::vector<Handle>& handles,
                                const inherited_values& values, std::span<const std::uint32_t> heirs)
    {
        const auto& all = static_cast<const inherited_values_of<T>&>(values);
        auto to = add_unset<Handle>(fine, name, all.nothing);
        store_inherited<T>(to, handles, all, heirs);
        store_beside_faces<Handle>(fine, to, all.nothing);
    }

    std::vector<Handle> handles_;
    std::vector<averaged> means_;
    std::vector<inherited> heirs_;
    std::vector<std::string> known_, unknown_;
};

} // namespace kith::detail
