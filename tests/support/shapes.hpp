// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "figures.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The control meshes of the tests: those of the figures, and others.
namespace shapes {

using namespace figures;

inline shape tetrahedron()
{
    return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

/// Returns rows * columns quads with a boundary, over the unit lattice. The surface is not flat.
inline shape grid(std::size_t rows = 3, std::size_t columns = 4)
{
    shape result;
    for (std::size_t i = 0; i <= rows; ++i)
        for (std::size_t j = 0; j <= columns; ++j) {
            result.points.push_back({double(j), double(i), 0.25 * double((3 * i + 2 * j) % 5)});
            if (i < rows and j < columns) {
                const std::size_t v = i * (columns + 1) + j;
                result.faces.push_back({v, v + 1, v + columns + 2, v + columns + 1});
            }
        }
    return result;
}

/// Returns three quads in an L. One boundary vertex has three faces, the boundary corners have one each.
inline shape l_shape()
{
    shape result = grid(2, 2);
    result.faces.pop_back();
    result.points.pop_back();
    return result;
}

/// Returns a ring of quads with two boundaries.
inline shape ring(std::size_t n = 5)
{
    shape result = torus(4, n);
    result.faces.resize(2 * n); // two of its four rows
    result.points.resize(3 * n);
    return result;
}

/// Returns n triangles around an inner vertex, vertex 0.
inline shape umbrella(std::size_t n)
{
    const double turn = 2 * std::acos(-1.);
    shape result{{{0, 0, 1}}, {}};
    for (std::size_t i = 0; i < n; ++i) {
        result.points.push_back({std::cos(turn * double(i) / double(n)), std::sin(turn * double(i) / double(n)), 0});
        result.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
    }
    return result;
}

/// Returns triangles, quads and a pentagon; V, E, F = 11, 20, 11.
inline shape house()
{
    return pentacube();
}

/// Returns the house without its floor and one wall: triangles and quads with a boundary.
inline shape open_house()
{
    shape result = house();
    result.faces.resize(9);
    return result;
}

inline shape polygon(std::size_t n)
{
    shape result = umbrella(n);
    result.points.erase(result.points.begin());
    result.faces = {{}};
    for (std::size_t i = 0; i < n; ++i)
        result.faces[0].push_back(i);
    return result;
}

/// Returns two quads around vertex 3, an inner vertex of valence two. Libraries that count faces by edges fail
/// on it.
inline shape valence_two()
{
    return {{{0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0.25, 0, 0.3}, {1, 0, 1}}, {{0, 1, 2, 3}, {3, 2, 4, 0}}};
}

/// Returns two shapes beside each other, which are not connected.
inline shape both(const shape& a, const shape& b)
{
    shape result = a;
    for (const auto& [x, y, z] : b.points)
        result.points.push_back({x + 10, y, z});
    for (auto f : b.faces) {
        for (auto& v : f)
            v += a.points.size();
        result.faces.push_back(f);
    }
    return result;
}

/// Moves every point a little, each differently. The result has no symmetries that could hide a wrong order of
/// operands.
inline shape shaken(shape s)
{
    std::uint64_t state = 42;
    for (auto& p : s.points)
        for (auto& x : p) {
            state = state * 6364136223846793005U + 1442695040888963407U;
            x += 0.1 * double(state >> 40) / double(1 << 24);
        }
    return s;
}

} // namespace shapes
