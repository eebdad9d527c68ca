// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "connectivity.hpp"
#include "mesh_traits.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/base/storage.hpp>

#include <algorithm>
#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ranges>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

/// The native mesh of kith: points and connectivity as a structure of arrays. It is made from face lists by
/// `make_mesh`, by refining, or by `to_native` from any other mesh. It is cheap to move, deep to copy, and never
/// changed by the library once it is made.
template <class Point = std::array<double, 3>, std::unsigned_integral Index = std::uint32_t>
class basic_mesh {
public:
    using point_type = Point;
    using index_type = Index;

    basic_mesh() = default;
    /// Takes the arrays of a mesh. Precondition: the arrays belong together; `make_mesh` is the function that checks
    /// them.
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

    /// Returns the vertices of a face, counter-clockwise.
    [[nodiscard]] std::span<const Index> face(std::size_t face) const
    {
        const std::size_t first = topology_.first_corner(face), end = topology_.first_corner(face + 1);
        return {topology_.corner_vertex.data() + first, end - first};
    }

    /// Returns the faces as a range; its elements are those that face(i) returns.
    [[nodiscard]] auto faces() const
    {
        return std::views::iota(std::size_t(0), face_count()) |
               std::views::transform([this](std::size_t i) { return face(i); });
    }
    /// Returns the faces in a type of the caller: faces_as<std::array<int, 4>>(), faces_as<std::vector<int>>().
    /// Errors: mesh_error for a face whose degree differs from the size of an array.
    template <class Face>
    [[nodiscard]] std::vector<Face> faces_as() const
    {
        std::vector<Face> result;
        result.reserve(face_count());
        for (const auto vertices : faces()) {
            if constexpr (requires { std::tuple_size<Face>::value; }) {
                Face& made = result.emplace_back();
                if (vertices.size() != made.size())
                    throw mesh_error("face " + std::to_string(result.size() - 1) + " has " +
                                     std::to_string(vertices.size()) + " vertices, not " + std::to_string(made.size()) +
                                     "; take faces_as<std::vector<int>>(), or triangulate the mesh first");
                std::ranges::transform(vertices, made.begin(), [](Index v) { return typename Face::value_type(v); });
            } else {
                result.emplace_back(vertices.begin(), vertices.end());
            }
        }
        return result;
    }

    [[nodiscard]] const connectivity<Index>& topology() const { return topology_; }
    /// Returns the number of subdivision steps since the control mesh. Sqrt(3) needs it, since it refines its boundary
    /// in every second step.
    [[nodiscard]] int generation() const { return generation_; }

private:
    storage<Point> points_;
    connectivity<Index> topology_;
    int generation_ = 0;
};

/// The handle of an element of a basic_mesh: its number.
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

    static halfedge next(const mesh_type& m, halfedge h) { return halfedge_at(m, m.topology().next(corner(m, h))); }
    static halfedge prev(const mesh_type& m, halfedge h) { return halfedge_at(m, m.topology().prev(corner(m, h))); }
    static halfedge opposite(const mesh_type&, halfedge h) { return {Index(h.value ^ 1)}; }
    static bool is_boundary(const mesh_type& m, halfedge h) { return corner(m, h) == connectivity<Index>::none; }
    static vertex source(const mesh_type& m, halfedge h)
    {
        if (not is_boundary(m, h))
            return {m.topology().corner_vertex[corner(m, h)]};
        return {m.topology().target(corner(m, opposite(m, h)))};
    }
    static edge edge_of(const mesh_type&, halfedge h) { return {Index(h.value / 2)}; }
    static face face_of(const mesh_type& m, halfedge h) { return {m.topology().face_of(corner(m, h))}; }
    /// Returns the half-edge at which a vertex starts. If the vertex starts at no corner of the mesh, the result is no
    /// half-edge of the mesh either.
    static halfedge halfedge_of(const mesh_type& m, vertex v)
    {
        const Index start = m.topology().vertex_corner[v.value];
        return start < m.topology().corners() ? halfedge_at(m, start) : halfedge{connectivity<Index>::none};
    }
    static halfedge halfedge_of(const mesh_type&, edge e) { return {Index(2 * e.value)}; }
    static halfedge halfedge_of(const mesh_type& m, face f)
    {
        return halfedge_at(m, m.topology().first_corner(f.value));
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
    static Index corner(const mesh_type& m, halfedge h) { return m.topology().halfedge_corner[h.value]; }
    static halfedge halfedge_at(const mesh_type& m, Index corner) { return {m.topology().corner_halfedge[corner]}; }
};

} // namespace kith
