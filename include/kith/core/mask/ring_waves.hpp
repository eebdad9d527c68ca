// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mask.hpp"

#include <kith/core/base/exact_cos.hpp>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith {

/// The largest number of operands of a ring that is summed with one row of weights per new point. For n operands with n
/// new points this takes O(n^2), so larger rings are summed by their waves.
inline constexpr std::size_t longest_row = 64;

/// The weights around a ring of n operands as a sum of waves, the shortest of half a ring. The operand at angle t from
/// the new point has the weight (x0 + 2 Re(x1 exp(-it)) + 2 Re(x2 exp(-2it)))/n. For real x1 and x2 this is
/// (x0 + 2 x1 cos t + 2 x2 cos 2t)/n. The matrix of these weights is a circulant.
struct wave_kernel {
    double x0;
    std::complex<double> x1, x2;

    /// Returns the weight of the operand at `half_steps` times half of 1/n of a turn from the new point.
    [[nodiscard]] constexpr double at(std::int64_t half_steps, std::size_t n) const
    {
        const auto wave = [&](const std::complex<double>& x, std::int64_t k) {
            const auto turn = k * half_steps, full = std::int64_t(2 * n);
            return 2 * (x.real() * exact_cos(turn, full) + x.imag() * sin_turn(turn, full));
        };
        return (x0 + wave(x1, 1) + wave(x2, 2)) / double(n);
    }
    /// Returns the weights of all operands, the first of which lies `half_steps` times half of 1/n of a turn from the
    /// new point.
    [[nodiscard]] std::vector<double> row(std::int64_t half_steps, std::size_t n) const
    {
        std::vector<double> weights;
        for (std::size_t j = 0; j < n; ++j)
            weights.push_back(at(2 * std::int64_t(j) + half_steps, n));
        return weights;
    }
};

/// The weighted sum of values that are already computed. The values must outlive the mask.
template <class Sum, class Scalar, std::size_t N>
struct mask_of_values : mask_base {
    const std::array<Sum, N>* values_of_ring;
    std::array<Scalar, N> weights;

    mask_of_values(const std::array<Sum, N>& values, std::array<Scalar, N> weights)
        : values_of_ring(&values), weights(std::move(weights))
    {
    }

    template <value_space Values>
    [[nodiscard]] Sum evaluate(const Values&) const
    {
        const auto term = [&](std::size_t i) {
            Sum result = (*values_of_ring)[i];
            Values::scale(result, weights[i]);
            return result;
        };
        Sum total = term(0);
        for (std::size_t i = 1; i < N; ++i)
            Values::add(total, term(i));
        return total;
    }
};

/// The sum of a ring of operands p_j and its first waves: sum p_j cos(k t_j) and sum p_j sin(k t_j), where t_j = 2 pi
/// j/n and k = 1 to Waves. All masks with a wave_kernel over the ring share these values. Cost: O(n), and O(1) for each
/// mask.
template <mask_evaluator Space, std::size_t Waves>
    requires(Waves <= 2) // a wave_kernel has no more waves
class ring_waves {
public:
    using sum_type = typename Space::sum;
    using scalar = typename Space::scalar;
    static constexpr std::size_t size = 1 + 2 * Waves;

    /// Computes the waves of the n operands of a ring, which are counter-clockwise.
    template <mask_range Ring>
    ring_waves(const Space& assoc, const Ring& ring, std::size_t n) : n_(n)
    {
        values_[0] = assoc.evaluate(sum(ring));
        for (std::size_t k = 1; k <= Waves; ++k) {
            const auto turns = [&](std::size_t j) { return std::int64_t(k * j); };
            values_[2 * k - 1] = wave(assoc, ring, [&](std::size_t j) { return exact_cos(turns(j), std::int64_t(n)); });
            values_[2 * k] = wave(assoc, ring, [&](std::size_t j) { return sin_turn(turns(j), std::int64_t(n)); });
        }
    }

    [[nodiscard]] std::size_t operands() const { return n_; }
    [[nodiscard]] const std::array<sum_type, size>& values() const { return values_; }

    /// Returns the weights of values() for `total` times the mask of a new point. The point lies `half_steps` times
    /// half of 1/n of a turn from the first operand. The part x0 is computed in the scalar type of the evaluation.
    [[nodiscard, gnu::noinline]] std::array<scalar, size> weights(const wave_kernel& kernel, std::int64_t half_steps,
                                                                  double total = 1) const
    {
        std::array<scalar, size> result;
        result[0] = scalar(total) * scalar(kernel.x0) / scalar(double(n_));
        for (std::size_t k = 1; k <= Waves; ++k) {
            const auto turn = std::int64_t(k) * half_steps, full = std::int64_t(2 * n_);
            const std::complex<double> x = (k == 1 ? kernel.x1 : kernel.x2) *
                                           std::complex(exact_cos(turn, full), sin_turn(turn, full));
            result[2 * k - 1] = scalar(2 * total * x.real() / double(n_));
            result[2 * k] = scalar(2 * total * x.imag() / double(n_));
        }
        return result;
    }
    /// Returns the mask of a new point. This object must outlive the mask.
    [[nodiscard]] auto mask(const wave_kernel& kernel, std::int64_t half_steps) const
    {
        return mask_of_values<sum_type, scalar, size>(values_, weights(kernel, half_steps));
    }

private:
    /// Returns a wave of a ring. The sum of the rounded weights is not quite zero, so the excess is subtracted from
    /// them. Then the weights of each mask have the correct sum, exactly so over exact numbers.
    template <class Ring, class WeightOf>
    [[gnu::noinline]] sum_type wave(const Space& assoc, const Ring& ring, const WeightOf& weight_of) const
    {
        scalar excess(0);
        for (std::size_t j = 0; j < n_; ++j)
            excess = excess + scalar(weight_of(j));
        excess = excess / scalar(double(n_));
        return assoc.evaluate(sum(ring, [&](std::size_t j) { return scalar(weight_of(j)) - excess; }));
    }

    std::size_t n_;
    std::array<sum_type, size> values_{};
};

} // namespace kith
