// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell_problem.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/loop.hpp>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <map>
#include <numbers>
#include <vector>

namespace thin_shells {

/// A maker of meshes that collects points and faces. Points with the same coordinates get one number.
template <class Scheme>
struct mesh_maker {
    static constexpr std::size_t degree = std::same_as<Scheme, kith::catmull_clark> ? 4 : 3;
    std::vector<point> points{};
    std::vector<std::array<std::size_t, degree>> faces{};
    std::map<std::array<long, 3>, std::size_t> numbers{};

    std::size_t add(const point& p)
    {
        const std::array<long, 3> key{std::lround(1e6 * p[0]), std::lround(1e6 * p[1]), std::lround(1e6 * p[2])};
        const auto [known, is_new] = numbers.try_emplace(key, points.size());
        if (is_new)
            points.push_back(p);
        return known->second;
    }
    std::size_t add_on_sphere(double radius, const point& direction)
    {
        const double scale = radius / std::hypot(direction[0], direction[1], direction[2]);
        return add({scale * direction[0], scale * direction[1], scale * direction[2]});
    }
    void add_face(const std::array<std::size_t, degree>& corners) { faces.push_back(corners); }
    [[nodiscard]] mesh make() const { return kith::make_mesh(points, faces); }
};

/// Returns `around` by `along` faces of a cylinder around the y axis, with a row of ghost faces at both ends. Angles go
/// up in steps from `first`. Rows of triangles are staggered, or consist of halved rectangles.
template <class Scheme>
mesh cylinder(double radius, double length, double first, double step, int around, int along, bool is_staggered)
{
    mesh_maker<Scheme> maker;
    constexpr bool has_quads = mesh_maker<Scheme>::degree == 4;
    const auto at = [&](int i, int j) {
        const double a = first + step * (double(i) + (is_staggered and not has_quads and j % 2 != 0 ? .5 : 0));
        return maker.add({radius * std::sin(a), length * (double(j) / double(along) - .5), radius * std::cos(a)});
    };
    for (int j = -1; j <= along; ++j)
        for (int i = 0; i < around; ++i) {
            const std::size_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            if constexpr (has_quads)
                maker.add_face({a, d, c, b});
            else if (is_staggered and j % 2 == 0) {
                maker.add_face({a, d, b});
                maker.add_face({b, d, c});
            } else {
                maker.add_face({a, c, b});
                maker.add_face({a, d, c});
            }
        }
    return maker.make();
}

/// Returns a sphere made from a cube with n segments per edge. The axes meet vertices of the mesh.
inline mesh cube_sphere(double radius, std::size_t n)
{
    mesh_maker<kith::catmull_clark> maker;
    const auto coordinate = [n](std::size_t k) {
        return std::tan(std::numbers::pi / 4 * (2 * double(k) / double(n) - 1));
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double side : {-1., 1.}) {
            const auto at = [&](std::size_t i, std::size_t j) {
                point p{};
                p[axis] = side;
                p[(axis + 1) % 3] = side * coordinate(i);
                p[(axis + 2) % 3] = coordinate(j);
                return maker.add_on_sphere(radius, p);
            };
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j)
                    maker.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return maker.make();
}
/// Returns an octahedron as a sphere. The axes x and y meet regular vertices; four irregular ones lie between them.
inline mesh octahedron_sphere(double radius, std::size_t n)
{
    mesh_maker<kith::loop> maker;
    for (const double z : {1., -1.})
        for (const auto& [x, y] : {std::array{1., 1.}, {-1., 1.}, {-1., -1.}, {1., -1.}}) {
            const auto at = [&](std::size_t i, std::size_t j) { // between (x, y, 0), (-yz, xz, 0) and the pole
                const double a = double(i), b = double(j), rest = double(n - i - j);
                return maker.add_on_sphere(radius,
                                           {a * x - b * y * z, a * y + b * x * z, std::numbers::sqrt2 * z * rest});
            };
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; i + j < n; ++j) {
                    maker.add_face({at(i, j), at(i + 1, j), at(i, j + 1)});
                    if (i + j + 1 < n)
                        maker.add_face({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
                }
        }
    return maker.make();
}

/// Returns supports that keep the ends of a cylinder circular.
inline auto at_diaphragms(double length)
{
    return [length](const point& p) {
        const bool is_held = std::abs(std::abs(p[1]) - length / 2) < 1e-6;
        return std::array{is_held, false, is_held};
    };
}

/// Returns a roof of 80 degrees under its own weight, on two rigid diaphragms. Its straight edges are free.
template <class Scheme>
shell_problem scordelis_lo_roof(int level)
{
    constexpr double radius = 25, length = 50, half_angle = 40 * std::numbers::pi / 180;
    const int n = 8 << level;
    const double step = 2 * half_angle / n;
    const double x = radius * std::sin(half_angle), z = radius * std::cos(half_angle);
    return {.surface = cylinder<Scheme>(radius, length, -half_angle - step, step, n + 2, n, false),
            .of = {.young = 4.32e8, .poisson = 0, .thickness = .25},
            .is_inside = [=](const point& p) { return p[2] > z and std::abs(p[1]) < length / 2; },
            .held = at_diaphragms(length),
            .gravity = 90,
            .probe = {{x, 0, z}, {0, 0, -1}},
            .reference = .3024};
}

/// Returns a cylinder between rigid diaphragms that is pinched by two opposite forces.
template <class Scheme>
shell_problem pinched_cylinder(int level)
{
    constexpr double radius = 300, length = 600;
    const int n = 32 << level;
    const point_load down{{0, 0, radius}, {0, 0, -1}}, up{{0, 0, -radius}, {0, 0, 1}};
    return {.surface = cylinder<Scheme>(radius, length, 0, 2 * std::numbers::pi / n, n, n / 8 * 3, true),
            .of = {.young = 3e6, .poisson = .3, .thickness = 3},
            .is_mirrored = {true, true, true},
            .is_inside = [](const point& p) { return std::abs(p[1]) < length / 2; },
            .held = at_diaphragms(length),
            .loads = {down, up},
            .probe = down,
            .reference = 1.8248e-5};
}

/// Returns a hemisphere with a free edge. Two forces pull it along x, two push it along y.
template <class Scheme>
shell_problem pinched_hemisphere(int level)
{
    constexpr double radius = 10;
    mesh surface;
    if constexpr (std::same_as<Scheme, kith::catmull_clark>)
        surface = cube_sphere(radius, std::size_t(8) << level);
    else
        surface = octahedron_sphere(radius, std::size_t(8) << level);
    return {.surface = std::move(surface),
            .of = {.young = 6.825e7, .poisson = .3, .thickness = .04},
            .is_mirrored = {true, true, false},
            .is_inside = [](const point& p) { return p[2] > 0; },
            .held = [](const point& p) { return std::array{false, false, p[2] > radius - 1e-6}; },
            .loads = {{{radius, 0, 0}, {2, 0, 0}},
                      {{-radius, 0, 0}, {-2, 0, 0}},
                      {{0, radius, 0}, {0, -2, 0}},
                      {{0, -radius, 0}, {0, 2, 0}}},
            .probe = {{radius, 0, 0}, {1, 0, 0}},
            .reference = .0924};
}

} // namespace thin_shells
