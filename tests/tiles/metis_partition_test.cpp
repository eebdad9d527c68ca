// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"
#include "support/native_shape.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/metis_partition.hpp>
#include <kith/refine.hpp>

#include <gtest/gtest.h>

TEST(metis_partition, needs_the_edges_of_the_mesh)
{
    const auto cube = native(shapes::cube());
    const auto fine = kith::refine(cube, kith::catmull_clark{}, 1);
    EXPECT_EQ(kith::metis_partition(fine, 3).part_of.size(), fine.face_count());
    const auto faces = kith::refine(cube, kith::catmull_clark{}, 1, {kith::connect::faces});
    for (const std::size_t parts : {1, 3})
        EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::metis_partition(faces, parts); }),
                  "the mesh has face-vertex lists only and no edges; refine it with connect::everything");
}
