// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cgal.hpp"

#include <kith/carry_properties.hpp>
#include <kith/property/standard_property.hpp>

#include <CGAL/IO/Color.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Point_2.h>
#include <CGAL/Vector_2.h>
#include <CGAL/Vector_3.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace kith {

namespace detail {

/// Points and vectors of a kernel.
template <class T, std::size_t N>
struct averaged_cartesian {
    template <class Number>
    static four_numbers<Number> load(const T& value)
    {
        four_numbers<Number> x{};
        for (std::size_t i = 0; i < N; ++i)
            x[i] = Number(value[int(i)]);
        return x;
    }
    template <class Number>
    static T store(const four_numbers<Number>& x)
    {
        const auto coordinate = [](const Number& c) {
            return as_coordinate<typename CGAL::Kernel_traits<T>::Kernel::FT>(c);
        };
        if constexpr (N == 2)
            return T(coordinate(x[0]), coordinate(x[1]));
        else
            return T(coordinate(x[0]), coordinate(x[1]), coordinate(x[2]));
    }
};

} // namespace detail

template <class Kernel>
struct averaged_value<CGAL::Point_2<Kernel>> : detail::averaged_cartesian<CGAL::Point_2<Kernel>, 2> {};
template <class Kernel>
struct averaged_value<CGAL::Vector_2<Kernel>> : detail::averaged_cartesian<CGAL::Vector_2<Kernel>, 2> {};
template <class Kernel>
struct averaged_value<CGAL::Point_3<Kernel>> : detail::averaged_cartesian<CGAL::Point_3<Kernel>, 3> {};
template <class Kernel>
struct averaged_value<CGAL::Vector_3<Kernel>> : detail::averaged_cartesian<CGAL::Vector_3<Kernel>, 3> {};

template <>
struct averaged_value<CGAL::IO::Color> {
    template <class Number>
    static detail::four_numbers<Number> load(const CGAL::IO::Color& c)
    {
        return {Number(c.red()), Number(c.green()), Number(c.blue()), Number(c.alpha())};
    }
    template <class Number>
    static CGAL::IO::Color store(const detail::four_numbers<Number>& x)
    {
        const auto channel = [](const Number& c) { return detail::as_coordinate<unsigned char>(CGAL::to_double(c)); };
        return {channel(x[0]), channel(x[1]), channel(x[2]), channel(x[3])};
    }
};

/// The property maps of a CGAL::Surface_mesh.
template <class Point>
struct property_access<CGAL::Surface_mesh<Point>> {
    using mesh = CGAL::Surface_mesh<Point>;
    using kernel = typename CGAL::Kernel_traits<Point>::Kernel;
    /// Exact numbers stay exact, floats are averaged as doubles.
    using number = std::conditional_t<std::floating_point<typename kernel::FT>, double, typename kernel::FT>;
    using value_types = std::tuple<
        bool, char, signed char, unsigned char, short, unsigned short, int, unsigned, long, unsigned long, long long,
        unsigned long long, float, double, std::string, CGAL::IO::Color, CGAL::Point_2<kernel>, CGAL::Vector_2<kernel>,
        CGAL::Point_3<kernel>, CGAL::Vector_3<kernel>, std::array<float, 2>, std::array<float, 3>, std::array<float, 4>,
        std::array<double, 2>, std::array<double, 3>, std::array<double, 4>>;

    template <class Handle>
    static std::vector<std::string> names(const mesh& m)
    {
        std::vector<std::string> result = m.template properties<Handle>();
        std::erase_if(result, is_reserved);
        return result;
    }
    static bool is_reserved(const std::string& name)
    {
        return name == "v:point" or name.ends_with(":connectivity") or name.ends_with(":removed") or
               name.find(":kith:") != std::string::npos;
    }
    static bool follows_from_points(const std::string&) { return false; }
    template <class Handle, class T>
    static auto find(const mesh& m, const std::string& name)
    {
        const auto found = m.template property_map<Handle, T>(name);
        if constexpr (requires { found.has_value(); }) // from CGAL 6 on
            return found;
        else
            return found.second ? std::optional(found.first) : std::nullopt;
    }
    template <class Handle, class T>
    static auto add(mesh& m, const std::string& name)
    {
        return m.template add_property_map<Handle, T>(name).first;
    }

    /// As CGAL's readers and writers call them.
    template <class Handle>
    static std::string standard_name(standard_property which)
    {
        return detail::standard_name<mesh, Handle>(which, {"color", "normal", "texcoord"});
    }
    template <standard_property Which>
    using standard_type = std::conditional_t<
        Which == standard_property::color, CGAL::IO::Color,
        std::conditional_t<Which == standard_property::normal, CGAL::Vector_3<kernel>, CGAL::Point_2<kernel>>>;
};

} // namespace kith
