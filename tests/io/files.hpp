// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Files of a tetrahedron with the points of `corners` and the faces of `triangles`.
namespace kith::files {

inline const std::vector<std::array<double, 3>> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline const std::vector<std::vector<std::size_t>> triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

inline const std::string off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
inline const std::string obj =
    "# a comment\no thing\nv 0 0 0\nv 1 0 0 0.5\nv 0 1 0\nv 0 0 1 1 0 0\nvt 0 0\nvn 0 0 1\ng back\n"
    "usemtl red\ns 1\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\nf 2/1 3/1 4/1\nf -2 -4 \\\n -1\n"
    "t crease 2/1/0 0 1 2.5\nt corner 1/1/0 3 10\nt other 1/0/1 3 word\n";
inline const std::string ply =
    "ply\nformat ascii 1.0\ncomment text\nelement vertex 4\nproperty float x\nproperty double y\nproperty int z\n"
    "property uchar red\nelement face 4\nproperty list uchar int vertex_indices\nproperty list uint float weights\n"
    "element edge 2\nproperty short a\nend_header\n"
    "0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n3 0 2 1 0\n3 0 1 3 1 0.5\n3 1 2 3 0\n3 2 0 3 2 nan 1\n-7\n8\n";
inline const std::string stl =
    "solid one\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal nan 1 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal -1 0 0\nouter loop\nvertex 0 1 0\nvertex -0 0 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid one\n";

/// Appends the bytes of a number, most significant byte first if `big_endian`.
template <class Number>
void append(std::string& bytes, Number number, bool big_endian = false)
{
    std::string own(reinterpret_cast<const char*>(&number), sizeof(number));
    bytes += big_endian ? std::string(own.rbegin(), own.rend()) : own;
}

inline std::string binary_stl(const std::string& name = "any words")
{
    std::string result = name;
    result.resize(80, ' ');
    append(result, std::uint32_t(triangles.size()));
    for (const auto& face : triangles) {
        for (int i = 0; i < 3; ++i)
            append(result, 0.f);
        for (const std::size_t v : face)
            for (const double x : corners[v])
                append(result, float(x));
        append(result, std::uint16_t(0));
    }
    return result;
}

/// Returns the tetrahedron as binary PLY. `place`, `count` and `index` are PLY's names for Place, Count and Index.
template <class Place, class Count, class Index>
std::string binary_ply(const std::string& place, const std::string& count, const std::string& index, bool big_endian)
{
    std::string result = "ply\nformat binary_" + std::string(big_endian ? "big" : "little") +
                         "_endian 1.0\nelement vertex 4\nproperty " + place + " x\nproperty " + place +
                         " y\nproperty " + place + " z\nproperty ushort s\nelement face 4\nproperty list " + count +
                         " " + index + " vertex_index\nproperty double area\nend_header\n";
    for (const auto& p : corners) {
        for (const double x : p)
            append(result, Place(x), big_endian);
        append(result, std::uint16_t(7), big_endian);
    }
    for (const auto& face : triangles) {
        append(result, Count(face.size()), big_endian);
        for (const std::size_t v : face)
            append(result, Index(v), big_endian);
        append(result, 0.5, big_endian);
    }
    return result;
}

} // namespace kith::files
