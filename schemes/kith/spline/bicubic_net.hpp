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

/// The 16 control points of a bicubic B-spline over a quad, in a grid. The quad lies between (1, 1) and (2, 2).
class bicubic_net {
public:
    /// Returns the net around a face of a mesh. Points beyond boundaries and sharp edges are mirrored. Returns nothing
    /// if the mesh around the face is no grid.
    template <std::unsigned_integral Index>
    static std::optional<bicubic_net> around(const rows_of_part<Index>& part, Index face)
    {
        const auto& mesh = part.mesh;
        bicubic_net net;
        std::array<Index, 4> corner{};
        std::array<bool, 4> is_wall{};
        for (std::size_t k = 0; k < 4; ++k) {
            corner[k] = Index(mesh.first_corner(face) + k);
            is_wall[k] = part.is_wall(corner[k]);
            net.at(k, 1, 1) = part.row(corner[k]);
        }
        for (std::size_t k = 0; k < 4; ++k)
            if (not is_wall[k]) {
                const Index beyond = mesh.across(corner[k]);
                if (part.degree_at(beyond) != 4)
                    return {};
                net.at(k, 1, 0) = part.row(mesh.next(mesh.next(beyond)));
                net.at(k, 2, 0) = part.row(mesh.prev(beyond));
            }
        for (std::size_t k = 0; k < 4; ++k)
            if (is_wall[k]) {
                net.at(k, 1, 0) = mirrored(net.at(k, 1, 1), net.at(k, 1, 2), net.at(k, 1, 1));
                net.at(k, 2, 0) = mirrored(net.at(k, 2, 1), net.at(k, 2, 2), net.at(k, 2, 1));
            }
        for (std::size_t k = 0; k < 4; ++k) {
            const bool before_is_wall = is_wall[(k + 3) % 4];
            const Index before = mesh.across(corner[(k + 3) % 4]); // at the vertex of corner k
            if (is_wall[k] and before_is_wall) {
                net.at(k, 0, 0) = mirrored(net.at(k, 0, 1), net.at(k, 0, 2), net.at(k, 0, 1));
            } else if (is_wall[k]) {
                if (not part.is_wall(mesh.prev(before)))
                    return {};
                net.at(k, 0, 0) = mirrored(net.at(k, 0, 1), net.at(k, 0, 2), net.at(k, 0, 1));
            } else if (before_is_wall) {
                if (not part.is_wall(mesh.next(mesh.across(corner[k]))))
                    return {};
                net.at(k, 0, 0) = mirrored(net.at(k, 1, 0), net.at(k, 2, 0), net.at(k, 1, 0));
            } else {
                const Index side = mesh.next(mesh.across(corner[k]));
                if (part.is_wall(side))
                    return {};
                const Index opposite = mesh.across(side);
                if (part.degree_at(opposite) != 4 or part.is_wall(mesh.next(opposite)) or
                    mesh.across(mesh.next(opposite)) != mesh.prev(before))
                    return {};
                net.at(k, 0, 0) = part.row(mesh.prev(opposite));
            }
        }
        return net;
    }
    /// Returns the net around child k that B-splines have, by knot insertion.
    [[nodiscard]] bicubic_net child(std::size_t k) const
    {
        static constexpr std::array<std::array<double, 4>, 4> halved{
            {{.5, .5, 0, 0}, {.125, .75, .125, 0}, {0, .5, .5, 0}, {0, .125, .75, .125}}};
        bicubic_net result;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) {
                control_row& row = result.at(0, i, j) = zero();
                for (std::size_t a = 0; a < 4; ++a)
                    for (std::size_t b = 0; b < 4; ++b)
                        if (const double weight = halved[i][a] * halved[j][b]; weight != 0)
                            add(row, weight, at(k, a, b));
            }
        return result;
    }
    [[nodiscard]] surface_polynomial polynomial() const
    {
        std::vector<control_row> coefficients;
        for (const auto& of_s : cubic_spline_powers)
            for (const auto& of_t : cubic_spline_powers) {
                control_row row = zero();
                for (std::size_t i = 0; i < 4; ++i)
                    for (std::size_t j = 0; j < 4; ++j)
                        add(row, of_s[i] * of_t[j], at(0, i, j));
                coefficients.push_back(std::move(row));
            }
        return polynomial_of(3, true, coefficients);
    }
    [[nodiscard]] std::span<const control_row> points() const { return points_; }

private:
    /// Returns a point in the grid as it is seen from corner k: a along the edge after it, b along the one before it.
    [[nodiscard]] const control_row& at(std::size_t k, std::size_t a, std::size_t b) const
    {
        const auto [i, j] = k == 0   ? std::pair(a, b)
                            : k == 1 ? std::pair(3 - b, a)
                            : k == 2 ? std::pair(3 - a, 3 - b)
                                     : std::pair(b, 3 - a);
        return points_[4 * i + j];
    }
    [[nodiscard]] control_row& at(std::size_t k, std::size_t a, std::size_t b)
    {
        return const_cast<control_row&>(std::as_const(*this).at(k, a, b));
    }
    [[nodiscard]] control_row zero() const { return control_row(points_[5].size()); }

    std::array<control_row, 16> points_;
};

} // namespace kith::detail
