// SPDX-License-Identifier: BSD-3-Clause
#include "files.hpp"

#include <kith/read_mesh.hpp>
#include <kith/text/file_error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

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

/// The tetrahedron and its attributes, however the numbers are written.
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

/// The numbers of the arrays in the order of the file.
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

/// One of the ways in which VTK writes its arrays.
enum class way { text, base64, base64_length_apart, appended_base64, appended_raw };

std::string file(way how, bool long_lengths = false)
{
    std::string arrays[7], data;
    std::size_t array = 0;
    put_arrays([&](const std::string& attributes, const auto& numbers) {
        std::string bytes, length, text;
        for (const auto x : numbers) {
            files::append(bytes, x);
            text += " " + std::to_string(x);
        }
        long_lengths ? files::append(length, std::uint64_t(bytes.size()))
                     : files::append(length, std::uint32_t(bytes.size()));
        const bool is_appended = how == way::appended_base64 or how == way::appended_raw;
        const std::string format = how == way::text ? "ascii" : is_appended ? "appended" : "binary";
        std::string& declared = arrays[array++];
        declared = "<DataArray " + attributes + " format=\"" + format + "\"";
        if (is_appended) {
            declared += " offset=\"" + std::to_string(data.size()) + "\"/>\n";
            data += how == way::appended_raw ? length + bytes : encoded(length + bytes);
        } else {
            declared += ">\n" +
                        (how == way::text                  ? text
                         : how == way::base64_length_apart ? encoded(length) + encoded(bytes)
                                                           : " " + encoded(length + bytes)) +
                        "\n</DataArray>\n";
        }
    });
    return "<?xml version=\"1.0\"?>\n<!-- <Piece> -->\n<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"" +
           std::string(long_lengths ? " header_type=\"UInt64\"" : "") +
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

/// Two triangles as text.
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

    // In binary, too: the last bytes of the last array are those of 2^53 + 1.
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
    EXPECT_EQ(refusal(replaced(text, "type=\"UnstructuredGrid\"", "type=\"PolyData\"")),
              "holds PolyData, not an UnstructuredGrid; save it as one");
    EXPECT_EQ(refusal(replaced(raw, "LittleEndian\"", "LittleEndian\" compressor=\"vtkZLibDataCompressor\"")),
              "is compressed, which is not read; write it without a compressor, or as text");
    EXPECT_EQ(refusal(replaced(raw, "LittleEndian", "BigEndian")),
              "its numbers are big-endian, which is not read; write it on another machine, or as text");
    EXPECT_EQ(refusal(replaced(text, "</Piece>", "</Piece><Piece NumberOfPoints=\"0\" NumberOfCells=\"0\">")),
              "has several pieces; save it as one");
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
    EXPECT_EQ(refusal(replaced(text, "0.000000 1.000000\n", "0.000000 nan\n")), "vertex 3 has no finite place");
    EXPECT_EQ(refusal("<VTKFile"), "the file ends inside of an element, which begins with '<VTKFile'");
    EXPECT_EQ(refusal("OFF 3"), "a file of VTK begins with the element VTKFile, which is not there");
    EXPECT_EQ(refusal(cells("3 6", "5 5", "0 1 2 1 4 2")),
              "cell 1 has a vertex that is not among the 4 vertices of the file");
    EXPECT_EQ(refusal(cells("3 6", "5 5", "0 1 2 1 -1 2")),
              "cell 1 has a vertex that is not among the 4 vertices of the file");
    EXPECT_EQ(refusal(cells("6 3", "5 5")), "the offsets of the cells do not increase");
    EXPECT_EQ(refusal(cells("3 6", "5 9")), "cell 1 has 3 corners, not what its type has");
    EXPECT_EQ(refusal(cells("2 6", "7 5")), "cell 0 has 2 corners, not what its type has");
    EXPECT_EQ(refusal(cells("3 6", "5 10")), "cell 1 is of type 10 of VTK, which is no face; take the surface alone");
}

} // namespace
