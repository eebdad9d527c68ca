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
    /// Returns the rows of two tangents at this point, in whose directions two differences of points of the net shrink.
    /// They may turn in their plane. The result is nothing if they span no plane, or if one shrinks faster than the
    /// other.
    [[nodiscard]] std::optional<std::array<control_row, 2>> tangents(control_row a, control_row b) const
    {
        normalize(a);
        normalize(b);
        for (int i = 0; i < most_steps; ++i) {
            control_row next_a = composed(a, *step_), next_b = composed(b, *step_);
            const double factor_of_a = normalize(next_a), factor_of_b = normalize(next_b);
            constexpr double parallel = 1e-6, same = 1e-9;
            const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), determinant = aa * bb - ab * ab;
            if (not(determinant > parallel * aa * bb))
                return {};
            // The new rows as sums of the old ones.
            const auto shares = [&](const control_row& row) {
                const double with_a = dot(row, a), with_b = dot(row, b);
                return std::array{(with_a * bb - with_b * ab) / determinant, (with_b * aa - with_a * ab) / determinant};
            };
            const auto of_a = shares(next_a), of_b = shares(next_b);
            const double change = std::max(distance(next_a, of_a, a, b), distance(next_b, of_b, a, b));
            a = std::move(next_a);
            b = std::move(next_b);
            if (change > 32 * rounding)
                continue;
            const double trace = factor_of_a * of_a[0] + factor_of_b * of_b[1];
            const double product = factor_of_a * factor_of_b * (of_a[0] * of_b[1] - of_a[1] * of_b[0]);
            if (not(trace * trace - 4 * product <= same * trace * trace))
                return {};
            return std::array{std::move(a), std::move(b)};
        }
        return {};
    }

private:
    static constexpr int most_steps = 2000;
    static constexpr double rounding = 0x1p-52;

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
