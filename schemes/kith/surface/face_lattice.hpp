// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lattice_values.hpp"
#include "piece_values.hpp"
#include "placed_pieces.hpp"

#include <kith/core/mask/stencil.hpp>
#include <kith/engine/lane/lanes.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace kith::detail {

/// Places at the same parameters in faces of one shape, ready to be evaluated for the points around each of the faces.
/// The points are those of the polynomials that contain the places, to the bit. If it takes less time, they are sums
/// with weights that are made once for all faces. The object has unit normals, too, if `HasNormals` is set.
template <bool HasNormals>
class face_lattice {
    using point = std::array<double, 3>;
    using values = lattice_values<HasNormals>;
    static constexpr std::size_t outputs = values::outputs;

public:
    /// Takes places of a face of a shape that are evaluated for about `faces` faces. Cost: that of locating and
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
        s_.assign(places.size() + values::room_after, 0);
        for (std::size_t i = 0; i < places.size(); ++i)
            s_[i] = all_.places[i].s;
        if (weights_pay(faces))
            make_weights();
    }

    /// Takes the control points around a face: control_of(input) returns each. If there are rows, the control points of
    /// the shape are weighted sums of these.
    template <class ControlOf>
    void move_to(const subdivision_matrix* rows, const ControlOf& control_of)
    {
        if (rows == nullptr)
            return take_inputs([&](std::size_t input) { return number::load(control_of(input)); });
        net_.clear();
        for (std::size_t input = 0; input < rows->columns; ++input)
            net_.push_back(number::load(control_of(input)));
        take_inputs([&](std::size_t input) { return piece_values<point>::row_of(*rows, input, net_.data()); });
    }
    /// Calls take(i, values, j) for the places in [begin, end): place i is number j of the values.
    template <class Take>
    void evaluate(std::size_t begin, std::size_t end, const Take& take)
    {
        while (begin < end) {
            const std::size_t first = weights_.empty() ? begin : begin / at_once * at_once;
            const std::size_t last = std::min(end, first + values::most);
            make_values(first, last);
            for (; begin < last; ++begin)
                take(begin, values_, begin - first);
        }
    }

private:
    using number = fast_affine<point>;
    static constexpr std::size_t at_once = 4; // number of places whose weights are stored side by side

    /// Returns true if sums of all control points take less time than polynomials. Counts operations.
    [[nodiscard]] bool weights_pay(std::size_t faces) const
    {
        constexpr double of_sum = 5, of_sum_side_by_side = 7; // cost of a weighted point
        constexpr std::size_t most_weights = std::size_t(1) << 20;
        if (all_.places.size() * outputs * inputs_ > most_weights)
            return false;
        double by_pieces = 0;
        for (const surface_net& net : all_.nets)
            by_pieces += net.rows == nullptr ? 0 : of_sum * double(net.rows->weight.size());
        for (const surface_piece& piece : all_.pieces)
            by_pieces += of_sum * double(piece.polynomial->rows.weight.size());
        for (std::size_t first = 0, end; first < all_.places.size(); first = end) {
            end = end_of_line(first, all_.places.size());
            const auto degree = double(all_.pieces[all_.places[first].piece].polynomial->degree);
            by_pieces += of_sum * (degree + 1) * double(HasNormals ? 2 * degree : degree) +
                         double((end - first + at_once - 1) / at_once) * 3 * double(outputs) * (2 * degree + 5);
        }
        const double by_weights = of_sum_side_by_side * double((all_.places.size() + at_once - 1) / at_once) *
                                  double(outputs * inputs_);
        const double to_make_them = by_pieces * double(inputs_) / 2 / double(faces);
        return by_weights + to_make_them < by_pieces;
    }
    /// Returns the end of the places on the same line of constant t as the first one.
    [[nodiscard]] std::size_t end_of_line(std::size_t first, std::size_t end) const
    {
        std::size_t last = first + 1;
        while (last < end and all_.places[last].piece == all_.places[first].piece and
               all_.places[last].t == all_.places[first].t)
            ++last;
        return last;
    }
    void make_weights()
    {
        constexpr std::size_t inputs_at_once = 8;
        using some_weights = std::array<double, inputs_at_once>;
        weights_.assign((all_.places.size() + at_once - 1) / at_once * at_once * outputs * inputs_, 0);
        control_.resize(inputs_);
        piece_values<some_weights> of_units;
        for (std::size_t first = 0; first < inputs_; first += inputs_at_once) {
            of_units.clear();
            of_units.add_face(all_, 0, [&](std::size_t input) {
                some_weights unit{};
                if (first <= input and input < first + inputs_at_once)
                    unit[input - first] = 1;
                return unit;
            });
            for (std::size_t i = 0; i < all_.places.size(); ++i) {
                const placed_parameters& place = all_.places[i];
                const auto made = of_units.template at<outputs>(all_.pieces[place.piece], place);
                for (std::size_t k = first; k < std::min(first + inputs_at_once, inputs_); ++k)
                    for (std::size_t output = 0; output < outputs; ++output)
                        weights_[((i / at_once * inputs_ + k) * outputs + output) * at_once + i % at_once] =
                            made[output][k - first];
            }
        }
    }
    /// Takes the inputs of the shape, as sums.
    template <class InputOf>
    void take_inputs(const InputOf& input_of)
    {
        if (weights_.empty()) {
            of_pieces_.clear();
            of_pieces_.add_face(all_, 0, input_of);
        } else {
            for (std::size_t k = 0; k < inputs_; ++k)
                control_[k] = number::store(input_of(k));
        }
    }

    /// Makes the values of some places, to the same bits in registers of any size.
    void make_values(std::size_t begin, std::size_t end)
    {
#if defined(KITH_HAS_LANES)
#if defined(__x86_64__)
        if (lane_bytes() >= 32)
            return make_values_32_bytes(begin, end);
#endif
        make_values_16_bytes(begin, end);
#else
        make_values_in<double>(begin, end);
#endif
    }
#if defined(KITH_HAS_LANES)
    KITH_LANES_OF_16_BYTES void make_values_16_bytes(std::size_t begin, std::size_t end)
    {
        make_values_in<typename lanes<double, 16>::type>(begin, end);
    }
#if defined(__x86_64__)
    KITH_LANES_OF_32_BYTES void make_values_32_bytes(std::size_t begin, std::size_t end)
    {
        make_values_in<typename lanes<double, 32>::type>(begin, end);
    }
#endif
#endif
    template <class Pack>
    [[gnu::always_inline]] void make_values_in(std::size_t begin, std::size_t end)
    {
        if (weights_.empty())
            for (std::size_t first = begin; first < end;)
                first = add_line<Pack>(begin, first, end);
        else
            for (std::size_t first = begin; first < end; first += at_once)
                values_.template add_sums<Pack>(
                    first - begin, weights_.data() + first * outputs * inputs_, at_once, control_);
        if constexpr (HasNormals)
            values_.template make_normals<Pack>(end - begin);
    }
    /// Evaluates the places on one line of a piece, beginning with `first`. Returns the end of the line.
    template <class Pack>
    [[gnu::always_inline]] std::size_t add_line(std::size_t begin, std::size_t first, std::size_t end)
    {
        const placed_parameters& place = all_.places[first];
        const surface_piece& piece = all_.pieces[place.piece];
        const std::size_t last = end_of_line(first, end);
        for (std::size_t i = 0; i <= piece.polynomial->degree; ++i) {
            std::array<typename number::sum, outputs> row;
            of_pieces_.template write_row<outputs>(piece, place, i, row);
            for (std::size_t output = 0; output < outputs; ++output)
                line_[i][output] = number::store(row[output]);
        }
        values_.template add_line<Pack>(first - begin, piece, line_, s_.data() + first, last - first);
        return last;
    }

    std::size_t inputs_;
    placed_pieces all_;     // of one face, whose inputs are numbered
    std::vector<double> s_; // of the places
    piece_values<point> of_pieces_;
    typename values::line line_{};
    std::vector<typename number::sum> net_; // around a face; the inputs are sums of it
    std::vector<double> weights_;           // empty if polynomials are evaluated
    std::vector<point> control_;
    values values_;
};

} // namespace kith::detail
