// SPDX-License-Identifier: BSD-3-Clause
#include "files.hpp"

#include <kith/attributes_of.hpp>
#include <kith/io/format/held_attributes.hpp>
#include <kith/io/text/file_error.hpp>
#include <kith/read_mesh.hpp>
#include <kith/write_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace kith;
using io::mesh_format;
using names = std::vector<std::string>;

constexpr double none = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
constexpr ply_number i8{1, false, true}, u8{1, false, false}, i16{2, false, true}, u16{2, false, false},
    i32{4, false, true}, u32{4, false, false}, f32{4, true, true}, f64{8, true, true};

std::string written(mesh_format format, const io::polygon_soup& soup, bool binary = false)
{
    const basic_mesh<> mesh = make_mesh(soup.points, soup.faces);
    const io::mesh_attributes attributes = attributes_of(soup, mesh);
    const io::written_mesh what{.mesh = mesh, .binary = binary, .attributes = &attributes};
    io::require_writable(format, what);
    std::ostringstream out;
    io::write_mesh(out, format, what);
    return out.str();
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

void expect_same(const std::vector<double>& a, const std::vector<double>& b, const std::string& name)
{
    ASSERT_EQ(a.size(), b.size()) << name;
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_TRUE(std::isnan(a[i]) ? std::isnan(b[i])
                                     : std::bit_cast<std::int64_t>(a[i]) == std::bit_cast<std::int64_t>(b[i]))
            << name << " " << i << ": " << a[i] << ", " << b[i];
}
void expect_same(const std::vector<io::attribute>& a, const std::vector<io::attribute>& b)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].name, b[i].name);
        EXPECT_EQ(a[i].type.bytes, b[i].type.bytes) << a[i].name;
        EXPECT_EQ(a[i].type.floating, b[i].type.floating) << a[i].name;
        EXPECT_EQ(a[i].type.is_signed, b[i].type.is_signed) << a[i].name;
        EXPECT_EQ(a[i].labels, b[i].labels);
        expect_same(a[i].values, b[i].values, a[i].name);
    }
}
void expect_same(const io::mesh_attributes& a, const io::mesh_attributes& b)
{
    expect_same(a.vertices, b.vertices);
    expect_same(a.faces, b.faces);
    expect_same(a.corners, b.corners);
    EXPECT_EQ(a.file_lines, b.file_lines);
}

/// Two quads in OBJ with a texture seam at vertex 2 and none at vertex 3, names, and colours at some vertices.
const std::string seam = "mtllib a.mtl b.mtl\nv 0 0 0 1 0.5 0.25\nv 1 0 0\nv 1 1 0 0 0 1\nv 0 1 0\nv 2 1 0\nv 2 2 0\n"
                         "vt 0 0\nvt 0.1 1e-3\nvt 1 1\nvt 0.25 1\nvt 0.5 0\nvt 7 -7\nvn 0 0 1\nvn 0 0.6 0.8\n"
                         "o thing\ng left side\nusemtl red\ns 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n"
                         "g\ns off\nf 3/5/2 5/6/2 4/-3/2\nusemtl blue\nf 3//1 6 5//1\n";

TEST(vtp_attributes, come_back_as_they_were_written)
{
    auto soup = io::read_mesh(mesh_format::off, files::off);
    const auto add = [](std::vector<io::attribute>& list,
                        const std::string& name,
                        const ply_number& type,
                        std::vector<double>
                            values) { list.push_back({name, type, std::move(values), {}}); };
    add(soup.attributes.vertices, "heat & \"cold\"", f64, {0.1, -2, none, 1e300});
    for (const auto name : {"red", "green", "blue"})
        add(soup.attributes.vertices, name, u8, {0, 1, 254, 255});
    for (const auto name : {"nx", "ny", "nz"})
        add(soup.attributes.vertices, name, f32, {0, 0.5, -1, 1});
    for (const auto name : {"u", "v"})
        add(soup.attributes.vertices, name, f64, {0.25, 0, 1, 7});
    add(soup.attributes.faces, "count", i32, {-7, 0, 8, 9});
    add(soup.attributes.faces, "material", u8, {0, 1, 2, 1});
    soup.attributes.faces.back().labels = {"", "red paint", "<wood>"};

    EXPECT_TRUE(not_held(mesh_format::vtp, soup.attributes).empty());
    const std::string bytes = written(mesh_format::vtp, soup);
    const auto again = io::read_mesh(mesh_format::vtp, bytes);
    EXPECT_EQ(again.points, soup.points);
    EXPECT_EQ(again.faces.vertices, io::read_mesh(mesh_format::off, written(mesh_format::off, soup)).faces.vertices);
    ASSERT_EQ(again.attributes.vertices.size(), soup.attributes.vertices.size());
    for (const auto* list : {&soup.attributes.vertices, &soup.attributes.faces})
        for (const io::attribute& a : *list) {
            const bool is_of_vertices = list == &soup.attributes.vertices;
            const auto& read = is_of_vertices ? again.attributes.vertices : again.attributes.faces;
            const std::string name = a.name.starts_with("heat") ? "heat_&_\"cold\"" : a.name; // names are words
            const auto found = std::ranges::find(read, name, &io::attribute::name);
            ASSERT_NE(found, read.end()) << name;
            expect_same(found->values, a.values, name);
            EXPECT_EQ(found->labels, a.labels);
            EXPECT_EQ(found->type.bytes, a.type.bytes) << name;
            EXPECT_EQ(found->type.floating, a.type.floating) << name;
        }
}

TEST(obj_attributes, are_read)
{
    const auto soup = io::read_mesh(mesh_format::obj, seam);
    EXPECT_TRUE(soup.not_kept.empty());
    const auto& corners = soup.attributes.corners;
    ASSERT_EQ(corners.size(), 5);
    EXPECT_EQ(corners[0].name, "u");
    expect_same(corners[0].values, {0, 0.1, 1, 0.25, 0.5, 7, 0.25, none, none, none}, "u");
    expect_same(corners[1].values, {0, 1e-3, 1, 1, 0, -7, 1, none, none, none}, "v");
    expect_same(corners[3].values, {0, 0, 0, 0, 0.6, 0.6, 0.6, 0, none, 0}, "ny");
    const auto& vertices = soup.attributes.vertices;
    ASSERT_EQ(vertices.size(), 3);
    expect_same(vertices[1].values, {0.5, none, 0, none, none, none}, "green");
    const auto& faces = soup.attributes.faces;
    ASSERT_EQ(faces.size(), 4);
    EXPECT_EQ(faces[0].name, "object");
    EXPECT_EQ(faces[1].labels, (names{"", "left side"}));
    expect_same(faces[1].values, {1, 0, 0}, "group");
    EXPECT_EQ(faces[2].labels, (names{"", "red", "blue"}));
    expect_same(faces[2].values, {1, 1, 2}, "material");
    expect_same(faces[3].values, {1, 0, 0}, "smoothing group");
    EXPECT_EQ(soup.attributes.file_lines, names{"mtllib a.mtl b.mtl"});
}

TEST(obj_attributes, may_have_a_comment_sign_in_their_names)
{
    const auto soup = io::read_mesh(mesh_format::obj,
                                    "mtllib a#1.mtl # one\nv 0 0 0\nv 1 0 0 0 0\nv 0 1 0#\nv 1 1 0\n"
                                    "usemtl Mat#1\nf 1 2 3#of all\nusemtl Mat#2 #\nf 2 4 3\n");
    EXPECT_EQ(soup.attributes.file_lines, names{"mtllib a#1.mtl"});
    ASSERT_EQ(soup.attributes.faces.size(), 1U);
    EXPECT_EQ(soup.attributes.faces[0].labels, (names{"", "Mat#1", "Mat#2"}));
    expect_same(soup.attributes.faces[0].values, {1, 2}, "material");
    EXPECT_EQ(soup.not_kept, names{"extra numbers after the coordinates of vertices"});
}

TEST(obj_attributes, are_written_as_they_are_read)
{
    const auto soup = io::read_mesh(mesh_format::obj, seam);
    const std::string text = written(mesh_format::obj, soup);
    const auto again = io::read_mesh(mesh_format::obj, text);
    expect_same(soup.attributes, again.attributes);
    EXPECT_EQ(written(mesh_format::obj, again), text);
    // Corners of a vertex with the same texture share a line; other corners do not.
    EXPECT_NE(text.find("\nvt 0 0\nvt 0.1 0.001\nvt 1 1\nvt 0.25 1\nvt 0.5 0\nvt 7 -7\nvn"), text.npos);
    EXPECT_NE(text.find("\no thing\ng left side\nusemtl red\ns 1\nf  1/1/1 2/2/2 3/3/3 4/4/4\n"
                        "g\ns off\nf  3/5/5 5/6/6 4/4/7\nusemtl blue\nf  3//3 6 5//8\n"),
              text.npos)
        << text;
}

/// Makes an OBJ fan. The first vertex has half as many texture values as there are triangles, each in two triangles.
std::string textured_fan(std::size_t triangles)
{
    const std::size_t textures = triangles / 2;
    std::string text = "v 0 0 0\n", faces;
    for (std::size_t i = 0; i <= triangles; ++i)
        text += "v " + std::to_string(i) + " 1 0\n";
    for (std::size_t i = 0; i < textures; ++i)
        text += "vt " + std::to_string(i * 7919 % textures) + " " + std::to_string(i % 5) + "\n";
    for (std::size_t i = 0; i < triangles; ++i)
        faces += "f 1/" + std::to_string(1 + i % textures) + " " + std::to_string(i + 3) + "/1 " +
                 std::to_string(i + 2) + "/1\n";
    return text + faces;
}

TEST(obj_attributes, many_at_one_vertex_share_their_lines)
{
    // The last size checks the time: it would be much longer if each line were compared with all lines of its vertex.
    for (const std::size_t triangles : {120U, 128U, 130U, 132U, 1000U, 200000U}) {
        const auto soup = io::read_mesh(mesh_format::obj, textured_fan(triangles));
        const std::string text = written(mesh_format::obj, soup);
        std::size_t lines = 0;
        for (std::size_t at = text.find("\nvt "); at != text.npos; at = text.find("\nvt ", at + 1))
            ++lines;
        EXPECT_EQ(lines, triangles / 2 + triangles + 1); // plus one line for each vertex on the boundary
        expect_same(soup.attributes, io::read_mesh(mesh_format::obj, text).attributes);
    }
}

TEST(obj_attributes, three_numbers_and_a_fourth_channel)
{
    const auto soup = io::read_mesh(mesh_format::obj,
                                    "v 0 0 0 1 1 1 0.5\nv 1 0 0 0 0 0\nv 0 1 0 1 1 1\n"
                                    "vt .5\nvt .5 1 2\nvt nan 1\nf 1/1 2/2 3/3\n");
    ASSERT_EQ(soup.attributes.corners.size(), 3);
    expect_same(soup.attributes.corners[1].values, {0, 1, 1}, "v");
    expect_same(soup.attributes.corners[2].values, {0, 2, 0}, "w");
    expect_same(soup.attributes.corners[0].values, {0.5, 0.5, none}, "u");
    ASSERT_EQ(soup.attributes.vertices.size(), 4);
    expect_same(soup.attributes.vertices[3].values, {0.5, 1, 1}, "alpha");
}

TEST(obj_attributes, indices_and_numbers_are_checked)
{
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_EQ(refusal(mesh_format::obj, points + "vt 0 0\nf 1/1 2/2 3/1\n"),
              "line 5: face 1: texture coordinate 2 does not exist, there are 1; correct the index");
    EXPECT_EQ(refusal(mesh_format::obj, points + "f 1/1 2/2 3/1\nvt 0 0\nvt 1 1\n"), "read");
    // The error names the first wrong face, whatever follows.
    EXPECT_EQ(
        refusal(mesh_format::obj, points + "vn 0 0 1\nf 1//1 2//1 3//1\n\nf 1//2 \\\n2//1 3//1\nf 1//9 2//1 3//1\n"),
        "line 7: face 2: normal 2 does not exist, there are 1; correct the index");
    EXPECT_EQ(refusal(mesh_format::obj, points + "f 1/1 2 3\nf 1/3 2 3\nf 1/7 2 3\nvt 0 0\nvt 1 1\n"),
              "line 5: face 2: texture coordinate 3 does not exist, there are 2; correct the index");
    EXPECT_EQ(refusal(mesh_format::obj, points + "f 1 2 3\nf 1 5 3\nf 1 9 3\nv 1 1 1\n"),
              "line 5: face 2: vertex 5 does not exist, there are 4; correct the index");
    EXPECT_EQ(refusal(mesh_format::obj, points + "vn 0 0 1\nf 1//-1 2//-2 3//1\n"),
              "line 5: face 1: normal -2 does not exist, there are 1 so far; correct the index");
    EXPECT_EQ(refusal(mesh_format::obj, points + "vt 0 0\nf 1/0 2/1 3/1\n"),
              "line 5: face 1: texture coordinate 0 does not exist, there are 1 so far; correct the index");
    EXPECT_EQ(refusal(mesh_format::obj, points + "vt\nf 1 2 3\n"), "line 4: texture coordinate 1 has no numbers");
    EXPECT_EQ(refusal(mesh_format::obj, points + "vt 0 x\nf 1 2 3\n"),
              "line 4: texture coordinate 1 should be a number, it is 'x'");
    EXPECT_EQ(refusal(mesh_format::obj, points + "f 1/1/1/1 2 3\n").substr(0, 8), "line 4: ");
    EXPECT_EQ(refusal(mesh_format::obj, points + "vt 0 0\nf 1/99999999999999999999 2 3\n").substr(0, 8), "line 5: ");
    // A name that ends in a backslash at the end of the file does not join the next line.
    auto soup = io::read_mesh(mesh_format::obj, points + "f 1 2 3\nmtllib a\\");
    EXPECT_EQ(soup.attributes.file_lines, names{"mtllib a"});
}

TEST(obj_attributes, that_are_not_in_the_file_are_noted)
{
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    const auto soup = io::read_mesh(mesh_format::obj,
                                    points + "vt 0 0\nvt 1 0\nf 1/1/1 2/2/2 3/1/3\nf 2/2/4 4/1/5 3/1/6\n");
    EXPECT_EQ(soup.notes, names{"faces refer to normals, and the file has none; the references are left out"});
    ASSERT_EQ(soup.attributes.corners.size(), 2);
    expect_same(soup.attributes.corners[0].values, {0, 1, 0, 1, 0, 0}, "u");
    EXPECT_TRUE(soup.not_kept.empty());
    const auto bare = io::read_mesh(mesh_format::obj, points + "f 1/1 2/2 3/3\n");
    EXPECT_EQ(bare.notes,
              names{"faces refer to texture coordinates, and the file has none; the references are left out"});
    EXPECT_TRUE(bare.attributes.empty());
}

TEST(ply_attributes, all_types_keep_their_bits)
{
    auto soup = io::read_mesh(mesh_format::off, files::off);
    const std::vector<io::attribute> all{{"c", i8, {-128, 127, 0, 1}, {}},
                                         {"red", u8, {0, 255, 128, 1}, {}},
                                         {"h", i16, {-32768, 32767, 0, 1}, {}},
                                         {"label", u16, {0, 65535, 1, 2}, {}},
                                         {"id", i32, {-2147483648., 2147483647, 0, 1}, {}},
                                         {"key", u32, {0, 4294967295, 1, 2}, {}},
                                         {"quality", f32, {double(0.1F), none, infinity, -0.}, {}},
                                         {"exact", f64, {0.1, -infinity, 5e-324, none}, {}}};
    soup.attributes.vertices = soup.attributes.faces = all;
    soup.attributes.corners = {{"u", f32, {0, 1, 2, 3, 4, 5, none, none, none, 9, 10, double(0.3F)}, {}},
                               {"v", f32, {1, 2, 3, 4, 5, 6, none, none, none, 0, 0, 0.5}, {}}};
    EXPECT_TRUE(not_held(mesh_format::ply, soup.attributes).empty());
    const auto in_mesh = attributes_of(soup, make_mesh(soup.points, soup.faces));
    EXPECT_EQ(in_mesh.corners[0].values[9], 10); // of the corner at vertex 0
    EXPECT_EQ(in_mesh.corners[0].values[11], 9);
    for (const bool binary : {false, true}) {
        const std::string bytes = written(mesh_format::ply, soup, binary);
        const auto again = io::read_mesh(mesh_format::ply, bytes);
        EXPECT_TRUE(again.not_kept.empty());
        expect_same(in_mesh, again.attributes);
        EXPECT_EQ(written(mesh_format::ply, again, binary), bytes);
    }
    EXPECT_NE(written(mesh_format::ply, soup)
                  .find("\nproperty list uchar float texcoord\nproperty char c\n"
                        "property uchar red\nproperty short h\nproperty ushort label\n"
                        "property int id\nproperty uint key\nproperty float quality\n"
                        "property double exact\nend_header\n"),
              std::string::npos);
}

TEST(ply_attributes, both_orders_of_bytes)
{
    for (const bool big_endian : {false, true}) {
        std::string bytes = "ply\nformat binary_" + std::string(big_endian ? "big" : "little") +
                            "_endian 1.0\nelement face 1\nproperty short material\nproperty list uchar int "
                            "vertex_indices\nproperty list uchar double texcoord\nelement vertex 3\nproperty float "
                            "q\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
        files::append(bytes, std::int16_t(-3), big_endian);
        files::append(bytes, std::uint8_t(3), big_endian);
        for (const std::int32_t v : {0, 1, 2})
            files::append(bytes, v, big_endian);
        files::append(bytes, std::uint8_t(6), big_endian);
        for (const double x : {0., 0.1, 0.2, 0.3, 0.4, 0.5})
            files::append(bytes, x, big_endian);
        for (const float v : {0.F, 1.F, 2.F})
            for (const float x : {v + 0.1F, v, v * v, 0.F})
                files::append(bytes, x, big_endian);
        const auto soup = io::read_mesh(mesh_format::ply, bytes);
        ASSERT_EQ(soup.attributes.faces.size(), 1);
        EXPECT_EQ(soup.attributes.faces[0].values, std::vector<double>{-3});
        ASSERT_EQ(soup.attributes.vertices.size(), 1);
        EXPECT_EQ(soup.attributes.vertices[0].values, (std::vector<double>{0.1F, 1.1F, 2.1F}));
        ASSERT_EQ(soup.attributes.corners.size(), 2);
        EXPECT_EQ(soup.attributes.corners[0].values, (std::vector<double>{0, 0.2, 0.4}));
        EXPECT_EQ(soup.attributes.corners[1].values, (std::vector<double>{0.1, 0.3, 0.5}));
    }
}

TEST(ply_attributes, lists_of_textures_fit_their_faces)
{
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
        "1\nproperty list uchar float texcoord\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 0 0 0 1 "
        "0\n";
    EXPECT_EQ(refusal(mesh_format::ply, header + "6 0 0 1 0 0 1 3 0 1 2\n"), "read");
    EXPECT_EQ(refusal(mesh_format::ply, header + "0 3 0 1 2\n"), "read");
    EXPECT_EQ(refusal(mesh_format::ply, header + "4 0 0 1 0 3 0 1 2\n"),
              "line 12: face 0 has 3 corners and 4 texture coordinates, 6 are needed");
}

TEST(ply_attributes, a_list_of_textures_of_two_types_is_one_of_doubles)
{
    io::polygon_soup soup{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .faces = {}};
    soup.faces.push_back(std::vector{0, 1, 2});
    soup.attributes.corners = {{"u", {4, true, true}, {.25, .5, .75}, {}}, {"v", {8, true, true}, {.1, .2, .3}, {}}};
    for (const bool binary : {false, true}) {
        const auto read = io::read_mesh(mesh_format::ply, written(mesh_format::ply, soup, binary));
        ASSERT_EQ(read.attributes.corners.size(), 2);
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_EQ(read.attributes.corners[i].values, soup.attributes.corners[i].values) << binary;
    }
}

TEST(ply_attributes, words_of_faces_are_comments_that_others_skip)
{
    const std::string obj = "mtllib my paint.mtl\nmtllib other.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\no\nf  1 2 3\n"
                            "o left side\ng a  b\nusemtl 7\ns 2\nf  2 4 3\n";
    const auto soup = io::read_mesh(mesh_format::obj, obj);
    const std::string bytes = written(mesh_format::ply, soup);
    EXPECT_EQ(bytes,
              "ply\nformat ascii 1.0\ncomment written by kith\ncomment mtllib my paint.mtl\ncomment mtllib other.mtl\n"
              "comment word object 1 left side\ncomment word group 1 a b\ncomment word material 1 7\n"
              "comment word smoothing_group 1 2\nelement vertex 4\nproperty double x\nproperty double y\n"
              "property double z\nelement face 2\nproperty list uchar int vertex_indices\nproperty int object\n"
              "property int group\nproperty int material\nproperty int smoothing_group\nend_header\n"
              "0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2 0 0 0 0\n3 1 3 2 1 1 1 1\n");
    for (const bool binary : {false, true}) {
        const auto again = io::read_mesh(mesh_format::ply, written(mesh_format::ply, soup, binary));
        expect_same(again.attributes.faces, soup.attributes.faces);
        EXPECT_EQ(written(mesh_format::obj, again), written(mesh_format::obj, soup));
    }

    // MeshLab names textures in this form; OBJ names them in its material files.
    std::string textured = bytes;
    textured.replace(textured.find("comment mtllib other.mtl"), 24, "comment TextureFile my skin.png");
    const auto with_picture = io::read_mesh(mesh_format::ply, textured);
    EXPECT_EQ(with_picture.attributes.file_lines, (names{"mtllib my paint.mtl", "TextureFile my skin.png"}));
    EXPECT_EQ(written(mesh_format::ply, with_picture), textured);
    EXPECT_EQ(not_held(mesh_format::ply, with_picture.attributes), names());
    EXPECT_EQ(not_held(mesh_format::obj, with_picture.attributes), names{"names of texture files"});
    EXPECT_EQ(written(mesh_format::obj, with_picture).find("skin"), std::string::npos);

    // The tag tells which step of a scheme comes next.
    const std::string tag(kith::odd_generation);
    auto odd = io::read_mesh(mesh_format::obj, obj + tag + "\n");
    EXPECT_EQ(odd.attributes.file_lines, (names{"mtllib my paint.mtl", "mtllib other.mtl", tag}));
    EXPECT_TRUE(odd.tags.unread.empty());
    const auto through = io::read_mesh(mesh_format::ply, written(mesh_format::ply, odd));
    EXPECT_EQ(through.attributes.file_lines, odd.attributes.file_lines);
    EXPECT_EQ(io::read_mesh(mesh_format::obj, written(mesh_format::obj, through)).attributes.file_lines,
              odd.attributes.file_lines);
    EXPECT_EQ(not_held(mesh_format::off, odd.attributes).back(),
              "the parity of sqrt3 steps (the next one splits the boundary)");
    EXPECT_TRUE(take_odd_generation(odd.attributes) and not take_odd_generation(odd.attributes));
    EXPECT_EQ(odd.attributes.file_lines, soup.attributes.file_lines);
    EXPECT_EQ(io::read_mesh(mesh_format::obj, obj + "t generation 1/0/0 2\n").tags.unread.size(), 1);

    // Other line ends are read. The property stays a number if the comments do not list all words in order. The same
    // holds if its type is a float, or if a value is no index of a word.
    const auto replaced = [&](const std::string& from, const std::string& to) {
        std::string text = bytes;
        for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
        return io::read_mesh(mesh_format::ply, text).attributes.faces;
    };
    expect_same(replaced("\n", "\r\n"), soup.attributes.faces);
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"word material 1 7", "word material 2 7"},
             {"comment word material 1 7\n", ""},
             {"word material 1", "word material"},
             {"word material 1 7\n", "word material 1 7\ncomment word material 3 8\n"},
             {"3 1 3 2 1 1 1 1", "3 1 3 2 1 1 -1 1"},
             {"int material", "float material"}}) {
        const auto faces = replaced(from, to);
        ASSERT_EQ(faces.size(), 4);
        EXPECT_EQ(faces[2].name, "material");
        EXPECT_TRUE(faces[2].labels.empty()) << to;
        EXPECT_EQ(faces[3].name, "smoothing group");
        EXPECT_EQ(faces[3].labels, (names{"", "2"}));
    }
}

TEST(off_attributes, normals_colours_and_textures)
{
    const std::string text = "STCNOFF\n3 2 0\n\n0 0 0 0 0 1  255 0 0 128 0.25 1\n1 0 0 0 1 0  0 7 0 255 0 0\n"
                             "0 1 0 1 0 0  1 2 3 4 0.5 0.5\n3  0 1 2  0.5 1.0 0.0 1.0\n3  0 2 1\n\n";
    const auto soup = io::read_mesh(mesh_format::off, text);
    EXPECT_TRUE(soup.not_kept.empty());
    const auto& vertices = soup.attributes.vertices;
    ASSERT_EQ(vertices.size(), 9);
    expect_same(vertices[2].values, {1, 0, 0}, "nz");
    EXPECT_EQ(vertices[4].name, "green");
    EXPECT_EQ(vertices[4].type.bytes, 1);
    expect_same(vertices[4].values, {0, 7, 2}, "green");
    expect_same(vertices[6].values, {128, 255, 4}, "alpha");
    expect_same(vertices[7].values, {0.25, 0, 0.5}, "u");
    ASSERT_EQ(soup.attributes.faces.size(), 4);
    EXPECT_TRUE(soup.attributes.faces[0].type.floating);
    expect_same(soup.attributes.faces[0].values, {0.5, none}, "red");
    EXPECT_EQ(written(mesh_format::off, soup), text);
}

TEST(off_attributes, colours_without_a_fourth_channel)
{
    const auto bytes = io::read_mesh(mesh_format::off, "COFF\n3 1\n0 0 0 255 0 9\n1 0 0\n0 1 0 1 1 1\n3 0 1 2 9 9 9\n");
    ASSERT_EQ(bytes.attributes.vertices.size(), 3);
    EXPECT_FALSE(bytes.attributes.vertices[0].type.floating);
    expect_same(bytes.attributes.vertices[0].values, {255, none, 1}, "red");
    EXPECT_EQ(written(mesh_format::off, bytes),
              "COFF\n3 1 0\n\n0 0 0  255 0 9 255\n1 0 0\n0 1 0  1 1 1 255\n3  0 1 2  9 9 9 255\n\n");
    const auto numbers = io::read_mesh(mesh_format::off, "COFF\n3 1\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 1 1 1\n3 0 1 2\n");
    EXPECT_TRUE(numbers.attributes.vertices[0].type.floating);
    EXPECT_EQ(written(mesh_format::off, numbers).substr(0, 36), "COFF\n3 1 0\n\n0 0 0  1.0 0.0 0.0 1.0\n1");
}

TEST(attributes, go_from_one_format_to_another)
{
    const auto obj = io::read_mesh(mesh_format::obj, seam);
    EXPECT_EQ(not_held(mesh_format::obj, obj.attributes), names());
    EXPECT_EQ(not_held(mesh_format::ply, obj.attributes), names{"normals"});
    EXPECT_EQ(not_held(mesh_format::off, obj.attributes),
              (names{"texture coordinates", "normals", "objects", "groups", "materials", "smoothing groups"}));
    const auto ply = io::read_mesh(mesh_format::ply, written(mesh_format::ply, obj));
    ASSERT_EQ(ply.attributes.corners.size(), 2);
    expect_same(ply.attributes.corners[0].values, {0, 0.1, 1, 0.25, 0.5, 7, 0.25, none, none, none}, "u");
    EXPECT_EQ(written_as_zero(mesh_format::ply, obj.attributes), names{"the colours of 4 of 6 vertices"});
    ASSERT_EQ(ply.attributes.vertices.size(), 3);
    expect_same(ply.attributes.vertices[0].values, {1, 0, 0, 0, 0, 0}, "red");
    expect_same(ply.attributes.vertices[1].values, {0.5, 0, 0, 0, 0, 0}, "green");
    expect_same(ply.attributes.faces, obj.attributes.faces);
    EXPECT_EQ(ply.attributes.file_lines, obj.attributes.file_lines);

    auto soup = io::read_mesh(mesh_format::off, files::off);
    soup.attributes.vertices = {{"diffuse_red", u8, {255, 0, 51, 102}, {}},
                                {"diffuse_green", u8, {0, 0, 0, 255}, {}},
                                {"diffuse_blue", u8, {255, 255, 255, 0}, {}},
                                {"texture_u", f32, {0, 0.5, 1, 0.25}, {}},
                                {"texture_v", f32, {0, 0, 1, 1}, {}},
                                {"quality", f32, {1, 2, 3, 4}, {}}};
    EXPECT_EQ(not_held(mesh_format::obj, soup.attributes), names{"the property 'quality' of vertices"});
    const auto in_obj = io::read_mesh(mesh_format::obj, written(mesh_format::obj, soup));
    expect_same(in_obj.attributes.vertices[0].values, {1, 0, 0.2, 0.4}, "red");
    expect_same(in_obj.attributes.corners[0].values, {0, 1, 0.5, 0, 0.5, 0.25, 0.5, 1, 0.25, 0, 0.25, 1}, "u");
    const auto in_off = io::read_mesh(mesh_format::off, written(mesh_format::off, soup));
    expect_same(in_off.attributes.vertices[0].values, {255, 0, 51, 102}, "red");
    expect_same(in_off.attributes.vertices[4].values, {0, 0.5, 1, 0.25}, "u");
    EXPECT_EQ(not_held(mesh_format::stl, soup.attributes),
              (names{"colours", "texture coordinates", "the property 'quality' of vertices"}));
    keep_held(mesh_format::obj, soup.attributes);
    EXPECT_EQ(soup.attributes.vertices.size(), 5);
}

TEST(attributes, what_is_not_finite_is_left_to_ply)
{
    auto soup = io::read_mesh(mesh_format::off, files::off);
    soup.attributes.vertices = {{"u", f64, {0, 1, infinity, 0}, {}}, {"v", f64, {0, 1, 2, 0}, {}}};
    EXPECT_THROW((void)written(mesh_format::obj, soup), io::file_error);
    EXPECT_THROW((void)written(mesh_format::off, soup), io::file_error);
    const auto again = io::read_mesh(mesh_format::ply, written(mesh_format::ply, soup));
    expect_same(again.attributes, soup.attributes);
}

TEST(attributes, are_rounded_into_their_types)
{
    EXPECT_EQ(io::as_stored(u8, 254.5), 255);
    EXPECT_EQ(io::as_stored(u8, 300), 255);
    EXPECT_EQ(io::as_stored(u8, -0.6), 0);
    EXPECT_EQ(io::as_stored(i8, -200), -128);
    EXPECT_EQ(io::as_stored(i16, 4e4), 32767);
    EXPECT_EQ(io::as_stored(u32, 5e9), 4294967295);
    EXPECT_EQ(io::as_stored(f32, 0.1), double(0.1F));
    EXPECT_EQ(io::as_stored(f64, 0.1), 0.1);
    EXPECT_TRUE(std::isnan(io::as_stored(u8, none)));
}

} // namespace
