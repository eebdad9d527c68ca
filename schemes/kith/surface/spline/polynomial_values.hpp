// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_polynomial.hpp"

#include <array>
#include <cstddef>

namespace kith::detail {

/// The evaluation of polynomials by Horner's rule over numbers of any kind: Number has the members of `affine`. All
/// arguments are passed by reference, since numbers may be in registers that not every processor has.
template <class Number>
struct polynomial_values {
    using sum = typename Number::sum;

    /// Adds weight * x.
    [[gnu::always_inline]] static void add_scaled(sum& total, const sum& x, double weight)
    {
        sum more = x;
        Number::scale(more, static_cast<typename Number::scalar>(weight));
        Number::add(total, more);
    }
    /// Writes a value with its derivatives, as many as there are outputs: value, s, t, ss, st, tt. write_row(i, to)
    /// writes the coefficient of s^i, with its derivatives by t.
    template <std::size_t Outputs, class Parameter, class WriteRow>
    [[gnu::always_inline]] static void evaluate(const surface_polynomial& polynomial, const Parameter& s,
                                                const WriteRow& write_row, std::array<sum, Outputs>& result)
    {
        write_row(polynomial.degree, result);
        for (std::size_t i = polynomial.degree; i-- > 0;) {
            std::array<sum, Outputs> row;
            write_row(i, row);
            // Derivatives come before the values that they are derivatives of.
            if constexpr (Outputs > 3) {
                multiply_and_add(result[3], s, result[1]);
                Number::add(result[3], result[1]);
                multiply_and_add(result[4], s, result[2]);
                multiply_and_add(result[5], s, row[5]);
            }
            if constexpr (Outputs > 1) {
                multiply_and_add(result[1], s, result[0]);
                multiply_and_add(result[2], s, row[2]);
            }
            multiply_and_add(result[0], s, row[0]);
        }
    }
    /// Writes the coefficient of s^i, a polynomial in t, with its derivatives by t; all others are zero.
    template <std::size_t Outputs, class Parameter>
    [[gnu::always_inline]] static void evaluate_row(const surface_polynomial& polynomial, const sum* coefficients,
                                                    std::size_t i, const Parameter& t, std::array<sum, Outputs>& result)
    {
        const sum* const row = coefficients + polynomial.begin_of_row(i);
        std::size_t j = polynomial.row_size(i) - 1;
        for (std::size_t output = 0; output < Outputs; ++output) {
            result[output] = row[j];
            if (output > 0)
                Number::scale(result[output], typename Number::scalar(0));
        }
        while (j-- > 0) {
            if constexpr (Outputs > 3) {
                multiply_and_add(result[5], t, result[2]);
                Number::add(result[5], result[2]);
            }
            if constexpr (Outputs > 1)
                multiply_and_add(result[2], t, result[0]);
            multiply_and_add(result[0], t, row[j]);
        }
    }

private:
    template <class Factor>
    [[gnu::always_inline]] static void multiply_and_add(sum& total, const Factor& factor, const sum& more)
    {
        Number::scale(total, factor);
        Number::add(total, more);
    }
};

} // namespace kith::detail
