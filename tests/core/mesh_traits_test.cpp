// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/mesh/mesh_traits.hpp>

#include "support/native_shape.hpp"

#include <gtest/gtest.h>

namespace {

/// A mesh type whose traits are those of the native mesh without one member.
struct hidden {};
using native_traits = kith::mesh_traits<mesh3d>;

struct without_next : native_traits {
    static void next() = delete;
};
struct without_build : native_traits {
    static void build() = delete;
};
struct with_text_points : native_traits {
    using point = const char*;
};

} // namespace

TEST(mesh_traits, the_native_mesh_can_be_read_and_made)
{
    EXPECT_TRUE(kith::mesh<mesh3d>);
    EXPECT_TRUE(kith::refinable_mesh<mesh3d>);
}

TEST(mesh_traits, a_type_without_traits_is_no_mesh)
{
    EXPECT_FALSE(kith::mesh<hidden>);
    EXPECT_FALSE(kith::mesh<int>);
}

TEST(mesh_traits, every_function_is_needed)
{
    EXPECT_FALSE((kith::mesh<mesh3d, without_next>));
}

TEST(mesh_traits, a_mesh_without_build_can_be_read_only)
{
    EXPECT_TRUE((kith::mesh<mesh3d, without_build>));
    EXPECT_FALSE((kith::refinable_mesh<mesh3d, without_build>));
}

TEST(mesh_traits, points_must_be_affine)
{
    EXPECT_FALSE((kith::mesh<mesh3d, with_text_points>));
}
