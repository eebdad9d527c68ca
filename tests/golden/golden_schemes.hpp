// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "golden.hpp"
#include "support/user_mesh.hpp"

#include <kith/compiled_schemes.hpp>

#include <gtest/gtest.h>

inline auto corner_rule(const golden::file& f)
{
    return f.corner_rule == "none" ? kith::boundary_corner::smoothed : kith::boundary_corner::kept;
}

/// Returns the control mesh of a file, made as users of the mesh type make it.
template <class M>
M control_mesh(const golden::file& f)
{
    return user_mesh<M>::make(f.levels[0].vertices, f.levels[0].faces);
}

// Each type calls test(file, control mesh, scheme) for the golden files of its scheme. The scheme has the options of
// the file.
template <class M>
struct catmull_clark_on {
    using mesh = M;
    template <class Test>
    static void for_each(const Test& test)
    {
        for (const auto& f : golden::files_of("catmull_clark"))
            if (f.levels[0].creases.empty())
                test(f, control_mesh<M>(f), kith::catmull_clark{.corners = corner_rule(f), .sharpness = {}});
    }
};
template <class M>
struct loop_on {
    using mesh = M;
    template <class Test>
    static void for_each(const Test& test)
    {
        for (const auto& f : golden::files_of("loop"))
            if (f.levels[0].creases.empty()) {
                const auto weights = f.weights == "warren" ? kith::loop_weights::warren : kith::loop_weights::loop;
                test(f, control_mesh<M>(f), kith::loop{.weights = weights, .corners = corner_rule(f), .sharpness = {}});
            }
    }
};
template <class M>
struct doo_sabin_on {
    using mesh = M;
    template <class Test>
    static void for_each(const Test& test)
    {
        using boundary = kith::doo_sabin_boundary;
        using weights = kith::doo_sabin_weights;
        for (const auto& f : golden::files_of("doo_sabin"))
            test(f,
                 control_mesh<M>(f),
                 kith::doo_sabin{.boundary = f.boundary == "drop"      ? boundary::drop
                                             : f.boundary == "clamped" ? boundary::clamped
                                                                       : boundary::thesis,
                                 .weights = f.weights == "averaging" ? weights::averaging : weights::cosine});
    }
};
template <class M>
struct sqrt3_on {
    using mesh = M;
    template <class Test>
    static void for_each(const Test& test)
    {
        for (const auto& f : golden::files_of("sqrt3"))
            test(f, control_mesh<M>(f), kith::sqrt3{});
    }
};
template <class M>
struct unified_on {
    using mesh = M;
    template <class Test>
    static void for_each(const Test& test)
    {
        for (const auto& f : golden::files_of("unified"))
            test(f, control_mesh<M>(f), kith::unified{.degree = f.degree});
    }
};

template <class M>
using triangle_schemes_on = testing::Types<loop_on<M>, sqrt3_on<M>>;
/// A scheme of polygons and one of triangles, for meshes that differ from others only in the type of their numbers.
template <class M>
using two_schemes_on = testing::Types<catmull_clark_on<M>, loop_on<M>>;
template <class M>
using all_schemes_on = testing::Types<catmull_clark_on<M>, doo_sabin_on<M>, loop_on<M>, sqrt3_on<M>, unified_on<M>>;
