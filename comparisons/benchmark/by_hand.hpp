// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/basic_mesh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

/// Two schemes written by hand for one kind of mesh: raw arrays, 32-bit numbers, closed meshes of quads or of triangles
/// only, no creases, no boundary, no checks. The order of operations is that of kith's schemes, so the results agree
/// bit for bit.
namespace kith::comparison::by_hand {

using point = std::array<double, 3>;
using mesh = basic_mesh<point>;
using id = std::uint32_t;

struct coordinates {
    double x, y, z;

    explicit coordinates(const point& p) : x(p[0]), y(p[1]), z(p[2]) {}
    coordinates(double x, double y, double z) : x(x), y(y), z(z) {}
    friend coordinates operator+(coordinates a, coordinates b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend coordinates operator*(double w, coordinates a) { return {w * a.x, w * a.y, w * a.z}; }
    operator point() const { return {x, y, z}; }
};

/// Allocates the arrays of a new level: all of them if `complete`, else the vertices of the faces only.
inline connectivity<id> allocate(std::size_t vertices, std::size_t edges, std::size_t faces, int degree, bool complete)
{
    connectivity<id> result;
    result.vertices = vertices;
    result.faces = faces;
    result.degree = degree;
    result.corner_vertex = storage<id>(faces * std::size_t(degree));
    if (complete) {
        result.corner_halfedge = storage<id>(faces * std::size_t(degree));
        result.halfedge_corner = storage<id>(2 * edges);
        result.vertex_corner = storage<id>(vertices);
    }
    return result;
}

/// Calls body(begin, end) on blocks of corners that fit into the cache, as kith::in_blocks does.
template <class Body>
void in_blocks(id corners, const Body& body)
{
    constexpr id corners_of_block = 4092; // of whole quads and of whole triangles
    for (id begin = 0; begin < corners; begin += corners_of_block)
        body(begin, std::min(corners - begin, corners_of_block) + begin);
}

/// Writes one corner of a face: its vertex and, if `Complete`, the half-edge that leaves it.
template <bool Complete>
void write_line(connectivity<id>& fine, id corner, id vertex, id halfedge)
{
    fine.corner_vertex[corner] = vertex;
    if constexpr (Complete) {
        fine.corner_halfedge[corner] = halfedge;
        fine.halfedge_corner[halfedge] = corner;
    }
}

template <bool Complete>
mesh catmull_clark_step(const mesh& coarse)
{
    const auto& t = coarse.topology();
    const id vertices = id(t.vertices), edges = id(t.edges()), faces = id(t.faces), corners = 4 * faces;
    const point* p = coarse.points().data();
    const id *vertex = t.corner_vertex.data(), *halfedge = t.corner_halfedge.data(), *corner = t.halfedge_corner.data(),
             *start = t.vertex_corner.data();
    const auto next = [](id c) { return (c & ~id(3)) | ((c + 1) & 3); };
    const auto prev = [](id c) { return (c & ~id(3)) | ((c + 3) & 3); };

    storage<point> points(std::size_t(vertices) + edges + faces);
    point *edge_points = points.data() + vertices, *face_points = edge_points + edges;
    for (id f = 0; f < faces; ++f) {
        const id* v = vertex + 4 * f;
        face_points[f] = 0.25 *
                         (coordinates(p[v[0]]) + coordinates(p[v[1]]) + coordinates(p[v[2]]) + coordinates(p[v[3]]));
    }
    auto fine = allocate(points.size(), 2 * std::size_t(edges) + corners, corners, 4, Complete);
    in_blocks(corners, [&](id begin, id end) {
        for (id c = begin; c < end; ++c) // edges and vertices face by face, so that their input stays in the cache
            if (halfedge[c] % 2 == 0)
                edge_points[halfedge[c] / 2] = 0.25 * (coordinates(p[vertex[c]]) + coordinates(p[vertex[next(c)]]) +
                                                       coordinates(face_points[c / 4]) +
                                                       coordinates(face_points[corner[halfedge[c] + 1] / 4]));
        for (id first = begin; first < end; ++first) {
            const id v = vertex[first];
            if (start[v] != first)
                continue;
            coordinates ring = coordinates(p[vertex[next(first)]]) + coordinates(face_points[first / 4]);
            double n = 1;
            for (id c = corner[halfedge[prev(first)] ^ 1]; c != first; c = corner[halfedge[prev(c)] ^ 1], ++n)
                ring = ring + (coordinates(p[vertex[next(c)]]) + coordinates(face_points[c / 4]));
            points[v] = (n - 2) / n * coordinates(p[v]) + 1 / (n * n) * ring;
        }
        for (id c = begin; c < end; ++c) {
            const id out = halfedge[c], in = halfedge[prev(c)];
            write_line<Complete>(fine, 4 * c, vertex[c], 2 * out + out % 2);
            write_line<Complete>(fine, 4 * c + 1, vertices + out / 2, 2 * (2 * edges + c));
            write_line<Complete>(fine, 4 * c + 2, vertices + edges + c / 4, 2 * (2 * edges + prev(c)) + 1);
            write_line<Complete>(fine, 4 * c + 3, vertices + in / 2, 2 * (in ^ 1) + in % 2);
        }
    });
    if constexpr (Complete) {
        for (id v = 0; v < vertices; ++v)
            fine.vertex_corner[v] = 4 * start[v];
        for (id e = 0; e < edges; ++e)
            fine.vertex_corner[vertices + e] = 4 * corner[2 * std::size_t(e)] + 1;
        for (id f = 0; f < faces; ++f)
            fine.vertex_corner[vertices + edges + f] = 16 * f + 2;
    }
    return {std::move(points), std::move(fine), coarse.generation() + 1};
}

template <bool Complete>
mesh loop_step(const mesh& coarse, const double* beta)
{
    const auto& t = coarse.topology();
    const id vertices = id(t.vertices), edges = id(t.edges()), faces = id(t.faces), corners = 3 * faces;
    const point* p = coarse.points().data();
    const id *vertex = t.corner_vertex.data(), *halfedge = t.corner_halfedge.data(), *corner = t.halfedge_corner.data(),
             *start = t.vertex_corner.data();
    const auto next = [](id c) { return c % 3 == 2 ? c - 2 : c + 1; };
    const auto prev = [](id c) { return c % 3 == 0 ? c + 2 : c - 1; };

    storage<point> points(std::size_t(vertices) + edges);
    point* edge_points = points.data() + vertices;
    auto fine = allocate(points.size(), 2 * std::size_t(edges) + corners, 4 * std::size_t(faces), 3, Complete);
    in_blocks(corners, [&](id begin, id end) {
        for (id c = begin; c < end; ++c)
            if (halfedge[c] % 2 == 0)
                edge_points[halfedge[c] / 2] = 0.375 * (coordinates(p[vertex[c]]) + coordinates(p[vertex[next(c)]])) +
                                               0.125 * (coordinates(p[vertex[prev(c)]]) +
                                                        coordinates(p[vertex[prev(corner[halfedge[c] + 1])]]));
        for (id first = begin; first < end; ++first) {
            const id v = vertex[first];
            if (start[v] != first)
                continue;
            coordinates ring(p[vertex[next(first)]]);
            std::size_t n = 1;
            for (id c = corner[halfedge[prev(first)] ^ 1]; c != first; c = corner[halfedge[prev(c)] ^ 1], ++n)
                ring = ring + coordinates(p[vertex[next(c)]]);
            points[v] = (1 - double(n) * beta[n]) * coordinates(p[v]) + beta[n] * ring;
        }
        for (id c = begin; c < end; ++c) {
            const id out = halfedge[c], in = halfedge[prev(c)];
            write_line<Complete>(fine, 3 * c, vertex[c], 2 * out + out % 2);
            write_line<Complete>(fine, 3 * c + 1, vertices + out / 2, 2 * (2 * edges + c));
            write_line<Complete>(fine, 3 * c + 2, vertices + in / 2, 2 * (in ^ 1) + in % 2);
            write_line<Complete>(fine, 3 * corners + c, vertices + in / 2, 2 * (2 * edges + c) + 1);
        }
    });
    if constexpr (Complete) {
        for (id v = 0; v < vertices; ++v)
            fine.vertex_corner[v] = 3 * start[v];
        for (id e = 0; e < edges; ++e)
            fine.vertex_corner[vertices + e] = 3 * corner[2 * std::size_t(e)] + 1;
    }
    return {std::move(points), std::move(fine), coarse.generation() + 1};
}

/// Refines a control mesh `levels` times; step(mesh, complete) makes one step.
template <class Step>
mesh refine(const mesh& control, int levels, bool complete, const Step& step)
{
    mesh result = control;
    for (int level = 1; level <= levels; ++level)
        result = step(result, complete or level < levels);
    return result;
}

} // namespace kith::comparison::by_hand
