// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random_meshes.hpp"

#include <kith/surface.hpp>

#include <cstddef>

namespace kith::comparison {

/// Returns a random place in a face.
template <class Scheme>
surface_place random_place(const basic_mesh<>& mesh, std::size_t face, random_numbers& random)
{
    constexpr bool has_quads = kith::detail::has_quad_parameters<Scheme>;
    double u = (random.coordinate() + 1) / 2, v = (random.coordinate() + 1) / 2;
    if (not has_quads and u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const std::size_t degree = mesh.face(face).size();
    return {face, u, v, has_quads and degree != 4 ? random.below(degree) : 0};
}

} // namespace kith::comparison
