// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// The control meshes of the thesis's figures, for examples, tests and measurements:
/// `kith::make_mesh(f.points, f.faces)`. The thesis prints the counts of the first four. If a figure shows a body
/// without its coordinates, the body is made of unit cubes.
namespace figures {

using point = std::array<double, 3>;
using polygons = std::vector<std::vector<std::size_t>>;

/// Points and faces; the faces are counter-clockwise seen from outside.
struct shape {
    std::vector<point> points;
    polygons faces;
};

/// Returns a cube; V, E, F = 8, 12, 6.
inline shape cube()
{
    return {{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
            {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

/// Cuts each face along the diagonals from its second corner. The cube becomes V, E, F = 8, 18, 12.
inline shape triangulated(const shape& s)
{
    shape result{s.points, {}};
    for (const auto& f : s.faces)
        for (std::size_t i = 2; i < f.size(); ++i)
            result.faces.push_back({f[1], f[i], f[(i + 1) % f.size()]});
    return result;
}

/// Returns a pentagonal prism with a roof: triangles, quads and a pentagon; V, E, F = 11, 20, 11.
inline shape pentacube()
{
    const double turn = 2 * std::acos(-1.) / 5;
    shape result{{{0, 0, 2}}, {}};
    for (const double z : {0, -1})
        for (std::size_t i = 0; i < 5; ++i)
            result.points.push_back({std::cos(turn * double(i)), std::sin(turn * double(i)), z});
    for (std::size_t i = 0; i < 5; ++i)
        result.faces.push_back({0, 1 + i, 1 + (i + 1) % 5});
    for (std::size_t i = 0; i < 5; ++i)
        result.faces.push_back({6 + i, 6 + (i + 1) % 5, 1 + (i + 1) % 5, 1 + i});
    result.faces.push_back({10, 9, 8, 7, 6});
    return result;
}

/// Returns a torus of rows * columns quads, with valence 4 everywhere. By default V, E, F = 288, 576, 288.
inline shape torus(std::size_t rows = 12, std::size_t columns = 24)
{
    const double turn = 2 * std::acos(-1.);
    shape result;
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j) {
            const double a = turn * double(i) / double(rows), b = turn * double(j) / double(columns);
            const double r = 2 + std::cos(a);
            result.points.push_back({r * std::cos(b), r * std::sin(b), std::sin(a)});
            const std::size_t up = (i + 1) % rows, right = (j + 1) % columns;
            result.faces.push_back({i * columns + j, i * columns + right, up * columns + right, up * columns + j});
        }
    return result;
}

using cell = std::array<int, 3>;

/// Returns the surface of unit cubes, each given by its smallest corner. Precondition: no two cubes touch only in an
/// edge or in a corner.
inline shape cubes(const std::vector<cell>& cells)
{
    shape result;
    const auto at = [&](const cell& corner) {
        const point p{double(corner[0]), double(corner[1]), double(corner[2])};
        const auto place = std::ranges::find(result.points, p) - result.points.begin();
        if (place == std::ptrdiff_t(result.points.size()))
            result.points.push_back(p);
        return std::size_t(place);
    };
    const std::array<cell, 6> outward{{{0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}};
    const std::array<std::array<cell, 4>, 6> sides{{{{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}},
                                                    {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}},
                                                    {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}},
                                                    {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}},
                                                    {{{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}}},
                                                    {{{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}}}}};
    const auto plus = [](const cell& a, const cell& b) { return cell{a[0] + b[0], a[1] + b[1], a[2] + b[2]}; };
    for (const cell& c : cells)
        for (std::size_t side = 0; side < 6; ++side)
            if (std::ranges::count(cells, plus(c, outward[side])) == 0) {
                auto& face = result.faces.emplace_back();
                for (const cell& corner : sides[side])
                    face.push_back(at(plus(c, corner)));
            }
    return result;
}

/// Returns four cubes in a T; V, E, F = 20, 36, 18.
inline shape t_shape()
{
    return cubes({{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {1, 1, 0}});
}

/// Returns the ends of the edges around the upper side of the T, which are sharp in the figure.
inline std::vector<std::array<std::size_t, 2>> t_shape_creases()
{
    const shape t = t_shape();
    const auto is_up = [&t](std::size_t v) { return t.points[v][2] == 1; };
    std::vector<std::array<std::size_t, 2>> result;
    for (const auto& f : t.faces)
        for (std::size_t i = 0; i < f.size(); ++i)
            if (const std::size_t a = f[i], b = f[(i + 1) % f.size()];
                is_up(a) and is_up(b) and not std::ranges::all_of(f, is_up))
                result.push_back({a, b});
    return result;
}

/// Returns a cube of 27 cubes without the middle cube and its six neighbours: three tunnels, genus 5;
/// V, E, F = 64, 144, 72.
inline shape hollow_cube()
{
    std::vector<cell> cells;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
            for (int z = 0; z < 3; ++z)
                if ((x == 1) + (y == 1) + (z == 1) < 2)
                    cells.push_back({x, y, z});
    return cubes(cells);
}

} // namespace figures
