// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/surface/surface_place.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace kith::detail {

/// Parameters s and t, or a difference of two pairs of them.
using parameters = std::array<double, 2>;

/// Returns x + weight * y.
inline parameters add_multiple(const parameters& x, double weight, const parameters& y)
{
    return {x[0] + weight * y[0], x[1] + weight * y[1]};
}

/// The parameters of the corners of a cell, counter-clockwise.
template <bool IsTensor>
inline constexpr auto corners_of_cell = [] {
    if constexpr (IsTensor)
        return std::array<parameters, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    else
        return std::array<parameters, 3>{{{0, 0}, {1, 0}, {0, 1}}};
}();
/// The parameters of the middle of a cell.
template <bool IsTensor>
inline constexpr parameters middle_of_cell = IsTensor ? parameters{.5, .5} : parameters{1. / 3, 1. / 3};

/// Returns the parameters in a cell that are nearest to the given ones.
template <bool IsTensor>
parameters nearest_in_cell(const parameters& x)
{
    const auto within = [](double y) { return std::clamp(y, 0., 1.); };
    if (IsTensor or x[0] + x[1] <= 1)
        return {within(x[0]), within(x[1])};
    const double s = within((1 + x[0] - x[1]) / 2);
    return {s, 1 - s};
}

/// The part of a face of a control mesh under a cell of its surface: the image of the unit square, or of the triangle
/// (0, 0), (1, 0), (0, 1), under an affine map. The numbers are exact down to the 50th halving. Faces have `Sides`
/// sides; cells may be triangles in quads.
template <bool IsTensor, std::size_t Sides>
struct cell_place {
    std::size_t face = 0, corner = 0;
    parameters origin{0, 0}, along_s{1, 0}, along_t{0, 1};

    /// Returns the place at parameters of the cell.
    [[nodiscard]] surface_place at(const parameters& x) const
    {
        const parameters uv = add_multiple(add_multiple(origin, x[0], along_s), x[1], along_t);
        const double u = std::clamp(uv[0], 0., 1.);
        return {face, u, std::clamp(uv[1], 0., Sides == 4 ? 1 : 1 - u), corner};
    }
    /// Returns the places of the halves of a Bezier patch.
    [[nodiscard]] std::array<cell_place, 2> halves(std::size_t side) const
    {
        const parameters middle = add_multiple(add_multiple({0, 0}, .5, along_s), .5, along_t);
        const parameters half_s = add_multiple({0, 0}, .5, along_s), half_t = add_multiple({0, 0}, .5, along_t);
        constexpr double taken = IsTensor ? 0 : -1;
        if (side == 0)
            return {with(origin, half_s, along_t),
                    with(add_multiple(origin, 1, half_s), half_s, add_multiple(along_t, taken, half_s))};
        if (side == 1)
            return {with(origin, along_s, half_t),
                    with(add_multiple(origin, 1, half_t), add_multiple(along_s, taken, half_t), half_t)};
        return {with(origin, along_s, middle), with(origin, middle, along_t)};
    }
    /// Returns the place of a part of the cell, given by its affine map into the cell.
    [[nodiscard]] cell_place within(const parameters& o, const parameters& s, const parameters& t) const
    {
        const auto direction = [&](const parameters& x) {
            return add_multiple(add_multiple({0, 0}, x[0], along_s), x[1], along_t);
        };
        return with(add_multiple(add_multiple(origin, o[0], along_s), o[1], along_t), direction(s), direction(t));
    }

private:
    [[nodiscard]] cell_place with(const parameters& o, const parameters& s, const parameters& t) const
    {
        return {face, corner, o, s, t};
    }
};

} // namespace kith::detail
