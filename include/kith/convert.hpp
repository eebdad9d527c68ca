// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "carry_properties.hpp"
#include "property_mesh.hpp"

#include <kith/base/affine.hpp>
#include <kith/base/storage.hpp>
#include <kith/field/standard_property.hpp>
#include <kith/level/lift.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// What has become of the properties of a mesh that was converted, by the names they had there.
struct conversion_report {
    struct omission {
        std::string name;
        std::string why;
    };
    std::vector<std::string> carried;
    /// Of those carried, and "points": whose values the new mesh cannot all hold exactly, such as doubles in floats.
    std::vector<std::string> narrowed;
    std::vector<omission> left_out;
};

template <mesh M>
struct conversion {
    M mesh;
    conversion_report report;
};

namespace detail {

/// Whether two values say the same; not a number is the same as itself.
template <class T>
bool same_number(const T& a, const T& b)
{
    return a == b or (a != a and b != b);
}

template <class Coordinates>
bool same_numbers(const Coordinates& a, const Coordinates& b)
{
    return std::equal(
        std::begin(a), std::end(a), std::begin(b), [](const auto& x, const auto& y) { return same_number(x, y); });
}

/// Points of one type as points of another.
template <class To, class From>
struct point_conversion {
    static To convert(const From& point)
    {
        const auto& from = affine<From>::load(point);
        typename affine<To>::sum to;
        static_assert(std::tuple_size_v<std::remove_cvref_t<decltype(from)>> == std::tuple_size_v<decltype(to)>,
                      "kith::convert: the points of the two meshes have different numbers of coordinates");
        for (std::size_t i = 0; i < from.size(); ++i)
            to[i] = as_coordinate<scalar_of<To>>(from[i]);
        return affine<To>::store(to);
    }
    static bool is_exact(const From& before, const To& after)
    {
        return same_numbers(affine<From>::load(before), affine<From>::load(point_conversion<From, To>::convert(after)));
    }
};

/// The mesh with points of another type.
template <class To, class From>
basic_mesh<To, std::uint32_t> with_points(basic_mesh<From, std::uint32_t>&& mesh, conversion_report& report)
{
    if constexpr (std::same_as<To, From>) {
        return std::move(mesh);
    } else {
        storage<To> points(mesh.vertex_count());
        bool is_exact = true;
        for (std::size_t v = 0; v < points.size(); ++v) {
            points[v] = point_conversion<To, From>::convert(mesh.point(v));
            is_exact = is_exact and point_conversion<To, From>::is_exact(mesh.point(v), points[v]);
        }
        if (not is_exact)
            report.narrowed.emplace_back("points");
        return {std::move(points), mesh.topology(), mesh.generation()};
    }
}

/// Values of several numbers of some type, and what is left of numbers when they have been values of that type.
template <class Number>
struct numbers_of_values {
    using numbers = four_numbers<Number>;
    using rounding = numbers (*)(const numbers&);

    template <class T>
    static numbers rounded(const numbers& x)
    {
        return averaged_value<T>::template load<Number>(averaged_value<T>::template store<Number>(x));
    }

    std::vector<numbers> values;
    rounding round;
};

/// How the numbers of one type are those of another.
template <class Number>
struct number_conversion {
    using numbers = four_numbers<Number>;
    using rounding = typename numbers_of_values<Number>::rounding;

    bool are_colors;
    rounding from, to;

    [[nodiscard]] numbers convert(const numbers& x) const { return are_colors ? color(x, from, to) : x; }
    [[nodiscard]] bool is_exact(const numbers& x) const
    {
        const numbers kept = to(convert(x));
        return are_colors ? same_numbers(opaque(x, from), opaque(from(color(kept, to, from)), from))
                          : same_numbers(x, from(kept));
    }

private:
    /// Integers are those from 0 to 255, other numbers those from 0 to 1, and a colour without a fourth is opaque.
    static numbers color(const numbers& x, rounding from, rounding to)
    {
        numbers result = opaque(x, from);
        for (Number& channel : result)
            channel = channel * full(to) / full(from);
        return result;
    }
    static numbers opaque(numbers x, rounding type)
    {
        const numbers alpha{0, 0, 0, 1};
        if (not(type(alpha) == alpha))
            x[3] = full(type);
        return x;
    }
    static Number full(rounding type)
    {
        const numbers half{0.5, 0, 0, 0};
        return type(half) == half ? 1 : 255;
    }
};

/// The elements of one kind in their order; of half-edges that of the edges, first the side that directs the edge or, where
/// that has no face, the other one.
template <class Handle, mesh M>
std::vector<Handle> all_handles(const M& mesh)
{
    using traits = mesh_traits<M>;
    std::vector<Handle> result;
    if constexpr (std::same_as<Handle, typename traits::halfedge>)
        for (const auto e : traits::edges(mesh)) {
            const Handle directs = traits::halfedge_of(mesh, e), other = traits::opposite(mesh, directs);
            const bool is_first = not traits::is_boundary(mesh, directs);
            result.push_back(is_first ? directs : other);
            result.push_back(is_first ? other : directs);
        }
    else
        for_each_handle<Handle>(mesh, [&](Handle x) { result.push_back(x); });
    return result;
}

/// Copies the properties on elements of one kind to a mesh with the same elements.
template <class FromHandle, class ToHandle, mesh_with_properties From, mesh_with_properties To>
class property_copier {
    using from_access = property_access<From>;
    using to_access = property_access<To>;
    /// Where one of the meshes has exact numbers these are.
    using number = std::conditional_t<std::floating_point<typename from_access::number>, typename to_access::number,
                                      typename from_access::number>;

public:
    property_copier(const From& from, To& to, conversion_report& report)
        : from_(from)
        , to_(to)
        , report_(report)
        , from_handles_(all_handles<FromHandle>(from))
        , to_handles_(all_handles<ToHandle>(to))
    {
    }

    template <class... T>
    void copy_all(std::tuple<T...>*)
    {
        for (const std::string& name : from_access::template names<FromHandle>(from_)) {
            const standard_property which = meaning_of(name);
            const one_property one{name, to_access::template standard_name<ToHandle>(which), which};
            if (not(copy<T>(one) or ...))
                leave_out(name, "its type is none of those that are looked for; name it, convert<mesh, type>(...)");
        }
    }

private:
    struct one_property {
        std::string name;
        std::string standard_name; ///< what the new library calls it, if it does
        standard_property which;
    };
    static standard_property meaning_of(const std::string& name)
    {
        using enum standard_property;
        for (const standard_property which : {color, normal, texture_coordinates})
            if (from_access::template standard_name<FromHandle>(which) == name)
                return which;
        return none;
    }
    template <standard_property Which>
    using own_type = typename to_access::template standard_type<Which>;
    template <class T, standard_property Which>
    static constexpr bool is_own = std::is_void_v<own_type<Which>> or std::same_as<T, own_type<Which>>;

    /// Whether it is of this type.
    template <class T>
    bool copy(const one_property& one)
    {
        const auto from = from_access::template find<FromHandle, T>(from_, one.name);
        if (not from)
            return false;
        using enum standard_property;
        constexpr std::array own{is_own<T, color>, is_own<T, normal>, is_own<T, texture_coordinates>};
        const bool is_standard = not one.standard_name.empty();
        const bool keeps_type = not is_standard or own[std::size_t(one.which)];
        if constexpr (can_be_averaged<T> and not std::is_arithmetic_v<T>)
            if (not keeps_type) {
                numbers_of_values<number> values{{}, numbers_of_values<number>::template rounded<T>};
                for (const FromHandle x : from_handles_)
                    values.values.push_back(averaged_value<T>::template load<number>((*from)[x]));
                copy_numbers(values, one);
                return true;
            }
        const std::string& to_name = is_standard and keeps_type ? one.standard_name : one.name;
        if (is_free(one.name, to_name, bool(to_access::template find<ToHandle, T>(to_, to_name)))) {
            auto to = to_access::template add<ToHandle, T>(to_, to_name);
            for (std::size_t i = 0; i < from_handles_.size(); ++i)
                to[to_handles_[i]] = (*from)[from_handles_[i]];
        }
        return true;
    }
    void copy_numbers(const numbers_of_values<number>& values, const one_property& one)
    {
        using enum standard_property;
        if (one.which == color)
            write<own_type<color>>(values, one);
        else if (one.which == normal)
            write<own_type<normal>>(values, one);
        else
            write<own_type<texture_coordinates>>(values, one);
    }
    template <class Own>
    void write(const numbers_of_values<number>& values, const one_property& one)
    {
        const bool is_there = bool(to_access::template find<ToHandle, Own>(to_, one.standard_name));
        if (not is_free(one.name, one.standard_name, is_there))
            return;
        const number_conversion<number> rule{
            one.which == standard_property::color, values.round, numbers_of_values<number>::template rounded<Own>};
        auto to = to_access::template add<ToHandle, Own>(to_, one.standard_name);
        bool is_exact = true;
        for (std::size_t i = 0; i < to_handles_.size(); ++i) {
            to[to_handles_[i]] = averaged_value<Own>::template store<number>(rule.convert(values.values[i]));
            is_exact = is_exact and rule.is_exact(values.values[i]);
        }
        if (not is_exact)
            report_.narrowed.push_back(one.name);
    }
    template <class Own>
        requires std::is_void_v<Own>
    void write(const numbers_of_values<number>&, const one_property&) // a mesh that takes any type
    {
    }
    /// Whether the new mesh has room for a property of this name, which it then has; else it is left out.
    bool is_free(const std::string& name, const std::string& to_name, bool is_there_in_its_type)
    {
        const auto there = to_access::template names<ToHandle>(to_);
        std::string why;
        if (to_access::is_reserved(to_name))
            why = "the new mesh keeps that name for itself";
        else if (std::ranges::find(made_, to_name) != made_.end())
            why = "another property has become '" + to_name + "'";
        else if (std::ranges::find(there, to_name) != there.end() and not is_there_in_its_type)
            why = "the new mesh has '" + to_name + "' in another type";
        if (not why.empty()) {
            leave_out(name, std::move(why));
            return false;
        }
        made_.push_back(to_name);
        report_.carried.push_back(name);
        return true;
    }
    void leave_out(const std::string& name, std::string why) { report_.left_out.push_back({name, std::move(why)}); }

    const From& from_;
    To& to_;
    conversion_report& report_;
    std::vector<FromHandle> from_handles_;
    std::vector<ToHandle> to_handles_;
    std::vector<std::string> made_;
};

template <class... More, mesh From, mesh To>
void copy_properties(const From& from, To& to, conversion_report& report)
{
    using from_traits = mesh_traits<From>;
    using to_traits = mesh_traits<To>;
    const auto for_each_kind = [](const auto& f) {
        f(typename from_traits::vertex(), typename to_traits::vertex());
        f(typename from_traits::halfedge(), typename to_traits::halfedge());
        f(typename from_traits::edge(), typename to_traits::edge());
        f(typename from_traits::face(), typename to_traits::face());
    };
    for_each_kind([&]<class FromHandle, class ToHandle>(FromHandle, ToHandle) {
        if constexpr (mesh_with_properties<From> and mesh_with_properties<To>) {
            using types = decltype(std::tuple_cat(std::declval<typename property_access<From>::value_types>(),
                                                  std::declval<typename property_access<To>::value_types>(),
                                                  std::declval<std::tuple<More...>>()));
            property_copier<FromHandle, ToHandle, From, To>(from, to, report).copy_all(static_cast<types*>(nullptr));
        } else if constexpr (mesh_with_properties<From>) {
            for (const std::string& name : property_access<From>::template names<FromHandle>(from))
                report.left_out.push_back({name, "the new mesh has no properties; property_mesh has"});
        }
    });
}

} // namespace detail

/// A mesh of another library with the same elements, in the same order, direction and start of each, and with all properties
/// that both can hold. Removed elements are left out.
/// A property keeps its name, its type and its values, on half-edges beyond the boundary, too. Colours, normals and texture
/// coordinates that have the name that the library of `mesh` gives them get that of the other one, and its type (with the
/// names of CGAL: "v:color", "v:normal", "v:texcoord"; of OpenMesh: "v:colors", "v:normals", "v:texcoords2D"). Coordinates are
/// rounded where To has other numbers. What was left out, or narrowed, is told.
/// Looked for are the types of values that property_access knows for either library, and More.
/// Errors: mesh_error for what is no mesh (isolated vertices, several fans at a vertex), for faces that To cannot hold. Cost:
/// O(elements), and that for each property.
template <refinable_mesh To, class... More, mesh From>
conversion<To> convert(const From& mesh)
{
    require_edges(mesh);
    conversion_report report;
    auto native = detail::with_points<typename mesh_traits<To>::point>(lift(mesh), report);
    conversion<To> result{mesh_traits<To>::build(std::move(native)), std::move(report)};
    detail::copy_properties<More...>(mesh, result.mesh, result.report);
    return result;
}

} // namespace kith
