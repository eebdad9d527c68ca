// SPDX-License-Identifier: BSD-3-Clause
#include "files.hpp"

#include <kith/io/text/file_error.hpp>
#include <kith/read_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <zlib.h>

namespace {

using namespace kith;
using io::mesh_format;

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return at == text.npos ? text : text.replace(at, from.size(), to);
}

io::polygon_soup read(const std::string& bytes)
{
    return io::read_mesh(mesh_format::vtu, bytes);
}

std::string refusal(const std::string& bytes)
{
    try {
        (void)read(bytes);
    } catch (const io::file_error& error) {
        return error.what();
    }
    return "read";
}

/// Expects the tetrahedron and its attributes, whatever the encoding of the numbers.
void expect_tetrahedron(const std::string& bytes)
{
    const auto soup = read(bytes);
    EXPECT_EQ(soup.not_kept, (std::vector<std::string>{"the field data 'words'"}));
    EXPECT_EQ(soup.points, files::corners);
    ASSERT_EQ(soup.faces.size(), 4);
    for (std::size_t f = 0; f < 4; ++f)
        EXPECT_EQ(std::vector<std::size_t>(soup.faces[f].begin(), soup.faces[f].end()), files::triangles[f]);
    ASSERT_EQ(soup.attributes.vertices.size(), 3);
    const auto& red = soup.attributes.vertices[0];
    EXPECT_EQ(red.name, "red");
    EXPECT_EQ(red.type.bytes, 1);
    EXPECT_FALSE(red.type.is_signed or red.type.floating);
    EXPECT_EQ(red.values, (std::vector<double>{0, 7, 255, 1}));
    EXPECT_EQ(soup.attributes.vertices[1].name, "u");
    EXPECT_EQ(soup.attributes.vertices[1].values, (std::vector<double>{0, .5, .25, 1}));
    EXPECT_EQ(soup.attributes.vertices[2].name, "v");
    EXPECT_EQ(soup.attributes.vertices[2].values, (std::vector<double>{1, 2, 3, 4}));
    EXPECT_EQ(soup.attributes.vertices[2].type.bytes, 4);
    ASSERT_EQ(soup.attributes.faces.size(), 1);
    EXPECT_EQ(soup.attributes.faces[0].name, "my_<id>");
    EXPECT_EQ(soup.attributes.faces[0].type.bytes, 8);
    EXPECT_EQ(soup.attributes.faces[0].values, (std::vector<double>{-1, 5000000000, 2, 3}));
}

/// Calls put(attributes, numbers) for each array in the order of the file.
template <class Put>
void put_arrays(const Put& put)
{
    put("type=\"Float64\" NumberOfComponents=\"3\"", std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    put("type=\"Int32\" Name=\"connectivity\"", std::vector<std::int32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3});
    put("type=\"UInt64\" Name=\"offsets\"", std::vector<std::uint64_t>{3, 6, 9, 12});
    put("type=\"UInt8\" Name=\"types\"", std::vector<std::uint8_t>{5, 5, 7, 5});
    put("type=\"UInt8\" Name=\"red\"", std::vector<std::uint8_t>{0, 7, 255, 1});
    put("type=\"Float32\" Name=\"where\" NumberOfComponents=\"2\"", std::vector<float>{0, 1, .5, 2, .25, 3, 1, 4});
    put("type=\"Int64\" Name='my &lt;id&gt;'", std::vector<std::int64_t>{-1, 5000000000, 2, 3});
}

std::string encoded(const std::string& bytes)
{
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            result += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
    }
    return result;
}

/// The encodings in which VTK writes its arrays.
enum class way { text, base64, base64_length_apart, appended_base64, appended_raw };

/// Returns the header and the compressed blocks as vtkZLibDataCompressor writes them. Word is the type of the numbers
/// in the header.
template <class Word>
std::pair<std::string, std::string> compressed(const std::string& bytes, std::size_t block_bytes)
{
    std::string head, blocks, lengths;
    Word count = 0;
    for (std::size_t at = 0; at < bytes.size(); at += block_bytes, ++count) {
        const std::string block = bytes.substr(at, block_bytes);
        std::vector<Bytef> out(compressBound(uLong(block.size())));
        uLongf size = uLongf(out.size());
        EXPECT_EQ(compress(out.data(), &size, reinterpret_cast<const Bytef*>(block.data()), uLong(block.size())), Z_OK);
        blocks.append(reinterpret_cast<const char*>(out.data()), size);
        files::append(lengths, Word(size));
    }
    for (const Word word : {count, Word(block_bytes), Word(bytes.size() % block_bytes)})
        files::append(head, word);
    return {head + lengths, blocks};
}

/// Returns a file of the tetrahedron. Arrays are compressed in blocks of `block_bytes`, or not at all for 0.
std::string file(way how, bool long_lengths = false, std::size_t block_bytes = 0)
{
    std::string arrays[7], data;
    std::size_t array = 0;
    put_arrays([&](const std::string& attributes, const auto& numbers) {
        std::string bytes, length, text;
        for (const auto x : numbers) {
            files::append(bytes, x);
            text += " " + std::to_string(x);
        }
        if (block_bytes != 0)
            std::tie(length, bytes) = long_lengths ? compressed<std::uint64_t>(bytes, block_bytes)
                                                   : compressed<std::uint32_t>(bytes, block_bytes);
        else
            long_lengths ? files::append(length, std::uint64_t(bytes.size()))
                         : files::append(length, std::uint32_t(bytes.size()));
        const bool is_appended = how == way::appended_base64 or how == way::appended_raw;
        const std::string format = how == way::text ? "ascii" : is_appended ? "appended" : "binary";
        std::string& declared = arrays[array++];
        declared = "<DataArray " + attributes + " format=\"" + format + "\"";
        if (is_appended) {
            declared += " offset=\"" + std::to_string(data.size()) + "\"/>\n";
            data += how == way::appended_raw ? length + bytes
                    : block_bytes != 0       ? encoded(length) + encoded(bytes)
                                             : encoded(length + bytes);
        } else {
            declared += ">\n" +
                        (how == way::text                                      ? text
                         : how == way::base64_length_apart or block_bytes != 0 ? encoded(length) + encoded(bytes)
                                                                               : " " + encoded(length + bytes)) +
                        "\n</DataArray>\n";
        }
    });
    return "<?xml version=\"1.0\"?>\n<!-- <Piece> -->\n<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"" +
           std::string(long_lengths ? " header_type=\"UInt64\"" : "") +
           (block_bytes != 0 ? " compressor=\"vtkZLibDataCompressor\"" : "") +
           ">\n<UnstructuredGrid>\n<FieldData>\n<DataArray type=\"String\" Name=\"words\" format=\"ascii\">1 0\n"
           "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"4\" NumberOfCells=\"4\">\n<PointData "
           "TCoords=\"where\">" +
           arrays[4] + arrays[5] + "</PointData><CellData>" + arrays[6] + "</CellData><Points>\n" + arrays[0] +
           "</Points><Cells>" + arrays[1] + arrays[2] + arrays[3] + "</Cells>\n</Piece>\n</UnstructuredGrid>\n" +
           (data.empty() ? ""
                         : "<AppendedData encoding=\"" + std::string(how == way::appended_raw ? "raw" : "base64") +
                               "\">\n _" + data + "\n</AppendedData>\n") +
           "</VTKFile>\n";
}

/// Returns a file with cells on four points as text; by default the cells are two triangles.
std::string cells(const std::string& offsets, const std::string& types, const std::string& vertices = "0 1 2 1 3 2")
{
    const std::size_t count = std::size_t(std::count(types.begin(), types.end(), ' ')) + 1;
    return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"" +
           std::to_string(count) +
           "\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0 1 1 0</DataArray>"
           "</Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\">" +
           vertices + "</DataArray><DataArray type=\"Int32\" Name=\"offsets\">" + offsets +
           "</DataArray><DataArray type=\"UInt8\" Name=\"types\">" + types +
           "</DataArray></Cells><CellData><DataArray type=\"Int8\" Name=\"x\">" +
           std::string("1 2 3 4").substr(0, 2 * count - 1) +
           "</DataArray></CellData></Piece></UnstructuredGrid></VTKFile>";
}

TEST(read_vtu, numbers_in_all_ways_of_writing_them)
{
    for (const way how : {way::text, way::base64, way::base64_length_apart, way::appended_base64, way::appended_raw})
        for (const bool long_lengths : {false, true})
            expect_tetrahedron(file(how, long_lengths));
}

TEST(read_vtu, numbers_that_are_compressed)
{
    for (const way how : {way::text, way::base64, way::appended_base64, way::appended_raw})
        for (const bool long_lengths : {false, true})
            for (const std::size_t block_bytes : {4, 32, 1 << 15})
                expect_tetrahedron(file(how, long_lengths, block_bytes));
}

TEST(read_vtu, empty_arrays_that_are_compressed)
{
    const auto soup = read(
        replaced(cells("3 6", "5 5"), "<VTKFile ", "<VTKFile compressor=\"vtkZLibDataCompressor\" "));
    EXPECT_EQ(soup.faces.size(), 2);
    // Header of zero blocks of 32768 bytes, the last one with 0 bytes, in words of four bytes.
    const std::string empty = "<DataArray type=\"Int64\" Name=\"none\" format=\"binary\">AAAAAACAAAAAAAAA</DataArray>";
    const std::string points =
        "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"binary\">AAAAAACAAAAAAAAA";
    const auto no_points = read(
        "<VTKFile type=\"PolyData\" compressor=\"vtkZLibDataCompressor\"><PolyData><Piece NumberOfPoints=\"0\">"
        "<Points>" +
        points + "</DataArray></Points><PointData>" + empty + "</PointData></Piece></PolyData></VTKFile>");
    EXPECT_EQ(no_points.points.size(), 0);
    ASSERT_EQ(no_points.attributes.vertices.size(), 1);
    EXPECT_EQ(no_points.attributes.vertices[0].name, "none");
}

TEST(read_vtu, refuses_compressed_numbers_that_are_damaged)
{
    const std::string plain = file(way::appended_raw, true, 32);
    const std::string compressor = "vtkZLibDataCompressor";
    for (const std::string other : {"vtkLZ4DataCompressor", "vtkLZMADataCompressor"})
        EXPECT_EQ(refusal(replaced(plain, compressor, other)),
                  "is compressed by " + other +
                      ", which is not read; write it with vtkZLibDataCompressor, or without a compressor");
    // A different number of points needs a different number of bytes.
    EXPECT_EQ(refusal(replaced(plain, "NumberOfPoints=\"4\"", "NumberOfPoints=\"3\"")),
              "the array '' should have 72 bytes, it has 96");
    EXPECT_EQ(refusal(replaced(plain, "NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"")),
              "the array '' should have 120 bytes, it has 96");
    EXPECT_EQ(refusal(replaced(plain, "NumberOfPoints=\"4\"", "NumberOfPoints=\"1\"")),
              "the array '' should have 24 bytes, it has more");
    EXPECT_EQ(refusal(plain.substr(0, plain.size() - 60)), "the file ends in the array 'my <id>'");
    // The header of the points: 3 blocks of 32 bytes.
    const std::size_t head = plain.find("\n _") + 3;
    const auto with = [&](std::size_t at, std::uint64_t number) {
        std::string bytes, result = plain;
        files::append(bytes, number);
        return refusal(result.replace(head + at, 8, bytes));
    };
    EXPECT_EQ(with(0, 2), "the array '' should have 96 bytes, it has 64");
    EXPECT_EQ(with(0, 4), "the array '' should have 96 bytes, it has 128");
    EXPECT_EQ(with(0, std::uint64_t(1) << 60), "the blocks of the array '' are not blocks of vtkZLibDataCompressor");
    EXPECT_EQ(with(16, 33), "the blocks of the array '' are not blocks of vtkZLibDataCompressor");
    EXPECT_EQ(with(16, 8), "the array '' should have 96 bytes, it has 72");
    EXPECT_EQ(with(8, 31), "the array '' should have 96 bytes, it has 93");
    EXPECT_EQ(with(24, std::uint64_t(1) << 60), "the file ends in the array ''");
    EXPECT_EQ(with(24, ~std::uint64_t(0)), "the file ends in the array ''");
    for (std::size_t block = 0; block < 3; ++block)
        EXPECT_EQ(with(24 + 8 * block, 0),
                  "block " + std::to_string(block) +
                      " of the array '' is damaged; write the "
                      "file again");
    std::string changed = plain;
    changed[head + 6 * 8 + 4] = char(changed[head + 6 * 8 + 4] ^ 1);
    EXPECT_EQ(refusal(changed), "block 0 of the array '' is damaged; write the file again");
}

TEST(read_vtu, refuses_arrays_of_another_length)
{
    for (const bool long_lengths : {false, true})
        for (const way how :
             {way::text, way::base64, way::base64_length_apart, way::appended_base64, way::appended_raw}) {
            const std::string whole = file(how, long_lengths);
            const std::string fewer = refusal(replaced(whole, "NumberOfPoints=\"4\"", "NumberOfPoints=\"3\""));
            const std::string more = refusal(replaced(whole, "NumberOfPoints=\"4\"", "NumberOfPoints=\"5\""));
            EXPECT_EQ(fewer,
                      how == way::text ? "the array '' should have 9 numbers, it has more"
                                       : "the array '' should have 72 bytes, it has 96");
            EXPECT_EQ(more,
                      how == way::text ? "the array '' should have 15 numbers, it has 12"
                                       : "the array '' should have 120 bytes, it has 96");
        }
    // The data of an array may be longer than its stated length, but not shorter.
    const std::string raw = file(way::appended_raw);
    std::string length, other;
    files::append(length, std::uint32_t(96));
    files::append(other, std::uint32_t(95));
    EXPECT_EQ(refusal(replaced(raw, "\n _" + length, "\n _" + other)), "the array '' should have 96 bytes, it has 95");
    for (std::size_t left = 0; left < 36; ++left) {
        const std::size_t begin = raw.find("\n _") + 3 + 4 + 96 + 4 + 48 + 4 + 32 + 4 + 4 + 4 + 4 + 4 + 32;
        EXPECT_EQ(refusal(raw.substr(0, begin + left)), "the file ends in the array 'my <id>'") << left;
    }
}

/// Returns an array of numbers as text.
std::string array(const std::string& type, const std::string& name, const std::string& numbers,
                  const std::string& more = "")
{
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" " + more + ">" + numbers + "</DataArray>\n";
}

std::string points(const std::string& numbers)
{
    return "<Points>" + array("Float64", "p", numbers, "NumberOfComponents=\"3\"") + "</Points>\n";
}

std::string piece(const std::string& points_there, std::size_t point_count, const std::string& vertices,
                  const std::string& offsets, const std::string& types, std::size_t cell_count,
                  const std::string& point_data, const std::string& cell_data)
{
    return "<Piece NumberOfPoints=\"" + std::to_string(point_count) + "\" NumberOfCells=\"" +
           std::to_string(cell_count) + "\">\n<PointData>" + point_data + "</PointData><CellData>" + cell_data +
           "</CellData>" + points(points_there) + "<Cells>" + array("Int64", "connectivity", vertices) +
           array("Int64", "offsets", offsets) + array("UInt8", "types", types) + "</Cells></Piece>\n";
}

std::string grid_of(const std::string& pieces)
{
    return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>\n" + pieces + "</UnstructuredGrid></VTKFile>\n";
}

/// Two pieces of a strip of three quads. The second piece has a face of the first piece as a ghost.
const std::string first_piece = piece("0 0 0 1 0 0 1 1 0 0 1 0", 4, "0 1 2 3", "4", "9", 1,
                                      array("Int64", "GlobalPointIds", "10 11 15 14") +
                                          array("Float32", "heat", "1 2 3 4"),
                                      array("Int64", "GlobalCellIds", "7") + array("Int16", "part", "-5"));
const std::string second_piece = piece(
    "3 1 0 2 1 0 2 0 0 3 0 0 1 0 0 1 1 0 0 0 0 0 1 0", 8, "4 2 1 5 2 3 0 1 6 4 5 7", "4 8 12", "9 9 9", 3,
    array("Int64", "GlobalPointIds", "17 16 12 13 11 15 10 14") + array("Float32", "heat", "8 7 5 6 2 3 1 4"),
    array("Int64", "GlobalCellIds", "3 9 7") + array("Int16", "part", "1 2 8") +
        array("UInt8", "vtkGhostType", "0 0 1"));

void expect_three_quads(const io::polygon_soup& soup)
{
    EXPECT_TRUE(soup.not_kept.empty());
    EXPECT_TRUE(soup.notes.empty());
    EXPECT_EQ(soup.points,
              (std::vector<std::array<double, 3>>{
                  {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}}));
    EXPECT_EQ(soup.faces.vertices, (std::vector<std::size_t>{1, 2, 6, 5, 0, 1, 5, 4, 2, 3, 7, 6}));
    EXPECT_EQ(soup.faces.first, (std::vector<std::size_t>{0, 4, 8, 12}));
    ASSERT_EQ(soup.attributes.vertices.size(), 1);
    EXPECT_EQ(soup.attributes.vertices[0].name, "heat");
    EXPECT_EQ(soup.attributes.vertices[0].values, (std::vector<double>{1, 2, 5, 6, 4, 3, 7, 8}));
    ASSERT_EQ(soup.attributes.faces.size(), 1);
    EXPECT_EQ(soup.attributes.faces[0].name, "part");
    EXPECT_EQ(soup.attributes.faces[0].type.bytes, 2);
    EXPECT_EQ(soup.attributes.faces[0].values, (std::vector<double>{1, -5, 2}));
}

TEST(read_vtu, several_pieces_that_share_vertices)
{
    expect_three_quads(read(grid_of(first_piece + second_piece)));
    expect_three_quads(read(grid_of(second_piece + first_piece)));
    // Pieces without elements need no arrays.
    expect_three_quads(
        read(grid_of("<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"></Piece>" + first_piece + second_piece)));

    EXPECT_EQ(refusal(grid_of(first_piece + replaced(second_piece, "1 0 0 1 1 0 0 0 0", "1 0 2 1 1 0 0 0 0"))),
              "the pieces have the vertex with the id 11 at several places; give different vertices different "
              "GlobalPointIds");
    EXPECT_EQ(refusal(grid_of(first_piece + replaced(second_piece, "3 9 7", "3 7 9"))),
              "the pieces have two cells with the id 7; give different cells different GlobalCellIds");
    const auto lacking = read(grid_of(first_piece + replaced(second_piece, "heat", "cold")));
    EXPECT_EQ(lacking.not_kept,
              (std::vector<std::string>{"the array 'heat', which some pieces lack",
                                        "the array 'cold', which some pieces lack"}));
    EXPECT_TRUE(lacking.attributes.vertices.empty());
    const auto wider = read(grid_of(first_piece + replaced(second_piece, "\"Int16\"", "\"Float32\"")));
    EXPECT_TRUE(wider.attributes.faces[0].type.floating);
    EXPECT_EQ(wider.attributes.faces[0].values, (std::vector<double>{1, -5, 2}));

    // A single piece keeps its ids as attributes, and its order.
    const auto alone = read(grid_of(first_piece));
    ASSERT_EQ(alone.attributes.vertices.size(), 2);
    EXPECT_EQ(alone.attributes.vertices[0].name, "GlobalPointIds");
    EXPECT_EQ(alone.points[2], (std::array<double, 3>{1, 1, 0}));
}

TEST(read_vtu, several_pieces_without_ids_stay_apart)
{
    const auto without = [](std::string text) {
        return replaced(replaced(text, "GlobalPointIds", "id"), "GlobalCellIds", "id");
    };
    const auto soup = read(grid_of(without(first_piece) + without(second_piece)));
    EXPECT_EQ(soup.points.size(), 12);
    EXPECT_EQ(soup.faces.vertices, (std::vector<std::size_t>{0, 1, 2, 3, 8, 6, 5, 9, 6, 7, 4, 5}));
    EXPECT_EQ(soup.attributes.faces[0].values, (std::vector<double>{7, 3, 9}));
    EXPECT_EQ(soup.notes,
              (std::vector<std::string>{"not all vertices of its pieces have GlobalPointIds; vertices of different "
                                        "pieces are not joined, even if they coincide"}));
}

/// PolyData with two lines, a pentagon, a triangle, and a strip of three triangles.
const std::string poly_data =
    "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"7\" NumberOfVerts=\"0\" NumberOfLines=\"2\" "
    "NumberOfStrips=\"1\" NumberOfPolys=\"2\">" +
    points("0 0 0 1 0 0 1 1 0 0 1 0 0 2 0 1 2 0 2 2 2") + "<CellData>" + array("UInt8", "color", "1 2 3 4 5") +
    "</CellData><PointData Normals=\"n\">" +
    array("Float32", "n", "0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 1 0", "NumberOfComponents=\"3\"") +
    "</PointData><Lines>" + array("Int32", "connectivity", "0 1 1 2") + array("Int32", "offsets", "2 4") +
    "</Lines><Strips>" + array("Int32", "connectivity", "0 1 3 2 4") + array("Int32", "offsets", "5") +
    "</Strips><Polys>" + array("Int32", "connectivity", "2 3 4 5 6 0 1 2") + array("Int32", "offsets", "5 8") +
    "</Polys></Piece></PolyData></VTKFile>";

TEST(read_vtu, poly_data_of_polygons_and_strips)
{
    const auto soup = read(poly_data);
    EXPECT_EQ(soup.not_kept, (std::vector<std::string>{"points and lines"}));
    EXPECT_EQ(soup.points.size(), 7);
    EXPECT_EQ(soup.points[6], (std::array<double, 3>{2, 2, 2}));
    EXPECT_EQ(soup.faces.first, (std::vector<std::size_t>{0, 5, 8, 11, 14, 17}));
    EXPECT_EQ(soup.faces.vertices, (std::vector<std::size_t>{2, 3, 4, 5, 6, 0, 1, 2, 0, 1, 3, 3, 1, 2, 3, 2, 4}));
    ASSERT_EQ(soup.attributes.faces.size(), 1);
    EXPECT_EQ(soup.attributes.faces[0].values, (std::vector<double>{3, 4, 5, 5, 5}));
    ASSERT_EQ(soup.attributes.vertices.size(), 3);
    EXPECT_EQ(soup.attributes.vertices[1].name, "ny");
    EXPECT_EQ(soup.attributes.vertices[1].values[6], 1);

    EXPECT_EQ(refusal(replaced(poly_data, "0 1 3 2 4", "0 1 3 2 7")),
              "cell 4 has a vertex that is not among the 7 vertices of the file");
    EXPECT_EQ(refusal(replaced(poly_data, "2 3 4 5 6 0 1 2", "2 3 4 5 6 0 1 -1")),
              "cell 3 has a vertex that is not among the 7 vertices of the file");
    EXPECT_EQ(refusal(replaced(poly_data, ">5 8<", ">6 8<")), "cell 3 has 2 corners, not what its type has");
    EXPECT_EQ(refusal(replaced(replaced(poly_data, "0 1 3 2 4", "0 1"), ">5<", ">2<")),
              "cell 4: a strip of 2 vertices makes no triangle; give it three or remove it");
    EXPECT_EQ(refusal(replaced(poly_data, "NumberOfPolys=\"2\"", "NumberOfPolys=\"3\"")),
              "the array 'offsets' should have 3 numbers, it has 2");
    EXPECT_EQ(refusal(replaced(poly_data, "NumberOfPolys=\"2\"", "NumberOfPolys=\"-2\"")),
              "line 1: NumberOfPolys should be a whole number, it is '-2'");
    EXPECT_EQ(read(cells("4", "6", "0 1 2 3")).faces.vertices, (std::vector<std::size_t>{0, 1, 2, 2, 1, 3}));
}

TEST(read_vtu, an_index_of_files)
{
    const std::filesystem::path here = std::filesystem::temp_directory_path() / "kith_read_vtu_test";
    std::filesystem::remove_all(here);
    std::filesystem::create_directories(here / "parts");
    const auto write = [&](const std::string& name, const std::string& text) {
        std::ofstream(here / name, std::ios::binary) << text;
    };
    const auto index = [](const std::string& sources) {
        return "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid>" + sources + "</PUnstructuredGrid></VTKFile>";
    };
    write("parts/0.vtu", grid_of(first_piece));
    write("parts/1.vtu", grid_of(second_piece));
    const std::string both = "<Piece Source=\"parts/0.vtu\"/>\n<Piece Source=\"parts/1.vtu\"/>";
    write("whole.pvtu", index(both));
    expect_three_quads(io::read_mesh_file((here / "whole.pvtu").string()));
    const std::string piece_with_words =
        "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><FieldData><DataArray type=\"String\" Name=\"group\" "
        "format=\"ascii\">0 97 0 98 0</DataArray></FieldData>";
    const auto with_words = [&](std::string text, const std::string& values) {
        return replaced(replaced(grid_of(replaced(text, "\"part\"", "\"group\"")),
                                 "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>",
                                 piece_with_words),
                        values,
                        values == ">-5<" ? ">2<" : ">0 1 2<");
    };
    write("parts/0.vtu", with_words(first_piece, ">-5<"));
    write("parts/1.vtu", with_words(second_piece, ">1 2 8<"));
    const auto soup = io::read_mesh_file((here / "whole.pvtu").string());
    EXPECT_TRUE(soup.not_kept.empty());
    ASSERT_EQ(soup.attributes.faces.size(), 1);
    EXPECT_EQ(soup.attributes.faces[0].labels, (std::vector<std::string>{"", "a", "b"}));
    EXPECT_EQ(soup.attributes.faces[0].values, (std::vector<double>{0, 2, 1}));

    const auto said = [&](const std::string& text) {
        write("whole.pvtu", text);
        try {
            (void)io::read_mesh_file((here / "whole.pvtu").string());
        } catch (const io::file_error& error) {
            const std::string path = here.string() + "/";
            std::string result = error.what();
            for (auto at = result.find(path); at != result.npos; at = result.find(path))
                result.erase(at, path.size());
            return result;
        }
        return std::string("read");
    };
    EXPECT_EQ(said(index("<Piece Source=\"parts/0.vtu\"/>\n<Piece Source=\"parts/0.vtu\"/>")),
              "whole.pvtu: names the piece parts/0.vtu twice; name it once");
    EXPECT_EQ(said(index("<Piece Source=\"parts/2.vtu\"/>")),
              "whole.pvtu: parts/2.vtu: cannot be opened: No such file or directory");
    EXPECT_EQ(said(index("<Piece/>")), "whole.pvtu: has a piece without a Source; name its file");
    EXPECT_EQ(said(index("<Piece Source=\"whole.pvtu\"/>")),
              "whole.pvtu: its piece whole.pvtu: is an index of pieces, not a piece");
    EXPECT_EQ(said(index("")), "whole.pvtu: has no piece with points and cells");
    write("parts/0.vtu", replaced(grid_of(first_piece), "\"types\"", "\"other\""));
    EXPECT_EQ(said(index(both)), "whole.pvtu: its piece parts/0.vtu: the cells have no array 'types'");
    EXPECT_EQ(refusal(index(both)), "has its pieces in files of their own; read it by its path");
    std::filesystem::remove_all(here);
}

TEST(read_vtu, gives_arrays_of_one_name_names_of_their_own)
{
    std::string arrays;
    for (int i = 0; i < 4; ++i)
        arrays += array("Int8", "a", "1 2");
    arrays += array("Int8", "a_2", "1 2") + array("Int8", "", "1 2") + array("Int8", "", "1 2");
    const auto soup = read(replaced(cells("3 6", "5 5"), "</CellData>", arrays + "</CellData>"));
    std::vector<std::string> names;
    for (const auto& a : soup.attributes.faces)
        names.push_back(a.name);
    EXPECT_EQ(names, (std::vector<std::string>{"x_", "a", "a_", "a_2", "a_3", "a_2_", "_", "_2"}));
}

TEST(read_vtu, arrays_behind_one_about_which_more_is_told)
{
    expect_tetrahedron(
        replaced(file(way::text),
                 " 0 7 255 1\n</DataArray>",
                 " 0 7 255 1\n<InformationKey name=\"L2_NORM_RANGE\" length=\"2\"><Value index=\"0\">1</Value>"
                 "</InformationKey>\n</DataArray>"));
}

TEST(read_vtu, text_whatever_is_said_of_what_is_none)
{
    const std::string other = "byte_order=\"BigEndian\" compressor=\"vtkZLibDataCompressor\"";
    expect_tetrahedron(replaced(file(way::text), "byte_order=\"LittleEndian\"", other));
    EXPECT_NE(refusal(replaced(file(way::base64), "byte_order=\"LittleEndian\"", other)).find("big-endian"),
              std::string::npos);
}

TEST(read_vtu, names_whole_numbers_that_a_double_does_not_hold)
{
    const auto with_ids = [](const std::string& type, const std::string& ids) {
        return read(replaced(
            replaced(cells("3 6", "5 5"), "Int8\" Name=\"x\"", type + "\" Name=\"id\""), ">1 2<", ">" + ids + "<"));
    };
    const std::vector<std::string> lost{"digits beyond 2^53 of the array 'id'"};
    const auto text = with_ids("Int64", "1 9007199254740993");
    EXPECT_EQ(text.not_kept, lost);
    EXPECT_EQ(text.attributes.faces[0].values, (std::vector<double>{1, 9007199254740992}));
    EXPECT_EQ(with_ids("Int64", "-9007199254740993 1").not_kept, lost);
    EXPECT_EQ(with_ids("Int64", "9223372036854775807 1").not_kept, lost);
    EXPECT_EQ(with_ids("UInt64", "18446744073709551615 1").not_kept, lost);
    for (const auto& [type, ids, values] : std::vector<std::tuple<std::string, std::string, std::vector<double>>>{
             {"Int64", "9007199254740992 -9007199254740992", {0x1p53, -0x1p53}},
             {"Int64", "-9223372036854775808 9223372036854774784", {-0x1p63, 0x1p63 - 1024}},
             {"UInt64", "9223372036854775808 1e3", {0x1p63, 1000}},
             {"Float64", "9007199254740993 1", {0x1p53, 1}}}) {
        const auto held = with_ids(type, ids);
        EXPECT_TRUE(held.not_kept.empty()) << ids;
        EXPECT_EQ(held.attributes.faces[0].values, values) << ids;
    }

    // Binary data lose these digits, too: one id becomes 2^53 + 1.
    std::string id, more;
    files::append(id, std::int64_t(5000000000));
    files::append(more, std::int64_t(9007199254740993));
    const auto soup = read(replaced(file(way::appended_raw), id, more));
    EXPECT_EQ(soup.not_kept.front(), "digits beyond 2^53 of the array 'my <id>'");
    EXPECT_EQ(soup.attributes.faces[0].values, (std::vector<double>{-1, 0x1p53, 2, 3}));
}

TEST(read_vtu, faces_of_all_kinds_and_what_lies_beside_them)
{
    const auto soup = read(cells("2 5 9", "3 5 8", "0 3 0 1 2 0 1 2 3"));
    ASSERT_EQ(soup.faces.size(), 2);
    EXPECT_EQ(soup.faces.vertices, (std::vector<std::size_t>{0, 1, 2, 0, 1, 3, 2}));
    EXPECT_EQ(soup.not_kept, (std::vector<std::string>{"points and lines"}));
    ASSERT_EQ(soup.attributes.faces.size(), 1);
    EXPECT_EQ(soup.attributes.faces[0].name, "x_"); // not a coordinate
    EXPECT_EQ(soup.attributes.faces[0].values, (std::vector<double>{2, 3}));
    EXPECT_EQ(read(cells("4", "9", "0 1 3 2")).faces.vertices, (std::vector<std::size_t>{0, 1, 3, 2}));
}

TEST(read_vtu, words_of_faces_as_field_data)
{
    const auto with_words = [](const std::string& name, const std::string& words, const std::string& more = "") {
        const std::string fields = "<UnstructuredGrid><FieldData><DataArray type=\"String\" Name=\"" + name +
                                   "\" format=\"ascii\">" + words + "</DataArray>" + more + "</FieldData>";
        return read(replaced(
            replaced(cells("3 6", "5 5"), "<UnstructuredGrid>", fields), "Name=\"x\"", "Name=\"" + name + "\""));
    };
    const auto named = with_words("smoothing group", "0 114 101 100 0\n -61 10 32 98 0");
    ASSERT_EQ(named.attributes.faces.size(), 1);
    EXPECT_EQ(named.attributes.faces[0].name, "smoothing group");
    EXPECT_EQ(named.attributes.faces[0].labels, (std::vector<std::string>{"", "red", "\xc3_ b"}));
    EXPECT_EQ(named.attributes.faces[0].values, (std::vector<double>{1, 2}));
    EXPECT_TRUE(named.not_kept.empty());

    for (const auto& [name, words] : std::vector<std::pair<std::string, std::string>>{
             {"material", "0 114 0"},         // too few
             {"material", "98 0 114 0 97 0"}, // none that says none
             {"region", "0 114 0 97 0"}}) {   // for which there is no word elsewhere
        const auto soup = with_words(name, words);
        EXPECT_TRUE(soup.attributes.faces[0].labels.empty());
        EXPECT_EQ(soup.not_kept, std::vector<std::string>{"the field data '" + name + "'"});
    }
    const auto other = with_words("group", "0 114 0 97 0", "<DataArray type=\"Float64\" Name=\"time\">0.5</DataArray>");
    EXPECT_EQ(other.attributes.faces[0].labels.size(), 3);
    EXPECT_EQ(other.not_kept, (std::vector<std::string>{"the field data 'time'"}));
}

TEST(read_vtu, tags_end_behind_what_is_quoted)
{
    const std::string text = file(way::text);
    for (const auto& [quoted, name] : std::vector<std::pair<std::string, std::string>>{
             {"\"a>b\"", "a>b"}, {"'a>b'", "a>b"}, {"\"a/>'b\"", "a/>'b"}, {"'a>\"b'", "a>\"b"}}) {
        const auto soup = read(replaced(text, "\"red\"", quoted));
        ASSERT_EQ(soup.attributes.vertices.size(), 3) << name;
        EXPECT_EQ(soup.attributes.vertices[0].name, name);
        EXPECT_EQ(soup.attributes.vertices[0].values, (std::vector<double>{0, 7, 255, 1}));
    }
    EXPECT_EQ(refusal(replaced(text, "\"ascii\">", "\"ascii>")), "an attribute of the element 'DataArray' has no end");
}

TEST(read_vtu, refuses_what_it_does_not_read_and_says_what_to_do)
{
    const std::string text = file(way::text), raw = file(way::appended_raw);
    EXPECT_EQ(refusal(replaced(text, "type=\"UnstructuredGrid\"", "type=\"ImageData\"")),
              "holds ImageData, which is not read; save it as an UnstructuredGrid (.vtu) or as PolyData (.vtp)");
    EXPECT_EQ(refusal(replaced(raw, "LittleEndian", "BigEndian")),
              "its numbers are big-endian, which is not read; write it on another machine, or as text");
    EXPECT_EQ(refusal(replaced(text, "NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"")),
              "the array '' should have 15 numbers, it has 12");
    EXPECT_EQ(refusal(replaced(text, "NumberOfPoints=\"4\"", "NumberOfPoints=\"18446744073709551615\"")),
              "the array '' should have more numbers than a file can have");
    EXPECT_EQ(refusal(replaced(raw, "NumberOfPoints=\"4\"", "NumberOfPoints=\"1000000000000\"")),
              "the array '' should have 24000000000000 bytes, it has 96");
    EXPECT_EQ(refusal(raw.substr(0, raw.size() - 60)), "the file ends in the array 'my <id>'");
    EXPECT_EQ(refusal(replaced(text, "<Points>", "<Nothing>")), "has no points");
    EXPECT_EQ(refusal(replaced(text, "\"types\"", "\"other\"")), "the cells have no array 'types'");
    EXPECT_EQ(refusal(replaced(text, " 255", " 256")), "a number of the array 'red' does not fit its type");
    EXPECT_EQ(refusal(replaced(text, " 255", " 25.5")), "number 2 of the array 'red' should be whole");
    EXPECT_EQ(refusal(replaced(text, "type=\"UInt8\" Name=\"red\"", "type=\"Text\" Name=\"red\"")),
              "the array 'red' is of the type 'Text', which is not read");
    EXPECT_EQ(refusal(replaced(text, "0.000000 1.000000\n", "0.000000 nan\n")),
              "vertex 3 has a coordinate that is not a finite number; give finite coordinates");
    EXPECT_EQ(refusal("<VTKFile"), "the file ends inside of an element, which begins with '<VTKFile'");
    EXPECT_EQ(refusal("OFF 3"), "a file of VTK begins with the element VTKFile, which is missing");
    EXPECT_EQ(refusal(cells("3 6", "5 5", "0 1 2 1 4 2")),
              "cell 1 has a vertex that is not among the 4 vertices of the file");
    EXPECT_EQ(refusal(cells("3 6", "5 5", "0 1 2 1 -1 2")),
              "cell 1 has a vertex that is not among the 4 vertices of the file");
    EXPECT_EQ(refusal(cells("6 3", "5 5")), "the offsets of the cells do not increase");
    EXPECT_EQ(refusal(cells("3 6", "5 9")), "cell 1 has 3 corners, not what its type has");
    EXPECT_EQ(refusal(cells("2 6", "7 5")), "cell 0 has 2 corners, not what its type has");
    EXPECT_EQ(refusal(cells("3 6", "5 10")), "cell 1 is of type 10 of VTK, which is not a face; save only the surface");
}

} // namespace
