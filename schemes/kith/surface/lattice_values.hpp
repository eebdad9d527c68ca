// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "piece_values.hpp"

#include <kith/limits/unit_normal.hpp>
#include <kith/surface/spline/polynomial_values.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace kith::detail {

/// The operations of a value on packs: numbers side by side, scaled by numbers and added.
template <class Pack>
struct pack_number {
    using sum = Pack;
    using scalar = double;

    [[gnu::always_inline]] static void add(Pack& total, const Pack& more) { total += more; }
    template <class Weight>
    [[gnu::always_inline]] static void scale(Pack& total, const Weight& weight)
    {
        total *= weight;
    }
};

/// The points of some places, and unit normals, coordinate by coordinate. The functions make several places side by
/// side: a Pack is a double or a register of doubles.
template <bool HasNormals>
class lattice_values {
public:
    static constexpr std::size_t outputs = HasNormals ? 3 : 1; ///< the point; with du and dv for the normal
    static constexpr std::size_t most = 64;
    static constexpr std::size_t room_after = 8; ///< number of places after the last one that may be written
    /// The coefficients of the powers of s on a line of constant t, with their derivatives.
    using line = std::array<std::array<std::array<double, 3>, outputs>, surface_polynomial::most_degree + 1>;

    [[nodiscard]] std::array<double, 3> point(std::size_t i) const { return {at(0, 0)[i], at(0, 1)[i], at(0, 2)[i]}; }
    /// Returns the normal, which is zero if it is not known.
    [[nodiscard]] normal_vector normal(std::size_t i) const { return {normals_[0][i], normals_[1][i], normals_[2][i]}; }

    /// Evaluates `count` places on a line of a piece and writes them from place `to` on.
    template <class Pack>
    [[gnu::always_inline]] void add_line(std::size_t to, const surface_piece& piece, const line& of_t, const double* s,
                                         std::size_t count)
    {
        using number = pack_number<Pack>;
        for (std::size_t i = 0; i < count; i += size<Pack>) {
            Pack at_s;
            load(s + i, at_s);
            for (std::size_t x = 0; x < 3; ++x) {
                const auto write_row = [&](std::size_t power, std::array<Pack, outputs>& row) {
                    for (std::size_t output = 0; output < outputs; ++output)
                        row[output] = of_t[power][output][x] - Pack{}; // so that minus zero keeps its sign
                };
                std::array<Pack, outputs> made{};
                polynomial_values<number>::template evaluate<outputs>(*piece.polynomial, at_s, write_row, made);
                take_parameters_of_face<number>(piece, made);
                for (std::size_t output = 0; output < outputs; ++output)
                    store(at(output, x) + to + i, made[output]);
            }
        }
    }
    /// Makes weighted sums of control points for `at_once` places. The weights are those of the first control point for
    /// each output, place by place, then those of the next one.
    template <class Pack>
    [[gnu::always_inline]] void add_sums(std::size_t to, const double* weights, std::size_t at_once,
                                         std::span<const std::array<double, 3>> control)
    {
        for (std::size_t first = 0; first < at_once; first += size<Pack>) {
            Pack total[outputs][3] = {};
            const double* next = weights + first;
            for (const auto& point : control)
                for (std::size_t output = 0; output < outputs; ++output, next += at_once) {
                    Pack weight;
                    load(next, weight);
                    for (std::size_t x = 0; x < 3; ++x)
                        total[output][x] += weight * point[x];
                }
            for (std::size_t output = 0; output < outputs; ++output)
                for (std::size_t x = 0; x < 3; ++x)
                    store(at(output, x) + to + first, total[output][x]);
        }
    }
    /// Makes the unit normals of the first places, to the bits of `unit_normal`.
    template <class Pack>
    [[gnu::always_inline]] void make_normals(std::size_t count)
    {
        for (std::size_t i = 0; i < count; i += size<Pack>) {
            std::array<Pack, 3> du, dv;
            load_vectors(1, i, du);
            load_vectors(2, i, dv);
            const auto n = cross(du, dv);
            store(lengths_ + i, Pack(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
            for (std::size_t x = 0; x < 3; ++x)
                store(normals_[x] + i, n[x]);
        }
        bool are_usual = true;
        for (std::size_t i = 0; i < count; ++i) {
            are_usual = are_usual and is_usual_square(lengths_[i]);
            lengths_[i] = std::sqrt(lengths_[i]);
        }
        for (std::size_t i = 0; i < count; i += size<Pack>) {
            Pack length;
            load(lengths_ + i, length);
            for (std::size_t x = 0; x < 3; ++x) {
                Pack coordinate;
                load(normals_[x] + i, coordinate);
                store(normals_[x] + i, Pack(coordinate / length));
            }
        }
        if (not are_usual) [[unlikely]]
            make_each_normal(count);
    }

private:
    template <class Pack>
    static constexpr std::size_t size = sizeof(Pack) / sizeof(double);

    // Not by memcpy: g++ makes two halves of it, for whose stores the next load of a register waits.
    template <class Pack>
    [[gnu::always_inline]] static void load(const double* from, Pack& to)
    {
        using anywhere [[gnu::aligned(alignof(double))]] = Pack;
        to = *reinterpret_cast<const anywhere*>(from);
    }
    template <class Pack>
    [[gnu::always_inline]] static void store(double* to, const Pack& value)
    {
        using anywhere [[gnu::aligned(alignof(double))]] = Pack;
        *reinterpret_cast<anywhere*>(to) = value;
    }
    /// Returns a coordinate of all places.
    [[nodiscard]] double* at(std::size_t output, std::size_t x) { return numbers_[3 * output + x]; }
    [[nodiscard]] const double* at(std::size_t output, std::size_t x) const { return numbers_[3 * output + x]; }
    template <class Pack>
    [[gnu::always_inline]] void load_vectors(std::size_t output, std::size_t i, std::array<Pack, 3>& to) const
    {
        for (std::size_t x = 0; x < 3; ++x)
            load(at(output, x) + i, to[x]);
    }
    [[gnu::noinline]] void make_each_normal(std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i) {
            normal_vector du, dv;
            load_vectors(1, i, du);
            load_vectors(2, i, dv);
            const auto normal = unit_normal(du, dv).value_or(normal_vector{});
            for (std::size_t x = 0; x < 3; ++x)
                normals_[x][i] = normal[x];
        }
    }

    alignas(64) double numbers_[3 * outputs][most + room_after] = {};
    alignas(64) double normals_[HasNormals ? 3 : 1][most + room_after] = {};
    alignas(64) double lengths_[HasNormals ? most + room_after : 1] = {};
};

} // namespace kith::detail
