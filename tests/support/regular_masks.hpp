// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "native_shape.hpp"

#include <kith/hierarchy.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

using vertex_handle = kith::mesh_traits<mesh3d>::vertex;
using edge_handle = kith::mesh_traits<mesh3d>::edge;
using face_handle = kith::mesh_traits<mesh3d>::face;

/// Returns the weights of the point that the first step makes under a tuple, the largest first and without zeros.
template <class Scheme, class... Handle>
std::vector<double> weights_of(const shapes::shape& shape, const Scheme& scheme, const Handle&... handle)
{
    kith::hierarchy levels(native(shape), scheme);
    levels.refine();
    const auto row = levels.assoc(0, handle..., kith::targets::V).value;
    const auto matrix = levels.matrix(0, 1);
    std::vector<double> result(matrix.weight.begin() + matrix.row_start[row],
                               matrix.weight.begin() + matrix.row_start[row + 1]);
    std::erase(result, 0.);
    std::ranges::sort(result, std::greater());
    return result;
}

inline void expect_weights(const std::vector<double>& is, const std::vector<double>& should_be)
{
    ASSERT_EQ(is.size(), should_be.size());
    for (std::size_t i = 0; i < is.size(); ++i)
        EXPECT_NEAR(is[i], should_be[i], 2e-16);
}

inline const auto regular_quads = shapes::torus(6, 6);
inline const auto regular_triangles = shapes::triangulated(regular_quads); // valence six everywhere
