// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cgal.hpp"
#include "cgal_arrays.hpp"
#include "cgal_values.hpp"

#include <kith/carry_properties.hpp>
#include <kith/fields/property/standard_property.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <typeindex>
#include <vector>

namespace kith {

/// The property maps of a CGAL::Surface_mesh, or of a class derived from it.
template <surface_mesh_or_derived M>
struct property_access<M> {
    using mesh = surface_mesh_of<M>;
    using Point = typename mesh::Point; // NOLINT(readability-identifier-naming): as CGAL calls it
    using kernel = typename CGAL::Kernel_traits<Point>::Kernel;
    /// The numbers in which values are averaged: doubles for floats and doubles, exact numbers for exact kernels.
    using number = std::conditional_t<std::floating_point<typename kernel::FT>, double, typename kernel::FT>;
    using value_types = std::tuple<
        bool, char, signed char, unsigned char, short, unsigned short, int, unsigned, long, unsigned long, long long,
        unsigned long long, float, double, std::string, CGAL::IO::Color, CGAL::Point_2<kernel>, CGAL::Vector_2<kernel>,
        CGAL::Point_3<kernel>, CGAL::Vector_3<kernel>, std::array<float, 2>, std::array<float, 3>, std::array<float, 4>,
        std::array<double, 2>, std::array<double, 3>, std::array<double, 4>, number>;

    template <class Handle>
    static std::vector<std::string> names(const mesh& m)
    {
        std::vector<std::string> result = m.template properties<Handle>();
        std::erase_if(result, is_reserved);
        return result;
    }
    static bool is_reserved(const std::string& name)
    {
        static constexpr std::array<std::string_view, 8> own{"v:point",
                                                             "v:connectivity",
                                                             "h:connectivity",
                                                             "f:connectivity",
                                                             "v:removed",
                                                             "e:removed",
                                                             "f:removed",
                                                             mesh_traits<M>::odd_generation};
        return std::ranges::find(own, name) != own.end();
    }
    static bool is_unnamed(const std::string& name, std::type_index) { return name.starts_with("anonymous-property-"); }
    /// True: several properties may have one name, each with another type.
    static constexpr bool types_share_names = true;
    static bool follows_from_points(const std::string&) { return false; }
    template <class Handle, class T>
    static auto find(const mesh& m, const std::string& name)
    {
        const auto found = m.template property_map<Handle, T>(name);
        if constexpr (requires { found.has_value(); }) // from CGAL 6 on
            return found.value_or(typename mesh::template Property_map<Handle, T>());
        else
            return found.first; // false if nothing was found
    }
    template <class Handle, class T>
    static auto add(mesh& m, const std::string& name, const T& unset = detail::value_of_nothing<T>())
    {
        return m.template add_property_map<Handle, T>(name, unset).first;
    }

    /// Returns a copy of the mesh with one vertex, one edge and one face. Their values are those that the property maps
    /// give to new elements.
    static M with_one_element(const M& m)
    {
        M result = m;
        mesh& one = result;
        one.clear_without_removing_property_maps();
        one.add_vertex();
        one.add_edge();
        one.add_face();
        return result;
    }
    template <class Handle>
    static std::vector<detail::any_property> other_properties(mesh& m, const std::vector<detail::known_property>& known)
    {
        return detail::other_arrays<Handle>(m, names<Handle>(m), known);
    }
    /// True if a map that was made without a value gives new elements one: T() leaves no part of it unset.
    template <class T>
    static constexpr bool starts_with_a_value = not detail::is_left_open<T>;

    /// Returns the name that CGAL's readers and writers use for a standard property.
    template <class Handle>
    static std::string standard_name(standard_property which)
    {
        return detail::standard_name<M, Handle>(which, {"color", "normal", "texcoord"});
    }
    template <standard_property Which>
    using standard_type = std::conditional_t<
        Which == standard_property::color, CGAL::IO::Color,
        std::conditional_t<Which == standard_property::normal, CGAL::Vector_3<kernel>, CGAL::Point_2<kernel>>>;
};

#ifdef KITH_COMPILED_CGAL
template <surface_mesh_or_derived M>
inline constexpr bool detail::has_compiled_properties<M> = is_compiled_mesh<M>;
#endif

} // namespace kith
