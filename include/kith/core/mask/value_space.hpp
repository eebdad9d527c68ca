// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <concepts>

namespace kith {

/// A type of numbers in which weights are computed: float, double, a rational or interval number of another library.
template <class S>
concept weight_number = requires(const S& a, const S& b) {
    requires std::copyable<S> and std::constructible_from<S, double> and std::constructible_from<S, int>;
    { a / b } -> std::convertible_to<S>; // 1/n, exact over exact numbers
};

/// A space of values over which masks are evaluated: points, values of the user, rows of the subdivision matrix, hashes
/// of the operands. A mask adds and scales its operands in the order of its text and does nothing else. So equal texts
/// give equal bits.
template <class V>
concept value_space = requires(typename V::sum& total, const typename V::sum& more, const typename V::scalar& weight) {
    requires weight_number<typename V::scalar>;
    requires std::copyable<typename V::sum>; // an operand, and what a mask has added up so far
    V::add(total, more);                     // total + more, in this order
    V::scale(total, weight);                 // total times a weight
};

/// A type that names the scalar type of an evaluation.
template <class T>
concept has_scalar = requires { requires weight_number<typename T::scalar>; };

} // namespace kith
