// SPDX-License-Identifier: BSD-3-Clause
#include "files.hpp"

#include <kith/io/text/file_error.hpp>
#include <kith/read_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string_view>

namespace {

using namespace kith;
using io::mesh_format;

/// Random numbers that are the same on every machine.
class dice {
public:
    explicit dice(unsigned seed) : engine_(seed) {}
    std::size_t below(std::size_t end) { return std::size_t(engine_() % std::max<std::size_t>(end, 1)); }

private:
    std::mt19937_64 engine_;
};

std::string damaged(std::string bytes, dice& dice)
{
    static const std::vector<std::string> words{"-1",
                                                "0",
                                                "4294967296",
                                                "99999999999999999999",
                                                "18446744073709551615",
                                                "1e999",
                                                "nan",
                                                "-inf",
                                                "1e-400",
                                                "\n",
                                                "\r",
                                                " ",
                                                "#",
                                                "\\\n",
                                                "\xef\xbb\xbf",
                                                "/",
                                                "//",
                                                "+",
                                                "-",
                                                ".",
                                                "\0\0",
                                                "list",
                                                "property",
                                                "endsolid",
                                                "facet",
                                                "t crease 2/1/0 0 9 1\n",
                                                "f -1 -2 -3\n",
                                                "element vertex 9000000000000000000\n"};
    for (std::size_t times = 1 + dice.below(4); times > 0; --times) {
        const std::size_t at = dice.below(bytes.size()), length = dice.below(12);
        switch (dice.below(7)) {
        case 0: bytes.resize(at); break;
        case 1: bytes.erase(at, length); break;
        case 2: bytes.insert(at, words[dice.below(words.size())]); break;
        case 3: bytes.replace(at, std::min(length, bytes.size() - at), words[dice.below(words.size())]); break;
        case 4: bytes.insert(at, bytes.substr(dice.below(bytes.size() + 1), 4 * length)); break;
        default:
            if (not bytes.empty())
                bytes[at] = char(dice.below(256));
        }
    }
    return bytes;
}

/// Reads bytes that end at the end of an allocation, so that the sanitizer notices reading beyond them. Returns true if
/// they were a mesh.
bool reads(mesh_format format, const std::string& bytes)
{
    const auto copy = std::make_unique<char[]>(bytes.size());
    std::ranges::copy(bytes, copy.get());
    io::polygon_soup soup;
    try {
        soup = io::read_mesh(format, {copy.get(), bytes.size()});
    } catch (const io::file_error& error) {
        EXPECT_NE(std::string_view(error.what()), "");
        return false;
    }
    EXPECT_LE(soup.points.size(), bytes.size());
    EXPECT_EQ(soup.faces.first.front(), 0);
    EXPECT_EQ(soup.faces.first.back(), soup.faces.vertices.size());
    EXPECT_TRUE(std::ranges::is_sorted(soup.faces.first));
    for (const std::size_t v : soup.faces.vertices)
        EXPECT_LT(v, soup.points.size());
    for (const auto& point : soup.points)
        for (const double x : point)
            EXPECT_TRUE(std::isfinite(x));
    const auto expect_values = [](const std::vector<io::attribute>& attributes, std::size_t elements) {
        for (const io::attribute& a : attributes) {
            EXPECT_EQ(a.values.size(), elements) << a.name;
            for (const double x : a.values) {
                EXPECT_TRUE(a.labels.empty() or (x >= 0 and x < double(a.labels.size())));
                EXPECT_TRUE(std::isnan(x) or io::as_stored(a.type, x) == x) << a.name;
            }
        }
    };
    expect_values(soup.attributes.vertices, soup.points.size());
    expect_values(soup.attributes.faces, soup.faces.size());
    expect_values(soup.attributes.corners, soup.faces.vertices.size());
    return true;
}

/// Damages files in some thousand ways. Expects that reading each file either throws an error with a message or returns
/// a consistent mesh.
void damage(mesh_format format, const std::vector<std::string>& files, unsigned seed)
{
    dice dice(seed);
    std::size_t meshes = 0;
    constexpr std::size_t all = 4000;
    for (std::size_t i = 0; i < all; ++i)
        meshes += reads(format, damaged(files[i % files.size()], dice));
    EXPECT_GT(meshes, all / 100);
    EXPECT_LT(meshes, all);
}

TEST(damaged_files, off)
{
    std::string colored = "COFF # colors\n4 4\n";
    colored +=
        "0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 0 0 0 1\n0 0 1 .5 .5 .5 1\n3 0 2 1 255 0 0\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    std::string one_line = files::off;
    std::ranges::replace(one_line, '\n', ' ');
    const std::string rich = "STCNOFF\n3 1\n0 0 0 0 0 1 255 0 9 255 0 1\n1 0 0 0 0 1 1 2 3 4 5 6\n0 1 0 0 0 1 .5 .5 .5 "
                             ".1 .2\n3 0 1 2 .1 .2 .3\n";
    damage(mesh_format::off, {files::off, colored, one_line, rich}, 1);
}

TEST(damaged_files, obj)
{
    damage(mesh_format::obj, {files::obj}, 2);
}

TEST(damaged_files, ply)
{
    damage(
        mesh_format::ply,
        {files::ply,
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty "
         "double u\nproperty char v\nelement face 1\nproperty list uchar float texcoord\nproperty list uchar int "
         "vertex_indices\nproperty ushort material\nend_header\n0 0 0 1e-5 -7\n1 0 0 inf 9\n0 1 0 nan 1\n6 0 0 1 0 0 "
         "1 3 0 1 2 65535\n",
         "ply\nformat ascii 1.0\ncomment word group 1 a\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nelement face 1\nproperty list "
         "uchar int vertex_indices\nproperty uchar group\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n9 0 1 2 3 -1 3 2 1 "
         "-1 3 0 1 3 1\n",
         files::binary_ply<float, std::uint8_t, std::int32_t>("float", "uchar", "int", false),
         files::binary_ply<double, std::int16_t, std::uint8_t>("double", "short", "uchar", true)},
        3);
}

TEST(damaged_files, stl)
{
    damage(mesh_format::stl, {files::stl, files::binary_stl(), files::binary_stl("solid name")}, 4);
}

TEST(damaged_files, vtu)
{
    const std::string head = "<VTKFile type=\"UnstructuredGrid\" header_type=\"UInt32\"><UnstructuredGrid><Piece "
                             "NumberOfPoints=\"3\" NumberOfCells=\"1\"><PointData Normals=\"n\"><DataArray "
                             "type=\"UInt8\" Name=\"red\">1 2 3</DataArray></PointData><Points>";
    const std::string tail = "</Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\">0 1 2</DataArray>"
                             "<DataArray type=\"Int8\" Name=\"offsets\">3</DataArray><DataArray type=\"UInt8\" "
                             "Name=\"types\">5</DataArray></Cells></Piece></UnstructuredGrid>";
    const std::string array = "<DataArray type=\"Float32\" NumberOfComponents=\"3\" ";
    std::string raw;
    files::append(raw, std::uint32_t(36));
    for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0})
        files::append(raw, x);
    const auto piece = [](const std::string& point_ids, const std::string& cell_id, const std::string& ghost) {
        return "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><PointData GlobalIds=\"id\"><DataArray type=\"Int64\" "
               "Name=\"id\">" +
               point_ids +
               "</DataArray><DataArray type=\"Int8\" Name=\"heat\">1 2 3</DataArray></PointData><CellData>"
               "<DataArray type=\"Int64\" Name=\"GlobalCellIds\">" +
               cell_id + "</DataArray><DataArray type=\"UInt8\" Name=\"vtkGhostType\">" + ghost +
               "</DataArray><DataArray type=\"Int8\" Name=\"group\">1</DataArray></CellData><Points><DataArray "
               "type=\"Float32\" NumberOfComponents=\"3\">0 0 0 0 0 0 0 0 0</DataArray></Points><Cells><DataArray "
               "type=\"Int64\" Name=\"connectivity\">0 1 2</DataArray><DataArray type=\"Int8\" Name=\"offsets\">3"
               "</DataArray><DataArray type=\"UInt8\" Name=\"types\">6</DataArray></Cells></Piece>";
    };
    const std::string pieces = "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><FieldData><DataArray "
                               "type=\"String\" Name=\"group\" format=\"ascii\">0 97 0</DataArray></FieldData>" +
                               piece("1 2 3", "5", "0") + piece("3 2 9", "4", "0") + piece("3 2 9", "4", "1") +
                               "</UnstructuredGrid></VTKFile>";
    // One compressed block of 36 zeros; its header has four words.
    const std::string zeros("\x78\x9c\x63\x60\x20\x0c\x00\x00\x24\x00\x01", 11);
    std::string block;
    for (const std::uint32_t word : {1, 36, 0, 11})
        files::append(block, word);
    const std::string poly_data =
        "<VTKFile type=\"PolyData\" compressor=\"vtkZLibDataCompressor\"><PolyData><Piece NumberOfPoints=\"3\" "
        "NumberOfLines=\"1\" NumberOfPolys=\"1\" NumberOfStrips=\"1\"><Points>" +
        array +
        "format=\"appended\" offset=\"0\"/></Points><Lines/><Polys><DataArray type=\"Int8\" Name=\"offsets\">3"
        "</DataArray><DataArray type=\"Int8\" Name=\"connectivity\">0 1 2</DataArray></Polys><Strips><DataArray "
        "type=\"Int8\" Name=\"offsets\">4</DataArray><DataArray type=\"Int8\" Name=\"connectivity\">0 1 2 0"
        "</DataArray></Strips></Piece></PolyData><AppendedData encoding=\"raw\">_" +
        block + zeros + "</AppendedData></VTKFile>";
    EXPECT_TRUE(reads(mesh_format::vtu, pieces));
    std::string marked_twice = pieces;
    marked_twice.insert(marked_twice.rfind("<DataArray type=\"Int8\" Name=\"group\""),
                        "<DataArray type=\"UInt8\" Name=\"vtkGhostType\">0</DataArray>");
    EXPECT_TRUE(reads(mesh_format::vtu, marked_twice));
    EXPECT_TRUE(reads(mesh_format::vtu, poly_data));
    damage(
        mesh_format::vtu,
        {pieces,
         poly_data,
         head + array + ">0 0 0 1 0 0 0 1e0 0</DataArray>" + tail + "</VTKFile>",
         head + array + "format=\"binary\">JAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAA==</DataArray>" + tail,
         head + array + "format=\"appended\" offset=\"0\"/>" + tail + "<AppendedData encoding=\"raw\">_" + raw},
        5);
}

} // namespace
