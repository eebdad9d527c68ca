// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cgal.hpp"

#include <kith/core/base/affine.hpp>
#include <kith/fields/property/averaged_value.hpp>

#include <CGAL/IO/Color.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>
#include <CGAL/Vector_2.h>
#include <CGAL/Vector_3.h>
#include <CGAL/number_type_basic.h>

#include <concepts>
#include <cstddef>
#include <type_traits>

/// Values of CGAL's types, which masks combine like points.
namespace kith {

namespace detail {

/// The points of meshes, which lie in space, and all points and vectors of a kernel, in the plane or in space.
template <class T, class Kernel = typename CGAL::Kernel_traits<T>::Kernel>
concept point_of_meshes = std::same_as<T, CGAL::Point_3<Kernel>>;
template <class T, class Kernel = typename CGAL::Kernel_traits<T>::Kernel>
concept point_or_vector = point_of_meshes<T> or std::same_as<T, CGAL::Point_2<Kernel>> or
                          std::same_as<T, CGAL::Vector_2<Kernel>> or std::same_as<T, CGAL::Vector_3<Kernel>>;

/// The arithmetic of points and vectors, which are combined like the points of a mesh: exact values are evaluated at
/// once, unless `lazy_numbers` are kept.
template <class T, std::size_t N>
struct affine_cartesian : coordinates_affine<typename CGAL::Kernel_traits<T>::Kernel::FT, N> {
    using typename coordinates_affine<typename CGAL::Kernel_traits<T>::Kernel::FT, N>::sum;

    static sum load(const T& value)
    {
        sum result;
        for (std::size_t i = 0; i < N; ++i)
            result[i] = value[int(i)];
        return result;
    }
    static T store(const sum& total)
    {
        const T result = [&] {
            if constexpr (N == 2)
                return T(total[0], total[1]);
            else
                return T(total[0], total[1], total[2]);
        }();
        if constexpr (requires { exact(result); })
            if (not lazy_numbers::are_kept())
                exact(result);
        return result;
    }
};

/// The conversion of points and vectors to four numbers and back, by which they are averaged.
template <class T, std::size_t N>
struct averaged_cartesian {
    static T nothing() { return store(four_numbers<double>{}); }
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

/// A class of numbers that can be divided, such as the numbers of an exact kernel.
template <class T>
concept class_of_numbers =
    std::is_class_v<T> and
    std::derived_from<typename CGAL::Algebraic_structure_traits<T>::Algebraic_category, CGAL::Field_tag>;

} // namespace detail

/// The arithmetic of points and vectors, except points of meshes: cgal.hpp has that beside the traits of meshes.
template <detail::point_or_vector T>
    requires(not detail::point_of_meshes<T>)
struct affine<T> : detail::affine_cartesian<T, T::Ambient_dimension::value> {};
template <detail::point_or_vector T>
struct averaged_value<T> : detail::averaged_cartesian<T, T::Ambient_dimension::value> {};

/// The arithmetic of CGAL's number types, for example exact ones.
template <detail::class_of_numbers Number>
struct affine<Number> {
    using scalar = Number;
    using sum = Number;

    static const Number& load(const Number& value) { return value; }
    static const Number& store(const Number& total)
    {
        if constexpr (requires { exact(total); })
            if (not lazy_numbers::are_kept())
                exact(total);
        return total;
    }
    static void add(Number& total, const Number& more) { total += more; }
    static void scale(Number& total, const Number& weight) { total *= weight; }
};
template <detail::class_of_numbers T>
struct averaged_value<T> {
    template <class Number>
    static detail::four_numbers<Number> load(const T& value)
    {
        return {detail::as_coordinate<Number>(value)};
    }
    template <class Number>
    static T store(const detail::four_numbers<Number>& x)
    {
        return detail::as_coordinate<T>(x[0]);
    }
    static T nothing() { return T(0); }
};

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

template <>
struct affine<CGAL::IO::Color> : coordinates_affine<double, 4> {
    static sum load(const CGAL::IO::Color& c) { return averaged_value<CGAL::IO::Color>::load<double>(c); }
    static CGAL::IO::Color store(const sum& total) { return averaged_value<CGAL::IO::Color>::store(total); }
};

} // namespace kith
