// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/exact_cos.hpp>
#include <kith/schemes/kernel/ring_matrix.hpp>

#include <algorithm>
#include <array>
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
    using row = ring_matrix::row;

    dart_matrix(std::size_t valence, std::vector<row> rows) : valence_(valence), matrix_(std::move(rows)) {}

    /// Returns the limit mask, one weight per point, followed by the mask of the tangent along the sharp edge. The
    /// tangent is the left eigenvector of the second largest eigenvalue that is symmetric about the sharp edge. Cost:
    /// up to 40 000 products, once per valence.
    [[nodiscard]] std::vector<double> weights() const
    {
        std::vector<double> position = matrix_.limit();
        std::array<std::vector<double>, 1> along{std::vector<double>(position.size(), 0)};
        for (std::size_t j = 0; j < valence_; ++j)
            along[0][1 + j] = exact_cos(std::int64_t(j), std::int64_t(valence_));
        matrix_.repeat(along, [this](auto& rows) { make_tangent(rows[0]); });
        position.insert(position.end(), along[0].begin(), along[0].end());
        return position;
    }

private:
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
    ring_matrix matrix_;
};

} // namespace kith
