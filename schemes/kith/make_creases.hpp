// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/level/to_native.hpp>
#include <kith/fields/property/map_value.hpp>
#include <kith/schemes/crease/creases.hpp>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace kith {

namespace detail {

/// Returns the sharpness of an element from a function, a property map (`get(map, handle)`) or an array by handles.
/// `number` is the number of the element in its mesh, for messages.
template <class Source, class Handle>
double sharpness_from(const Source& source, const Handle& x, std::size_t number, const char* kind)
{
    using value = std::remove_cvref_t<decltype(map_value(source, x))>;
    if constexpr (std::is_arithmetic_v<value> and not std::same_as<value, bool>) {
        const auto given = map_value(source, x);
        if (std::is_integral_v<value> and given == std::numeric_limits<value>::max())
            return infinitely_sharp; // integers have no infinity
        const double sharpness = double(given);
        if (not(sharpness >= 0))
            throw mesh_error(std::string(kind) + " " + std::to_string(number) + ": its sharpness is " +
                             std::to_string(sharpness) + "; give 0 or more, or infinitely_sharp");
        return sharpness;
    } else {
        return bool(map_value(source, x)) ? infinitely_sharp : 0.;
    }
}

} // namespace detail

/// Returns the creases of a mesh from the user's sharpness of edges and vertices. Each source is a function of the
/// mesh's handles, a property map over them (CGAL's edge_is_constrained_map), or an object that takes them in brackets.
/// Numbers are sharpness; `true` and the largest number of an integer type stand for infinitely_sharp. Errors:
/// mesh_error for a sharpness below 0 or NaN, and for a mesh without edges. Cost: O(elements).
template <mesh M, class EdgeSharpness, class VertexSharpness>
creases make_creases(const M& mesh, const EdgeSharpness& edge_sharpness, const VertexSharpness& vertex_sharpness,
                     crease_method method = crease_method::uniform)
{
    require_edges(mesh);
    const level_of<M> level(mesh);
    creases result(method);
    const auto sharpness_of = [&](const auto& source, const auto& x, const char* kind) {
        return detail::sharpness_from(source, x.handle(), number_in_mesh(level, x), kind);
    };
    for (const auto e : level.edges())
        result.sharpen_edge(e.index(), sharpness_of(edge_sharpness, e, "edge"));
    for (const auto v : level.vertices())
        result.sharpen_vertex(v.index(), sharpness_of(vertex_sharpness, v, "vertex"));
    return result;
}
/// Returns the same creases without sharp vertices.
template <mesh M, class EdgeSharpness>
creases make_creases(const M& mesh, const EdgeSharpness& edge_sharpness, crease_method method = crease_method::uniform)
{
    return make_creases(mesh, edge_sharpness, [](const auto&) { return 0.; }, method);
}

/// Requirements of a mesh whose edges and vertices have status bits, one of which marks features: OpenMesh.
template <class M>
concept mesh_with_features = mesh<M> and
                             requires(const M& m, typename mesh_traits<M>::edge e, typename mesh_traits<M>::vertex v) {
                                 { m.has_edge_status() } -> std::convertible_to<bool>;
                                 { m.has_vertex_status() } -> std::convertible_to<bool>;
                                 { m.status(e).feature() } -> std::convertible_to<bool>;
                                 { m.status(v).feature() } -> std::convertible_to<bool>;
                             };

/// Returns creases and corners, all of one sharpness, where the mesh's status bits mark features. Errors: mesh_error if
/// neither edges nor vertices have a status. Cost: O(elements).
template <mesh_with_features M>
creases creases_from_features(const M& mesh, double sharpness = infinitely_sharp,
                              crease_method method = crease_method::uniform)
{
    const bool edges = mesh.has_edge_status(), vertices = mesh.has_vertex_status();
    if (not edges and not vertices)
        throw mesh_error("neither edges nor vertices have a status, where features are marked; call "
                         "request_edge_status() or request_vertex_status() and mark them");
    return make_creases(
        mesh,
        [&](auto e) { return edges and mesh.status(e).feature() ? sharpness : 0.; },
        [&](auto v) { return vertices and mesh.status(v).feature() ? sharpness : 0.; },
        method);
}

/// Returns creases with every inner edge sharp at which the normals of its two faces turn by more than `degrees`.
/// Errors: mesh_error for a mesh without edges. Cost: O(corners).
template <mesh M>
creases creases_by_angle(const M& mesh, double degrees, double sharpness = infinitely_sharp)
{
    using coordinates = std::array<double, 3>;
    require_edges(mesh);
    const level_of<M> level(mesh);
    const auto place = [](const auto& v) {
        const auto sum = affine<typename level_of<M>::point_type>::load(v.point());
        return coordinates{double(sum[0]), double(sum[1]), double(sum[2])};
    };
    const auto normal = [&](const auto& f) { // Newell's
        coordinates n{};
        for (const auto c : f.corners()) {
            const auto a = place(c.v()), b = place(c.next().v());
            for (int i = 0; i < 3; ++i)
                n[i] += (a[(i + 1) % 3] - b[(i + 1) % 3]) * (a[(i + 2) % 3] + b[(i + 2) % 3]);
        }
        return n;
    };
    const auto dot = [](const coordinates& a, const coordinates& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    std::vector<coordinates> normals(level.face_count()); // computed once per face: a face may have many edges
    for (const auto f : level.faces())
        normals[f.index()] = normal(f);
    const double limit = std::cos(degrees * 3.14159265358979323846 / 180);
    creases result;
    for (const auto e : level.edges())
        if (not e.is_boundary()) {
            const auto &a = normals[e.lface().index()], &b = normals[e.rface().index()];
            if (dot(a, b) < limit * std::sqrt(dot(a, a) * dot(b, b)))
                result.sharpen_edge(e.index(), sharpness);
        }
    return result;
}

} // namespace kith
