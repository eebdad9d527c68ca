// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_graph.hpp"

#include <kith/in_place/join_elements.hpp>

#include <CGAL/Surface_mesh/Surface_mesh.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace kith::cgal {

/// The elements of a graph in the order of the native mesh that was written into it. A graph need not list them so:
/// one that makes new elements of removed ones, such as a Linear_cell_complex, has some before old ones.
template <class Vertices, class Edges>
struct written_elements {
    Vertices vertices;
    Edges edges;
};

namespace detail {

/// A graph whose elements hold values of their own, such as a Polyhedron_3: what a vertex, an edge or a face has is not
/// what another should have.
template <class Graph>
concept has_items = requires { typename Graph::HalfedgeDS; };

/// A graph whose elements have their values in arrays, such as a mesh of OpenMesh: what these grow by is new.
template <class Graph>
concept has_arrays = requires(Graph& g, std::size_t n) {
    g.resize(n, n, n);
    { g.n_vertices() } -> std::convertible_to<std::size_t>;
    g.face_colors_pph();
};

/// Makes zero what OpenMesh leaves open in new elements: its vectors, on all but the first vertices.
template <has_arrays Graph>
void clear_vectors(Graph& g, std::size_t vertices_to_keep)
{
    const auto clear = [&](bool is_there, auto property, std::size_t first) {
        if (not is_there)
            return;
        auto& values = g.property(property).data_vector();
        for (std::size_t i = first; i < values.size(); ++i)
            values[i].vectorize(0);
    };
    clear(g.has_vertex_normals(), g.vertex_normals_pph(), vertices_to_keep);
    clear(g.has_vertex_colors(), g.vertex_colors_pph(), vertices_to_keep);
    clear(g.has_vertex_texcoords2D(), g.vertex_texcoords2D_pph(), vertices_to_keep);
    clear(g.has_vertex_texcoords3D(), g.vertex_texcoords3D_pph(), vertices_to_keep);
    clear(g.has_halfedge_normals(), g.halfedge_normals_pph(), 0);
    clear(g.has_halfedge_colors(), g.halfedge_colors_pph(), 0);
    clear(g.has_halfedge_texcoords2D(), g.halfedge_texcoords2D_pph(), 0);
    clear(g.has_halfedge_texcoords3D(), g.halfedge_texcoords3D_pph(), 0);
    clear(g.has_edge_colors(), g.edge_colors_pph(), 0);
    clear(g.has_face_normals(), g.face_normals_pph(), 0);
    clear(g.has_face_colors(), g.face_colors_pph(), 0);
}

/// As many descriptors as are asked for: of those that the graph has at most `kept`, while the others are removed, and
/// new ones.
template <class Descriptor, class Add, class Remove>
void resize(std::vector<Descriptor>& all, std::size_t kept, std::size_t size, const Add& add, const Remove& remove)
{
    while (all.size() > std::min(kept, size)) {
        remove(all.back());
        all.pop_back();
    }
    all.reserve(size);
    while (all.size() < size)
        all.push_back(add());
}

/// Makes elements of those that were removed, so that no count or list of them is left. Clearing the mesh would do so,
/// too, with all that property maps hold.
template <class Point>
void take_back_removed(CGAL::Surface_mesh<Point>& m)
{
    const bool recycles = m.does_recycle_garbage();
    m.set_recycle_garbage(true);
    for (auto left = m.number_of_removed_vertices(); left > 0; --left)
        m.add_vertex();
    for (auto left = m.number_of_removed_edges(); left > 0; --left)
        m.add_edge();
    for (auto left = m.number_of_removed_faces(); left > 0; --left)
        m.add_face();
    m.set_recycle_garbage(recycles);
}

} // namespace detail

/// Overwrites any model of MutableFaceGraph with these elements. Descriptors that are there are used again, in their
/// order, those of vertices, edges and faces from 0 on, and new ones are added; where elements hold values, only
/// those of vertices that are to keep them, and in a mesh of OpenMesh all other elements have T() or zero as new ones
/// do, but that vectors in properties of the user's own may be open. Points are not written. Cost: O(elements).
template <class Graph>
auto write_connectivity(Graph& g, const connectivity<std::uint32_t>& t, bool keeps_vertices)
{
    using traits = boost::graph_traits<Graph>;
    using halfedge = typename traits::halfedge_descriptor;
    using namespace graph_calls;
    const auto list = [](const auto& range) {
        return std::vector<typename std::iterator_traits<decltype(range.begin())>::value_type>(range.begin(),
                                                                                               range.end());
    };
    [[maybe_unused]] std::size_t vertices_to_keep = 0;
    if constexpr (detail::has_arrays<Graph>) {
        vertices_to_keep = keeps_vertices ? std::size_t(g.n_vertices()) : 0;
        g.resize(vertices_to_keep, 0, 0);
        g.resize(vertices_to_keep, t.edges(), t.faces);
    }
    auto vertices = list(all_vertices(g));
    auto edges = list(all_edges(g));
    auto faces = list(all_faces(g));
    constexpr std::size_t all = std::numeric_limits<std::size_t>::max(), kept = detail::has_items<Graph> ? 0 : all;
    detail::resize(
        vertices,
        keeps_vertices ? all : kept,
        t.vertices,
        [&] { return add_vertex(g); },
        [&](auto v) { remove_vertex(v, g); });
    detail::resize(edges, kept, t.edges(), [&] { return add_edge(g); }, [&](auto e) { remove_edge(e, g); });
    detail::resize(faces, kept, t.faces, [&] { return add_face(g); }, [&](auto f) { remove_face(f, g); });

    if constexpr (detail::has_arrays<Graph>)
        detail::clear_vectors(g, vertices_to_keep);

    std::vector<halfedge> halfedges;
    halfedges.reserve(2 * edges.size());
    for (const auto& e : edges) {
        const halfedge h = halfedge_at(g, e);
        halfedges.push_back(h);
        halfedges.push_back(opposite_of(g, h));
    }
    std::vector<std::uint32_t> leaving(t.vertices); // the half-edge without face that leaves a vertex
    for (std::size_t f = 0; f < t.faces; ++f) {
        const std::size_t first = t.first_corner(f), end = t.first_corner(f + 1);
        for (std::size_t c = first; c < end; ++c) {
            const std::size_t next = c + 1 == end ? first : c + 1;
            const std::uint32_t number = t.corner_halfedge[c], beyond = number ^ 1;
            const halfedge h = halfedges[number];
            set_face(h, faces[f], g);
            set_target(h, vertices[t.corner_vertex[next]], g);
            set_next(h, halfedges[t.corner_halfedge[next]], g);
            if (t.halfedge_corner[beyond] == t.none) {
                set_face(halfedges[beyond], traits::null_face(), g);
                set_target(halfedges[beyond], vertices[t.corner_vertex[c]], g);
                leaving[t.corner_vertex[next]] = beyond;
            }
        }
        set_halfedge(faces[f], halfedges[t.corner_halfedge[first]], g);
    }
    for (std::size_t c = 0; c < t.corners(); ++c)
        if (const std::uint32_t beyond = t.corner_halfedge[c] ^ 1; t.halfedge_corner[beyond] == t.none)
            set_next(halfedges[beyond], halfedges[leaving[t.corner_vertex[c]]], g);
    for (std::size_t v = 0; v < t.vertices; ++v) // CGAL's half-edge of a vertex comes in
        set_halfedge(vertices[v], halfedges[t.corner_halfedge[t.vertex_corner[v]] ^ 1], g);
    return written_elements{std::move(vertices), std::move(edges)};
}

/// The same in bulk. Vertices keep their indices if they are to, and removed ones stay removed; edges and faces are
/// numbered from 0 on. Property maps stay, with their defaults on all edges, half-edges, faces and new vertices.
template <class Point>
auto write_connectivity(CGAL::Surface_mesh<Point>& m, const connectivity<std::uint32_t>& t, bool keeps_vertices)
{
    using mesh = CGAL::Surface_mesh<Point>;
    using vertex = typename mesh::Vertex_index;
    using size = typename mesh::size_type;
    std::vector<vertex> handles, removed;
    if (keeps_vertices)
        for (size v = 0; v < m.num_vertices(); ++v)
            (m.is_removed(vertex(v)) ? removed : handles).push_back(vertex(v));
    const std::size_t bound = handles.size() + removed.size();
    for (std::size_t v = handles.size(); v < t.vertices; ++v)
        handles.emplace_back(size(v + removed.size()));
    const bool has_garbage = m.has_garbage();
    detail::take_back_removed(m);
    m.resize(size(bound), 0, 0);
    m.resize(size(t.vertices + removed.size()), size(t.edges()), size(t.faces));
    mesh_traits<mesh>::forget_generation(m);
    for (const vertex v : removed)
        m.remove_vertex(v);
    in_place::join_elements(m, t, [&](std::size_t v) { return handles[v]; });
    if (has_garbage and removed.empty())
        m.collect_garbage(); // there is none any more, which it does not know yet
    return written_elements{m.vertices(), m.edges()};
}

} // namespace kith::cgal
