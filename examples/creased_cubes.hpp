// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../tests/support/figures.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/core/mesh/make_mesh.hpp>

#include <array>
#include <cstdint>

/// A control mesh for pictures, three cubes side by side, and a scheme with creases on top of the cubes.
struct creased_cubes {
    kith::basic_mesh<std::array<double, 3>> control;
    kith::catmull_clark creased;

    creased_cubes()
    {
        const auto shape = figures::cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        control = kith::make_mesh(shape.points, shape.faces);
        const auto& topology = control.topology();
        for (std::uint32_t corner = 0; corner < topology.corners(); ++corner) {
            const auto &a = control.point(topology.corner_vertex[corner]), &b = control.point(topology.target(corner));
            if (a[2] == 1 and b[2] == 1) // edges on top: sharp on all levels, or for one step
                creased.sharpness.sharpen_edge(topology.corner_halfedge[corner] / 2,
                                               a[0] + b[0] > 2 ? kith::infinitely_sharp : 1);
        }
    }
};
