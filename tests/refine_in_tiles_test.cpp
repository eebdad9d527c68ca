// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.hpp"
#include "native_shape.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/refine_in_tiles.hpp>

#include <gtest/gtest.h>

#include <string>

namespace {

std::string refusal(const mesh3d& mesh, int levels)
{
    return error_text<kith::mesh_error>(
        [&] { kith::tiled_refinement(mesh, kith::catmull_clark{}, levels, kith::block_partition(mesh, 2)); });
}

} // namespace

TEST(ring_schedule, has_an_entry_per_level)
{
    const kith::catmull_clark scheme;
    EXPECT_EQ(kith::ring_schedule(scheme, 1000).size(), 1001U);
    EXPECT_EQ(kith::ring_schedule(scheme, 2, 3).back(), 3);
    for (const int levels : {1001, 2147483647})
        EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::ring_schedule(scheme, levels); }),
                  "catmull-clark: " + std::to_string(levels) +
                      " levels were asked for; no surface has so many, ask for at most 1000");
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::ring_schedule(scheme, -1); }),
              "catmull-clark: levels and rings are counted from 0");
}

TEST(tiled_refinement, needs_the_edges_of_the_control_mesh)
{
    const auto cube = native(shapes::cube());
    const kith::catmull_clark scheme;
    EXPECT_EQ(refusal(kith::refine(cube, scheme, 1), 1), "no error");
    EXPECT_EQ(refusal(kith::refine(cube, scheme, 1, {kith::connect::faces}), 1),
              "the mesh has face-vertex lists only and no edges; refine it with connect::everything");
}

TEST(tiled_refinement, refuses_levels_that_no_surface_has)
{
    const auto cube = native(shapes::cube());
    EXPECT_EQ(refusal(cube, 1000), "the whole mesh has more elements than 64 bits can number; refine fewer times");
    EXPECT_EQ(refusal(cube, 2147483647),
              "catmull-clark: 2147483647 levels were asked for; no surface has so many, ask for at most 1000");
}
