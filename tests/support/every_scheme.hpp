// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "all_shapes.hpp"
#include "native_shape.hpp"

#include <kith/compiled_schemes.hpp>

#include <gtest/gtest.h>

#include <string>

template <class Scheme>
std::string name_of(const Scheme&)
{
    return std::string(kith::scheme_name<Scheme>());
}

/// Calls test(scheme, mesh) for the schemes of the thesis, with their boundary conventions, and every shape that they
/// accept.
template <class Test>
void for_each_scheme_and_shape(const Test& test)
{
    const auto on = [&](const auto& shapes, const auto&... schemes) {
        for (const auto& [name, shape] : shapes) {
            const auto run = [&, &name = name, &shape = shape](const auto& scheme) {
                SCOPED_TRACE(name_of(scheme) + " of " + name);
                test(scheme, native(shape));
            };
            (run(schemes), ...);
        }
    };
    using doo_sabin_boundary = kith::doo_sabin_boundary;
    on(shapes::all_shapes(),
       kith::catmull_clark{},
       kith::catmull_clark{.corners = kith::boundary_corner::smoothed, .sharpness = {}});
    on(shapes::shapes_without_valence_two(),
       kith::doo_sabin{},
       kith::doo_sabin{.boundary = doo_sabin_boundary::clamped},
       kith::doo_sabin{.boundary = doo_sabin_boundary::drop, .weights = kith::doo_sabin_weights::averaging});
    on(shapes::triangle_shapes(),
       kith::loop{},
       kith::loop{.weights = kith::loop_weights::warren, .corners = kith::boundary_corner::smoothed, .sharpness = {}},
       kith::sqrt3{});
}

/// Calls test(scheme, mesh) for the other schemes and every shape that they accept.
template <class Test>
void for_each_other_scheme_and_shape(const Test& test)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        const auto run = [&, &name = name](const auto& scheme, const mesh3d& mesh) {
            SCOPED_TRACE(name_of(scheme) + " of " + name);
            test(scheme, mesh);
        };
        const auto mesh = native(shape);
        run(kith::linear{}, mesh);
        run(kith::nasri_hasbini{}, mesh);
        run(kith::quad_tri{}, mesh);
        if (name != "valence two") // mid-edge would make a face with two corners there
            run(kith::mid_edge{}, mesh);
        run(kith::four_eight{}, kith::tri_quad(mesh));
        const int degree = mesh.topology().degree;
        if (count(mesh.topology()).boundary_edges == 0) {
            for (const int bidegree : {1, 2, 5, 8})
                run(kith::unified{.degree = bidegree}, mesh);
            if (degree == 3)
                run(kith::interpolatory_sqrt3{}, mesh);
        }
        if (degree == 4)
            run(kith::kobbelt{}, mesh);
        if (degree == 3) {
            run(kith::butterfly{}, mesh);
            run(kith::linear_triangles{}, mesh);
        }
    }
}

template <class Test>
void for_each_of_all_schemes_and_shape(const Test& test)
{
    for_each_scheme_and_shape(test);
    for_each_other_scheme_and_shape(test);
}
