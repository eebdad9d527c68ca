// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "openmesh.hpp"

#include <kith/carry_properties.hpp>
#include <kith/fields/property/standard_property.hpp>

#include <OpenMesh/Core/Mesh/Status.hh>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <type_traits>
#include <typeindex>
#include <vector>

namespace kith {

template <class Scalar, int N>
    requires(N <= 4)
struct averaged_value<OpenMesh::VectorT<Scalar, N>>
    : averaged_coordinates<OpenMesh::VectorT<Scalar, N>, Scalar, std::size_t(N)> {};

namespace detail {

/// OpenMesh's type of handle for a property on elements with handles of this type.
template <class Handle, class T>
using openmesh_property_handle =
    std::conditional_t<std::same_as<Handle, OpenMesh::VertexHandle>, OpenMesh::VPropHandleT<T>,
                       std::conditional_t<std::same_as<Handle, OpenMesh::HalfedgeHandle>, OpenMesh::HPropHandleT<T>,
                                          std::conditional_t<std::same_as<Handle, OpenMesh::EdgeHandle>,
                                                             OpenMesh::EPropHandleT<T>, OpenMesh::FPropHandleT<T>>>>;

/// The values of a property of OpenMesh, if there is one.
template <class Property>
struct openmesh_property {
    Property* values;

    explicit operator bool() const { return values != nullptr; }
    decltype(auto) operator[](OpenMesh::BaseHandle x) const { return (*values)[x.idx()]; }
    [[nodiscard]] const void* array() const { return static_cast<const OpenMesh::BaseProperty*>(values); }
};

/// Calls f(property) for each property on elements with handles of this type.
template <class Handle, class Kernel, class F>
void for_each_property(Kernel& m, const F& f)
{
    const auto all = [&f](auto begin, auto end) {
        for (auto p = begin; p != end; ++p)
            if (*p != nullptr)
                f(*p);
    };
    if constexpr (std::same_as<Handle, OpenMesh::VertexHandle>)
        all(m.vprops_begin(), m.vprops_end());
    else if constexpr (std::same_as<Handle, OpenMesh::HalfedgeHandle>)
        all(m.hprops_begin(), m.hprops_end());
    else if constexpr (std::same_as<Handle, OpenMesh::EdgeHandle>)
        all(m.eprops_begin(), m.eprops_end());
    else
        all(m.fprops_begin(), m.fprops_end());
}

} // namespace detail

/// The properties of any mesh of OpenMesh, through the base class that has them. In this way types of values are
/// compiled once.
template <>
struct property_access<OpenMesh::BaseKernel> {
    using mesh = OpenMesh::BaseKernel;
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

    template <class Handle, class T>
    static detail::openmesh_property<const OpenMesh::PropertyT<T>> find(const mesh& m, const std::string& name)
    {
        detail::openmesh_property_handle<Handle, T> handle;
        return {m.get_property_handle(handle, name) ? &m.property(handle) : nullptr};
    }
    template <class Handle, class T>
    static detail::openmesh_property<OpenMesh::PropertyT<T>> add(mesh& m, const std::string& name)
    {
        detail::openmesh_property_handle<Handle, T> handle;
        if (not m.get_property_handle(handle, name))
            m.add_property(handle, name);
        return {&m.property(handle)};
    }
    template <class Handle>
    static Handle at(std::size_t i)
    {
        return Handle(int(i));
    }
};

namespace detail {

template <class Handle>
inline constexpr bool has_means<Handle, OpenMesh::BaseKernel> = std::same_as<Handle, OpenMesh::VertexHandle> or
                                                                std::same_as<Handle, OpenMesh::HalfedgeHandle>;
#ifdef KITH_COMPILED_OPENMESH
template <>
inline constexpr bool has_compiled_properties<OpenMesh::BaseKernel> = true;
#endif

/// The part of the access to a mesh's properties that does not depend on its traits.
struct openmesh_properties {
    using base = OpenMesh::BaseKernel;
    using number = property_access<base>::number;
    using value_types = property_access<base>::value_types;

    static bool is_reserved(const std::string& name) { return name == "v:points"; }
    /// True: several properties may have one name, each with another type.
    static constexpr bool types_share_names = true;
    static bool follows_from_points(const std::string& name) { return name.ends_with(":normals"); }
    template <class Handle, class T>
    static auto find(const base& m, const std::string& name)
    {
        return property_access<base>::find<Handle, T>(m, name);
    }
};

} // namespace detail

/// The named properties of a mesh of OpenMesh, and its attributes in traits or by request. Status, colors and texture
/// coordinates are carried. Normals are not carried; update_normals() computes them.
template <std::derived_from<OpenMesh::PolyConnectivity> M>
struct property_access<M> : detail::openmesh_properties {
    static OpenMesh::BaseKernel& base_of(M& m) { return m; }
    static const OpenMesh::BaseKernel& base_of(const M& m) { return m; }
    template <class Handle>
    static std::vector<std::string> names(const M& m)
    {
        std::vector<std::string> result;
        const auto add_all = [&]<class Data>(std::type_identity<Data>) {
            // Every mesh has a property for the element data of its traits, which mostly are an empty class.
            detail::for_each_property<Handle>(m, [&](const OpenMesh::BaseProperty* p) {
                const bool is_nothing = std::is_empty_v<Data> and
                                        dynamic_cast<const OpenMesh::PropertyT<Data>*>(p) != nullptr;
                if (not is_reserved(p->name()) and not is_nothing)
                    result.push_back(p->name());
            });
        };
        if constexpr (std::same_as<Handle, OpenMesh::VertexHandle>)
            add_all(std::type_identity<typename M::VertexData>());
        else if constexpr (std::same_as<Handle, OpenMesh::HalfedgeHandle>)
            add_all(std::type_identity<typename M::HalfedgeData>());
        else if constexpr (std::same_as<Handle, OpenMesh::EdgeHandle>)
            add_all(std::type_identity<typename M::EdgeData>());
        else
            add_all(std::type_identity<typename M::FaceData>());
        return result;
    }
    /// Returns true if a property has no name of its own. The element data of the mesh's traits have none either, but
    /// count as named, because each mesh with these traits has them.
    static bool is_unnamed(const std::string& name, std::type_index type)
    {
        if (type == typeid(typename M::VertexData) or type == typeid(typename M::HalfedgeData) or
            type == typeid(typename M::EdgeData) or type == typeid(typename M::FaceData))
            return false;
        return name == "<vprop>" or name == "<hprop>" or name == "<eprop>" or name == "<fprop>" or name == "<mprop>";
    }
    template <class Handle, class T>
    static auto add(M& m, const std::string& name)
    {
        request<Handle>(m, name, typeid(T));
        return property_access<base>::add<Handle, T>(m, name);
    }
    /// Requests an attribute that has this name and type, so that the functions of the mesh see it, too.
    template <class Handle>
    static void request(M& m, const std::string& name, std::type_index type)
    {
        mesh_traits<M>::for_each_attribute([&](auto has, auto request, auto property) {
            using attribute = std::invoke_result_t<decltype(property), M>;
            using value = typename attribute::Value;
            if constexpr (std::derived_from<attribute, detail::openmesh_property_handle<Handle, value>>) {
                if (type != typeid(value) or (m.*has)())
                    return;
                M empty; // knows the name
                (empty.*request)();
                if (empty.property((empty.*property)()).name() == name)
                    (m.*request)();
            }
        });
    }

    static std::vector<std::string> names_of_whole(const M& m)
    {
        std::vector<std::string> result;
        for (auto p = m.mprops_begin(); p != m.mprops_end(); ++p)
            if (*p != nullptr and not is_mark((*p)->name()))
                result.push_back((*p)->name());
        return result;
    }
    /// Copies the properties of the mesh as a whole, such as the pictures to which texture indices refer, and adds
    /// their names to `copied`. Returns the names of properties of other types or without a name of their own.
    static std::vector<std::string> copy_of_whole(const M& from, M& to, std::vector<std::string>& copied)
    {
        std::vector<std::string> others;
        for (auto p = from.mprops_begin(); p != from.mprops_end(); ++p)
            if (*p != nullptr and not is_mark((*p)->name())) {
                const bool is_known = not is_unnamed((*p)->name(), typeid(void)) and
                                      copy_of_whole(
                                          from,
                                          to,
                                          **p,
                                          static_cast<std::tuple<value_types, std::tuple<pictures>>*>(nullptr));
                (is_known ? copied : others).push_back((*p)->name());
            }
        return others;
    }

    /// Returns the name that OpenMesh gives to a standard attribute.
    template <class Handle>
    static std::string standard_name(standard_property which)
    {
        const bool has_none = (std::same_as<Handle, OpenMesh::EdgeHandle> and which != standard_property::color) or
                              (std::same_as<Handle, OpenMesh::FaceHandle> and
                               which == standard_property::texture_coordinates);
        return detail::standard_name<M, Handle>(has_none ? standard_property::none : which,
                                                {"colors", "normals", "texcoords2D"});
    }
    template <standard_property Which>
    using standard_type = std::conditional_t<
        Which == standard_property::color, typename M::Color,
        std::conditional_t<Which == standard_property::normal, typename M::Normal, typename M::TexCoord2D>>;

private:
    /// Returns true for kith's own property, which records the step that made a mesh. It is not copied, because another
    /// step made the other mesh.
    static bool is_mark(const std::string& name) { return name.starts_with("kith:"); }

    using pictures = std::map<int, std::string>; // as OpenMesh's readers have them
    template <class... T, class... More>
    static bool copy_of_whole(const M& from, M& to, const OpenMesh::BaseProperty& property,
                              std::tuple<std::tuple<T...>, std::tuple<More...>>*)
    {
        return (copy_if<T>(from, to, property) or ...) or (copy_if<More>(from, to, property) or ...);
    }
    template <class T>
    static bool copy_if(const M& from, M& to, const OpenMesh::BaseProperty& property)
    {
        OpenMesh::MPropHandleT<T> handle, copy;
        if (not from.get_property_handle(handle, property.name()))
            return false;
        if (not to.get_property_handle(copy, property.name()))
            to.add_property(copy, property.name());
        to.property(copy) = from.property(handle);
        return true;
    }
};

} // namespace kith
