// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "in_library.hpp"

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace kith {

/// The arithmetic of values of type T: how they are added and scaled by weights. A mask can be evaluated over any type
/// that has an `affine`: points, numbers, colours, stencil rows, hashes. Specialise it for your own type.
///
///   scalar            the type of the weights
///   sum               the accumulator
///   load(T) -> sum    store(sum) -> T
///   add(sum&, const sum&)    scale(sum&, scalar)
///   is_array = true   optional: a T in memory is exactly the array of numbers that `sum` is
template <class T>
struct affine;

/// The arithmetic of coordinates: N numbers, added and scaled one by one. Every point type accumulates in this form. So
/// the same scalar type gives the same bits for the points of every library.
template <class Scalar, std::size_t N>
struct coordinates_affine {
    using scalar = Scalar;
    using sum = std::array<Scalar, N>;

    static void add(sum& total, const sum& more)
    {
        for (std::size_t i = 0; i < N; ++i)
            total[i] += more[i];
    }
    static void scale(sum& total, const scalar& weight)
    {
        for (std::size_t i = 0; i < N; ++i)
            total[i] *= weight;
    }
};

template <class Scalar, std::size_t N>
struct affine<std::array<Scalar, N>> : coordinates_affine<Scalar, N> {
    static const std::array<Scalar, N>& load(const std::array<Scalar, N>& value) { return value; }
    static const std::array<Scalar, N>& store(const std::array<Scalar, N>& total) { return total; }
};

/// Returns a weighted sum as an integer: rounded to the nearest one, and clamped to the range of the type, as negative
/// weights may lead out of it.
template <std::integral Integer>
Integer rounded(double x)
{
    constexpr Integer least = std::numeric_limits<Integer>::min(), most = std::numeric_limits<Integer>::max();
    if (not(x > double(least))) // a NaN, too
        return least;
    return x >= double(most) ? most : Integer(std::round(x));
}

/// The arithmetic of integer coordinates, such as the channels of a colour: they are combined as doubles and rounded at
/// the end.
template <class T, std::integral Coordinate, std::size_t N>
struct rounded_affine : coordinates_affine<double, N> {
    using typename coordinates_affine<double, N>::sum;

    static sum load(const T& value)
    {
        sum result;
        for (std::size_t i = 0; i < N; ++i)
            result[i] = double(value[i]);
        return result;
    }
    static T store(const sum& total)
    {
        T result;
        for (std::size_t i = 0; i < N; ++i)
            result[i] = rounded<Coordinate>(total[i]);
        return result;
    }
};
template <std::integral Scalar, std::size_t N>
struct affine<std::array<Scalar, N>> : rounded_affine<std::array<Scalar, N>, Scalar, N> {};

/// The scalar type and the size of a vector of another library, if its size is fixed. Eigen gives the size as
/// constants, glm as length().
template <class T>
struct fixed_vector;
template <class T>
    requires requires(T& v) {
        requires T::RowsAtCompileTime > 0 and T::ColsAtCompileTime > 0;
        requires T::RowsAtCompileTime == 1 or T::ColsAtCompileTime == 1;
        requires std::is_arithmetic_v<typename T::Scalar>;
        { v[0] } -> std::same_as<typename T::Scalar&>;
    }
struct fixed_vector<T> {
    using scalar = typename T::Scalar;
    static constexpr std::size_t size = std::size_t(T::RowsAtCompileTime) * std::size_t(T::ColsAtCompileTime);
};
template <class T>
    requires requires(T& v) {
        typename T::length_type;
        requires T::length() > 0;
        requires std::is_arithmetic_v<typename T::value_type>;
        { v[0] } -> std::same_as<typename T::value_type&>;
    }
struct fixed_vector<T> {
    using scalar = typename T::value_type;
    static constexpr std::size_t size = std::size_t(T::length());
};
template <class T>
concept is_fixed_vector = requires { fixed_vector<T>::size; };

template <is_fixed_vector T>
struct affine<T> : coordinates_affine<typename fixed_vector<T>::scalar, fixed_vector<T>::size> {
    using typename coordinates_affine<typename fixed_vector<T>::scalar, fixed_vector<T>::size>::sum;

    static sum load(const T& value)
    {
        sum result;
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = value[int(i)];
        return result;
    }
    static T store(const sum& total)
    {
        T result;
        for (std::size_t i = 0; i < total.size(); ++i)
            result[int(i)] = total[i];
        return result;
    }
};
template <is_fixed_vector T>
    requires std::integral<typename fixed_vector<T>::scalar>
struct affine<T> : rounded_affine<T, typename fixed_vector<T>::scalar, fixed_vector<T>::size> {};

template <std::floating_point Scalar>
struct affine<Scalar> {
    using scalar = Scalar;
    using sum = Scalar;

    static Scalar load(Scalar value) { return value; }
    static Scalar store(Scalar total) { return total; }
    static void add(Scalar& total, Scalar more) { total += more; }
    static void scale(Scalar& total, Scalar weight) { total *= weight; }
};

/// The type of the weights for values of type T.
template <class T>
using scalar_of = typename affine<T>::scalar;

/// A value that masks can combine and that arrays can hold.
template <class T>
concept affine_value = requires(const T& value, typename affine<T>::sum total, typename affine<T>::scalar weight) {
    requires std::copyable<T> and std::default_initializable<T>;
    { affine<T>::load(value) } -> std::convertible_to<typename affine<T>::sum>;
    { affine<T>::store(total) } -> std::convertible_to<T>;
    affine<T>::add(total, total);
    affine<T>::scale(total, weight);
};

/// A point of another library that consists of its coordinates and nothing else. So an array of these points has the
/// same bytes as an array of coordinate arrays.
template <class T>
concept array_point = affine_value<T> and requires { requires affine<T>::is_array; } and
                      std::is_trivially_copyable_v<T> and sizeof(T) == sizeof(typename affine<T>::sum) and
                      alignof(T) == alignof(typename affine<T>::sum);

/// The point type of a native mesh that stands for points of type T: a plain array for each `array_point`, T itself
/// otherwise. So the same code refines the points of all libraries.
template <class T>
struct native_point {
    using type = T;
};
template <array_point T>
struct native_point<T> {
    using type = typename affine<T>::sum;
};

} // namespace kith
