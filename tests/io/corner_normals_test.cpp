// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"

#include <kith/core/mesh/make_mesh.hpp>
#include <kith/io/format/mesh_format.hpp>
#include <kith/io/text/file_error.hpp>
#include <kith/read_mesh.hpp>
#include <kith/write_mesh.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace kith;
using io::mesh_format;
using points = std::vector<std::array<double, 3>>;

/// Two quads that meet in an edge at a right angle, with the normals of their corners.
struct fold {
    basic_mesh<> mesh = make_mesh(points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, -1}, {1, 1, -1}},
                                  std::vector<std::vector<int>>{{0, 1, 2, 3}, {1, 4, 5, 2}});
    points of_vertices = points(6, {0, 0, 1});
    points of_corners{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}};

    [[nodiscard]] io::written_mesh what(bool binary = false) const
    {
        return {.mesh = mesh, .normals = of_vertices, .binary = binary, .corner_normals = of_corners};
    }
};

std::string written(mesh_format format, const io::written_mesh& what)
{
    io::require_writable(format, what);
    std::ostringstream out;
    io::write_mesh(out, format, what);
    return out.str();
}

} // namespace

TEST(corner_normals, of_obj_are_lines_for_each_side_of_a_vertex)
{
    const std::string text = written(mesh_format::obj, fold().what());
    EXPECT_EQ(text,
              "# kith: 6 vertices, 2 faces\n"
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 1 1 -1\n"
              "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 1 0 0\nvn 1 0 0\nvn 1 0 0\nvn 1 0 0\n"
              "f  1//1 2//2 3//3 4//4\nf  2//5 5//6 6//7 3//8\n");
    const auto read = io::read_mesh(mesh_format::obj, text).attributes.corners;
    ASSERT_EQ(read.size(), 3U);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t c = 0; c < 8; ++c)
            EXPECT_EQ(read[axis].values[c], fold().of_corners[c][axis]);
}

TEST(corner_normals, of_ply_are_a_list_of_each_face_beside_those_of_vertices)
{
    const std::string head = "ply\nformat ascii 1.0\ncomment written by kith\nelement vertex 6\nproperty double x\n"
                             "property double y\nproperty double z\nproperty double nx\nproperty double ny\n"
                             "property double nz\nelement face 2\nproperty list uchar int vertex_indices\n"
                             "property list uchar double normal\nend_header\n";
    const std::string text = written(mesh_format::ply, fold().what());
    EXPECT_EQ(text,
              head + "0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n1 0 -1 0 0 1\n1 1 -1 0 0 1\n"
                     "4 0 1 2 3 12 0 0 1 0 0 1 0 0 1 0 0 1\n4 1 4 5 2 12 1 0 0 1 0 0 1 0 0 1 0 0\n");
    const std::string binary = written(mesh_format::ply, fold().what(true));
    const std::size_t begin = binary.find("end_header\n") + 11;
    EXPECT_EQ(binary.size() - begin, 6 * 48 + 2 * (1 + 16 + 1 + 4 * 24));
    for (const std::string& file : {text, binary}) {
        const auto soup = io::read_mesh(mesh_format::ply, file);
        EXPECT_EQ(soup.faces.size(), 2U);
        EXPECT_EQ(soup.points.size(), 6U);
        EXPECT_EQ(soup.not_kept, std::vector<std::string>{"normals"}); // normals of vertices are kept
        ASSERT_EQ(soup.attributes.vertices.size(), 3U);
    }
}

TEST(corner_normals, of_off_are_left_aside)
{
    const fold f;
    EXPECT_EQ(written(mesh_format::off, f.what()),
              written(mesh_format::off, {.mesh = f.mesh, .normals = f.of_vertices}));
}

TEST(corner_normals, that_are_not_finite_are_refused)
{
    fold f;
    f.of_corners[5][1] = std::numeric_limits<double>::infinity();
    for (const auto format : {mesh_format::obj, mesh_format::ply})
        EXPECT_EQ(error_text<io::file_error>([&] { io::require_writable(format, f.what()); }),
                  "vertex 4 would have no finite normal; the coordinates of the input are too large");
}
