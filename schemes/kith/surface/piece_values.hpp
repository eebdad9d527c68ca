// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast_affine.hpp"
#include "placed_pieces.hpp"

#include <kith/base/affine.hpp>
#include <kith/mask/stencil.hpp>
#include <kith/spline/surface_polynomial.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace kith::detail {

/// The coefficients of pieces of a limit surface for control values of a type, and the values that the pieces have.
template <affine_value T>
class piece_values {
    using number = fast_affine<T>;

public:
    using sum = typename number::sum;
    /// The coefficients of the powers of s at some t, each with its derivatives by t.
    template <std::size_t Outputs>
    using line = std::array<std::array<sum, Outputs>, surface_polynomial::most_degree + 1>;

    void clear()
    {
        coefficients_.clear();
        first_coefficient_.clear();
    }
    /// Adds the pieces of a face. control_of(input) returns the sum of one of the inputs of `all`. Cost: that of a
    /// product with a matrix of some dozen rows.
    template <class ControlOf>
    void add_face(const placed_pieces& all, std::size_t face, const ControlOf& control_of)
    {
        const end_of_face begin = face == 0 ? end_of_face{0, 0, 0} : all.faces[face - 1], end = all.faces[face];
        points_.clear();
        first_point_.clear();
        for (std::size_t n = begin.nets; n < end.nets; ++n) {
            const surface_net& net = all.nets[n];
            first_point_.push_back(points_.size());
            for (std::size_t i = 0; i < net.size; ++i)
                if (net.rows == nullptr)
                    points_.push_back(control_of(net.parent + i));
                else
                    points_.push_back(row_of(*net.rows, i, points_.data() + first_point_[net.parent]));
        }
        for (std::size_t p = begin.pieces; p < end.pieces; ++p) {
            const surface_piece& piece = all.pieces[p];
            first_coefficient_.push_back(coefficients_.size());
            for (std::size_t term = 0; term < piece.polynomial->terms(); ++term)
                coefficients_.push_back(row_of(piece.polynomial->rows, term, points_.data() + first_point_[piece.net]));
        }
    }

    /// Returns the sum of points with the weights of a row.
    static sum row_of(const subdivision_matrix& rows, std::size_t row, const sum* points)
    {
        std::size_t k = rows.begin_of_row(row);
        sum total = scaled(points[std::size_t(rows.column[k])], rows.weight[k]);
        for (++k; k < rows.begin_of_row(row + 1); ++k)
            add_scaled(total, points[std::size_t(rows.column[k])], rows.weight[k]);
        return total;
    }

    /// Returns the value at a place and, if there are 3 or 6 outputs, its derivatives by u and v: du, dv, duu, duv, dvv.
    /// `piece` is the piece of the place. Derivatives that are not known are no numbers.
    template <std::size_t Outputs>
    [[nodiscard]] std::array<sum, Outputs> at(const surface_piece& piece, const placed_parameters& here) const
    {
        const sum* const coefficients = coefficients_.data() + first_coefficient_[here.piece];
        return by_parameters_of_face(piece, sums<Outputs>(*piece.polynomial, here.s, [&](std::size_t i) {
                                         return row_at<Outputs>(*piece.polynomial, coefficients, i, here.t);
                                     }));
    }
    /// Writes the line of all s at the t of a place.
    template <std::size_t Outputs>
    void make_line(const surface_piece& piece, const placed_parameters& here, line<Outputs>& to) const
    {
        const sum* const coefficients = coefficients_.data() + first_coefficient_[here.piece];
        for (std::size_t i = 0; i <= piece.polynomial->degree; ++i)
            to[i] = row_at<Outputs>(*piece.polynomial, coefficients, i, here.t);
    }
    /// Returns what `at` returns, to the bit, for a place on the line that was made of its piece.
    template <std::size_t Outputs>
    static std::array<sum, Outputs> on_line(const surface_piece& piece, double s, const line<Outputs>& of_t)
    {
        return by_parameters_of_face(
            piece, sums<Outputs>(*piece.polynomial, s, [&](std::size_t i) -> const auto& { return of_t[i]; }));
    }

private:
    /// Returns weight * x.
    static sum scaled(sum x, double weight)
    {
        number::scale(x, static_cast<typename number::scalar>(weight));
        return x;
    }
    static void add_scaled(sum& total, const sum& x, double weight) { number::add(total, scaled(x, weight)); }
    template <class Scalar>
    static void multiply_and_add(sum& total, const Scalar& factor, const sum& more)
    {
        number::scale(total, factor);
        number::add(total, more);
    }
    /// Returns a value and its derivatives by the parameters of the face, from those by the parameters of the piece.
    template <std::size_t Outputs>
    static std::array<sum, Outputs> by_parameters_of_face(const surface_piece& at, const std::array<sum, Outputs>& made)
    {
        std::array<sum, Outputs> result = made;
        if constexpr (Outputs > 1) {
            const auto first = [&](double by_s, double by_t) {
                sum total = scaled(made[1], by_s);
                add_scaled(total, made[2], by_t);
                return total;
            };
            result[1] = first(at.s_u, at.t_u);
            result[2] = first(at.s_v, at.t_v);
        }
        if constexpr (Outputs > 3) {
            const auto second = [&](double s1, double t1, double s2, double t2) {
                sum total = scaled(made[3], s1 * s2);
                add_scaled(total, made[4], s1 * t2 + s2 * t1);
                add_scaled(total, made[5], t1 * t2);
                return total;
            };
            result[3] = second(at.s_u, at.t_u, at.s_u, at.t_u);
            result[4] = second(at.s_u, at.t_u, at.s_v, at.t_v);
            result[5] = second(at.s_v, at.t_v, at.s_v, at.t_v);
        }
        constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
        for (std::size_t i = 1; i < Outputs; ++i)
            if (at.polynomial->derivatives < (i < 3 ? 1 : 2))
                result[i] = scaled(result[i], no_number);
        return result;
    }
    /// Returns a value with its derivatives, as many as there are outputs: value, s, t, ss, st, tt. row_of_power(i)
    /// returns the coefficient of s^i, with its derivatives by t.
    template <std::size_t Outputs, class RowOfPower>
    static std::array<sum, Outputs> sums(const surface_polynomial& polynomial, double s, const RowOfPower& row_of_power)
    {
        const auto x = static_cast<typename number::scalar>(s);
        std::array<sum, Outputs> result = row_of_power(polynomial.degree);
        for (std::size_t i = polynomial.degree; i-- > 0;) {
            const std::array<sum, Outputs>& row = row_of_power(i);
            // Horner's rule: derivatives come before what they are derivatives of.
            if constexpr (Outputs > 3) {
                multiply_and_add(result[3], x, result[1]);
                number::add(result[3], result[1]);
                multiply_and_add(result[4], x, result[2]);
                multiply_and_add(result[5], x, row[5]);
            }
            if constexpr (Outputs > 1) {
                multiply_and_add(result[1], x, result[0]);
                multiply_and_add(result[2], x, row[2]);
            }
            multiply_and_add(result[0], x, row[0]);
        }
        return result;
    }
    /// Returns the coefficient of s^i, a polynomial in t, with its derivatives by t; all others are zero.
    template <std::size_t Outputs>
    static std::array<sum, Outputs> row_at(const surface_polynomial& polynomial, const sum* coefficients, std::size_t i,
                                           double t)
    {
        const auto y = static_cast<typename number::scalar>(t);
        const sum* const row = coefficients + polynomial.begin_of_row(i);
        std::size_t j = polynomial.row_size(i) - 1;
        std::array<sum, Outputs> result;
        if constexpr (Outputs > 1)
            result.fill(scaled(row[j], 0));
        result[0] = row[j];
        while (j-- > 0) {
            if constexpr (Outputs > 3) {
                multiply_and_add(result[5], y, result[2]);
                number::add(result[5], result[2]);
            }
            if constexpr (Outputs > 1)
                multiply_and_add(result[2], y, result[0]);
            multiply_and_add(result[0], y, row[j]);
        }
        return result;
    }

    std::vector<sum> points_;                    // of the face that was added last
    std::vector<std::size_t> first_point_;       // of each of its nets
    std::vector<sum> coefficients_;              // of all pieces
    std::vector<std::size_t> first_coefficient_; // of each piece
};

} // namespace kith::detail
