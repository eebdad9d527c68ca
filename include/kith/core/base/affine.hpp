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

/// How values of type T are combined with weights. A mask is evaluated over anything that has an `affine`:
/// points, numbers, colours, stencil rows, hashes. Specialise it for your own type.
///
///   scalar            the type of the weights
///   sum               the accumulator
///   load(T) -> sum    store(sum) -> T
///   add(sum&, const sum&)    scale(sum&, scalar)
///   is_array = true   optional: a T is the array of numbers that `sum` is, and nothing else
template <class T>
struct affine;

/// Coordinates: N numbers, added and scaled one by one. Every point type accumulates in this form, so that the same
/// scalar gives the same bits whatever library the point comes from.
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

/// A weighted sum as an integer: rounded, and kept in range where weights are negative.
template <std::integral Integer>
Integer rounded(double x)
{
    constexpr Integer least = std::numeric_limits<Integer>::min(), most = std::numeric_limits<Integer>::max();
    if (not(x > double(least))) // no number, too
        return least;
    return x >= double(most) ? most : Integer(std::round(x));
}

/// Coordinates that are integers, such as the channels of a colour: combined as doubles and rounded at the end.
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

/// Vectors of other libraries with a fixed number of coordinates, by their shape: Eigen's say it in constants, glm's by
/// length().
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

/// The type of the weights of T.
template <class T>
using scalar_of = typename affine<T>::scalar;

/// A value that masks combine, and that arrays hold.
template <class T>
concept affine_value = requires(const T& value, typename affine<T>::sum total, typename affine<T>::scalar weight) {
    requires std::copyable<T> and std::default_initializable<T>;
    { affine<T>::load(value) } -> std::convertible_to<typename affine<T>::sum>;
    { affine<T>::store(total) } -> std::convertible_to<T>;
    affine<T>::add(total, total);
    affine<T>::scale(total, weight);
};

/// A point of another library that is an array of its coordinates, to the bit: in memory an array of such points is one
/// of arrays.
template <class T>
concept array_point = affine_value<T> and requires { requires affine<T>::is_array; } and
                      std::is_trivially_copyable_v<T> and sizeof(T) == sizeof(typename affine<T>::sum) and
                      alignof(T) == alignof(typename affine<T>::sum);

/// What a native mesh has in place of such points, so that the points of all libraries are refined by the same code.
template <class T>
struct native_point {
    using type = T;
};
template <array_point T>
struct native_point<T> {
    using type = typename affine<T>::sum;
};

} // namespace kith
