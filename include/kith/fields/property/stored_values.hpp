// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "averaged_value.hpp"
#include "property_access.hpp"

#include <kith/core/base/storage.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace kith::detail {

/// The inherited values of a property of any type, one per element of the control mesh.
struct inherited_values {
    virtual ~inherited_values() = default;
    /// Drops the values of all elements but these, whose numbers are increasing.
    virtual void keep(std::span<const std::uint32_t> elements) = 0;
};
template <class T>
struct inherited_values_of final : inherited_values {
    explicit inherited_values_of(const T& unset) : nothing(unset) {}

    void keep(std::span<const std::uint32_t> elements) override
    {
        for (std::size_t i = 0; i < elements.size(); ++i)
            if (elements[i] != i)
                values[i] = T(values[elements[i]]);
        values.resize(elements.size(), nothing);
    }

    T nothing; ///< the value of elements that inherit nothing
    std::vector<T> values;
};

/// An exchange of values between elements of one mesh, by the numbers of their handles. It never fails for types whose
/// swap does not.
struct value_exchange {
    virtual ~value_exchange() = default;
    virtual void swap(std::size_t a, std::size_t b) noexcept = 0;
};
template <class M, class Handle, class T, class To>
struct value_exchange_in final : value_exchange {
    explicit value_exchange_in(To map) : to(map) {}

    void swap(std::size_t a, std::size_t b) noexcept override
    {
        const Handle x = handle_at(a), y = handle_at(b);
        if constexpr (std::is_lvalue_reference_v<decltype(to[x])>) {
            using std::swap;
            swap(to[x], to[y]);
        } else { // bits
            const T value = to[x];
            to[x] = T(to[y]);
            to[y] = value;
        }
    }
    static Handle handle_at(std::size_t i)
    {
        if constexpr (requires { property_access<M>::template at<Handle>(i); })
            return property_access<M>::template at<Handle>(i);
        else
            return mesh_traits<M>::template at<Handle>(i);
    }

    To to;
};
/// Returns the exchange of the values of a map, or nullptr unless the handles of the mesh, or of the base, are numbers.
template <class M, class Handle, class T, class To>
std::unique_ptr<value_exchange> exchange_of(To to)
{
    if constexpr (mesh_with_other_properties<M> or requires { property_access<M>::template at<Handle>(0); })
        return std::make_unique<value_exchange_in<M, Handle, T, To>>(to);
    else
        return nullptr;
}

/// The handles whose values are written, by the numbers of the elements, and the half-edges without a face.
template <class Handle>
struct written_places {
    std::vector<Handle> elements, beside_faces;
};

template <class T, class From, class Handle>
std::unique_ptr<inherited_values> load_inherited(const From& from, const std::vector<Handle>& handles, const T& nothing)
{
    auto result = std::make_unique<inherited_values_of<T>>(nothing);
    result->values.reserve(handles.size());
    for (const Handle x : handles)
        result->values.push_back(from[x]);
    return result;
}
/// Writes inherited values to handles. An entry of `heirs` is 1 + the number of the element from which a handle
/// inherits, or 0 if it inherits nothing.
template <class T, class To, class Handle>
void store_inherited(To to, const std::vector<Handle>& handles, const inherited_values_of<T>& all,
                     std::span<const std::uint32_t> heirs)
{
    for (std::size_t i = 0; i < handles.size(); ++i)
        to[handles[i]] = heirs[i] == 0 ? all.nothing : T(all.values[heirs[i] - 1]);
}

/// Returns the half-edges without a face, which inherit nothing. Returns none for handles of other kinds.
template <class Handle, mesh M>
std::vector<Handle> handles_beside_faces(const M& mesh)
{
    using traits = mesh_traits<M>;
    std::vector<Handle> result;
    if constexpr (std::same_as<Handle, typename traits::halfedge>)
        for (const auto e : traits::edges(mesh))
            for (const Handle h : {traits::halfedge_of(mesh, e), traits::opposite(mesh, traits::halfedge_of(mesh, e))})
                if (traits::is_boundary(mesh, h))
                    result.push_back(h);
    return result;
}
/// Returns the places of all elements of a mesh.
template <class Handle, mesh M>
written_places<Handle> places_in(const M& mesh)
{
    return {handles_of<Handle>(mesh), handles_beside_faces<Handle>(mesh)};
}
template <class Handle, class T, class To>
void store_nothing(To& to, const std::vector<Handle>& handles, const T& nothing)
{
    for (const Handle h : handles)
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

} // namespace kith::detail
