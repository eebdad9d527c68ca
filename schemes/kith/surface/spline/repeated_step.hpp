// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "control_row.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace kith::detail {

/// A step that makes a smaller net of the same kind from a net, around the same point. Its repetition leads to the left
/// eigenvectors of its matrix. By these kith finds limits for which no scheme has masks.
class repeated_step {
public:
    /// Takes the matrix of the step, and a row of a point of the net. The matrix must outlive this object. Cost:
    /// O(entries of the matrix) for each step; usually a few dozen steps.
    repeated_step(const subdivision_matrix& step, control_row point) : step_(&step)
    {
        for (int i = 0; i < most_steps; ++i) {
            control_row next = composed(point, step);
            const double change = difference(point, next);
            point = std::move(next);
            if (change <= rounding) {
                point_ = std::move(point);
                return;
            }
        }
    }

    /// Returns the row of the point to which the net shrinks; nothing if it does not shrink to one.
    [[nodiscard]] const std::optional<control_row>& point() const { return point_; }
    /// The rows of two tangents, and the factors by which steps shrink differences of points in their directions.
    struct tangent_rows {
        control_row first, second;
        double largest_factor, smallest_factor;
    };
    /// Returns two tangents at this point, in whose directions two differences of points of the net shrink. They may
    /// turn in their plane. The result is nothing if they span no plane, or if other differences do not turn into it.
    [[nodiscard]] std::optional<tangent_rows> tangents(control_row a, control_row b) const
    {
        normalize(a);
        normalize(b);
        for (int i = 0; i < most_steps; ++i) {
            b = without(std::move(b), a);
            constexpr double parallel = 1e-6;
            const double aa = dot(a, a), bb = dot(b, b);
            if (not(bb > parallel * aa))
                return {};
            control_row next_a = composed(a, *step_), next_b = composed(b, *step_);
            const double factor_of_a = normalize(next_a), factor_of_b = normalize(next_b);
            // The new rows as sums of the old ones.
            const auto shares = [&](const control_row& row) { return std::array{dot(row, a) / aa, dot(row, b) / bb}; };
            const auto of_a = shares(next_a), of_b = shares(next_b);
            const double half_trace = (factor_of_a * of_a[0] + factor_of_b * of_b[1]) / 2;
            const double product = factor_of_a * factor_of_b * (of_a[0] * of_b[1] - of_a[1] * of_b[0]);
            const double square = half_trace * half_trace - product;
            const bool are_alike = square <= same * product; // both shrink by the same factor
            const double change = std::max(
                {distance(next_a, of_a, a, b), distance(next_b, of_b, a, b), are_alike ? 0 : std::abs(of_a[1])});
            if (not(change <= 32 * rounding)) {
                a = std::move(next_a);
                b = std::move(next_b);
                continue;
            }
            if (not are_alike and factor_of_a * of_a[0] < half_trace) { // turn, so that b does not shrink more slowly
                std::swap(a, b);
                for (double& weight : b)
                    weight = -weight;
                continue;
            }
            const double least = are_alike ? std::sqrt(product) : half_trace - std::sqrt(square);
            if (not(least > 0 and others_turn_into_plane(a, b, are_alike)))
                return {};
            return tangent_rows{std::move(a), std::move(b), product / least, least};
        }
        return {};
    }

private:
    static constexpr int most_steps = 2000;
    static constexpr double rounding = 0x1p-52;
    static constexpr double same = 1e-9;

    static double difference(const control_row& a, const control_row& b)
    {
        double result = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            result = std::max(result, std::abs(a[i] - b[i]));
        return result;
    }
    static double dot(const control_row& a, const control_row& b)
    {
        double result = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            result += a[i] * b[i];
        return result;
    }
    /// Returns the row without its part in the direction of another one.
    static control_row without(control_row row, const control_row& other)
    {
        add(row, -dot(row, other) / dot(other, other), other);
        return row;
    }
    /// Returns true if all other differences turn into the plane of two orthogonal rows. They do if they shrink faster.
    /// They also do, slowly, if they shrink as fast and each step adds parts in the plane. If the two rows do not
    /// shrink alike, the first one shrinks more slowly, and parts in its direction do not count.
    [[nodiscard]] bool others_turn_into_plane(const control_row& a, const control_row& b, bool are_alike) const
    {
        constexpr int steps = 400;
        constexpr double turned = 1e-3, slowly = .75; // half of the angle is left after twice the steps
        control_row row(a.size());
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] = std::sin(double(i * i + 1)); // without symmetries
        double before = 0;
        for (int i = 1; i <= 2 * steps; ++i) {
            row = composed(row, *step_);
            if (not are_alike)
                row = without(std::move(row), a);
            if (not(normalize(row) > 0))
                return true;
            if (i % steps != 0)
                continue;
            const control_row outside = without(without(row, a), b);
            const double of_a = are_alike ? dot(row, a) * dot(row, a) / dot(a, a) : 0;
            const double inside = of_a + dot(row, b) * dot(row, b) / dot(b, b);
            const double angle = std::sqrt(dot(outside, outside) / inside);
            if (angle < turned)
                return true;
            if (i > steps)
                return angle < slowly * before;
            before = angle;
        }
        return false;
    }
    /// Removes the part that stays in all steps. Makes the largest weight 1 and returns its former value.
    double normalize(control_row& row) const
    {
        double sum = 0, largest = 0;
        for (const double weight : row)
            sum += weight;
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] -= sum * (*point_)[i];
        for (const double weight : row)
            largest = std::max(largest, std::abs(weight));
        for (double& weight : row)
            weight /= largest;
        return largest;
    }
    /// Returns the largest difference of a row from a sum of two rows.
    static double distance(const control_row& row, const std::array<double, 2>& shares, const control_row& a,
                           const control_row& b)
    {
        double result = 0;
        for (std::size_t i = 0; i < row.size(); ++i)
            result = std::max(result, std::abs(row[i] - shares[0] * a[i] - shares[1] * b[i]));
        return result;
    }

    const subdivision_matrix* step_;
    std::optional<control_row> point_;
};

} // namespace kith::detail
