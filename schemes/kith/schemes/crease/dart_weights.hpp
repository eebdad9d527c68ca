// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/exact_cos.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith {

/// The subdivision matrix of the points around a dart with n faces, and its left eigenvectors. Point 0 is the dart.
/// Points 1 to n are its neighbours, the first of which is the other end of the sharp edge. Points n+1 to 2n, if there
/// are any, are opposite the dart in its faces.
class dart_matrix {
public:
    using row = std::vector<std::pair<std::size_t, double>>; ///< of a new point: old points with their weights

    dart_matrix(std::size_t valence, std::vector<row> rows) : valence_(valence), rows_(std::move(rows)) {}

    /// Returns the limit mask, one weight per point, followed by the mask of the tangent along the sharp edge. The
    /// tangent is the left eigenvector of the second largest eigenvalue that is symmetric about the sharp edge. Cost:
    /// up to 40 000 products, once per valence.
    [[nodiscard]] std::vector<double> weights() const
    {
        std::vector<double> position(rows_.size(), 0), along = position;
        position[0] = 1;
        for (std::size_t j = 0; j < valence_; ++j)
            along[1 + j] = exact_cos(std::int64_t(j), std::int64_t(valence_));
        iterate(position, [](std::vector<double>& weights) {
            double sum = 0;
            for (const double w : weights)
                sum += w;
            for (double& w : weights)
                w /= sum;
        });
        iterate(along, [this](std::vector<double>& weights) { make_tangent(weights); });
        position.insert(position.end(), along.begin(), along.end());
        return position;
    }

private:
    /// Multiplies by the matrix until no weight changes by more than its rounding.
    template <class Normalize>
    void iterate(std::vector<double>& weights, const Normalize& normalize) const
    {
        constexpr int most_steps = 40000;
        double change = 1;
        for (int i = 0; i < most_steps and change >= 0x1p-52; ++i) {
            auto next = image(weights);
            normalize(next);
            change = 0;
            for (std::size_t k = 0; k < next.size(); ++k)
                change = std::max(change, std::abs(next[k] - weights[k]));
            weights = std::move(next);
        }
    }
    /// Returns the product of a row of weights and the matrix.
    [[nodiscard]] std::vector<double> image(const std::vector<double>& weights) const
    {
        std::vector<double> result(weights.size(), 0);
        for (std::size_t i = 0; i < rows_.size(); ++i)
            for (const auto& [point, weight] : rows_[i])
                result[point] += weights[i] * weight;
        return result;
    }
    /// Removes the effects of rounding: the part that is not symmetric about the sharp edge, and the sum. The largest
    /// weight becomes 1.
    void make_tangent(std::vector<double>& weights) const
    {
        const auto mirror = [&weights](std::size_t a, std::size_t b) {
            weights[a] = weights[b] = (weights[a] + weights[b]) / 2;
        };
        for (std::size_t j = 1; 2 * j < valence_; ++j)
            mirror(1 + j, 1 + valence_ - j);
        for (std::size_t j = 0; weights.size() > 1 + valence_ and 2 * j + 1 < valence_; ++j)
            mirror(1 + valence_ + j, 2 * valence_ - j);
        double largest = 0, sum = 0;
        for (const double w : weights)
            largest = std::max(largest, std::abs(w));
        for (double& w : weights)
            sum += w /= largest;
        weights[0] -= sum;
    }

    std::size_t valence_;
    std::vector<row> rows_;
};

} // namespace kith
