// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/storage.hpp>
#include <kith/core/level/to_native.hpp>
#include <kith/fields/field.hpp>
#include <kith/fields/property/averaged_value.hpp>
#include <kith/fields/property/property_access.hpp>
#include <kith/fields/property/standard_property.hpp>

#include <any>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// A native mesh whose elements have named values of any type, as meshes of CGAL and OpenMesh have them.
template <class Point = std::array<double, 3>>
class property_mesh {
public:
    using native_mesh = basic_mesh<Point, std::uint32_t>;

    property_mesh() = default;
    /// Takes a native mesh. Errors: mesh_error for a mesh of face-vertex lists only.
    property_mesh(native_mesh mesh) : mesh_(std::move(mesh)) { require_edges(mesh_); }

    [[nodiscard]] const native_mesh& native() const { return mesh_; }
    operator const native_mesh&() const { return mesh_; }

    /// Stores the values of a field on elements of a kind under a name. They replace what had that name there, except
    /// values of this type on half-edges beyond the boundary. Corners are kept as the half-edges that lead to them, as
    /// in the other libraries.
    /// Errors: mesh_error unless there is a value for each element.
    template <field_on Where, class T, class Rule>
    void set(const std::string& name, const field<Where, T, Rule>& values)
    {
        const auto handles = handles_on<Where>();
        if (values.size() != handles.size())
            throw mesh_error("property '" + name + "' has " + std::to_string(values.size()) + " values for " +
                             std::to_string(handles.size()) + " elements; give one for each");
        using handle = typename decltype(handles)::value_type;
        storage<T>& to = add<handle, T>(name);
        for (std::size_t i = 0; i < handles.size(); ++i)
            to[handles[i].value] = values[i];
    }
    /// Returns the values under a name by dense number, as fields take them. Errors: mesh_error if there are none of
    /// this type.
    template <field_on Where, class T>
    [[nodiscard]] storage<T> get(const std::string& name) const
    {
        const auto handles = handles_on<Where>();
        const storage<T>* const from = find<typename decltype(handles)::value_type, T>(name);
        if (from == nullptr)
            throw mesh_error("the mesh has no property '" + name + "' of this type on such elements");
        storage<T> result(handles.size());
        for (std::size_t i = 0; i < handles.size(); ++i)
            result[i] = (*from)[handles[i].value];
        return result;
    }

private:
    using traits = mesh_traits<native_mesh>;
    using values_by_name = std::map<std::string, std::any>; // of type storage<T>, by the numbers of the handles
    friend property_access<property_mesh>;

    template <class Handle, class This>
    static auto& values_on(This& mesh)
    {
        if constexpr (std::same_as<Handle, typename traits::vertex>)
            return mesh.on_vertices_;
        else if constexpr (std::same_as<Handle, typename traits::halfedge>)
            return mesh.on_halfedges_;
        else if constexpr (std::same_as<Handle, typename traits::edge>)
            return mesh.on_edges_;
        else
            return mesh.on_faces_;
    }
    template <class Handle, class T>
    [[nodiscard]] const storage<T>* find(const std::string& name) const
    {
        const values_by_name& all = values_on<Handle>(*this);
        const auto found = all.find(name);
        return found == all.end() ? nullptr : std::any_cast<storage<T>>(&found->second);
    }
    template <class Handle, class T>
    storage<T>& add(const std::string& name)
    {
        std::any& place = values_on<Handle>(*this)[name];
        if (std::any_cast<storage<T>>(&place) == nullptr)
            place = storage<T>(bound<Handle>(), T());
        return *std::any_cast<storage<T>>(&place);
    }
    template <class Handle>
    [[nodiscard]] std::size_t bound() const
    {
        if constexpr (std::same_as<Handle, typename traits::vertex>)
            return mesh_.vertex_count();
        else if constexpr (std::same_as<Handle, typename traits::halfedge>)
            return 2 * mesh_.edge_count();
        else if constexpr (std::same_as<Handle, typename traits::edge>)
            return mesh_.edge_count();
        else
            return mesh_.face_count();
    }
    template <field_on Where>
    [[nodiscard]] auto handles_on() const
    {
        if constexpr (Where == field_on::vertices)
            return detail::handles_of<typename traits::vertex>(mesh_);
        else if constexpr (Where == field_on::edges)
            return detail::handles_of<typename traits::edge>(mesh_);
        else if constexpr (Where == field_on::faces)
            return detail::handles_of<typename traits::face>(mesh_);
        else
            return detail::handles_of<typename traits::halfedge>(mesh_);
    }
    native_mesh mesh_;
    values_by_name on_vertices_, on_halfedges_, on_edges_, on_faces_;
};

/// The elements of a property_mesh, which are those of its native mesh.
template <class Point>
struct mesh_traits<property_mesh<Point>> : mesh_traits<basic_mesh<Point, std::uint32_t>> {};

/// The properties of a property_mesh. Values may have any type; only the usual types are looked for.
template <class Point>
struct property_access<property_mesh<Point>> {
    using mesh = property_mesh<Point>;
    /// The type in which values are averaged: exact numbers stay exact, floats are averaged as doubles.
    using number = std::conditional_t<std::floating_point<scalar_of<Point>>, double, scalar_of<Point>>;
    using value_types =
        std::tuple<bool, char, signed char, unsigned char, short, unsigned short, int, unsigned, long, unsigned long,
                   long long, unsigned long long, float, double, std::string, std::array<unsigned char, 3>,
                   std::array<unsigned char, 4>, std::array<float, 2>, std::array<float, 3>, std::array<float, 4>,
                   std::array<double, 2>, std::array<double, 3>, std::array<double, 4>>;

    template <class Handle>
    static std::vector<std::string> names(const mesh& m)
    {
        std::vector<std::string> result;
        for (const auto& [name, values] : mesh::template values_on<Handle>(m))
            result.push_back(name);
        return result;
    }
    static bool is_reserved(const std::string&) { return false; }
    static bool follows_from_points(const std::string&) { return false; }
    template <class Handle, class T>
    static auto find(const mesh& m, const std::string& name)
    {
        const storage<T>* const found = m.template find<Handle, T>(name);
        return values_of<Handle, const T>{found == nullptr ? nullptr : found->data()};
    }
    template <class Handle, class T>
    static auto add(mesh& m, const std::string& name)
    {
        return values_of<Handle, T>{m.template add<Handle, T>(name).data()};
    }

    /// Returns the name that CGAL gives a standard property, for values of any type.
    template <class Handle>
    static std::string standard_name(standard_property which)
    {
        return detail::standard_name<mesh, Handle>(which, {"color", "normal", "texcoord"});
    }
    template <standard_property>
    using standard_type = void;

private:
    template <class Handle, class T>
    struct values_of {
        T* values; ///< null if there are none

        explicit operator bool() const { return values != nullptr; }
        T& operator[](Handle x) const { return values[x.value]; }
    };
};

} // namespace kith
