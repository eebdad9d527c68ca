// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "native_shape.hpp"

#include <kith/surface/surface_place.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

// Places on the surfaces that tests evaluate.

using parameters = std::array<double, 2>;
using point = std::array<double, 3>;

inline double distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Returns the place at t, 0 to 1, on the side of a face that begins at a corner. Faces with `sides` corners have one
/// parameter domain, all others one in each sub-face.
inline kith::surface_place place_on_side(const mesh3d& mesh, std::size_t corner, double t, std::size_t sides)
{
    const auto& topology = mesh.topology();
    const std::size_t f = topology.face_of(std::uint32_t(corner)), k = corner - topology.first_corner(f);
    if (mesh.face(f).size() != sides)
        return t <= .5 ? kith::surface_place{f, 2 * t, 0, k}
                       : kith::surface_place{f, 0, 2 - 2 * t, (k + 1) % mesh.face(f).size()};
    const parameters quad = k == 0   ? parameters{t, 0}
                            : k == 1 ? parameters{1, t}
                            : k == 2 ? parameters{1 - t, 1}
                                     : parameters{0, 1 - t};
    const parameters triangle = k == 0 ? parameters{t, 0} : k == 1 ? parameters{1 - t, t} : parameters{0, 1 - t};
    return sides == 4 ? kith::surface_place{f, quad[0], quad[1], 0}
                      : kith::surface_place{f, triangle[0], triangle[1], 0};
}

/// Returns the place that lies off a corner of a face by x along the side after it and by y along the side before it.
/// The face has `sides` corners.
inline kith::surface_place place_off_corner(const mesh3d& mesh, std::size_t corner, double x, double y,
                                            std::size_t sides)
{
    const auto& topology = mesh.topology();
    const auto next = topology.next(std::uint32_t(corner)), before = topology.prev(std::uint32_t(corner));
    const auto here = place_on_side(mesh, corner, 0, sides), a = place_on_side(mesh, next, 0, sides),
               z = place_on_side(mesh, before, 0, sides);
    return {here.face,
            here.u + x * (a.u - here.u) + y * (z.u - here.u),
            here.v + x * (a.v - here.v) + y * (z.v - here.v),
            0};
}

/// Returns the place at `at` in the sub-face at a corner of a face. For a quad it converts to the parameters of the
/// whole quad.
inline kith::surface_place place_in_sub_face(const mesh3d& mesh, std::size_t f, std::size_t corner,
                                             const parameters& at)
{
    if (mesh.face(f).size() != 4)
        return {f, at[0], at[1], corner};
    parameters quad{at[0] / 2, at[1] / 2};
    for (std::size_t turn = 0; turn < corner; ++turn)
        quad = {1 - quad[1], quad[0]};
    return {f, quad[0], quad[1], 0};
}
