// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapes.hpp"
#include "user_mesh.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/face_varying.hpp>
#include <kith/hierarchy.hpp>
#include <kith/refine_with_fields.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

/// Expects that values at the corners of an M are refined as on the native copy of the mesh. It tests a hierarchy and
/// `refine_with_fields`; every third face is a chart of its own.
template <class M>
void expect_face_varying_as_native(bool open)
{
    using uv = std::array<double, 2>;
    const auto shape = open ? shapes::shaken(shapes::open_house()) : shapes::shaken(shapes::torus(5, 7));
    const M mesh = user_mesh<M>::make(shape.points, shape.faces);
    kith::catmull_clark scheme;
    scheme.sharpness.sharpen_edge(3, 1.5);
    scheme.sharpness.sharpen_edge(4, 0.5);
    scheme.sharpness.sharpen_edge(6, kith::infinitely_sharp);
    const kith::level_of<M> level(mesh);
    std::vector<uv> values;
    for (const auto f : level.faces())
        for (const auto v : f.vertices())
            values.push_back({double(v.index() * v.index()), double(f.index() % 3 == 0)});
    using enum kith::face_varying_linear;
    for (const auto linear : {none, corners_only, corners_plus1, corners_plus2, boundaries, all}) {
        const auto field = kith::on_corners(values, kith::face_varying{linear});
        auto expected = field, at_once = field;
        kith::refine_with_fields(kith::to_native_valid(mesh), scheme, 2, std::tie(expected));
        kith::refine_with_fields(mesh, scheme, 2, std::tie(at_once));
        kith::hierarchy levels(mesh, scheme);
        levels.refine(2);
        EXPECT_TRUE(std::ranges::equal(at_once.values(), expected.values()));
        EXPECT_TRUE(std::ranges::equal(levels.carry(0, 2, field).values(), expected.values()));
    }
}
