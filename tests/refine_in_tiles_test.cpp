// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.hpp"
#include "native_shape.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/refine_in_tiles.hpp>

#include <gtest/gtest.h>

namespace {

std::string refusal(const mesh3d& mesh, int levels)
{
    return error_text<kith::mesh_error>(
        [&] { kith::tiled_refinement(mesh, kith::catmull_clark{}, levels, kith::block_partition(mesh, 2)); });
}

} // namespace

TEST(tiled_refinement, needs_the_edges_of_the_control_mesh)
{
    const auto cube = native(shapes::cube());
    const kith::catmull_clark scheme;
    EXPECT_EQ(refusal(kith::refine(cube, scheme, 1), 1), "no error");
    EXPECT_EQ(refusal(kith::refine(cube, scheme, 1, {kith::connect::faces}), 1),
              "the mesh has face-vertex lists only and no edges; refine it with connect::everything");
}
