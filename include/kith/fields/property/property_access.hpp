// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/mesh_traits.hpp>

#include <concepts>
#include <cstddef>
#include <string>
#include <typeindex>
#include <vector>

namespace kith {

/// The access to named properties in the meshes of a library, specialised beside mesh_traits. It has:
///
///   number                             the type in which values are averaged;
///   value_types                        std::tuple of the types of values that are looked for;
///   names<Handle>(mesh)                the names of all properties on elements with such handles, except those of the
///                                      library itself;
///   is_reserved(name)                  whether the library itself has, or may have, a property of that name;
///   follows_from_points(name)          whether the library makes it, as normals;
///   find<Handle, T>(mesh, name)        an object with [handle] that converts to true if there are such values;
///   add<Handle, T>(mesh, name)         an object with [handle] to write to; a new property if there is none;
///   standard_name<Handle>(which)       the library's name of a standard_property on such elements, or an empty one;
///   standard_type<which>               and the type of its values; void for any type.
///
/// If elements without an assigned value have a value other than T(), it also has:
///
///   with_one_element(mesh)             a mesh with the same properties and one element of each kind, which have these
///                                      values;
///   starts_with_a_value<T>             whether these values are never uninitialized;
///   add<Handle, T>(mesh, name, unset)  as above; a new property has this value.
///
/// If several properties may have one name, each with another type:
///
///   types_share_names                  true.
///
/// If properties without a name get one from the library, which means nothing in another mesh:
///
///   is_unnamed(name, type)             whether it is such a name, for values of a type; void for those of any type.
///
/// If meshes of many types keep their properties in one base, for which alone types of values are then compiled:
///
///   base                               its type; its own property_access has number, value_types, find and add as
///                                      here, and at<Handle>(number), an element;
///   base_of(mesh)                      the base of a mesh;
///   request<Handle>(mesh, name, type)  prepares the mesh for a property that will be added there.
///
/// If a mesh as a whole has properties:
///
///   names_of_whole(mesh)               their names;
///   copy_of_whole(from, to, copied)    copies them, adds their names to `copied`, and returns the names of those whose
///                                      type it does not know.
///
/// If values of types that are not named can be copied inside a mesh whose handles are numbers:
///
///   other_properties<Handle>(mesh, known)
///                                      std::vector<any_property>: all properties on elements with such handles, except
///                                      the known ones and those of the library itself.
template <class M>
struct property_access;

/// A property that was left out, with the reason and the remedy.
struct omission {
    std::string name;
    std::string why;
};

namespace detail {

/// A property whose values were read by their type.
struct known_property {
    std::string name;
    std::type_index type;
    const void* array; ///< the place where its library has it, if that matters
};

/// A property of any type, with the functions of its library. Elements are given by the numbers of their handles.
struct any_property {
    std::string name;
    void* array;
    void (*copy)(void* array, std::size_t from, std::size_t to);
    void (*swap)(void* array, std::size_t a, std::size_t b);
};

} // namespace detail

/// A mesh whose properties have names.
template <class M>
concept mesh_with_properties = mesh<M> and requires { typename property_access<M>::value_types; };

/// A mesh that can copy values of any type from one of its elements to another.
template <class M>
concept mesh_with_other_properties = mesh_with_properties<M> and
                                     requires(M& mesh, const std::vector<detail::known_property>& known) {
                                         property_access<M>::template other_properties<typename mesh_traits<M>::face>(
                                             mesh, known);
                                     };

namespace detail {

/// Returns true if the library gives this name to properties without one, for values of this type.
template <mesh_with_properties M>
bool is_unnamed([[maybe_unused]] const std::string& name, [[maybe_unused]] std::type_index type = typeid(void))
{
    if constexpr (requires { property_access<M>::is_unnamed(name, type); })
        return property_access<M>::is_unnamed(name, type);
    else
        return false;
}

/// The part of a mesh that has its properties: the mesh itself where property_access names no base.
template <class M>
struct property_base {
    using type = M;

    static M& of(M& mesh) { return mesh; }
    static const M& of(const M& mesh) { return mesh; }
};
template <class M>
    requires requires { typename property_access<M>::base; }
struct property_base<M> {
    using type = typename property_access<M>::base;

    static type& of(M& mesh) { return property_access<M>::base_of(mesh); }
    static const type& of(const M& mesh) { return property_access<M>::base_of(mesh); }
};

/// Calls f(handle) for all elements in the order of dense numbers. A half-edge stands for the corner at its target, as
/// is usual for texture coordinates.
template <class Handle, mesh M, class F>
void for_each_handle(const M& mesh, const F& f)
{
    using traits = mesh_traits<M>;
    if constexpr (std::same_as<Handle, typename traits::vertex>) {
        for (const Handle v : traits::vertices(mesh))
            f(v);
    } else if constexpr (std::same_as<Handle, typename traits::edge>) {
        for (const Handle e : traits::edges(mesh))
            f(e);
    } else if constexpr (std::same_as<Handle, typename traits::face>) {
        for (const Handle x : traits::faces(mesh))
            f(x);
    } else {
        std::vector<Handle> sides;
        for (const auto x : traits::faces(mesh)) {
            sides.clear();
            for_each_side(mesh, x, [&](Handle h) { sides.push_back(h); });
            if (not sides.empty())
                f(sides.back());
            for (std::size_t i = 1; i < sides.size(); ++i)
                f(sides[i - 1]);
        }
    }
}
/// Returns all handles in the order of for_each_handle.
template <class Handle, mesh M>
std::vector<Handle> handles_of(const M& mesh)
{
    std::vector<Handle> result;
    for_each_handle<Handle>(mesh, [&](Handle x) { result.push_back(x); });
    return result;
}

} // namespace detail

} // namespace kith
