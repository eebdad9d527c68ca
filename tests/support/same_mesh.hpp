// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/to_native.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Returns the faces of any mesh as lists of vertex numbers, in the order of the mesh. Each list begins with the first
/// corner of the face.
template <class M>
std::vector<std::vector<std::size_t>> faces_of(const M& mesh)
{
    const kith::level_of<M> level(mesh);
    std::vector<std::vector<std::size_t>> result;
    for (const auto f : level.faces()) {
        result.emplace_back();
        for (const auto& v : f.vertices())
            result.back().push_back(v.index());
    }
    return result;
}

/// Returns the faces in a normal form that does not depend on their order or first corners. Equal lists mean equal
/// oriented faces.
inline std::vector<std::vector<std::size_t>> as_cycles(std::vector<std::vector<std::size_t>> faces)
{
    for (auto& face : faces)
        std::ranges::rotate(face, std::ranges::min_element(face));
    std::ranges::sort(faces);
    return faces;
}

/// Returns the edge between two vertices, given by their numbers. Precondition: there is such an edge.
template <class Level>
typename Level::edge_handle edge_between(const Level& level, std::size_t a, std::size_t b)
{
    return level.edge_at(index_tuple(level.vertices()[a], level.vertices()[b]).value);
}

/// Returns the bit pattern of a number, so that zeros of different sign differ. Returns other scalar types unchanged.
template <class Scalar>
auto bits_of(const Scalar& x)
{
    if constexpr (std::same_as<Scalar, double>)
        return std::bit_cast<std::uint64_t>(x);
    else if constexpr (std::same_as<Scalar, float>)
        return std::bit_cast<std::uint32_t>(x);
    else
        return x;
}

template <class Point>
bool same_points(const Point& a, const Point& b)
{
    const auto& x = kith::affine<Point>::load(a);
    const auto& y = kith::affine<Point>::load(b);
    const auto bits = [](const auto& number) { return bits_of(number); };
    return std::ranges::equal(x, y, {}, bits, bits);
}

template <class Index>
bool same_arrays(const kith::connectivity<Index>& a, const kith::connectivity<Index>& b)
{
    return a.vertices == b.vertices and a.faces == b.faces and a.degree == b.degree and
           std::ranges::equal(a.corner_vertex, b.corner_vertex) and
           std::ranges::equal(a.corner_halfedge, b.corner_halfedge) and
           std::ranges::equal(a.halfedge_corner, b.halfedge_corner) and
           std::ranges::equal(a.vertex_corner, b.vertex_corner) and std::ranges::equal(a.face_corner, b.face_corner) and
           std::ranges::equal(a.corner_face, b.corner_face);
}

/// Returns true if points agree bit for bit, and elements agree in numbers, directions and first corners.
template <class Point, class Index>
bool same_bits(const kith::basic_mesh<Point, Index>& a, const kith::basic_mesh<Point, Index>& b)
{
    return same_arrays(a.topology(), b.topology()) and std::ranges::equal(a.points(), b.points(), same_points<Point>);
}
template <class M>
bool same_bits(const M& a, const M& b)
{
    return same_bits(kith::to_native(a), kith::to_native(b));
}

/// Returns the coordinates of a point of any library, as doubles.
template <class Point>
std::array<double, 3> coordinates(const Point& point)
{
    const auto as_double = [](const auto& x) {
        if constexpr (std::convertible_to<decltype(x), double>)
            return double(x);
        else
            return to_double(x); // function of the library that defines the number
    };
    const auto& x = kith::affine<Point>::load(point);
    return {as_double(x[0]), as_double(x[1]), as_double(x[2])};
}
