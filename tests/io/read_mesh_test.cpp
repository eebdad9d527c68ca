// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"
#include "files.hpp"

#include <kith/io/format/ply_attributes.hpp>
#include <kith/io/text/file_error.hpp>
#include <kith/read_mesh.hpp>
#include <kith/schemes/crease/creases.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace kith;
using io::mesh_format;

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// Reads the tetrahedron and expects its points and faces. Formats that merge vertices may number them in any order.
io::polygon_soup expect_tetrahedron(mesh_format format, const std::string& bytes)
{
    auto soup = io::read_mesh(format, bytes);
    EXPECT_EQ(soup.points.size(), 4);
    EXPECT_EQ(soup.faces.size(), 4);
    for (std::size_t f = 0; f < soup.faces.size() and f < 4; ++f) {
        EXPECT_EQ(soup.faces[f].size(), 3);
        for (std::size_t i = 0; i < soup.faces[f].size() and i < 3; ++i)
            EXPECT_EQ(soup.points[soup.faces[f][i]], files::corners[files::triangles[f][i]]);
    }
    return soup;
}

std::string refusal(mesh_format format, const std::string& bytes)
{
    try {
        (void)io::read_mesh(format, bytes);
    } catch (const io::file_error& error) {
        return error.what();
    }
    return "read";
}

const std::vector<std::pair<mesh_format, std::string>> texts{{mesh_format::off, files::off},
                                                             {mesh_format::obj, files::obj},
                                                             {mesh_format::ply, files::ply},
                                                             {mesh_format::stl, files::stl}};

TEST(read_mesh, texts_with_all_ends_of_lines_and_a_byte_order_mark)
{
    for (const auto& [format, text] : texts)
        for (const std::string end : {"\n", "\r", "\r\n"})
            for (const std::string mark : {"", "\xef\xbb\xbf"})
                expect_tetrahedron(format, mark + replaced(text, "\n", end));
}

TEST(read_mesh, lines_are_counted_at_all_ends)
{
    for (const std::string end : {"\n", "\r", "\r\n"})
        EXPECT_EQ(refusal(mesh_format::off, replaced(replaced(files::off, "3 1 2 3", "3 1 2 4"), "\n", end)),
                  "line 9: face 2: vertex 4 does not exist, there are 4; correct the index");
}

TEST(read_off, keywords)
{
    for (const std::string keyword : {"off", "Off", "OFF"})
        expect_tetrahedron(mesh_format::off, replaced(files::off, "OFF", keyword));
    for (const std::string keyword : {"nOFF\n3", "nOFF 3"})
        expect_tetrahedron(mesh_format::off, replaced(files::off, "OFF", keyword));
    for (const std::string keyword : {"nOFF\n2", "4nOFF\n4"})
        EXPECT_NE(refusal(mesh_format::off, replaced(files::off, "OFF", keyword)).find("three are needed"),
                  std::string::npos);
    for (const std::string keyword : {"NNOFF", "STSOFF", "CCOFF", "SOFF", "XOFF", "44OFF"})
        EXPECT_EQ(refusal(mesh_format::off, replaced(files::off, "OFF", keyword)),
                  "line 1: an OFF file begins with the word OFF, this one with '" + keyword + "'");
    EXPECT_EQ(refusal(mesh_format::off, replaced(files::off, "OFF", "OFFICE")),
              "line 1: an OFF file begins with the word OFF, this one with 'OFFICE'");
    EXPECT_EQ(refusal(mesh_format::off, replaced(files::off, "OFF", "OFF BINARY")).substr(0, 29),
              "line 1: binary OFF is not rea");
}

TEST(read_off, has_at_most_nine_numbers_behind_the_coordinates_of_a_vertex)
{
    const auto with = [](const std::string& more) {
        std::string result = "OFF\n6 1 0\n";
        for (int v = 0; v < 6; ++v)
            result += std::to_string(v) + " 1 0" + more + "\n";
        return result + "6 0 1 2 3 4 5\n";
    };
    EXPECT_EQ(refusal(mesh_format::off, with(" 0 0 1 1 1 1 1 .5 .5")), "read");
    EXPECT_EQ(refusal(mesh_format::off, with(" 0 0 1 1 1 1 1 .5 .5 0")),
              "line 3: vertex 0 has too many numbers; each vertex has a line of its own");
}

TEST(read_off, one_line)
{
    expect_tetrahedron(mesh_format::off, replaced(files::off, "\n", " "));
    expect_tetrahedron(mesh_format::off, "OFF\n4 4 6\n0 0 0 1 0 0 0 1 0 0 0 1\n3 0 2 1 3 0 1 3 3 1 2 3 3 2 0 3");
    expect_tetrahedron(mesh_format::off,
                       "noff 4 4 0 0 0 0 9 9 9 1 0 0 9 9 9 0 1 0 9 9 9 0 0 1 9 9 9 3 0 2 1 3 0 1 3 3 1 2 3 3 2 0 3");
    EXPECT_EQ(refusal(mesh_format::off, "OFF 4 4 6 0 0 0 1 0 0 0 1 0 0 0 1 3 0 2 1 3 0 1 3 3 1 2 3 3 2 0"),
              "line 1: face 3 should have 3 corners, 2 are there");
    EXPECT_EQ(refusal(mesh_format::off, replaced(files::off, "4 4 6", "4 4 6 0 0 0")),
              "line 2: this line holds more than the numbers of vertices, faces and edges");
}

TEST(read_off, what_is_not_kept)
{
    EXPECT_TRUE(expect_tetrahedron(mesh_format::off, files::off).not_kept.empty());
    EXPECT_TRUE(expect_tetrahedron(mesh_format::off, files::off).attributes.empty());
    const auto numbers = replaced(replaced(files::off, "0 1 0\n", "0 1 0 7\n"), "3 0 1 3", "3 0 1 3 255");
    EXPECT_EQ(expect_tetrahedron(mesh_format::off, numbers).not_kept,
              (std::vector<std::string>{"extra numbers after the coordinates of vertices",
                                        "colours of faces given as indices of a colour map"}));
}

TEST(read_obj, everything_else_is_named)
{
    const auto soup = expect_tetrahedron(mesh_format::obj, files::obj);
    EXPECT_EQ(soup.first_number, 1);
    EXPECT_EQ(soup.not_kept, std::vector<std::string>{"weights of vertices"});
    EXPECT_EQ(topics_of(soup.attributes),
              (std::vector<std::string>{
                  "colours", "texture coordinates", "normals", "objects", "groups", "materials", "smoothing groups"}));
    const std::string others = "l 1 2\nvt 5 5\nvn 0 1 0\nv 0 0 0 1 2 3 4 5\nusemap x\nmg 1 2\n";
    EXPECT_EQ(io::read_mesh(mesh_format::obj, files::obj + others).not_kept,
              (std::vector<std::string>{"weights of vertices",
                                        "lines",
                                        "extra numbers after the coordinates of vertices",
                                        "texture maps",
                                        "smoothing groups",
                                        "texture coordinates that no corner has",
                                        "normals that no corner has"}));
    ASSERT_EQ(soup.tags.edges.size(), 1);
    EXPECT_EQ(soup.tags.edges[0].sharpness, 2.5);
    ASSERT_EQ(soup.tags.vertices.size(), 1);
    EXPECT_EQ(soup.tags.vertices[0], std::pair(std::size_t(3), infinitely_sharp));
    ASSERT_EQ(soup.tags.unread.size(), 1);
    EXPECT_EQ(soup.tags.unread[0].name, "other");
    EXPECT_EQ(soup.tags.unread[0].line, 19);
}

TEST(read_obj, indices)
{
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_EQ(refusal(mesh_format::obj, points + "f 1 2 -4\n"),
              "line 4: face 1: vertex -4 does not exist, there are 3 so far; correct the index");
    EXPECT_EQ(refusal(mesh_format::obj, points + "f 1 2 3\nf 1 9 3\nv 1 1 1\n"),
              "line 5: face 2: vertex 9 does not exist, there are 4; correct the index");
    EXPECT_EQ(io::read_mesh(mesh_format::obj, "f 1 2 3\n" + points).faces.size(), 1);
    // A comment that ends in a backslash does not continue on the next line.
    EXPECT_EQ(io::read_mesh(mesh_format::obj, "# c:\\dir\\\n" + points + "f 1 2 3\n").points.size(), 3);
}

TEST(read_ply, types_of_numbers)
{
    for (const bool big : {false, true}) {
        const auto soup = expect_tetrahedron(
            mesh_format::ply, files::binary_ply<float, std::uint8_t, std::int32_t>("float", "uchar", "int", big));
        EXPECT_TRUE(soup.not_kept.empty());
        ASSERT_EQ(soup.attributes.vertices.size(), 1);
        EXPECT_EQ(soup.attributes.vertices[0].name, "s");
        EXPECT_EQ(soup.attributes.vertices[0].values, std::vector<double>(4, 7));
        ASSERT_EQ(soup.attributes.faces.size(), 1);
        EXPECT_EQ(soup.attributes.faces[0].name, "area");
        EXPECT_EQ(soup.attributes.faces[0].values, std::vector<double>(4, 0.5));
        expect_tetrahedron(mesh_format::ply,
                           files::binary_ply<double, std::int8_t, std::uint8_t>("double", "char", "uchar", big));
        expect_tetrahedron(
            mesh_format::ply,
            files::binary_ply<std::int16_t, std::uint16_t, std::int16_t>("short", "ushort", "short", big));
        expect_tetrahedron(mesh_format::ply,
                           files::binary_ply<std::uint8_t, std::int32_t, std::int8_t>("uint8", "int32", "int8", big));
        expect_tetrahedron(mesh_format::ply,
                           files::binary_ply<std::int32_t, std::uint32_t, std::uint16_t>("int", "uint", "uint16", big));
    }
}

TEST(read_ply, strips_of_triangles)
{
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
    const auto header = [](const std::string& format, const std::string& elements) {
        return "ply\nformat " + format +
               " 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
               "property float z\n" +
               elements + "end_header\n";
    };
    const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
    const auto read = [&](const std::string& elements, const std::string& data) {
        return io::read_mesh(mesh_format::ply, header("ascii", elements) + points + data);
    };
    using numbers = std::vector<std::size_t>;
    EXPECT_EQ(read(strips, "6 0 1 2 3 4 5").faces.vertices, (numbers{0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5}));
    // Two strips, each ended by -1; a strip that continues across triangles without area; a strip that ends in one.
    EXPECT_EQ(read(strips, "9 0 1 2 3 -1 2 3 4 -1").faces.vertices, (numbers{0, 1, 2, 2, 1, 3, 2, 3, 4}));
    EXPECT_EQ(read(strips, "8 0 1 2 3 3 2 2 5").faces.vertices, (numbers{0, 1, 2, 2, 1, 3}));
    EXPECT_EQ(read(strips, "4 0 1 2 2").faces.vertices, (numbers{0, 1, 2}));
    EXPECT_EQ(read("element tristrips 2\nproperty list int int vertex_indices\n", "3 0 1 2 4 2 3 4 5").faces.vertices,
              (numbers{0, 1, 2, 2, 3, 4, 4, 3, 5}));
    const auto more = read("element tristrips 1\nproperty uchar flag\nproperty list int int vertex_indices\n",
                           "9 3 0 1 2");
    EXPECT_EQ(more.faces.size(), 1);
    EXPECT_EQ(more.not_kept, (std::vector<std::string>{"the property 'flag' of strips"}));

    // Faces beside strips come first, whatever the order in the file, and only they keep their values.
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nproperty uchar red\n";
    for (const bool strips_first : {false, true}) {
        const auto both = strips_first ? read(strips + faces, "3 0 1 2 4 2 3 5 4 9")
                                       : read(faces + strips, "4 2 3 5 4 9 3 0 1 2");
        EXPECT_EQ(both.faces.vertices, (numbers{2, 3, 5, 4, 0, 1, 2}));
        EXPECT_TRUE(both.not_kept.empty());
        ASSERT_EQ(both.attributes.faces.size(), 1);
        EXPECT_EQ(both.attributes.faces[0].values[0], 9);
        EXPECT_TRUE(std::isnan(both.attributes.faces[0].values[1]));
    }
    for (const bool big_endian : {false, true}) {
        std::string bytes = header(big_endian ? "binary_big_endian" : "binary_little_endian", strips);
        for (int v = 0; v < 6; ++v)
            for (const float x : {float(v % 2), float(v / 2), 0.F})
                files::append(bytes, x, big_endian);
        for (const std::int32_t x : {8, 0, 1, 2, -1, 2, 3, 4, 5})
            files::append(bytes, x, big_endian);
        EXPECT_EQ(io::read_mesh(mesh_format::ply, bytes).faces.vertices, (numbers{0, 1, 2, 2, 3, 4, 4, 3, 5}));
    }

    const auto said = [&](const std::string& data) {
        return error_text<io::file_error>([&] { (void)read(strips, data); });
    };
    EXPECT_EQ(said("6 0 1 2 -1 3 4"),
              "tristrips 0: a strip of 2 vertices makes no triangle; give it three or remove it");
    EXPECT_NE(said("3 0 1 6").find("tristrips 0: vertex 6 does not exist, there are 6; correct the index"),
              std::string::npos);
    EXPECT_NE(said("3 0 1 -2").find("tristrips 0: vertex -2 does not exist"), std::string::npos);
    EXPECT_NE(said("3 0 1").find("the file ends where tristrips 0: vertex_indices should be"), std::string::npos);
    EXPECT_EQ(error_text<io::file_error>([&] { (void)read("", ""); }),
              "the file must have one element 'vertex' and one element 'face' or 'tristrips'");
    EXPECT_EQ(error_text<io::file_error>(
                  [&] { (void)read("element tristrips 1\nproperty list int float vertex_indices\n", "0"); }),
              "the strips have no list 'vertex_indices' of whole numbers");
}

TEST(read_ply, everything_else_is_named)
{
    const auto soup = expect_tetrahedron(mesh_format::ply, files::ply);
    EXPECT_EQ(soup.not_kept, (std::vector<std::string>{"the property 'weights' of faces", "the elements 'edge'"}));
    ASSERT_EQ(soup.attributes.vertices.size(), 1);
    EXPECT_EQ(soup.attributes.vertices[0].values, (std::vector<double>{1, 2, 3, 4}));
    EXPECT_EQ(io::not_kept(read_ply_header(files::ply)), soup.not_kept);
    const auto kinds = io::kinds_in(read_ply_header(files::ply));
    ASSERT_EQ(kinds.vertices.size(), 1);
    EXPECT_EQ(kinds.vertices[0].name, soup.attributes.vertices[0].name);
    EXPECT_TRUE(kinds.vertices[0].values.empty() and kinds.faces.empty() and kinds.corners.empty());
}

TEST(read_ply, data_after_a_header_with_carriage_returns_may_begin_with_a_newline)
{
    auto file = files::binary_ply<std::uint8_t, std::uint8_t, std::int32_t>("uchar", "uchar", "int", false);
    const std::size_t data = file.find("end_header\n") + 11;
    file = replaced(file.substr(0, data), "\n", "\r") + "\n" + file.substr(data + 1); // x of vertex 0 is '\n'
    EXPECT_EQ(io::read_mesh(mesh_format::ply, file).points[0][0], 10);
}

TEST(read_ply, bytes_after_the_end)
{
    const auto file = files::binary_ply<float, std::uint8_t, std::int32_t>("float", "uchar", "int", false);
    EXPECT_EQ(refusal(mesh_format::ply, file + "!"), "the file goes on for 1 byte after its last element");
    EXPECT_EQ(refusal(mesh_format::ply, file.substr(0, file.size() - 1)), "the file ends where face 3: area should be");
}

TEST(read_stl, text_and_binary)
{
    expect_tetrahedron(mesh_format::stl, replaced(replaced(files::stl, "solid", "SOLID"), "vertex", "Vertex"));
    expect_tetrahedron(mesh_format::stl, "# exported by a program\n" + files::stl);
    std::string nameless = files::stl.substr(files::stl.find("facet"));
    expect_tetrahedron(mesh_format::stl, nameless);
    expect_tetrahedron(mesh_format::stl, nameless.substr(0, nameless.find("endsolid")));
    for (const std::string name : {"any words", "solid name"}) {
        EXPECT_TRUE(expect_tetrahedron(mesh_format::stl, files::binary_stl(name)).notes.empty());
        const auto soup = expect_tetrahedron(mesh_format::stl, files::binary_stl(name) + "more");
        EXPECT_EQ(soup.notes, std::vector<std::string>{"4 bytes after the last of 4 triangles are ignored"});
    }
    EXPECT_EQ(io::read_mesh(mesh_format::stl, files::stl + files::stl).not_kept,
              std::vector<std::string>{"the division into 2 solids"});
}

TEST(read_stl, cut_off)
{
    for (std::size_t size = 0; size < files::stl.size() - 10; ++size)
        EXPECT_NE(refusal(mesh_format::stl, files::stl.substr(0, size)), "read") << size;
    const std::size_t normal = files::stl.find("normal 0 0") + 10;
    EXPECT_EQ(refusal(mesh_format::stl, files::stl.substr(0, normal)),
              "the file ends where the normal of triangle 0 should be");
    const auto binary = files::binary_stl();
    for (std::size_t size = 0; size < binary.size(); ++size)
        EXPECT_NE(refusal(mesh_format::stl, binary.substr(0, size)), "read") << size;
}

} // namespace
