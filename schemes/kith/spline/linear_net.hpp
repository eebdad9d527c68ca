// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "control_net.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// The corners of a face between which a scheme interpolates linearly: four of a quad, or three of a triangle.
template <std::size_t Corners>
class linear_net {
public:
    /// Returns the net of a face.
    template <std::unsigned_integral Index>
    static std::optional<linear_net> around(const rows_of_part<Index>& part, Index face)
    {
        linear_net net;
        for (std::size_t k = 0; k < Corners; ++k)
            net.points_[k] = part.row(Index(part.mesh.first_corner(face) + k));
        return net;
    }
    /// Returns the net of child k.
    [[nodiscard]] linear_net child(std::size_t k) const
    {
        const auto middle = [&](std::size_t i, std::size_t j) {
            control_row row(points_[0].size());
            add(row, .5, points_[i % Corners]);
            add(row, .5, points_[j % Corners]);
            return row;
        };
        linear_net result;
        if constexpr (Corners == 4) {
            control_row centre(points_[0].size());
            for (const control_row& point : points_)
                add(centre, .25, point);
            result.points_ = {points_[k], middle(k, k + 1), std::move(centre), middle(k, k + 3)};
        } else if (k < 3) {
            result.points_ = {points_[k], middle(k, k + 1), middle(k, k + 2)};
        } else {
            result.points_ = {middle(2, 0), middle(0, 1), middle(1, 2)};
        }
        return result;
    }
    [[nodiscard]] surface_polynomial polynomial() const
    {
        const auto difference = [](const control_row& a, const control_row& b) {
            control_row row = a;
            add(row, -1, b);
            return row;
        };
        const control_row along_s = difference(points_[1], points_[0]);
        if constexpr (Corners == 3) {
            return polynomial_of(
                1, false, std::vector<control_row>{points_[0], difference(points_[2], points_[0]), along_s});
        } else {
            control_row twist = difference(points_[2], points_[3]);
            add(twist, -1, along_s);
            return polynomial_of(
                1,
                true,
                std::vector<control_row>{points_[0], difference(points_[3], points_[0]), along_s, std::move(twist)});
        }
    }
    [[nodiscard]] std::span<const control_row> points() const { return points_; }

private:
    std::array<control_row, Corners> points_;
};

} // namespace kith::detail
