// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graph_calls.hpp"

#include <kith/cgal.hpp>
#include <kith/core/mesh/mesh_traits.hpp>

#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace kith::cgal {

/// A graph whose descriptors hold numbers, such as a Surface_mesh or a mesh of OpenMesh. The half-edges of edge i have
/// the numbers 2i and 2i+1.
template <class Graph, class Traits = boost::graph_traits<Graph>>
concept numbered_graph = requires(typename Traits::vertex_descriptor v, typename Traits::halfedge_descriptor h,
                                  typename Traits::face_descriptor f) {
    { v.idx() } -> std::integral;
    { h.idx() } -> std::integral;
    { f.idx() } -> std::integral;
};

/// A table of numbers for descriptors that hold none, in the order in which the descriptors are added.
template <class Descriptor>
class number_table {
public:
    void add(const Descriptor& x) { numbers_.emplace(x, std::uint32_t(numbers_.size())); }
    [[nodiscard]] std::size_t operator[](const Descriptor& x) const
    {
        const auto found = numbers_.find(x);
        return found == numbers_.end() ? bound() : found->second; // a number that no element has
    }
    [[nodiscard]] std::size_t bound() const { return numbers_.size(); }

private:
    std::unordered_map<Descriptor, std::uint32_t> numbers_;
};
/// The numbers that descriptors hold. The numbers of removed elements may reach beyond the bound.
template <class Descriptor>
class held_numbers {
public:
    void add(const Descriptor& x) { bound_ = std::max(bound_, std::size_t(x.idx()) + 1); }
    [[nodiscard]] std::size_t operator[](const Descriptor& x) const { return std::size_t(x.idx()); }
    [[nodiscard]] std::size_t bound() const { return bound_; }

private:
    std::size_t bound_ = 0;
};

/// A view that reads any model of CGAL's FaceListGraph, with a property map of its points, as a mesh. Descriptors
/// without numbers, such as those of Polyhedron_3, are numbered in tables when the view is made, in the order of the
/// graph. Coordinates that are floats or doubles are read as arrays, so that the same code refines all these graphs.
/// Isolated vertices are left out, like removed ones.
template <class Graph, class VertexPointMap>
class face_graph {
    template <class Descriptor>
    using numbers_of = std::conditional_t<numbered_graph<Graph>, held_numbers<Descriptor>, number_table<Descriptor>>;

public:
    using vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
    using halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;
    using face = typename boost::graph_traits<Graph>::face_descriptor;
    /// An edge, known by its number. CGAL's descriptors of edges remember the half-edge by which they were requested.
    struct edge {
        std::uint32_t number = 0;
        friend bool operator==(const edge&, const edge&) = default;
    };
    using graph_point = typename boost::property_traits<VertexPointMap>::value_type;
    using number = typename CGAL::Kernel_traits<graph_point>::Kernel::FT;
    static constexpr bool has_plain_points = std::floating_point<number>;
    using point = std::conditional_t<has_plain_points, std::array<number, 3>, graph_point>;

    /// Takes a graph and a map of its points. Precondition: the graph outlives the view and does not change. Cost:
    /// O(elements).
    face_graph(const Graph& graph, VertexPointMap points) : graph_(&graph), points_(points)
    {
        using namespace graph_calls;
        std::uint32_t number = 0;
        for (const vertex v : all_vertices(graph)) {
            if (not is_alone(graph, v))
                vertices_.push_back(v), vertex_numbers_.add(v), joined_.push_back(number);
            ++number;
        }
        if (joined_.size() == number)
            joined_.clear();
        for (const face f : all_faces(graph))
            faces_.push_back(f), face_numbers_.add(f);
        for (const auto& e : all_edges(graph)) {
            halfedge h = halfedge_at(graph, e);
            if constexpr (numbered_graph<Graph>)
                if (h.idx() % 2 != 0)
                    h = opposite_of(graph, h);
            const halfedge other = opposite_of(graph, h);
            halfedge_numbers_.add(h), halfedge_numbers_.add(other);
            const std::size_t number = halfedge_numbers_[h] / 2;
            edges_.push_back({std::uint32_t(number)});
            if (number >= directing_.size())
                directing_.resize(number + 1);
            directing_[number] = h;
        }
    }

    [[nodiscard]] const Graph& graph() const { return *graph_; }
    [[nodiscard]] const std::vector<vertex>& vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<edge>& edges() const { return edges_; }
    [[nodiscard]] const std::vector<face>& faces() const { return faces_; }
    /// Returns the numbers of the vertices of this view among all vertices of the graph. The result is empty if no
    /// vertex is left out.
    [[nodiscard]] const std::vector<std::uint32_t>& joined() const { return joined_; }
    [[nodiscard]] const auto& vertex_numbers() const { return vertex_numbers_; }
    [[nodiscard]] const auto& face_numbers() const { return face_numbers_; }
    [[nodiscard]] const auto& halfedge_numbers() const { return halfedge_numbers_; }
    [[nodiscard]] halfedge directing(edge e) const { return directing_[e.number]; }

    [[nodiscard]] point read_point(vertex v) const
    {
        if constexpr (has_plain_points) {
            const graph_point p = get(points_, v);
            return {p.x(), p.y(), p.z()};
        } else {
            return get(points_, v);
        }
    }
    static graph_point to_graph(const point& p)
    {
        if constexpr (has_plain_points)
            return {p[0], p[1], p[2]};
        else
            return p;
    }

private:
    const Graph* graph_;
    VertexPointMap points_;
    std::vector<vertex> vertices_;
    std::vector<std::uint32_t> joined_;
    std::vector<edge> edges_;
    std::vector<face> faces_;
    std::vector<halfedge> directing_; ///< by the numbers of edges
    numbers_of<vertex> vertex_numbers_;
    numbers_of<face> face_numbers_;
    numbers_of<halfedge> halfedge_numbers_;
};

} // namespace kith::cgal

namespace kith {

template <class Graph, class VertexPointMap>
struct mesh_traits<cgal::face_graph<Graph, VertexPointMap>> {
    using mesh_type = cgal::face_graph<Graph, VertexPointMap>;
    using vertex = typename mesh_type::vertex;
    using edge = typename mesh_type::edge;
    using face = typename mesh_type::face;
    using halfedge = typename mesh_type::halfedge;
    using point = typename mesh_type::point;

    static const std::vector<vertex>& vertices(const mesh_type& m) { return m.vertices(); }
    static const std::vector<edge>& edges(const mesh_type& m) { return m.edges(); }
    static const std::vector<face>& faces(const mesh_type& m) { return m.faces(); }
    static std::size_t index(const mesh_type& m, vertex v) { return m.vertex_numbers()[v]; }
    static std::size_t index(const mesh_type&, edge e) { return e.number; }
    static std::size_t index(const mesh_type& m, face f) { return m.face_numbers()[f]; }
    static std::size_t index(const mesh_type& m, halfedge h) { return m.halfedge_numbers()[h]; }
    static std::size_t vertex_bound(const mesh_type& m) { return m.vertex_numbers().bound(); }
    static std::size_t edge_bound(const mesh_type& m) { return halfedge_bound(m) / 2; }
    static std::size_t face_bound(const mesh_type& m) { return m.face_numbers().bound(); }
    static std::size_t halfedge_bound(const mesh_type& m) { return m.halfedge_numbers().bound(); }

    static halfedge next(const mesh_type& m, halfedge h) { return cgal::graph_calls::next_of(m.graph(), h); }
    static halfedge prev(const mesh_type& m, halfedge h) { return cgal::graph_calls::prev_of(m.graph(), h); }
    static halfedge opposite(const mesh_type& m, halfedge h) { return cgal::graph_calls::opposite_of(m.graph(), h); }
    static bool is_boundary(const mesh_type& m, halfedge h) { return cgal::graph_calls::has_no_face(m.graph(), h); }
    static vertex source(const mesh_type& m, halfedge h) { return cgal::graph_calls::source_of(m.graph(), h); }
    static edge edge_of(const mesh_type& m, halfedge h) { return {std::uint32_t(index(m, h) / 2)}; }
    static face face_of(const mesh_type& m, halfedge h) { return cgal::graph_calls::face_beside(m.graph(), h); }
    static halfedge halfedge_of(const mesh_type& m, vertex v) // CGAL's leads to it
    {
        return opposite(m, cgal::graph_calls::halfedge_at(m.graph(), v));
    }
    static halfedge halfedge_of(const mesh_type& m, edge e) { return m.directing(e); }
    static halfedge halfedge_of(const mesh_type& m, face f) { return cgal::graph_calls::halfedge_at(m.graph(), f); }
    static bool is_isolated(const mesh_type& m, vertex v)
    {
        return cgal::graph_calls::halfedge_at(m.graph(), v) == boost::graph_traits<Graph>::null_halfedge();
    }
    static point point_of(const mesh_type& m, vertex v) { return m.read_point(v); }
};

} // namespace kith
