// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "openmesh.hpp"

#include <kith/carry_properties.hpp>

#include <OpenMesh/Core/Mesh/Status.hh>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace kith {

template <class Scalar, int N>
    requires(N <= 4)
struct averaged_value<OpenMesh::VectorT<Scalar, N>>
    : averaged_coordinates<OpenMesh::VectorT<Scalar, N>, Scalar, std::size_t(N)> {};

/// The properties of a mesh of OpenMesh that have a name, and its attributes in traits or by request: status, colors and texture
/// coordinates are carried, normals are not; update_normals() makes them.
template <std::derived_from<OpenMesh::PolyConnectivity> M>
struct property_access<M> {
    using number = double;
    template <class Scalar>
    using vectors = std::tuple<OpenMesh::VectorT<Scalar, 1>, OpenMesh::VectorT<Scalar, 2>, OpenMesh::VectorT<Scalar, 3>,
                               OpenMesh::VectorT<Scalar, 4>>;
    using value_types = decltype(std::tuple_cat(
        std::tuple<bool, char, signed char, unsigned char, short, unsigned short, int, unsigned, long, unsigned long,
                   long long, unsigned long long, float, double, std::string, OpenMesh::Attributes::StatusInfo,
                   std::array<float, 2>, std::array<float, 3>, std::array<float, 4>, std::array<double, 2>,
                   std::array<double, 3>, std::array<double, 4>>(),
        vectors<float>(), vectors<double>(), vectors<unsigned char>(), vectors<int>(), vectors<unsigned>()));

    template <class Handle>
    static std::vector<std::string> names(const M& m)
    {
        std::vector<std::string> result;
        const auto add_all = [&](auto begin, auto end) {
            for (auto p = begin; p != end; ++p)
                if (*p != nullptr and (*p)->name() != "v:points" and
                    std::ranges::find(result, (*p)->name()) == result.end())
                    result.push_back((*p)->name());
        };
        if constexpr (std::same_as<Handle, OpenMesh::VertexHandle>)
            add_all(m.vprops_begin(), m.vprops_end());
        else if constexpr (std::same_as<Handle, OpenMesh::HalfedgeHandle>)
            add_all(m.hprops_begin(), m.hprops_end());
        else if constexpr (std::same_as<Handle, OpenMesh::EdgeHandle>)
            add_all(m.eprops_begin(), m.eprops_end());
        else
            add_all(m.fprops_begin(), m.fprops_end());
        return result;
    }
    static bool follows_from_points(const std::string& name) { return name.ends_with(":normals"); }

    /// A property of elements with such handles.
    template <class Handle, class T>
    using property_handle = std::conditional_t<
        std::same_as<Handle, OpenMesh::VertexHandle>, OpenMesh::VPropHandleT<T>,
        std::conditional_t<std::same_as<Handle, OpenMesh::HalfedgeHandle>, OpenMesh::HPropHandleT<T>,
                           std::conditional_t<std::same_as<Handle, OpenMesh::EdgeHandle>, OpenMesh::EPropHandleT<T>,
                                              OpenMesh::FPropHandleT<T>>>>;
    template <class Handle, class T, class Mesh>
    struct property_of {
        Mesh* mesh;
        property_handle<Handle, T> handle;

        decltype(auto) operator[](Handle x) const { return mesh->property(handle, x); }
    };

    template <class Handle, class T>
    static std::optional<property_of<Handle, T, const M>> find(const M& m, const std::string& name)
    {
        property_handle<Handle, T> handle;
        if (not m.get_property_handle(handle, name))
            return std::nullopt;
        return property_of<Handle, T, const M>{&m, handle};
    }
    template <class Handle, class T>
    static property_of<Handle, T, M> add(M& m, const std::string& name)
    {
        property_handle<Handle, T> handle;
        if (not m.get_property_handle(handle, name))
            m.add_property(handle, name);
        return {&m, handle};
    }
};

} // namespace kith
