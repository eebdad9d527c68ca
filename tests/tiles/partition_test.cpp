// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"
#include "support/native_shape.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/tiles/part/partition.hpp>
#include <kith/tiles/refine/cut_tiles.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace {

std::string refusal_of_file(const mesh3d& mesh, const std::string& text)
{
    return error_text<kith::mesh_error>([&] {
        std::istringstream in(text);
        kith::read_partition(in, mesh);
    });
}

} // namespace

TEST(read_partition, takes_parts_that_are_empty_and_scattered)
{
    const auto cube = native(shapes::cube());
    std::istringstream in("0\n3\n0\n5\n3\n0\n");
    const auto parts = kith::read_partition(in, cube);
    EXPECT_EQ(parts.part_of, (std::vector<std::uint32_t>{0, 3, 0, 5, 3, 0}));
    EXPECT_EQ(parts.parts, 6U);
    kith::tile_cutter cutter(cube, kith::catmull_clark{}, parts.part_of, parts.parts);
    EXPECT_EQ(cutter.faces(1).size(), 0U);
    EXPECT_EQ(cutter.cut(1, 1).part.mesh.face_count(), 0U);
}

TEST(read_partition, says_what_is_wrong_with_a_file)
{
    const auto cube = native(shapes::cube());
    const auto part_of_face_2 = [&](const char* part) {
        return refusal_of_file(cube, std::string("0 1 ") + part + " 1 0 1");
    };
    EXPECT_EQ(part_of_face_2("5"), "no error");
    for (const char* part : {"-1", "6", "4294967294", "9223372036854775807"})
        EXPECT_EQ(part_of_face_2(part),
                  std::string("the partition file gives face 2 part ") + part +
                      ", the mesh has 6 faces; number the parts from 0, below the number of faces");
    for (const char* text : {"0 1 2", "0 1 2 one 3 4 5", "0 1 99999999999999999999 2 3 4"})
        EXPECT_NE(refusal_of_file(cube, text).find("numbers, the mesh has 6 faces; give one number per face"),
                  std::string::npos)
            << text;
}

TEST(block_partition, refuses_more_parts_than_can_be_held)
{
    const auto cube = native(shapes::cube());
    const auto text = [&](std::size_t parts) {
        return error_text<kith::mesh_error>([&] { kith::block_partition(cube, parts); });
    };
    EXPECT_EQ(text(0), "0 parts were asked for; ask for 1 or more");
    EXPECT_EQ(text(7), "no error");
    EXPECT_EQ(text(std::size_t(1) << 20), "no error");
    const std::vector<std::uint32_t> part_of(6, 0);
    for (const std::size_t parts : {(std::size_t(1) << 20) + 1, std::size_t(UINT32_MAX), SIZE_MAX}) {
        const std::string expected = std::to_string(parts) +
                                     " parts were asked for, and the mesh has 6 faces; ask for at most 1048576";
        EXPECT_EQ(text(parts), expected);
        EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::tile_cutter(cube, kith::catmull_clark{}, part_of, parts); }),
                  expected);
    }
}
