// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"
#include "support/vtu_files.hpp"
#include "files.hpp"

#include <kith/io/format/facet_normal.hpp>
#include <kith/io/format/obj_tag.hpp>
#include <kith/io/text/file_error.hpp>
#include <kith/read_mesh.hpp>
#include <kith/schemes/crease/creases.hpp>
#include <kith/write_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace kith;
using io::mesh_format;
using points = std::vector<std::array<double, 3>>;

basic_mesh<> tetrahedron(const points& corners = files::corners)
{
    return make_mesh(corners, files::triangles);
}

std::string written(mesh_format format, const io::written_mesh& what)
{
    io::require_writable(format, what);
    std::ostringstream out;
    io::write_mesh(out, format, what);
    return out.str();
}

std::string refusal(mesh_format format, const io::written_mesh& what)
{
    try {
        io::require_writable(format, what);
    } catch (const io::file_error& error) {
        return error.what();
    }
    return "written";
}

TEST(write_mesh, all_formats_read_back_to_the_same_bits)
{
    const points corners{{0.1, -0., 1e-300}, {5. / 9, 1e22, 5e-324}, {1 / 3., 123456789, -1e300}, {2, 3, 1e5}};
    const basic_mesh<> mesh = tetrahedron(corners);
    for (const auto format : {mesh_format::off, mesh_format::obj, mesh_format::ply})
        for (const bool binary : {false, true})
            for (const points& normals : {points(), points(4, {0.6, 0.8, 0.1})}) {
                const io::written_mesh what{.mesh = mesh, .normals = normals, .binary = binary};
                const auto soup = io::read_mesh(format, written(format, what));
                ASSERT_EQ(soup.points.size(), 4);
                for (std::size_t v = 0; v < 4; ++v)
                    for (std::size_t i = 0; i < 3; ++i) {
                        EXPECT_EQ(soup.points[v][i], corners[v][i]);
                        EXPECT_EQ(std::signbit(soup.points[v][i]), std::signbit(corners[v][i]));
                    }
                EXPECT_EQ(soup.faces.size(), 4);
                EXPECT_TRUE(soup.not_kept.empty());
                const auto& read = format == mesh_format::obj ? soup.attributes.corners : soup.attributes.vertices;
                ASSERT_EQ(read.size(), normals.empty() ? 0 : 3);
                for (std::size_t i = 0; i < read.size(); ++i)
                    EXPECT_EQ(read[i].values, std::vector<double>(format == mesh_format::obj ? 12 : 4, normals[0][i]));
            }
}

TEST(write_mesh, the_text_of_each_format)
{
    const basic_mesh<> mesh = make_mesh(points{{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}},
                                        std::vector<std::vector<int>>{{0, 1, 2}});
    const io::written_mesh what{.mesh = mesh};
    EXPECT_EQ(written(mesh_format::off, what), "OFF\n3 1 0\n\n0 0 0\n1 0 0\n0 0.5 0\n3  0 1 2\n\n");
    EXPECT_EQ(written(mesh_format::obj, what), "# kith: 3 vertices, 1 face\nv 0 0 0\nv 1 0 0\nv 0 0.5 0\nf  1 2 3\n");
    EXPECT_EQ(written(mesh_format::ply, what),
              "ply\nformat ascii 1.0\ncomment written by kith\nelement vertex 3\nproperty double x\nproperty double y\n"
              "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
              "0 0 0\n1 0 0\n0 0.5 0\n3 0 1 2\n");
    EXPECT_EQ(written(mesh_format::stl, what),
              "solid kith\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0.5 0\nendloop\n"
              "endfacet\nendsolid kith\n");
}

TEST(write_mesh_file, writes_the_format_that_the_extension_names)
{
    const vtu_files::directory here;
    const basic_mesh<> mesh = tetrahedron();
    for (const char* name : {"mesh.off", "mesh.obj", "mesh.ply", "mesh.stl"}) {
        const std::string path = here.path / name;
        io::write_mesh_file(path, {.mesh = mesh});
        EXPECT_EQ(vtu_files::bytes_of(path), written(io::format_of(path), {.mesh = mesh}));
        EXPECT_EQ(io::read_mesh_file(path).faces.size(), 4);
    }
}

TEST(write_mesh_file, what_is_refused_leaves_the_file_as_it_was)
{
    const vtu_files::directory here;
    const std::string path = here.path / "mesh.off";
    basic_mesh<> mesh = tetrahedron();
    io::write_mesh_file(path, {.mesh = mesh});
    const std::string before = vtu_files::bytes_of(path);
    mesh.points()[2][1] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(error_text<io::file_error>([&] { io::write_mesh_file(path, {.mesh = mesh}); }),
              path + ": vertex 2 would not have finite coordinates; the coordinates of the input are too large");
    EXPECT_EQ(vtu_files::bytes_of(path), before);
    for (const std::string name : {"mesh.vtu", "mesh.txt"})
        EXPECT_EQ(error_text<io::file_error>([&] { io::write_mesh_file(name, {.mesh = mesh}); }),
                  name +
                      ": the extension decides the format and must be .off, .obj, .ply, .stl, .vtp or .glb, or .vtu or "
                      ".pvtu, which are written in tiles");
}

TEST(write_mesh_file, writes_off_to_standard_output)
{
    testing::internal::CaptureStdout();
    const basic_mesh<> mesh = tetrahedron();
    io::write_mesh_file("-", {.mesh = mesh});
    EXPECT_EQ(testing::internal::GetCapturedStdout(), written(mesh_format::off, {.mesh = mesh}));
}

TEST(write_mesh, vtu_is_refused_and_not_written_as_another_format)
{
    const basic_mesh<> mesh = tetrahedron();
    const std::string text = "VTU is written in tiles, by kith::vtu_file; choose .vtp or another format";
    EXPECT_EQ(refusal(mesh_format::vtu, {.mesh = mesh}), text);
    std::ostringstream out;
    EXPECT_EQ(error_text<io::file_error>([&] { io::write_mesh(out, mesh_format::vtu, {.mesh = mesh}); }), text);
    EXPECT_EQ(out.str(), "");
}

TEST(write_mesh, faces_of_many_corners)
{
    for (const std::size_t n : {127, 128, 255, 256, 32768, 65535, 65536}) {
        points corners;
        std::vector<std::size_t> face;
        for (std::size_t i = 0; i < n; ++i) {
            corners.push_back({double(i), double(i * i), 0.25});
            face.push_back((i + 5) % n);
        }
        // A triangle at the first side, so that faces have several degrees.
        corners.push_back({-1, -1, 7});
        const basic_mesh<> mesh = make_mesh(corners, std::vector<std::vector<std::size_t>>{face, {1, 0, n}});
        io::mesh_attributes attributes;
        for (const auto name : {"u", "v"}) {
            attributes.corners.emplace_back().name = name;
            for (std::size_t c = 0; c < n + 3; ++c)
                attributes.corners.back().values.push_back(double(c) / (name[0] == 'u' ? 2 : 4));
        }
        const std::string degree = n > 65535 ? "uint" : n > 255 ? "ushort" : "uchar";
        const std::string values = n > 32767 ? "uint" : n > 127 ? "ushort" : "uchar";
        for (const bool binary : {false, true}) {
            const std::string bytes = written(mesh_format::ply,
                                              {.mesh = mesh, .binary = binary, .attributes = &attributes});
            EXPECT_NE(bytes.find("property list " + degree + " int vertex_indices\nproperty list " + values +
                                 " double texcoord\nend_header\n"),
                      std::string::npos)
                << n;
            const auto soup = io::read_mesh(mesh_format::ply, bytes);
            ASSERT_EQ(soup.faces.size(), 2);
            EXPECT_TRUE(std::ranges::equal(soup.faces[0], mesh.face(0)));
            EXPECT_TRUE(std::ranges::equal(soup.faces[1], mesh.face(1)));
            EXPECT_EQ(soup.points, corners);
            ASSERT_EQ(soup.attributes.corners.size(), 2);
            EXPECT_EQ(soup.attributes.corners[0].values, attributes.corners[0].values);
            EXPECT_EQ(soup.attributes.corners[1].values, attributes.corners[1].values);
        }
    }
}

TEST(write_mesh, isolated_points_come_last)
{
    const basic_mesh<> mesh = tetrahedron();
    const points isolated{{7, 8, 9}};
    for (const auto format : {mesh_format::off, mesh_format::obj, mesh_format::ply}) {
        const auto soup = io::read_mesh(format, written(format, {.mesh = mesh, .isolated = isolated}));
        ASSERT_EQ(soup.points.size(), 5);
        EXPECT_EQ(soup.points[4], isolated[0]);
        EXPECT_EQ(soup.faces.size(), 4);
    }
}

TEST(write_mesh, large_meshes_are_written_in_blocks)
{
    points strip;
    std::vector<std::vector<int>> faces;
    for (int i = 0; i < 300000; ++i)
        strip.push_back({double(i), double(i % 2), 0.1 * i});
    for (int i = 0; i + 2 < 300000; ++i)
        faces.push_back(i % 2 == 0 ? std::vector{i, i + 1, i + 2} : std::vector{i + 1, i, i + 2});
    const basic_mesh<> mesh = make_mesh(strip, faces);
    const auto soup = io::read_mesh(mesh_format::off, written(mesh_format::off, {.mesh = mesh}));
    EXPECT_EQ(soup.points, strip);
    ASSERT_EQ(soup.faces.size(), faces.size());
    EXPECT_EQ(soup.faces[299997][1], 299999);
}

TEST(write_mesh, what_is_not_finite_is_refused)
{
    constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    basic_mesh<> mesh = tetrahedron();
    const points normals{{0, 0, 1}, {0, 0, 1}, {0, nan, 1}, {0, 0, 1}};
    for (const auto format : {mesh_format::off, mesh_format::obj, mesh_format::ply})
        EXPECT_EQ(refusal(format, {.mesh = mesh, .normals = normals}),
                  "vertex 2 would have no finite normal; the coordinates of the input are too large");
    mesh.points()[1][2] = 1e39;
    EXPECT_EQ(refusal(mesh_format::stl, {.mesh = mesh, .binary = true}),
              "vertex 1 is too far away for the floats of binary STL; write text, or .off, .obj or .ply");
    EXPECT_EQ(refusal(mesh_format::stl, {.mesh = mesh}), "written");
    mesh.points()[1][2] = std::numeric_limits<float>::max();
    EXPECT_EQ(refusal(mesh_format::stl, {.mesh = mesh, .binary = true}), "written");
    mesh.points()[3][0] = infinity;
    for (const auto format : {mesh_format::off, mesh_format::obj, mesh_format::ply, mesh_format::stl})
        EXPECT_EQ(refusal(format, {.mesh = mesh}),
                  "vertex 3 would not have finite coordinates; the coordinates of the input are too large");
}

TEST(write_stl, leaves_out_triangles_that_fall_together)
{
    // A long strip of quads, cut into triangles, far from the origin: in floats the ends of the short edges are equal.
    const double far = 1 << 24;
    const points strip{{far, 0, 0},
                       {far + 2, 0, 0},
                       {far + 4, 0, 0},
                       {far, 1, 0},
                       {far + 2, 1, 0},
                       {far + 2.5, 1, 0},
                       {far + 4, 1, 0}};
    const std::vector<std::vector<int>> faces{{0, 1, 4}, {0, 4, 3}, {1, 5, 4}, {1, 2, 6}, {1, 6, 5}};
    const basic_mesh<> mesh = make_mesh(strip, faces);
    EXPECT_EQ(io::fallen_faces({.mesh = mesh}), 1);
    const auto soup = io::read_mesh(mesh_format::stl, written(mesh_format::stl, {.mesh = mesh, .binary = true}));
    EXPECT_EQ(soup.faces.size(), 4);
    EXPECT_EQ(soup.points.size(), 6);
    EXPECT_TRUE(validate(soup.points, soup.faces).ok());
    EXPECT_EQ(io::read_mesh(mesh_format::stl, written(mesh_format::stl, {.mesh = mesh})).faces.size(), 5);

    // If no surface is left, no file is written that kith could not read.
    const points corners{{far, 0, 0}, {far + .1, 0, 0}, {far, 1, 0}, {far, 0, 1}};
    const basic_mesh<> small = make_mesh(corners,
                                         std::vector<std::vector<int>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
    EXPECT_EQ(io::fallen_faces({.mesh = small}), 2);
    EXPECT_EQ(refusal(mesh_format::stl, {.mesh = small}), "written");
    EXPECT_EQ(written(mesh_format::stl, {.mesh = small, .binary = true}).size(), 84 + 2 * 50);
    const points line{{far, 0, 0}, {far + .1, 0, 0}, {far + .2, 0, 0}, {far + .3, 0, 0}};
    const basic_mesh<> gone = make_mesh(line,
                                        std::vector<std::vector<int>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
    EXPECT_EQ(refusal(mesh_format::stl, {.mesh = gone, .binary = true}),
              "4 of 4 triangles collapse in the floats of binary STL, and the others form no surface that can be "
              "read; write text, .off, .obj or .ply, or move the mesh to the origin");
    // Two sheets whose distance is below the precision of floats.
    const points sheets{{far, 0, 0}, {far, 9, 0}, {far, 0, 9}, {far + .1, 0, 0}, {far + .1, 9, 0}, {far + .1, 0, 9}};
    const basic_mesh<> two = make_mesh(sheets, std::vector<std::vector<int>>{{0, 1, 2}, {3, 4, 5}});
    EXPECT_EQ(refusal(mesh_format::stl, {.mesh = two, .binary = true}).substr(0, 40),
              "0 of 2 triangles collapse in the floats ");
    // Points that are equal as doubles, too, are written as they are.
    const points touching{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}};
    const basic_mesh<> pinched = make_mesh(touching, std::vector<std::vector<int>>{{0, 1, 2}, {3, 4, 5}});
    EXPECT_EQ(refusal(mesh_format::stl, {.mesh = pinched, .binary = true}), "written");
}

TEST(facet_normal, is_finite_for_all_sizes)
{
    for (const double s : {1., 1e-300, 1e-160, 1e-100, 1e100, 1e160, 1e300, 1.7e308}) {
        const auto n = io::facet_normal({-s, 0, 0}, {s, 0, 0}, {0, s, s});
        EXPECT_NEAR(n[0], 0, 1e-15) << s;
        EXPECT_NEAR(n[1], -std::sqrt(0.5), 1e-15) << s;
        EXPECT_NEAR(n[2], std::sqrt(0.5), 1e-15) << s;
    }
    EXPECT_EQ(io::facet_normal({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), (std::array<double, 3>{1, 0, 0}));
}

TEST(obj_tags, are_written_as_they_are_read)
{
    const std::string lines = "t crease 2/1/0 0 1 2.5\nt crease 2/1/0 1 2 10\nt corner 1/1/0 3 0.5\nt hole 1/0/0 2\n"
                              "t interpolateboundary 1/0/0 2\nt creasemethod 0/0/1 chaikin\n";
    const auto soup = io::read_mesh(mesh_format::obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n" + lines);
    EXPECT_EQ(soup.tags.edges[1].sharpness, infinitely_sharp);
    EXPECT_EQ(io::obj_tag_lines(soup.tags), lines);
    const basic_mesh<> mesh = tetrahedron();
    const auto again = io::read_mesh(mesh_format::obj, written(mesh_format::obj, {.mesh = mesh, .tags = &soup.tags}));
    EXPECT_EQ(io::obj_tag_lines(again.tags), lines);
}

} // namespace
