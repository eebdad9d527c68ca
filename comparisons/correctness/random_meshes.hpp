// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../tests/support/all_shapes.hpp"

#include <kith/core/mesh/make_mesh.hpp>
#include <kith/schemes/crease/creases.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace kith::comparison {

/// Random numbers that are the same on every machine, unlike the standard distributions.
class random_numbers {
public:
    explicit random_numbers(std::uint64_t seed) : engine_(seed) {}

    /// Returns a random number from 0 to n - 1.
    std::size_t below(std::size_t n) { return std::size_t(engine_() % n); }
    bool one_in(std::size_t n) { return below(n) == 0; }
    /// Returns a random number between -1 and 1.
    double coordinate() { return 2 * double(engine_() >> 11) / double(std::uint64_t(1) << 53) - 1; }

private:
    std::mt19937_64 engine_;
};

/// Removes random faces as long as the rest is a manifold, and removes vertices that are left without faces.
inline shapes::shape with_gaps(shapes::shape s, random_numbers& random, std::size_t attempts)
{
    for (std::size_t i = 0; i < attempts and s.faces.size() > 2; ++i) {
        auto rest = s;
        rest.faces.erase(rest.faces.begin() + std::ptrdiff_t(random.below(rest.faces.size())));
        std::vector<std::size_t> number(rest.points.size(), rest.points.size());
        std::vector<shapes::point> points;
        for (auto& face : rest.faces)
            for (auto& v : face) {
                if (number[v] == number.size()) {
                    number[v] = points.size();
                    points.push_back(rest.points[v]);
                }
                v = number[v];
            }
        rest.points = points;
        try {
            make_mesh(rest.points, rest.faces);
        } catch (const mesh_error&) { // the faces around a vertex would no longer be connected
            continue;
        }
        s = rest;
    }
    return s;
}

/// Makes a small triangle mesh, closed or bounded, with vertices of all valences at random points of a cube.
inline shapes::shape random_triangles(random_numbers& random)
{
    const auto size = [&](std::size_t least) { return least + random.below(3); };
    const std::array bases{shapes::cube(),
                           shapes::tetrahedron(),
                           shapes::house(),
                           shapes::umbrella(size(3) + 3),
                           shapes::torus(size(3), size(3)),
                           shapes::grid(size(1), size(2)),
                           shapes::ring(size(3))};
    auto result = shapes::triangulated(bases[random.below(bases.size())]);
    result = shapes::with_flips(result, std::uint32_t(1 + random.below(1000)), int(random.below(30)));
    result = with_gaps(result, random, random.below(4));
    for (auto& p : result.points)
        p = {random.coordinate(), random.coordinate(), random.coordinate()};
    return result;
}

/// Makes a random triangle mesh and joins some of its triangles to polygons.
inline shapes::shape random_polygons(random_numbers& random)
{
    auto triangles = random_triangles(random);
    const auto joins = random.below(5 * triangles.faces.size());
    return shapes::with_joins(std::move(triangles), std::uint32_t(1 + random.below(1000)), int(joins));
}

/// The precision with which OpenSubdiv's floats represent the sharpness of random creases.
enum class float_sharpness : unsigned char {
    alike,   ///< exact: the values whose mean is taken at a vertex are equal
    few,     ///< exact: values differ, but at most two of them meet at a vertex
    rounded, ///< inexact: any values, which floats round
};

/// Makes random creases: infinitely sharp, whole and fractional edges and vertices. They form creases, darts, corners
/// and lone sharp vertices.
inline creases random_creases(const basic_mesh<>& mesh, float_sharpness kind, crease_method method,
                              random_numbers& random)
{
    const level_of<basic_mesh<>> level(mesh);
    const double alike = double(random.below(56)) / 16;
    const auto number = [&] {
        if (random.one_in(4))
            return infinitely_sharp;
        if (kind == float_sharpness::few)
            return double(1 + random.below(64)) / 16;
        if (kind == float_sharpness::rounded)
            return double(float(2 + 2 * random.coordinate()));
        // Uniform values lose 1 per level; if their fractions are equal, they are equal when they end. Chaikin's values
        // mix.
        return method == crease_method::uniform ? alike + double(random.below(3)) : alike;
    };
    const std::size_t one_edge_in = 2 + random.below(6), one_vertex_in = 4 + random.below(20);
    std::vector<int> semi_sharp(level.vertex_count());
    const auto room_at = [&](const auto& v) { return kind != float_sharpness::few or semi_sharp[v.index()] < 2; };
    creases result(method);
    for (const auto e : level.edges())
        if (not e.is_boundary() and random.one_in(one_edge_in)) {
            const double sharpness = number();
            if (sharpness < infinitely_sharp) {
                if (not room_at(e.org()) or not room_at(e.dst()))
                    continue;
                ++semi_sharp[e.org().index()], ++semi_sharp[e.dst().index()];
            }
            result.sharpen_edge(e.index(), sharpness);
        }
    for (const auto v : level.vertices())
        if (random.one_in(one_vertex_in) and room_at(v))
            result.sharpen_vertex(v.index(), number());
    return result;
}

} // namespace kith::comparison
