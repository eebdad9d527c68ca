// SPDX-License-Identifier: BSD-3-Clause
#include "files.hpp"

#include <kith/read_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Every reader takes time in proportion to the file: twice as many elements take about twice as long.

namespace {

using namespace kith;
using io::mesh_format;

/// A function that makes a file with n elements of some kind.
using file_of = std::function<std::string(std::size_t)>;

struct growing_file {
    std::string what;
    mesh_format format;
    std::size_t n; ///< this number takes some milliseconds
    file_of file;
};

std::string text(std::size_t number)
{
    return std::to_string(number);
}

/// Returns the concatenation of part(i) for all i below n.
template <class Part>
std::string joined(std::size_t n, const Part& part)
{
    std::string result;
    for (std::size_t i = 0; i < n; ++i)
        result += part(i);
    return result;
}
std::string repeated(std::size_t n, const std::string& part)
{
    return joined(n, [&](std::size_t) { return part; });
}
std::string numbers(std::size_t n)
{
    return joined(n, [](std::size_t i) { return " " + text(i); });
}

const std::string off_corners = "0 0 0\n1 0 0\n0 1 0\n";
const std::string obj_corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string off(const std::string& begin, std::size_t vertices, const std::string& rest)
{
    return begin + "OFF\n" + text(vertices) + " " + rest;
}

std::string ply(const std::string& header, const std::string& data, bool binary = false)
{
    return std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") + " 1.0\n" + header +
           "end_header\n" + data;
}
std::string ply_vertices(std::size_t n, const std::string& more = "")
{
    return "element vertex " + text(n) + "\n" + more + "property double x\nproperty double y\nproperty double z\n";
}
std::string ply_faces(std::size_t n, const std::string& more = "")
{
    return "element face " + text(n) + "\nproperty list uint uint vertex_indices\n" + more;
}
std::string ply_properties(std::size_t n)
{
    return joined(n, [](std::size_t i) { return "property uchar p" + text(i) + "\n"; });
}

const std::string facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

std::string array(const std::string& type, const std::string& name, const std::string& values,
                  std::size_t components = 1)
{
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + text(components) + "\">" +
           values + "</DataArray>\n";
}
/// Returns a piece of triangles at the first three points, or one polygon of all points.
std::string vtu_piece(std::size_t points, std::size_t faces, const std::string& data, bool is_one_polygon = false)
{
    return "<Piece NumberOfPoints=\"" + text(points) + "\" NumberOfCells=\"" + text(faces) + "\"><Points>" +
           array("Float64", "", repeated(points, "0 1 2 "), 3) + "</Points><Cells>" +
           array("Int64", "connectivity", is_one_polygon ? numbers(points) : repeated(faces, "0 1 2 ")) +
           array("Int64",
                 "offsets",
                 is_one_polygon ? text(points) : joined(faces, [](std::size_t i) { return " " + text(3 * i + 3); })) +
           array("UInt8", "types", repeated(faces, "7 ")) + "</Cells>" + data + "</Piece>";
}
std::string vtu(const std::string& pieces)
{
    return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>" + pieces + "</UnstructuredGrid></VTKFile>";
}
std::string vtp(const std::string& sections, const std::string& counts, std::size_t points)
{
    return "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"" + text(points) + "\" " + counts +
           "><Points>" + array("Float64", "", repeated(points, "0 1 2 "), 3) + "</Points>" + sections +
           "</Piece></PolyData></VTKFile>";
}

std::vector<growing_file> files_of_off()
{
    const auto f = mesh_format::off;
    return {
        {"vertices", f, 20000, [](auto n) { return off("", n, "1 0\n" + repeated(n, "0 0 0\n") + "3 0 1 2\n"); }},
        {"vertices with attributes",
         f,
         10000,
         [](auto n) { return off("STCN", n, "1 0\n" + repeated(n, "0 0 0 0 0 1 .1 .2 .3 .4 .5 .6\n") + "3 0 1 2\n"); }},
        {"faces",
         f,
         20000,
         [](auto n) { return off("", 3, text(n) + " 0\n" + off_corners + repeated(n, "3 0 1 2\n")); }},
        {"faces with colours",
         f,
         20000,
         [](auto n) { return off("", 3, text(n) + " 0\n" + off_corners + repeated(n, "3 0 1 2 9 8 7\n")); }},
        {"corners of a face",
         f,
         60000,
         [](auto n) { return off("", 3, "1 0\n" + off_corners + text(n) + repeated(n, " 1") + "\n"); }},
        {"letters of a comment",
         f,
         1000000,
         [](auto n) { return off("#" + repeated(n, "x") + "\n", 3, "1 0\n" + off_corners + "3 0 1 2\n"); }},
        {"comments",
         f,
         100000,
         [](auto n) { return off(repeated(n, "# x\n"), 3, "1 0\n" + off_corners + "3 0 1 2\n"); }},
        {"blanks in a line",
         f,
         1000000,
         [](auto n) { return off("", 3, "1 0\n" + off_corners + repeated(n, " ") + "3 0 1 2\n"); }},
        {"vertices in one line", f, 20000, [](auto n) {
             return off("", n, "1 0 " + repeated(n, "0 0 0 ") + "3 0 1 2\n");
         }}};
}

std::vector<growing_file> files_of_obj()
{
    const auto f = mesh_format::obj;
    const std::string face = "f 1 2 3\n", begin = obj_corners;
    const auto behind = [=](const std::string& part) {
        return [=](std::size_t n) { return begin + repeated(n, part) + face; };
    };
    const auto statements = [=](const std::string& word, const std::string& last) {
        return [=](std::size_t n) {
            return begin + joined(n, [&](std::size_t i) { return word + " " + text(i) + "\n" + last; }) + face;
        };
    };
    return {{"vertices", f, 20000, behind("v 1 2 3\n")},
            {"vertices with colours", f, 20000, behind("v 1 2 3 .1 .2 .3\n")},
            {"texture coordinates", f, 20000, behind("vt 1 2\n")},
            {"normals", f, 20000, behind("vn 1 2 3\n")},
            {"faces", f, 20000, behind(face)},
            {"faces with references",
             f,
             20000,
             [=](auto n) { return begin + "vt 0 1\nvn 0 0 1\n" + repeated(n, "f 1/1/1 2/1/1 3/1/1\n"); }},
            {"references to what follows",
             f,
             10000,
             [=](auto n) {
                 return joined(n, [](std::size_t i) { return "f 1 2 " + text(i + 3) + "/" + text(i + 1) + "\n"; }) +
                        repeated(n, "v 0 0 1\nvt 0 0\n") + begin;
             }},
            {"corners of a face",
             f,
             60000,
             [=](auto n) { return begin + "f" + repeated(n, " 1/1/1") + "\nvt 0 1\nvn 0 0 1\n"; }},
            {"continued lines", f, 60000, [=](auto n) { return begin + "f" + repeated(n, " 1 \\\n") + " 2 3\n"; }},
            {"groups", f, 10000, statements("g", face)},
            {"materials", f, 10000, statements("usemtl", face)},
            {"objects without faces", f, 20000, statements("o", "")},
            {"smoothing groups", f, 10000, statements("s", face)},
            {"libraries", f, 20000, statements("mtllib", "")},
            {"other statements", f, 20000, statements("l 1", "")},
            {"creases", f, 10000, statements("t crease 2/1/0 0 1", "")},
            {"unknown tags", f, 10000, [=](auto n) { return begin + face + repeated(n, "t other 1/0/1 3 word\n"); }},
            {"letters of a name", f, 1000000, [=](auto n) { return begin + "g " + repeated(n, "x") + "\n" + face; }},
            {"words of a name", f, 100000, [=](auto n) { return begin + "g" + repeated(n, " x") + "\n" + face; }},
            {"letters of a comment", f, 1000000, [=](auto n) { return "#" + repeated(n, "x") + "\n" + begin + face; }}};
}

std::vector<growing_file> files_of_ply()
{
    const auto f = mesh_format::ply;
    const std::string triangle = "3 0 1 2\n";
    return {
        {"vertices",
         f,
         20000,
         [=](auto n) { return ply(ply_vertices(n) + ply_faces(1), repeated(n, "0 0 0\n") + triangle); }},
        {"faces",
         f,
         20000,
         [=](auto n) { return ply(ply_vertices(3) + ply_faces(n), off_corners + repeated(n, triangle)); }},
        {"corners of a face",
         f,
         60000,
         [](auto n) { return ply(ply_vertices(3) + ply_faces(1), off_corners + text(n) + repeated(n, " 1")); }},
        {"texture coordinates of a face",
         f,
         60000,
         [](auto n) {
             return ply(ply_vertices(3) + ply_faces(1, "property list uint float texcoord\n"),
                        off_corners + text(n) + repeated(n, " 1") + " " + text(2 * n) + repeated(2 * n, " 1"));
         }},
        {"properties of vertices",
         f,
         20000,
         [=](auto n) {
             return ply(ply_vertices(3, ply_properties(n)) + ply_faces(1),
                        repeated(3, repeated(n, "1 ") + "0 0 0\n") + triangle);
         }},
        {"properties of faces",
         f,
         20000,
         [=](auto n) {
             return ply(ply_vertices(3) + ply_faces(1, ply_properties(n)), off_corners + "3 0 1 2" + repeated(n, " 1"));
         }},
        {"properties in binary",
         f,
         20000,
         [](auto n) {
             std::string data = std::string(3 * (n + 24), '\0');
             files::append(data, std::uint32_t(3));
             for (const std::uint32_t v : {0, 1, 2})
                 files::append(data, v);
             return ply(ply_vertices(3, ply_properties(n)) + ply_faces(1), data, true);
         }},
        {"lists of faces that are not kept",
         f,
         20000,
         [=](auto n) {
             return ply(
                 ply_vertices(3) +
                     ply_faces(1,
                               joined(n, [](std::size_t i) { return "property list uchar int l" + text(i) + "\n"; })),
                 off_corners + "3 0 1 2" + repeated(n, " 0"));
         }},
        {"other elements",
         f,
         20000,
         [=](auto n) {
             return ply(ply_vertices(3) + ply_faces(1) +
                            joined(n, [](std::size_t i) { return "element e" + text(i) + " 1\nproperty int a\n"; }),
                        off_corners + triangle + repeated(n, "5\n"));
         }},
        {"comments",
         f,
         40000,
         [=](auto n) {
             return ply(repeated(n, "comment x\n") + ply_vertices(3) + ply_faces(1), off_corners + triangle);
         }},
        {"words",
         f,
         20000,
         [=](auto n) {
             return ply(joined(n, [](std::size_t i) { return "comment word group " + text(i + 1) + " w\n"; }) +
                            ply_vertices(3) + ply_faces(1, "property int group\n"),
                        off_corners + "3 0 1 2 " + text(n));
         }},
        {"vertices of a strip",
         f,
         40000,
         [](auto n) {
             return ply(ply_vertices(3) + "element tristrips 1\nproperty list int int vertex_indices\n",
                        off_corners + text(3 * n) + repeated(n, " 0 1 2"));
         }},
        {"strips",
         f,
         20000,
         [](auto n) {
             return ply(ply_vertices(3) + "element tristrips 1\nproperty list int int vertex_indices\n",
                        off_corners + text(4 * n) + repeated(n, " 0 1 2 -1"));
         }},
        {"letters of a comment", f, 1000000, [=](auto n) {
             return ply("comment " + repeated(n, "x") + "\n" + ply_vertices(3) + ply_faces(1), off_corners + triangle);
         }}};
}

std::vector<growing_file> files_of_stl()
{
    const auto f = mesh_format::stl;
    return {{"triangles", f, 10000, [](auto n) { return "solid x\n" + repeated(n, facet) + "endsolid x\n"; }},
            {"points",
             f,
             10000,
             [](auto n) {
                 return "solid x\n" +
                        joined(n,
                               [](std::size_t i) {
                                   return "facet normal 0 0 1\nouter loop\nvertex 0 0 " + text(i) + "\nvertex 1 0 " +
                                          text(i) + "\nvertex 0 1 " + text(i) + "\nendloop\nendfacet\n";
                               }) +
                        "endsolid x\n";
             }},
            {"solids", f, 10000, [](auto n) { return repeated(n, "solid x\n" + facet + "endsolid x\n"); }},
            {"letters of a name",
             f,
             1000000,
             [](auto n) { return "solid " + repeated(n, "x") + "\n" + facet + "endsolid\n"; }},
            {"triangles in binary", f, 40000, [](auto n) {
                 std::string result(80, ' ');
                 files::append(result, std::uint32_t(n));
                 for (std::size_t i = 0; i < n; ++i) {
                     for (std::size_t k = 0; k < 12; ++k)
                         files::append(result, float(k == 3 ? i : k));
                     files::append(result, std::uint16_t(i));
                 }
                 return result;
             }}};
}

std::vector<growing_file> files_of_vtk()
{
    const auto f = mesh_format::vtu;
    const auto arrays = [](const std::string& section, const auto& name) {
        return [=](std::size_t n) {
            return vtu("<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"><Points>" + array("Float64", "", "", 3) +
                       "</Points><Cells>" + array("Int64", "connectivity", "") + array("Int64", "offsets", "") +
                       array("UInt8", "types", "") + "</Cells><" + section + ">" +
                       joined(n, [&](std::size_t i) { return array("Float32", name(i), "", 16); }) + "</" + section +
                       "></Piece>");
        };
    };
    const auto own = [](std::size_t i) { return "a" + text(i); };
    const auto one = [](std::size_t) { return std::string("a"); };
    return {{"points", f, 20000, [](auto n) { return vtu(vtu_piece(n, 1, "")); }},
            {"cells", f, 20000, [](auto n) { return vtu(vtu_piece(3, n, "")); }},
            {"corners of a face", f, 20000, [](auto n) { return vtu(vtu_piece(n, 1, "", true)); }},
            {"empty arrays", f, 4000, arrays("PointData", own)},
            {"empty arrays of cells", f, 4000, arrays("CellData", own)},
            {"empty arrays of one name", f, 4000, arrays("PointData", one)},
            {"arrays of cells",
             f,
             10000,
             [](auto n) {
                 return vtu(vtu_piece(3, 1, "<CellData>" + joined(n, [](std::size_t i) {
                                                return array("Int8", text(i), "1");
                                            }) + "</CellData>"));
             }},
            {"words",
             f,
             20000,
             [](auto n) {
                 return vtu("<FieldData><DataArray type=\"String\" Name=\"group\" format=\"ascii\">0" +
                            repeated(n, " 65 66 0") + "</DataArray></FieldData>" +
                            vtu_piece(3, 1, "<CellData>" + array("Int32", "group", text(n)) + "</CellData>"));
             }},
            {"lists of words",
             f,
             10000,
             [](auto n) {
                 return vtu("<FieldData>" +
                            joined(n,
                                   [](std::size_t i) {
                                       return "<DataArray type=\"String\" Name=\"w" + text(i) +
                                              "\" format=\"ascii\">0 65 0</DataArray>";
                                   }) +
                            "</FieldData>" + vtu_piece(3, 1, ""));
             }},
            {"pieces",
             f,
             2000,
             [](auto n) {
                 return vtu(joined(n, [](std::size_t i) {
                     return vtu_piece(3,
                                      1,
                                      "<PointData>" +
                                          array("Int64",
                                                "GlobalPointIds",
                                                text(2 * i) + " " + text(2 * i + 1) + " " + text(1000000 + i)) +
                                          array("Int8", "a" + text(i), "1 2 3") + "</PointData><CellData>" +
                                          array("Int64", "GlobalCellIds", text(i)) + "</CellData>");
                 }));
             }},
            {"comments", f, 40000, [](auto n) { return vtu(repeated(n, "<!-- > -->") + vtu_piece(3, 1, "")); }},
            {"letters of a comment",
             f,
             1000000,
             [](auto n) { return vtu("<!--" + repeated(n, "x") + "-->" + vtu_piece(3, 1, "")); }},
            {"attributes of an element",
             f,
             20000,
             [](auto n) {
                 return vtu("<Other" + joined(n, [](std::size_t i) { return " a" + text(i) + "=\"1\""; }) + "/>" +
                            vtu_piece(3, 1, ""));
             }},
            {"polygons of PolyData",
             f,
             20000,
             [](auto n) {
                 return vtp(
                     "<Polys>" + array("Int64", "connectivity", repeated(n, "0 1 2 ")) +
                         array("Int64", "offsets", joined(n, [](std::size_t i) { return " " + text(3 * i + 3); })) +
                         "</Polys>",
                     "NumberOfPolys=\"" + text(n) + "\"",
                     3);
             }},
            {"vertices of a strip of PolyData", f, 20000, [](auto n) {
                 return vtp("<Strips>" + array("Int64", "connectivity", repeated(n, "0 1 2 ")) +
                                array("Int64", "offsets", text(3 * n)) + "</Strips>",
                            "NumberOfStrips=\"1\"",
                            3);
             }}};
}

/// Returns the processor time of reading in seconds; other processes do not count.
double seconds(mesh_format format, const std::string& bytes)
{
    const std::clock_t begin = std::clock();
    (void)io::read_mesh(format, bytes);
    return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

void expect_linear(const std::vector<growing_file>& all)
{
    constexpr double most = 3.2; // linear time gives a ratio of two, quadratic time of four
    constexpr int most_rounds = 8;
    for (const auto& [what, format, n, file] : all) {
        const std::string small = file(n), large = file(2 * n);
        constexpr double least = 1e-4; // shorter times cannot be measured
        double of_small = std::numeric_limits<double>::infinity(), of_large = of_small;
        for (int round = 0; round < most_rounds and not(of_large <= most * std::max(of_small, least)); ++round) {
            of_small = std::min(of_small, seconds(format, small));
            of_large = std::min(of_large, seconds(format, large));
        }
        EXPECT_LE(of_large, most * std::max(of_small, least)) << what << ": " << of_small << " s, then " << of_large;
    }
}

TEST(linear_time, off)
{
    expect_linear(files_of_off());
}
TEST(linear_time, obj)
{
    expect_linear(files_of_obj());
}
TEST(linear_time, ply)
{
    expect_linear(files_of_ply());
}
TEST(linear_time, stl)
{
    expect_linear(files_of_stl());
}
TEST(linear_time, vtk)
{
    expect_linear(files_of_vtk());
}

} // namespace
