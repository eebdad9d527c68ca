// SPDX-License-Identifier: BSD-3-Clause
#include "files.hpp"

#include <kith/attributes_of.hpp>
#include <kith/io/format/held_attributes.hpp>
#include <kith/io/text/file_error.hpp>
#include <kith/read_mesh.hpp>
#include <kith/write_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
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
using numbers = std::vector<double>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr ply_number u8{1, false, false}, i32{4, false, true}, f64{8, true, true};

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

const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

/// Reads a tetrahedron in OFF whose face lines end with these words.
io::polygon_soup off_with(const names& of_faces)
{
    const names faces{"3 0 2 1", "3 0 1 3", "3 1 2 3", "3 0 3 2"};
    std::string text = "OFF\n4 4 0\n" + points;
    for (std::size_t f = 0; f < faces.size(); ++f)
        text += faces[f] + " " + of_faces[f] + "\n";
    return io::read_mesh(mesh_format::off, text);
}

/// Expects these values of red, green, blue and, if there are four, opacity on each element.
void expect_colors(const std::vector<io::attribute>& attributes, const std::vector<numbers>& colors,
                   const ply_number& type)
{
    ASSERT_EQ(attributes.size(), colors[0].size());
    for (std::size_t i = 0; i < attributes.size(); ++i) {
        EXPECT_EQ(attributes[i].name, io::color_names[i]);
        EXPECT_EQ(attributes[i].type.bytes, type.bytes);
        EXPECT_EQ(attributes[i].type.floating, type.floating);
        ASSERT_EQ(attributes[i].values.size(), colors.size());
        for (std::size_t element = 0; element < colors.size(); ++element) {
            const double found = attributes[i].values[element], right = colors[element][i];
            EXPECT_TRUE(std::isnan(right) ? std::isnan(found) : found == right)
                << i << " of element " << element << ": " << found << ", not " << right;
        }
    }
}

TEST(off_colors, are_of_their_own_kind_each)
{
    const auto mixed = off_with({"255 0 51", "0.0 1.0 0.0", "0.5 0.5 1.0", "0 0 255"});
    const std::vector<numbers> shares{{1, 0, 0.2}, {0, 1, 0}, {.5, .5, 1}, {0, 0, 1}};
    expect_colors(mixed.attributes.faces, shares, f64);
    EXPECT_NE(written(mesh_format::off, mixed)
                  .find("3  0 2 1  1.0 0.0 0.2 1.0\n3  0 1 3  0.0 1.0 0.0 1.0\n3  1 2 3  0.5 0.5 1.0 1.0\n"
                        "3  0 3 2  0.0 0.0 1.0 1.0\n"),
              std::string::npos);
    expect_colors(io::read_mesh(mesh_format::off, written(mesh_format::off, mixed)).attributes.faces,
                  {{1, 0, 0.2, 1}, {0, 1, 0, 1}, {.5, .5, 1, 1}, {0, 0, 1, 1}},
                  f64);
    // Zeros and ones are bytes if other values are bytes. They are fractions of 1 if they have a decimal point, or if
    // no value is a byte.
    expect_colors(off_with({"9 0 0", "1 0 1", "0 0 0", "255.0 0.0 0.0"}).attributes.faces,
                  {{9, 0, 0}, {1, 0, 1}, {0, 0, 0}, {255, 0, 0}},
                  u8);
    expect_colors(off_with({"1 0 0", "1 0 1", "0 0 0", "1e0 0 0"}).attributes.faces,
                  {{1, 0, 0}, {1, 0, 1}, {0, 0, 0}, {1, 0, 0}},
                  f64);
    expect_colors(off_with({"51 0 0", "1 0 1", "0 0 0", "0.0 0 1"}).attributes.faces,
                  {{.2, 0, 0}, {1 / 255., 0, 1 / 255.}, {0, 0, 0}, {0, 0, 1}},
                  f64);
    // The fourth channel may be of the other kind, and may be missing on other faces.
    expect_colors(off_with({"51 0 0 255", "0.5 0.5 0.5 0.25", "255 0 0 0.5", "0.5 0.0 0.0 51"}).attributes.faces,
                  {{.2, 0, 0, 1}, {.5, .5, .5, .25}, {1, 0, 0, .5}, {.5, 0, 0, .2}},
                  f64);
    expect_colors(off_with({"9 0 0 128", "7 8 9", "", "0 0 0 255"}).attributes.faces,
                  {{9, 0, 0, 128}, {7, 8, 9, 255}, {none, none, none, none}, {0, 0, 0, 255}},
                  u8);
    // Values above 1, brighter than white, are kept.
    expect_colors(off_with({"1.5 0.0 0.0", "", "", ""}).attributes.faces,
                  {{1.5, 0, 0}, {none, none, none}, {none, none, none}, {none, none, none}},
                  f64);
}

TEST(off_colors, of_vertices_are_of_their_own_kind_each)
{
    const auto soup = io::read_mesh(mesh_format::off,
                                    "COFF\n3 1 0\n0 0 0 255 0 51 255\n1 0 0 0.0 1.0 0.5 1.0\n0 1 0\n3 0 1 2\n");
    expect_colors(soup.attributes.vertices, {{1, 0, .2, 1}, {0, 1, .5, 1}, {none, none, none, none}}, f64);
}

TEST(off_keyword, may_have_its_letters_in_any_order)
{
    const std::string normal = " 0 0 1", color = " 255 0 9 255", texture = " 0.5 2";
    for (const auto& [word, numbers] :
         std::vector<std::pair<std::string, std::string>>{{"STCNOFF", normal + color + texture},
                                                          {"NCSTOFF", color + normal + texture},
                                                          {"CNSTOFF", normal + color + texture},
                                                          {"NSTCOFF", color + normal + texture},
                                                          {"CNOFF", color + normal},
                                                          {"CNOFF", normal + color},
                                                          {"NCOFF", color + normal},
                                                          {"NCOFF", normal + color},
                                                          {"NSTOFF", normal + texture},
                                                          {"STNOFF", normal + texture},
                                                          {"CSTOFF", color + texture},
                                                          {"STCOFF", color + texture},
                                                          {"NOFF", normal},
                                                          {"COFF", color},
                                                          {"cstoff", color + texture},
                                                          {"ncOFF", color + normal + "!"}}) {
        if (numbers.ends_with("!")) { // n is the number of coordinates there
            EXPECT_THROW((void)io::read_mesh(mesh_format::off, word + "\n1 0 0\n"), io::file_error);
            continue;
        }
        const auto soup = io::read_mesh(mesh_format::off,
                                        word + "\n3 1 0\n0 0 0" + numbers + "\n1 0 0" + numbers + "\n0 1 0" + numbers +
                                            "\n3 0 1 2\n");
        EXPECT_TRUE(soup.not_kept.empty()) << word;
        EXPECT_TRUE(soup.notes.empty()) << word;
        const auto expect = [&](const std::string& name, double value) {
            const io::attribute* const a = find(soup.attributes.vertices, name);
            ASSERT_NE(a, nullptr) << word << ": " << name;
            EXPECT_EQ(a->values, (std::vector<double>(3, value))) << word << ": " << name;
        };
        if (word.find_first_of("Nn") != word.npos) {
            expect("nx", 0);
            expect("nz", 1);
        }
        if (word.find_first_of("Cc") != word.npos) {
            expect("red", 255);
            expect("blue", 9);
            expect("alpha", 255);
        }
        if (word.find("ST") != word.npos or word.find("st") != word.npos) {
            expect("u", .5);
            expect("v", 2);
        }
    }
    EXPECT_EQ(io::read_mesh(mesh_format::off, "4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 1 0 1\n3 0 1 2\n").points[1][0], 1);
    EXPECT_EQ(io::read_mesh(mesh_format::off, "4nOFF\n3\n3 1 0\n0 0 0 1\n2 0 0 2\n0 1 0 1\n3 0 1 2\n").points[1][0], 1);
    EXPECT_EQ(io::read_mesh(mesh_format::off, "nOFF 3\n3 1 0\n0 0 0\n2 0 0\n0 1 0\n3 0 1 2\n").points[1][0], 2);
}

TEST(off_keyword, decides_where_the_numbers_do_not)
{
    // Each line may have a normal and a colour in either order, since all numbers lie between 0 and 1.
    const auto read = [](const std::string& word) {
        return io::read_mesh(mesh_format::off,
                             word + "\n3 1 0\n0 0 0 1 0 0 0 0 1\n1 0 0 1 0 0 0 0 1\n0 1 0 1 0 0 0 0 1\n3 0 1 2\n");
    };
    const auto geomview = read("CNOFF"), meshlab = read("NCOFF");
    EXPECT_EQ(find(geomview.attributes.vertices, "nx")->values, numbers(3, 1));
    EXPECT_EQ(find(geomview.attributes.vertices, "red")->values, numbers(3, 0));
    EXPECT_EQ(find(meshlab.attributes.vertices, "nx")->values, numbers(3, 0));
    EXPECT_EQ(find(meshlab.attributes.vertices, "red")->values, numbers(3, 1));
    EXPECT_EQ(geomview.notes,
              names{"the order of vertex normals and colours is ambiguous; normals are read first, "
                    "as Geomview writes them after CN"});
    EXPECT_EQ(meshlab.notes,
              names{"the order of vertex colours and normals is ambiguous; colours are read first, "
                    "as MeshLab writes them after NC"});
    // If everything stands in one line, the numbers decide.
    const auto line = io::read_mesh(mesh_format::off,
                                    "CNOFF 3 1 0 0 0 0 0 0 255 255 0 0 1 1 0 0 0 0 255 255 0 0 1 "
                                    "0 1 0 0 0 255 255 0 0 1 3 0 1 2");
    EXPECT_EQ(find(line.attributes.vertices, "nz")->values, numbers(3, 1));
    EXPECT_EQ(find(line.attributes.vertices, "blue")->values, numbers(3, 255));
}

TEST(written_as_zero, names_what_a_format_cannot_leave_out)
{
    auto soup = off_with({"9 0 0", "9 0 0 128", "", ""});
    soup.attributes.vertices = {{"nx", f64, {1, 0, 0, none}, {}},
                                {"ny", f64, {0, 1, 0, none}, {}},
                                {"nz", f64, {0, 0, 1, none}, {}},
                                {"id", i32, {1, 2, 3, none}, {}},
                                {"quality", f64, {1, 2, 3, none}, {}}};
    EXPECT_EQ(written_as_zero(mesh_format::ply, soup.attributes),
              (names{"the normals of 1 of 4 vertices",
                     "the property 'id' of 1 of 4 vertices",
                     "the colours of 2 of 4 faces"}));
    EXPECT_EQ(written_as_zero(mesh_format::off, soup.attributes), names{"the normals of 1 of 4 vertices"});
    EXPECT_EQ(written_as_zero(mesh_format::vtu, soup.attributes),
              (names{"the property 'id' of 1 of 4 vertices", "the colours of 2 of 4 faces"}));
    EXPECT_EQ(written_as_zero(mesh_format::obj, soup.attributes), names());
    EXPECT_EQ(written_as_zero(mesh_format::stl, soup.attributes), names());
    const std::string ply = written(mesh_format::ply, soup);
    EXPECT_NE(ply.find("\n0 0 1 0 0 0 0 nan\n"), ply.npos) << ply; // NaN is a number of 'quality'
    EXPECT_NE(ply.find("\n3 0 2 1 9 0 0 255\n3 0 1 3 9 0 0 128\n3 1 2 3 0 0 0 0\n3 0 3 2 0 0 0 0\n"), ply.npos) << ply;
    EXPECT_NE(written(mesh_format::off, soup).find("\n3  1 2 3\n3  0 3 2\n"), std::string::npos);

    // Colours at some vertices in OBJ are doubles.
    const auto obj = io::read_mesh(mesh_format::obj, "v 0 0 0 1 .5 .25\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(written_as_zero(mesh_format::ply, obj.attributes), names{"the colours of 2 of 3 vertices"});
    for (const bool binary : {false, true}) {
        const auto again = io::read_mesh(mesh_format::ply, written(mesh_format::ply, obj, binary));
        expect_colors(again.attributes.vertices, {{1, .5, .25}, {0, 0, 0}, {0, 0, 0}}, f64);
    }
    EXPECT_NE(written(mesh_format::obj, obj).find("\nv 0 0 0 1 0.5 0.25\nv 1 0 0\nv 0 1 0\n"), std::string::npos);
}

/// Makes a tetrahedron in binary STL with these two attribute bytes per triangle.
std::string stl_with(const std::vector<std::uint16_t>& bits, const std::string& header = "made by hand")
{
    std::string bytes = files::binary_stl(header);
    for (std::size_t f = 0; f < bits.size(); ++f) {
        bytes[84 + 50 * f + 48] = char(bits[f] & 255);
        bytes[84 + 50 * f + 49] = char(bits[f] >> 8);
    }
    return bytes;
}
std::vector<std::uint16_t> bits_of(const std::string& stl)
{
    std::vector<std::uint16_t> result;
    for (std::size_t at = 84 + 48; at < stl.size(); at += 50)
        result.push_back(std::uint16_t(std::uint8_t(stl[at]) | std::uint8_t(stl[at + 1]) << 8));
    return result;
}

TEST(stl_colors, of_viscam_and_solidview)
{
    const std::vector<std::uint16_t> bits{0x8000 | 31 << 10, 0x8000 | 16 << 5, 0x8000 | 1, 0x7fff};
    const auto soup = io::read_mesh(mesh_format::stl, stl_with(bits));
    EXPECT_TRUE(soup.not_kept.empty());
    expect_colors(soup.attributes.faces, {{255, 0, 0}, {0, 132, 0}, {0, 0, 8}, {none, none, none}}, u8);
    const std::string again = written(mesh_format::stl, soup, true);
    EXPECT_EQ(bits_of(again), (std::vector<std::uint16_t>{bits[0], bits[1], bits[2], 0}));
    EXPECT_EQ(not_held(mesh_format::stl, soup.attributes, true), names());
    EXPECT_EQ(not_held(mesh_format::stl, soup.attributes), names{"colours of faces"});
    // All 32 shades are read back.
    std::vector<std::uint16_t> shade(4);
    for (std::uint16_t s = 0; s < 32; ++s) {
        std::ranges::fill(shade, std::uint16_t(0x8000 | s << 10 | (31 - s) << 5 | s));
        EXPECT_EQ(bits_of(written(mesh_format::stl, io::read_mesh(mesh_format::stl, stl_with(shade)), true)), shade);
    }
}

TEST(stl_colors, of_materialise)
{
    std::string header = "COLOR=";
    for (const int byte : {10, 20, 30, 40})
        header += char(byte);
    const std::vector<std::uint16_t> bits{31, 16 << 5, 1 << 10, 0xffff};
    const auto soup = io::read_mesh(mesh_format::stl, stl_with(bits, header + ",MATERIAL=abcdefghijkl"));
    EXPECT_EQ(soup.not_kept, names{"the material of the part"});
    expect_colors(soup.attributes.faces, {{255, 0, 0, 255}, {0, 132, 0, 255}, {0, 0, 8, 255}, {10, 20, 30, 40}}, u8);
    EXPECT_EQ(not_held(mesh_format::stl, soup.attributes, true),
              (names{"the transparency of faces", "colours of faces beyond 32 shades of red, green and blue"}));
    EXPECT_EQ(bits_of(written(mesh_format::stl, soup, true)),
              (std::vector<std::uint16_t>{0x8000 | 31 << 10, 0x8000 | 16 << 5, 0x8001, 0x8000 | 1 << 10 | 2 << 5 | 4}));
    // Attribute bytes of zero mean the colour of the part. An opaque part needs no fourth channel.
    const auto part = io::read_mesh(mesh_format::stl, stl_with({0, 0, 0, 0}, header));
    expect_colors(part.attributes.faces, std::vector<numbers>(4, {10, 20, 30, 40}), u8);
    header.back() = char(255);
    const auto opaque = io::read_mesh(mesh_format::stl, stl_with({0x8000, 0, 31, 0x8000}, header));
    expect_colors(opaque.attributes.faces, {{10, 20, 30}, {0, 0, 0}, {255, 0, 0}, {10, 20, 30}}, u8);
}

TEST(stl_colors, are_named_where_the_bytes_are_none)
{
    for (const std::uint16_t constant : {0, 0x2020, 77})
        EXPECT_TRUE(
            io::read_mesh(mesh_format::stl, stl_with(std::vector<std::uint16_t>(4, constant))).attributes.empty());
    const auto others = io::read_mesh(mesh_format::stl, stl_with({1, 2, 3, 4}));
    EXPECT_TRUE(others.attributes.empty());
    EXPECT_EQ(others.not_kept, names{"the two attribute bytes of each triangle"});
}

TEST(stl_colors, from_other_formats)
{
    const auto soup = off_with({"255 0 0", "0.0 1.0 0.0", "", "0 0 255"});
    const std::string bytes = written(mesh_format::stl, soup, true);
    EXPECT_EQ(bits_of(bytes), (std::vector<std::uint16_t>{0xfc00, 0x83e0, 0, 0x801f}));
    expect_colors(io::read_mesh(mesh_format::stl, bytes).attributes.faces,
                  {{255, 0, 0}, {0, 255, 0}, {none, none, none}, {0, 0, 255}},
                  u8);
}

TEST(texture_numbers, are_not_called_texture_coordinates)
{
    const auto soup = io::read_mesh(mesh_format::ply,
                                    "ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment TextureFile b.png\n"
                                    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                                    "element face 2\nproperty list uchar int vertex_indices\n"
                                    "property list uchar float texcoord\nproperty int texnumber\nend_header\n"
                                    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 6 0 0 .5 0 .5 1 0\n3 0 2 3 6 0 0 1 1 0 1 1\n");
    EXPECT_EQ(not_held(mesh_format::obj, soup.attributes), (names{"texture numbers", "names of texture files"}));
    EXPECT_EQ(not_held(mesh_format::ply, soup.attributes), names());
    EXPECT_NE(written(mesh_format::obj, soup).find("\nvt 0.5 0\n"), std::string::npos);
}

} // namespace
