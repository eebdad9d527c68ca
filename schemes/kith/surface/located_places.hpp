// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast_affine.hpp"
#include "placed_pieces.hpp"

#include <kith/base/affine.hpp>
#include <kith/base/error.hpp>
#include <kith/base/for_parts.hpp>
#include <kith/base/storage.hpp>
#include <kith/mask/stencil.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <ranges>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// The derivatives of a limit surface that a caller asks for; second ones come with first ones.
enum class derivatives : unsigned char { none, first, second };

/// Values of a limit surface at some places, in the order of the places, and their derivatives by the parameters of the
/// faces. Derivatives that were not asked for are empty.
template <class T>
struct surface_values {
    storage<T> points;
    storage<T> du{}, dv{};
    storage<T> duu{}, duv{}, dvv{};
};

/// Places on a limit surface that have been located: the polynomial of each. They can be evaluated any number of times,
/// for control points that move and for other values at the vertices of the control mesh.
class located_places {
public:
    located_places() = default;
    /// Takes over what `surface_locator` has found.
    explicit located_places(detail::placed_pieces pieces) : all_(std::move(pieces)) {}

    [[nodiscard]] std::size_t size() const { return all_.places.size(); }

    /// Returns the values of the limit surface for a value per vertex of the control mesh, such as points, colours or
    /// rows of weights, and their derivatives; for a value per corner if the places were located for those. See
    /// `surface_locator` for what is not known at irregular vertices; such derivatives are no numbers. Runs on the
    /// threads of OpenMP where values are plain bytes. Errors: mesh_error unless there is a value for each.
    /// Cost: O(places), and for each face with places that of a product with a matrix of some dozen rows.
    template <affine_value T>
    [[nodiscard]] surface_values<T> evaluate(std::span<const T> control, derivatives wanted = derivatives::none) const
    {
        if (control.size() != all_.values) {
            const std::string elements = all_.are_at_corners ? "corners" : "vertices";
            throw mesh_error("places on a surface with " + std::to_string(all_.values) + " control " + elements +
                             " were given " + std::to_string(control.size()) + " values; give one for each of these " +
                             elements);
        }
        surface_values<T> result{storage<T>(size())};
        if (wanted != derivatives::none)
            for (storage<T>* values : {&result.du, &result.dv})
                *values = storage<T>(size());
        if (wanted == derivatives::second)
            for (storage<T>* values : {&result.duu, &result.duv, &result.dvv})
                *values = storage<T>(size());
        const bool is_parallel = std::is_trivially_copyable_v<T> and detail::is_worth_threads(size());
        detail::for_parts(
            all_.groups.size(),
            is_parallel,
            [&](std::size_t begin, std::size_t end) {
                group_memory<typename detail::fast_affine<T>::sum> memory;
                for (std::size_t group = begin; group < end; ++group)
                    switch (wanted) {
                    case derivatives::none: evaluate_group<1>(group, control, memory, result); break;
                    case derivatives::first: evaluate_group<3>(group, control, memory, result); break;
                    case derivatives::second: evaluate_group<6>(group, control, memory, result); break;
                    }
            },
            2);
        return result;
    }
    template <std::ranges::contiguous_range Values>
        requires affine_value<std::ranges::range_value_t<Values>>
    [[nodiscard]] auto evaluate(const Values& values, derivatives wanted = derivatives::none) const
    {
        return evaluate(std::span<const std::ranges::range_value_t<Values>>(values), wanted);
    }

    /// Returns the weights of the control vertices in the values at the places, a row per place, and in derivatives.
    /// Errors: mesh_error where a derivative is asked for that is not known. Cost: O(entries log of them).
    [[nodiscard]] surface_values<stencil_row> weights(derivatives wanted = derivatives::none) const
    {
        for (std::size_t group = 0; group < all_.groups.size(); ++group)
            for (const auto& place : places_of(group))
                if (pieces_of(group)[place.piece].polynomial->derivatives < int(wanted))
                    throw mesh_error("place " + std::to_string(place.number) +
                                     " is an irregular vertex, at which such derivatives have no finite value; ask for "
                                     "fewer derivatives or move the place");
        return evaluate(unit_rows(all_.values), wanted);
    }

private:
    /// The memory of a thread while it evaluates groups of faces.
    template <class Sum>
    struct group_memory {
        std::vector<Sum> points;                    ///< of the face at work
        std::vector<std::size_t> first_point;       ///< of each of its nets
        std::vector<Sum> coefficients;              ///< of all pieces of the group
        std::vector<std::size_t> first_coefficient; ///< of each piece
    };

    /// Returns weight * x.
    template <class T>
    static typename detail::fast_affine<T>::sum scaled(typename detail::fast_affine<T>::sum x, double weight)
    {
        detail::fast_affine<T>::scale(x, static_cast<typename detail::fast_affine<T>::scalar>(weight));
        return x;
    }
    /// Returns the end of all that belongs to the faces before one, or before a group.
    [[nodiscard]] detail::end_of_face begin_of_face(std::size_t face) const
    {
        return face == 0 ? detail::end_of_face{0, 0, 0} : all_.faces[face - 1];
    }
    [[nodiscard]] detail::end_of_group begin_of_group(std::size_t group) const
    {
        return group == 0 ? detail::end_of_group{0, 0} : all_.groups[group - 1];
    }
    [[nodiscard]] std::span<const detail::placed_parameters> places_of(std::size_t group) const
    {
        const std::size_t first = begin_of_group(group).places;
        return std::span(all_.places).subspan(first, all_.groups[group].places - first);
    }
    [[nodiscard]] std::span<const detail::surface_piece> pieces_of(std::size_t group) const
    {
        const std::size_t first = begin_of_face(begin_of_group(group).faces).pieces;
        return std::span(all_.pieces).subspan(first, all_.faces[all_.groups[group].faces - 1].pieces - first);
    }

    /// Evaluates the places of a group: the coefficients of its faces first, so that values are written in their order.
    template <std::size_t Outputs, class T, class Sum>
    void evaluate_group(std::size_t group, std::span<const T> control, group_memory<Sum>& memory,
                        surface_values<T>& result) const
    {
        memory.coefficients.clear();
        memory.first_coefficient.clear();
        for (std::size_t face = begin_of_group(group).faces; face < all_.groups[group].faces; ++face)
            add_coefficients(face, control, memory);
        const auto pieces = pieces_of(group);
        for (const auto& place : places_of(group))
            store<T, Outputs>(
                pieces[place.piece], memory.coefficients.data() + memory.first_coefficient[place.piece], place, result);
    }
    template <class T, class Sum>
    void add_coefficients(std::size_t face, std::span<const T> control, group_memory<Sum>& memory) const
    {
        const detail::end_of_face begin = begin_of_face(face), end = all_.faces[face];
        auto& [points, first_point, coefficients, first_coefficient] = memory;
        points.clear();
        first_point.clear();
        for (std::size_t n = begin.nets; n < end.nets; ++n) {
            const detail::surface_net& net = all_.nets[n];
            first_point.push_back(points.size());
            for (std::size_t i = 0; i < net.size; ++i)
                if (net.rows == nullptr)
                    points.push_back(detail::fast_affine<T>::load(control[all_.inputs[net.parent + i]]));
                else
                    points.push_back(
                        row_of<T>(*net.rows, i, std::span<const Sum>(points).subspan(first_point[net.parent])));
        }
        for (std::size_t p = begin.pieces; p < end.pieces; ++p) {
            const detail::surface_piece& piece = all_.pieces[p];
            const auto of_net = std::span<const Sum>(points).subspan(first_point[piece.net]);
            first_coefficient.push_back(coefficients.size());
            for (std::size_t term = 0; term < piece.polynomial->terms(); ++term)
                coefficients.push_back(row_of<T>(piece.polynomial->rows, term, of_net));
        }
    }
    template <class T, class Sum>
    static Sum row_of(const subdivision_matrix& rows, std::size_t row, std::span<const Sum> points)
    {
        std::size_t k = rows.begin_of_row(row);
        Sum total = scaled<T>(points[std::size_t(rows.column[k])], rows.weight[k]);
        for (++k; k < rows.begin_of_row(row + 1); ++k)
            detail::fast_affine<T>::add(total, scaled<T>(points[std::size_t(rows.column[k])], rows.weight[k]));
        return total;
    }
    /// Writes the value at a place and, if there are 3 or 6 outputs, its first or first and second derivatives.
    template <class T, std::size_t Outputs, class Sum>
    static void store(const detail::surface_piece& at, const Sum* coefficients, const detail::placed_parameters& here,
                      surface_values<T>& result)
    {
        const detail::surface_polynomial& polynomial = *at.polynomial;
        const auto made = sums<T, Outputs>(polynomial, coefficients, here.s, here.t);
        const auto write = [&](storage<T>& to, const Sum& x, int needed) {
            constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
            to[here.number] = detail::fast_affine<T>::store(polynomial.derivatives < needed ? scaled<T>(x, no_number)
                                                                                            : x);
        };
        write(result.points, made[0], 0);
        if constexpr (Outputs > 1) {
            const auto first = [&](double by_s, double by_t) {
                Sum total = scaled<T>(made[1], by_s);
                detail::fast_affine<T>::add(total, scaled<T>(made[2], by_t));
                return total;
            };
            write(result.du, first(at.s_u, at.t_u), 1);
            write(result.dv, first(at.s_v, at.t_v), 1);
        }
        if constexpr (Outputs > 3) {
            const auto second = [&](double s1, double t1, double s2, double t2) {
                Sum total = scaled<T>(made[3], s1 * s2);
                detail::fast_affine<T>::add(total, scaled<T>(made[4], s1 * t2 + s2 * t1));
                detail::fast_affine<T>::add(total, scaled<T>(made[5], t1 * t2));
                return total;
            };
            write(result.duu, second(at.s_u, at.t_u, at.s_u, at.t_u), 2);
            write(result.duv, second(at.s_u, at.t_u, at.s_v, at.t_v), 2);
            write(result.dvv, second(at.s_v, at.t_v, at.s_v, at.t_v), 2);
        }
    }
    /// A value with its derivatives, as many as there are outputs: value, s, t, ss, st, tt.
    template <class T, std::size_t Outputs, class Sum>
    static std::array<Sum, Outputs> sums(const detail::surface_polynomial& polynomial, const Sum* coefficients,
                                         double s, double t)
    {
        const auto x = static_cast<typename detail::fast_affine<T>::scalar>(s);
        std::array<Sum, Outputs> result = row_at<T, Outputs>(polynomial, coefficients, polynomial.degree, t);
        for (std::size_t i = polynomial.degree; i-- > 0;) {
            const std::array<Sum, Outputs> row = row_at<T, Outputs>(polynomial, coefficients, i, t);
            // Horner's rule: derivatives come before what they are derivatives of.
            if constexpr (Outputs > 3) {
                multiply_and_add<T>(result[3], x, result[1]);
                detail::fast_affine<T>::add(result[3], result[1]);
                multiply_and_add<T>(result[4], x, result[2]);
                multiply_and_add<T>(result[5], x, row[5]);
            }
            if constexpr (Outputs > 1) {
                multiply_and_add<T>(result[1], x, result[0]);
                multiply_and_add<T>(result[2], x, row[2]);
            }
            multiply_and_add<T>(result[0], x, row[0]);
        }
        return result;
    }
    /// Returns the coefficient of s^i, a polynomial in t, with its derivatives by t; all others are zero.
    template <class T, std::size_t Outputs, class Sum>
    static std::array<Sum, Outputs> row_at(const detail::surface_polynomial& polynomial, const Sum* coefficients,
                                           std::size_t i, double t)
    {
        const auto y = static_cast<typename detail::fast_affine<T>::scalar>(t);
        const Sum* const row = coefficients + polynomial.begin_of_row(i);
        std::size_t j = polynomial.row_size(i) - 1;
        std::array<Sum, Outputs> result;
        if constexpr (Outputs > 1)
            result.fill(scaled<T>(row[j], 0));
        result[0] = row[j];
        while (j-- > 0) {
            if constexpr (Outputs > 3) {
                multiply_and_add<T>(result[5], y, result[2]);
                detail::fast_affine<T>::add(result[5], result[2]);
            }
            if constexpr (Outputs > 1)
                multiply_and_add<T>(result[2], y, result[0]);
            multiply_and_add<T>(result[0], y, row[j]);
        }
        return result;
    }
    template <class T, class Sum, class Scalar>
    static void multiply_and_add(Sum& total, const Scalar& factor, const Sum& more)
    {
        detail::fast_affine<T>::scale(total, factor);
        detail::fast_affine<T>::add(total, more);
    }

    detail::placed_pieces all_;
};

} // namespace kith
