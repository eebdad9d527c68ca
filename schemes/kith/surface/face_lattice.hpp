// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_search.hpp"
#include "piece_values.hpp"
#include "placed_pieces.hpp"

#include <kith/base/affine.hpp>
#include <kith/lane/lanes.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <numeric>
#include <span>
#include <vector>

namespace kith::detail {

/// Places at the same parameters in faces of one shape, ready to be evaluated for the points around each of the faces.
/// Values are those of the polynomials that the places lie in or, where that takes less time, sums with weights that
/// are made once for all faces. Their rounding errors differ.
///
/// There are Outputs values at each place: the point or, of three, du and dv, too.
template <affine_value T, std::size_t Outputs>
class face_lattice {
public:
    /// Takes places of a face of a shape that are evaluated for about so many faces. Cost: that of locating and
    /// evaluating them once or, with weights, as often as a face has control points.
    template <class Search, class Shape>
    face_lattice(Search& search, Shape& shape, std::size_t corner, std::span<const std::array<double, 2>> parameters,
                 std::size_t faces)
        : inputs_(shape.inputs)
    {
        typename Search::neighbourhood of_shape{&shape, {}, {}, {}};
        of_shape.control.resize(inputs_);
        std::iota(of_shape.control.begin(), of_shape.control.end(), typename Shape::index_type(0));
        std::vector<surface_place> places;
        for (const auto& [u, v] : parameters)
            places.push_back({0, u, v, corner});
        std::vector<std::size_t> numbers(places.size());
        std::iota(numbers.begin(), numbers.end(), std::size_t(0));
        all_.places.resize(places.size());
        search.locate(of_shape, 0, places, numbers, all_.places, places.size(), all_);
        if (weights_pay(faces))
            make_weights();
    }

    /// Takes the control values around a face: control_of(input) returns each. If there are rows, those of the shape
    /// are weighted sums of these.
    template <class ControlOf>
    void move_to(const subdivision_matrix* rows, const ControlOf& control_of)
    {
        if (rows == nullptr)
            return take_inputs([&](std::size_t input) { return fast_affine<T>::load(control_of(input)); });
        net_.clear();
        for (std::size_t input = 0; input < rows->columns; ++input)
            net_.push_back(fast_affine<T>::load(control_of(input)));
        take_inputs([&](std::size_t input) { return piece_values<T>::row_of(*rows, input, net_.data()); });
    }
    /// Calls take(i, values) for the places from one to another.
    template <class Take>
    void evaluate(std::size_t begin, std::size_t end, const Take& take)
    {
        if (weights_.empty())
            evaluate_pieces(begin, end, take);
        else if constexpr (has_coordinates)
            evaluate_weights(begin, end, take);
    }

private:
    /// Takes the inputs of the shape, as sums.
    template <class InputOf>
    void take_inputs(const InputOf& input_of)
    {
        if (weights_.empty()) {
            values_.clear();
            values_.add_face(all_, 0, input_of);
            line_piece_ = all_.pieces.size();
            return;
        }
        if constexpr (has_coordinates)
            for (std::size_t k = 0; k < inputs_; ++k) {
                const auto point = affine<T>::load(fast_affine<T>::store(input_of(k)));
                control_[k] = {double(point[0]), double(point[1]), double(point[2])};
            }
    }

    using sum = typename affine<T>::sum;
    static constexpr bool has_coordinates = std::same_as<sum, std::array<scalar_of<T>, 3>> and
                                            std::floating_point<scalar_of<T>>;
    static constexpr std::size_t at_once = 4; // places side by side

    /// Returns true if sums of all control points take less time than polynomials. Counts sums of weighted points.
    [[nodiscard]] bool weights_pay(std::size_t faces) const
    {
        double by_pieces = 0;
        for (const surface_net& net : all_.nets)
            by_pieces += net.rows == nullptr ? 0 : double(net.rows->weight.size());
        for (const surface_piece& piece : all_.pieces)
            by_pieces += double(piece.polynomial->rows.weight.size());
        for (const placed_parameters& place : all_.places)
            by_pieces += double(Outputs) + double(all_.pieces[place.piece].polynomial->degree * (2 * Outputs - 1));
        const double by_weights = .5 * double(all_.places.size() * Outputs * inputs_);
        const double to_make_them = by_pieces * double(inputs_) / 2 / double(faces);
        return has_coordinates and by_weights + to_make_them < by_pieces;
    }
    void make_weights()
    {
        constexpr std::size_t inputs_at_once = 8;
        using some_weights = std::array<double, inputs_at_once>;
        weights_.assign((all_.places.size() + at_once - 1) / at_once * at_once * Outputs * inputs_, 0);
        control_.resize(inputs_);
        piece_values<some_weights> values;
        for (std::size_t first = 0; first < inputs_; first += inputs_at_once) {
            values.clear();
            values.add_face(all_, 0, [&](std::size_t input) {
                some_weights unit{};
                if (first <= input and input < first + inputs_at_once)
                    unit[input - first] = 1;
                return unit;
            });
            for (std::size_t i = 0; i < all_.places.size(); ++i) {
                const placed_parameters& place = all_.places[i];
                const auto made = values.template at<Outputs>(all_.pieces[place.piece], place);
                for (std::size_t k = first; k < std::min(first + inputs_at_once, inputs_); ++k)
                    for (std::size_t output = 0; output < Outputs; ++output)
                        weights_[((i / at_once * inputs_ + k) * Outputs + output) * at_once + i % at_once] =
                            made[output][k - first];
            }
        }
    }

    template <class Take>
    void evaluate_pieces(std::size_t begin, std::size_t end, const Take& take)
    {
        for (std::size_t i = begin; i < end; ++i) {
            const placed_parameters& place = all_.places[i];
            const surface_piece& piece = all_.pieces[place.piece];
            if (place.piece != line_piece_ or place.t != line_t_) {
                values_.template make_line<Outputs>(piece, place, line_);
                line_piece_ = place.piece;
                line_t_ = place.t;
            }
            const auto made = values_.template on_line<Outputs>(piece, place.s, line_);
            std::array<T, Outputs> result;
            for (std::size_t output = 0; output < Outputs; ++output)
                result[output] = fast_affine<T>::store(made[output]);
            take(i, result);
        }
    }
    template <class Take>
    void evaluate_weights(std::size_t begin, std::size_t end, const Take& take)
    {
        for (std::size_t block = begin / at_once; block * at_once < end; ++block) {
            add_up(weights_.data() + block * Outputs * inputs_ * at_once);
            for (std::size_t i = std::max(begin, block * at_once); i < std::min(end, (block + 1) * at_once); ++i) {
                std::array<T, Outputs> result;
                for (std::size_t output = 0; output < Outputs; ++output) {
                    sum value;
                    for (std::size_t x = 0; x < 3; ++x)
                        value[x] = static_cast<scalar_of<T>>(totals_[output][x][i % at_once]);
                    result[output] = affine<T>::store(value);
                }
                take(i, result);
            }
        }
    }
    /// Makes the weighted sums of places that are side by side, to the same bits in registers of any size.
    void add_up(const double* weights)
    {
#if defined(KITH_HAS_LANES)
#if defined(__x86_64__)
        if (lane_bytes() >= 32)
            return add_up_32_bytes(weights);
#endif
        add_up_16_bytes(weights);
#else
        add_up_packs<double>(weights);
#endif
    }
#if defined(KITH_HAS_LANES)
    KITH_LANES_OF_16_BYTES void add_up_16_bytes(const double* weights)
    {
        add_up_packs<typename lanes<double, 16>::type>(weights);
    }
#if defined(__x86_64__)
    KITH_LANES_OF_32_BYTES void add_up_32_bytes(const double* weights)
    {
        add_up_packs<typename lanes<double, 32>::type>(weights);
    }
#endif
#endif
    template <class Pack>
    [[gnu::always_inline]] void add_up_packs(const double* weights)
    {
        constexpr std::size_t size = sizeof(Pack) / sizeof(double);
        for (std::size_t first = 0; first < at_once; first += size) {
            Pack total[Outputs][3] = {};
            const double* next = weights + first;
            for (const auto& point : control_)
                for (std::size_t output = 0; output < Outputs; ++output, next += at_once) {
                    Pack weight;
                    std::memcpy(&weight, next, sizeof(Pack));
                    for (std::size_t x = 0; x < 3; ++x)
                        total[output][x] += weight * point[x];
                }
            for (std::size_t output = 0; output < Outputs; ++output)
                for (std::size_t x = 0; x < 3; ++x)
                    std::memcpy(&totals_[output][x][first], &total[output][x], sizeof(Pack));
        }
    }

    std::size_t inputs_;
    placed_pieces all_; // of one face, whose inputs are numbered
    piece_values<T> values_;
    std::vector<typename piece_values<T>::sum> net_; // around a face, of which the inputs are sums
    typename piece_values<T>::template line<Outputs> line_;
    std::size_t line_piece_ = 0;
    double line_t_ = 0;
    std::vector<double> weights_; // of `at_once` places side by side; none: by pieces
    std::vector<std::array<double, 3>> control_;
    double totals_[Outputs][3][at_once] = {};
};

} // namespace kith::detail
