// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "placed_pieces.hpp"

#include <kith/core/base/affine.hpp>
#include <kith/core/mask/stencil.hpp>
#include <kith/surface/spline/fast_affine.hpp>
#include <kith/surface/spline/polynomial_values.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace kith::detail {

/// Replaces the derivatives of a value by the parameters of a piece with those by the parameters of the face. Unknown
/// derivatives become NaN.
template <class Number, std::size_t Outputs>
[[gnu::always_inline]] inline void take_parameters_of_face(const surface_piece& at,
                                                           std::array<typename Number::sum, Outputs>& values)
{
    using sum = typename Number::sum;
    using scalar = typename Number::scalar;
    const auto scale = [](sum& x, double weight) { Number::scale(x, static_cast<scalar>(weight)); };
    if constexpr (Outputs > 1) {
        const sum by_s = values[1], by_t = values[2];
        const auto write = [&](sum& to, double s, double t) {
            to = by_s;
            scale(to, s);
            polynomial_values<Number>::add_scaled(to, by_t, t);
        };
        write(values[1], at.s_u, at.t_u);
        write(values[2], at.s_v, at.t_v);
    }
    if constexpr (Outputs > 3) {
        const sum ss = values[3], st = values[4], tt = values[5];
        const auto write = [&](sum& to, double s1, double t1, double s2, double t2) {
            to = ss;
            scale(to, s1 * s2);
            polynomial_values<Number>::add_scaled(to, st, s1 * t2 + s2 * t1);
            polynomial_values<Number>::add_scaled(to, tt, t1 * t2);
        };
        write(values[3], at.s_u, at.t_u, at.s_u, at.t_u);
        write(values[4], at.s_u, at.t_u, at.s_v, at.t_v);
        write(values[5], at.s_v, at.t_v, at.s_v, at.t_v);
    }
    constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 1; i < Outputs; ++i)
        if (at.polynomial->derivatives < (i < 3 ? 1 : 2))
            scale(values[i], no_number);
}

/// The coefficients of pieces of a limit surface for control values of a type, and the values that the pieces have.
template <affine_value T>
class piece_values {
    using number = fast_affine<T>;

public:
    using sum = typename number::sum;

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
        sum total = points[std::size_t(rows.column[k])];
        number::scale(total, static_cast<typename number::scalar>(rows.weight[k]));
        for (++k; k < rows.begin_of_row(row + 1); ++k)
            values::add_scaled(total, points[std::size_t(rows.column[k])], rows.weight[k]);
        return total;
    }

    /// Returns the value at a place of a piece and, if there are 3 or 6 outputs, its derivatives by u and v: du, dv,
    /// duu, duv, dvv. Unknown derivatives are NaN.
    template <std::size_t Outputs>
    [[nodiscard]] std::array<sum, Outputs> at(const surface_piece& piece, const placed_parameters& here) const
    {
        const auto s = static_cast<typename number::scalar>(here.s);
        std::array<sum, Outputs> result;
        values::template evaluate<Outputs>(
            *piece.polynomial,
            s,
            [&](std::size_t i, std::array<sum, Outputs>& row) { write_row(piece, here, i, row); },
            result);
        take_parameters_of_face<number>(piece, result);
        return result;
    }
    /// Writes the coefficient of s^i at the t of a place, with its derivatives by t.
    template <std::size_t Outputs>
    void write_row(const surface_piece& piece, const placed_parameters& here, std::size_t i,
                   std::array<sum, Outputs>& row) const
    {
        const auto t = static_cast<typename number::scalar>(here.t);
        values::template evaluate_row<Outputs>(
            *piece.polynomial, coefficients_.data() + first_coefficient_[here.piece], i, t, row);
    }

private:
    using values = polynomial_values<number>;

    std::vector<sum> points_;                    // of the face that was added last
    std::vector<std::size_t> first_point_;       // of each of its nets
    std::vector<sum> coefficients_;              // of all pieces
    std::vector<std::size_t> first_coefficient_; // of each piece
};

} // namespace kith::detail
