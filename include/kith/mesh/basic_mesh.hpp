// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_traits.hpp"

#include <kith/base/counts.hpp>
#include <kith/base/error.hpp>
#include <kith/base/storage.hpp>

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ranges>
#include <span>
#include <utility>

namespace kith {

/// The connectivity of a mesh as flat arrays of indices, corner by corner.
///
/// A *corner* is a vertex in a face; it stands for the half-edge that leaves the vertex inside the face, too. The
/// corners of a face are contiguous and counter-clockwise. Half-edge 2e+s is side s of edge e; the side of a boundary
/// edge that has no face is always side 1 and has no corner. Everything else is arithmetic on these arrays:
/// the corner across an edge is halfedge_corner[corner_halfedge[c] ^ 1].
template <std::unsigned_integral Index>
struct connectivity {
    static constexpr Index none = std::numeric_limits<Index>::max();

    std::size_t vertices = 0;
    std::size_t faces = 0;
    int degree = 0;                 ///< of all faces alike; 0: mixed, see face_corner
    storage<Index> corner_vertex;   ///< per corner
    storage<Index> corner_halfedge; ///< per corner: 2e+s
    storage<Index> halfedge_corner; ///< two per edge
    storage<Index> vertex_corner;   ///< per vertex: where its fan starts; at the boundary the side without neighbour
    storage<Index> face_corner;     ///< mixed only, faces+1: the first corner of each face
    storage<Index> corner_face;     ///< mixed only

    [[nodiscard]] std::size_t corners() const { return corner_vertex.size(); }
    [[nodiscard]] std::size_t edges() const { return halfedge_corner.size() / 2; }
    /// Face-vertex lists only: the last level of a refinement, when nobody asked for more.
    [[nodiscard]] bool faces_only() const { return corner_halfedge.empty() and corners() != 0; }
    [[nodiscard]] Index first_corner(std::size_t face) const
    {
        return degree != 0 ? Index(face * degree) : face_corner[face];
    }
};

/// Counts of a mesh, with the boundary classes. Cost: one pass over the edges and over the boundary fans.
template <std::unsigned_integral Index>
counts count(const connectivity<Index>& mesh)
{
    counts result{.vertices = mesh.vertices, .edges = mesh.edges(), .faces = mesh.faces};
    const auto prev = [&](Index c) {
        if (mesh.degree != 0)
            return Index(c % mesh.degree == 0 ? c + mesh.degree - 1 : c - 1);
        const Index f = mesh.corner_face[c];
        return c == mesh.face_corner[f] ? Index(mesh.face_corner[f + 1] - 1) : Index(c - 1);
    };
    for (std::size_t e = 0; e < mesh.edges(); ++e) {
        if (mesh.halfedge_corner[2 * e + 1] != mesh.none)
            continue;
        ++result.boundary_edges;
        std::uint64_t fan = 0; // each boundary edge starts the fan of exactly one boundary vertex
        for (Index c = mesh.halfedge_corner[2 * e]; c != mesh.none;
             c = mesh.halfedge_corner[mesh.corner_halfedge[prev(c)] ^ 1])
            ++fan;
        result.boundary_corners += fan;
        result.boundary_vertices_of_one_face += fan == 1;
        result.boundary_vertices_of_many_faces += fan >= 3;
    }
    return result;
}

/// kith's own mesh: points and connectivity, structure of arrays. Made from face lists by `make_mesh`, by refining,
/// or by `lift` from any other mesh. Cheap to move, deep to copy, never changed by the library once it is made.
template <class Point = std::array<double, 3>, std::unsigned_integral Index = std::uint32_t>
class basic_mesh {
public:
    using point_type = Point;
    using index_type = Index;

    basic_mesh() = default;
    /// Preconditions: the arrays belong together; `make_mesh` is the function that checks.
    basic_mesh(storage<Point> points, connectivity<Index> topology, int generation = 0)
        : points_(std::move(points)), topology_(std::move(topology)), generation_(generation)
    {
    }

    [[nodiscard]] std::size_t vertex_count() const { return topology_.vertices; }
    [[nodiscard]] std::size_t edge_count() const { return topology_.edges(); }
    [[nodiscard]] std::size_t face_count() const { return topology_.faces; }
    [[nodiscard]] std::size_t corner_count() const { return topology_.corners(); }

    [[nodiscard]] std::span<const Point> points() const { return {points_.data(), points_.size()}; }
    [[nodiscard]] std::span<Point> points() { return {points_.data(), points_.size()}; }
    [[nodiscard]] const Point& point(std::size_t vertex) const { return points_[vertex]; }

    /// The vertices of a face, counter-clockwise.
    [[nodiscard]] std::span<const Index> face(std::size_t face) const
    {
        const Index first = topology_.first_corner(face);
        return {topology_.corner_vertex.data() + first, topology_.first_corner(face + 1) - first};
    }

    [[nodiscard]] const connectivity<Index>& topology() const { return topology_; }
    /// Subdivision steps since the control mesh: sqrt(3) refines its boundary at every second one.
    [[nodiscard]] int generation() const { return generation_; }

private:
    storage<Point> points_;
    connectivity<Index> topology_;
    int generation_ = 0;
};

/// An element of a basic_mesh, by number.
template <class Kind, std::unsigned_integral Index>
struct element_id {
    Index value = std::numeric_limits<Index>::max();

    friend constexpr auto operator<=>(const element_id&, const element_id&) = default;
};

template <class Point, std::unsigned_integral Index>
struct mesh_traits<basic_mesh<Point, Index>> {
    using mesh_type = basic_mesh<Point, Index>;
    using vertex = element_id<struct vertex_kind, Index>;
    using edge = element_id<struct edge_kind, Index>;
    using face = element_id<struct face_kind, Index>;
    using halfedge = element_id<struct halfedge_kind, Index>;
    using point = Point;

    static auto vertices(const mesh_type& m) { return all<vertex>(m.vertex_count()); }
    static auto edges(const mesh_type& m) { return all<edge>(m.edge_count()); }
    static auto faces(const mesh_type& m) { return all<face>(m.face_count()); }
    template <class Kind>
    static std::size_t index(const mesh_type&, element_id<Kind, Index> x)
    {
        return x.value;
    }
    static std::size_t vertex_bound(const mesh_type& m) { return m.vertex_count(); }
    static std::size_t edge_bound(const mesh_type& m) { return m.edge_count(); }
    static std::size_t face_bound(const mesh_type& m) { return m.face_count(); }
    static std::size_t halfedge_bound(const mesh_type& m) { return 2 * m.edge_count(); }

    static halfedge next(const mesh_type& m, halfedge h) { return step(m, h, 1); }
    static halfedge prev(const mesh_type& m, halfedge h) { return step(m, h, -1); }
    static halfedge opposite(const mesh_type&, halfedge h) { return {Index(h.value ^ 1)}; }
    static bool is_boundary(const mesh_type& m, halfedge h)
    {
        return m.topology().halfedge_corner[h.value] == connectivity<Index>::none;
    }
    static vertex source(const mesh_type& m, halfedge h)
    {
        const auto& t = m.topology();
        if (not is_boundary(m, h))
            return {t.corner_vertex[t.halfedge_corner[h.value]]};
        return source(m, next(m, opposite(m, h)));
    }
    static edge edge_of(const mesh_type&, halfedge h) { return {Index(h.value / 2)}; }
    static face face_of(const mesh_type& m, halfedge h)
    {
        const auto& t = m.topology();
        const Index c = t.halfedge_corner[h.value];
        return {t.degree != 0 ? Index(c / t.degree) : t.corner_face[c]};
    }
    static halfedge halfedge_of(const mesh_type& m, vertex v)
    {
        return {m.topology().corner_halfedge[m.topology().vertex_corner[v.value]]};
    }
    static halfedge halfedge_of(const mesh_type&, edge e) { return {Index(2 * e.value)}; }
    static halfedge halfedge_of(const mesh_type& m, face f)
    {
        return {m.topology().corner_halfedge[m.topology().first_corner(f.value)]};
    }
    static bool is_isolated(const mesh_type& m, vertex v)
    {
        return m.topology().vertex_corner[v.value] == connectivity<Index>::none;
    }
    static const Point& point_of(const mesh_type& m, vertex v) { return m.point(v.value); }
    static Point* points(mesh_type& m) { return m.points().data(); }
    static int generation(const mesh_type& m) { return m.generation(); }
    static mesh_type build(mesh_type&& fine) { return std::move(fine); }

private:
    template <class Id>
    static auto all(std::size_t size)
    {
        return std::views::iota(std::size_t(0), size) |
               std::views::transform([](std::size_t i) { return Id{Index(i)}; });
    }
    static halfedge step(const mesh_type& m, halfedge h, int by)
    {
        const auto& t = m.topology();
        const face f = face_of(m, h);
        const Index first = t.first_corner(f.value);
        const Index degree = t.first_corner(f.value + 1) - first;
        return {t.corner_halfedge[first + (t.halfedge_corner[h.value] - first + degree + by) % degree]};
    }
};

} // namespace kith
