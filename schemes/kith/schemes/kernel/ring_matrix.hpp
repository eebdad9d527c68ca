// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith {

/// The subdivision matrix of the points around a vertex, and its left eigenvectors. Point 0 is the vertex.
class ring_matrix {
public:
    using row = std::vector<std::pair<std::size_t, double>>; ///< of a new point: old points with their weights

    explicit ring_matrix(std::vector<row> rows) : rows_(std::move(rows)) {}

    /// Returns the limit mask of the vertex, one weight per point. Cost: up to 40 000 products.
    [[nodiscard]] std::vector<double> limit() const
    {
        std::array<std::vector<double>, 1> result{std::vector<double>(rows_.size(), 0)};
        result[0][0] = 1;
        repeat(result, [](auto& rows) {
            double sum = 0;
            for (const double w : rows[0])
                sum += w;
            for (double& w : rows[0])
                w /= sum;
        });
        return std::move(result[0]);
    }
    /// Multiplies rows of weights by the matrix until no weight changes by more than its rounding. After each product
    /// normalize(rows) is called.
    template <std::size_t Count, class Normalize>
    void repeat(std::array<std::vector<double>, Count>& rows, const Normalize& normalize) const
    {
        constexpr int most_steps = 40000;
        double change = 1;
        for (int i = 0; i < most_steps and change >= 0x1p-52; ++i) {
            std::array<std::vector<double>, Count> next;
            for (std::size_t k = 0; k < Count; ++k)
                next[k] = image(rows[k]);
            normalize(next);
            change = 0;
            for (std::size_t k = 0; k < Count; ++k)
                for (std::size_t x = 0; x < next[k].size(); ++x)
                    change = std::max(change, std::abs(next[k][x] - rows[k][x]));
            rows = std::move(next);
        }
    }

private:
    /// Returns the product of a row of weights and the matrix.
    [[nodiscard]] std::vector<double> image(const std::vector<double>& weights) const
    {
        std::vector<double> result(weights.size(), 0);
        for (std::size_t i = 0; i < rows_.size(); ++i)
            for (const auto& [point, weight] : rows_[i])
                result[point] += weights[i] * weight;
        return result;
    }

    std::vector<row> rows_;
};

} // namespace kith
