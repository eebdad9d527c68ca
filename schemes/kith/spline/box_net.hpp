// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "control_net.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// The 12 control points of a quartic box spline over a triangle, in a lattice: its corners are (0, 0), (1, 0), (0, 1).
class box_net {
public:
    /// Same as for bicubic_net. Returns nothing if the mesh around the face is not regular.
    template <std::unsigned_integral Index>
    static std::optional<box_net> around(const rows_of_part<Index>& part, Index face)
    {
        const auto& mesh = part.mesh;
        box_net net;
        std::array<Index, 3> corner{};
        std::array<bool, 3> is_wall{};
        for (std::size_t k = 0; k < 3; ++k) {
            corner[k] = Index(mesh.first_corner(face) + k);
            is_wall[k] = part.is_wall(corner[k]);
            net.at(k, 0, 0) = part.row(corner[k]);
        }
        for (std::size_t k = 0; k < 3; ++k)
            net.at(k, 1, -1) = is_wall[k] ? mirrored(net.at(k, 0, 0), net.at(k, 0, 1), net.at(k, 1, 0))
                                          : part.row(mesh.prev(mesh.across(corner[k])));
        for (std::size_t k = 0; k < 3; ++k) {
            const Index before = corner[(k + 2) % 3];
            const bool before_is_wall = is_wall[(k + 2) % 3];
            if (is_wall[k] and before_is_wall) {
                net.at(k, 0, -1) = mirrored(net.at(k, 0, 0), net.at(k, 0, 1), net.at(k, 0, 0));
                net.at(k, -1, 0) = mirrored(net.at(k, 0, 0), net.at(k, 1, 0), net.at(k, 0, 0));
            } else if (is_wall[k]) {
                const Index side = mesh.prev(mesh.across(before));
                if (part.is_wall(side) or not part.is_wall(mesh.prev(mesh.across(side))))
                    return {};
                net.at(k, -1, 0) = part.row(mesh.prev(mesh.across(side)));
                net.at(k, 0, -1) = mirrored(net.at(k, -1, 0), net.at(k, -1, 1), net.at(k, 0, 0));
            } else if (before_is_wall) {
                const Index side = mesh.next(mesh.across(corner[k]));
                if (part.is_wall(side) or not part.is_wall(mesh.next(mesh.across(side))))
                    return {};
                net.at(k, 0, -1) = part.row(mesh.prev(mesh.across(side)));
                net.at(k, -1, 0) = mirrored(net.at(k, 0, -1), net.at(k, 1, -1), net.at(k, 0, 0));
            } else if (part.is_wall(mesh.next(mesh.across(corner[k])))) { // the face touches a boundary at the vertex
                if (not part.is_wall(mesh.prev(mesh.across(before))))
                    return {};
                net.at(k, 0, -1) = mirrored(net.at(k, 1, -1), net.at(k, 1, 0), net.at(k, 0, 0));
                net.at(k, -1, 0) = mirrored(net.at(k, -1, 1), net.at(k, 0, 1), net.at(k, 0, 0));
            } else {
                std::array<Index, 4> around{mesh.across(corner[k])}; // each leads to the vertex of corner k
                for (std::size_t i = 0; i < 3; ++i) {
                    const Index side = mesh.next(around[i]);
                    if (part.is_wall(side))
                        return {};
                    around[i + 1] = mesh.across(side);
                }
                if (mesh.across(mesh.next(around[3])) != mesh.prev(mesh.across(before)))
                    return {};
                net.at(k, 0, -1) = part.row(mesh.prev(around[1]));
                net.at(k, -1, 0) = part.row(mesh.prev(around[2]));
            }
        }
        return net;
    }
    /// Returns the net around child k that box splines have, by the regular masks of Loop 1987.
    [[nodiscard]] box_net child(std::size_t k) const
    {
        box_net result;
        for (const auto& [a, b] : places)
            result.at(0, a, b) = k < 3 ? halved(k, a, b) : halved(0, a + b, 1 - a);
        return result;
    }
    [[nodiscard]] surface_polynomial polynomial() const
    {
        std::vector<control_row> coefficients(quartic::terms, control_row(points_.front().size()));
        const auto add_basis = [&](const control_row& point, const std::array<double, quartic::terms>& basis) {
            for (std::size_t i = 0; i < basis.size(); ++i)
                add(coefficients[i], basis[i], point);
        };
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3, before = (k + 2) % 3;
            add_basis(at(k, 0, 0), box_spline_of(box_spline_kind::corner, k, next));
            add_basis(at(k, 1, -1), box_spline_of(box_spline_kind::across, k, next));
            add_basis(at(k, 0, -1), box_spline_of(box_spline_kind::beyond, k, next));
            add_basis(at(k, -1, 0), box_spline_of(box_spline_kind::beyond, k, before));
        }
        return polynomial_of(4, false, coefficients);
    }
    [[nodiscard]] std::span<const control_row> points() const { return points_; }

private:
    static constexpr std::array<std::pair<int, int>, 12> places{
        {{0, 0}, {1, 0}, {0, 1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {-1, 0}, {2, -1}, {2, 0}, {0, 2}, {-1, 2}}};

    /// Returns a point in the lattice as it is seen from corner k: a along the edge after it, b along the one before.
    [[nodiscard]] const control_row& at(std::size_t k, int a, int b) const
    {
        const std::pair<int, int> place = k == 0   ? std::pair(a, b)
                                          : k == 1 ? std::pair(1 - a - b, a)
                                                   : std::pair(b, 1 - a - b);
        return points_[std::size_t(std::ranges::find(places, place) - places.begin())];
    }
    [[nodiscard]] control_row& at(std::size_t k, int a, int b)
    {
        return const_cast<control_row&>(std::as_const(*this).at(k, a, b));
    }
    /// Returns the new point at (a / 2, b / 2), as it is seen from corner k.
    [[nodiscard]] control_row halved(std::size_t k, int a, int b) const
    {
        control_row result(points_.front().size());
        const auto add_points = [&](double weight, std::initializer_list<std::pair<int, int>> list) {
            for (const auto& [x, y] : list)
                add(result, weight, at(k, x, y));
        };
        const int x = (a - (a & 1)) / 2, y = (b - (b & 1)) / 2;
        if ((a & 1) == 0 and (b & 1) == 0) {
            add_points(5. / 8, {{x, y}});
            add_points(1. / 16, {{x + 1, y}, {x, y + 1}, {x - 1, y + 1}, {x - 1, y}, {x, y - 1}, {x + 1, y - 1}});
        } else if ((b & 1) == 0) {
            add_points(3. / 8, {{x, y}, {x + 1, y}});
            add_points(1. / 8, {{x, y + 1}, {x + 1, y - 1}});
        } else if ((a & 1) == 0) {
            add_points(3. / 8, {{x, y}, {x, y + 1}});
            add_points(1. / 8, {{x + 1, y}, {x - 1, y + 1}});
        } else {
            add_points(3. / 8, {{x + 1, y}, {x, y + 1}});
            add_points(1. / 8, {{x, y}, {x + 1, y + 1}});
        }
        return result;
    }

    std::array<control_row, 12> points_;
};

} // namespace kith::detail
