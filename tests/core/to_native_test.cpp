// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/level/to_native.hpp>

#include "support/every_level.hpp"
#include "support/every_scheme.hpp"
#include "support/same_mesh.hpp"

#include <kith/refine.hpp>

#include <gtest/gtest.h>

// These tests read the native mesh through its traits. For meshes of other libraries see cgal_test.cpp and
// openmesh_test.cpp.

TEST(to_native, what_is_read_through_the_traits_is_the_mesh_itself)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        const auto mesh = native(shape);
        EXPECT_TRUE(same_bits(kith::to_native(mesh), mesh));
    }
}

TEST(to_native, refined_meshes_are_read_right_too)
{
    for_each_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        const auto fine = kith::refine(mesh, scheme, 1);
        EXPECT_TRUE(same_bits(kith::to_native(fine), fine));
    });
}
