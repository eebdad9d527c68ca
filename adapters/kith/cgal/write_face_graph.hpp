// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_graph.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace kith::cgal {

/// The elements of a graph in the order of the native mesh that was written into it. The graph may list them in another
/// order: a graph that makes new elements of removed ones, such as a Linear_cell_complex, lists some before old ones.
template <class Vertices, class Edges>
struct written_elements {
    Vertices vertices;
    Edges edges;
};

namespace detail {

/// A graph whose elements hold their own values, such as a Polyhedron_3. An element must not get the values of another
/// one.
template <class Graph>
concept has_items = requires { typename Graph::HalfedgeDS; };

/// A graph whose elements have their values in arrays, such as a mesh of OpenMesh. Arrays that grow get the values of
/// new elements.
template <class Graph>
concept has_arrays = requires(Graph& g, std::size_t n) {
    g.resize(n, n, n);
    { g.n_vertices() } -> std::convertible_to<std::size_t>;
    g.face_colors_pph();
};

/// Sets the vectors that OpenMesh leaves unset in new elements to zero. The first `vertices_to_keep` vertices keep
/// theirs.
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

/// A list of `size` elements of a graph: at most `kept` of the existing ones, and new ones. Until commit(), which
/// removes the surplus elements, the graph has all of them. Without commit() the destructor removes the new ones.
template <class Descriptor, class Add, class Remove>
class resized_elements {
public:
    resized_elements(std::vector<Descriptor> all, std::size_t kept, std::size_t size, const Add& add,
                     const Remove& remove)
        : all_(std::move(all)), remove_(remove), kept_(std::min({all_.size(), kept, size}))
    {
        surplus_.assign(all_.begin() + std::ptrdiff_t(kept_), all_.end());
        all_.resize(kept_);
        all_.reserve(size);
        try {
            while (all_.size() < size)
                all_.push_back(add());
        } catch (...) {
            remove_new();
            throw;
        }
    }
    resized_elements(const resized_elements&) = delete;
    resized_elements& operator=(const resized_elements&) = delete;
    ~resized_elements()
    {
        if (not is_committed_)
            remove_new();
    }

    [[nodiscard]] const std::vector<Descriptor>& all() const { return all_; }
    /// Removes from the graph the elements that are not in all(). Returns the others.
    std::vector<Descriptor> commit()
    {
        is_committed_ = true;
        for (; not surplus_.empty(); surplus_.pop_back())
            remove_(surplus_.back());
        return std::move(all_);
    }

private:
    void remove_new()
    {
        for (; all_.size() > kept_; all_.pop_back())
            remove_(all_.back());
    }

    std::vector<Descriptor> all_, surplus_;
    Remove remove_;
    std::size_t kept_;
    bool is_committed_ = false;
};

} // namespace detail

/// Overwrites any model of MutableFaceGraph with these elements. Existing descriptors of vertices, edges and faces are
/// used again in their order, from 0 on, and new ones are added. If elements hold values, only vertices that are to
/// keep their values are used again. In a mesh of OpenMesh all other elements get T() or zero, like new ones; vectors
/// in the user's own properties may be unset. Isolated vertices stay. Points are not written. If an element cannot be
/// added, the graph is unchanged, except a mesh of OpenMesh. Cost: O(elements).
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
    constexpr std::size_t all = std::numeric_limits<std::size_t>::max(), kept = detail::has_items<Graph> ? 0 : all;
    auto joined = list(all_vertices(g));
    std::erase_if(joined, [&](auto v) { return is_alone(g, v); });
    [[maybe_unused]] std::size_t vertices_to_keep = 0;
    if constexpr (detail::has_arrays<Graph>) {
        if (keeps_vertices)
            vertices_to_keep = std::size_t(g.n_vertices());
        else
            joined.clear();
        g.resize(vertices_to_keep, 0, 0);
        g.resize(vertices_to_keep, t.edges(), t.faces);
    }
    detail::resized_elements vertices(
        std::move(joined),
        keeps_vertices ? all : kept,
        t.vertices,
        [&] { return add_vertex(g); },
        [&](auto v) { remove_vertex(v, g); });
    detail::resized_elements edges(
        list(all_edges(g)), kept, t.edges(), [&] { return add_edge(g); }, [&](auto e) { remove_edge(e, g); });
    detail::resized_elements faces(
        list(all_faces(g)), kept, t.faces, [&] { return add_face(g); }, [&](auto f) { remove_face(f, g); });

    std::vector<halfedge> halfedges;
    halfedges.reserve(2 * t.edges());
    for (const auto& e : edges.all()) {
        const halfedge h = halfedge_at(g, e);
        halfedges.push_back(h);
        halfedges.push_back(opposite_of(g, h));
    }
    std::vector<std::uint32_t> leaving(t.vertices); // by vertex, the half-edge without face that leaves it
    const auto new_vertices = vertices.commit();
    const auto new_edges = edges.commit();
    const auto new_faces = faces.commit();
    if constexpr (detail::has_arrays<Graph>)
        detail::clear_vectors(g, vertices_to_keep);
    for (std::size_t f = 0; f < t.faces; ++f) {
        const std::size_t first = t.first_corner(f), end = t.first_corner(f + 1);
        for (std::size_t c = first; c < end; ++c) {
            const std::size_t next = c + 1 == end ? first : c + 1;
            const std::uint32_t number = t.corner_halfedge[c], beyond = number ^ 1;
            const halfedge h = halfedges[number];
            set_face(h, new_faces[f], g);
            set_target(h, new_vertices[t.corner_vertex[next]], g);
            set_next(h, halfedges[t.corner_halfedge[next]], g);
            if (t.halfedge_corner[beyond] == t.none) {
                set_face(halfedges[beyond], traits::null_face(), g);
                set_target(halfedges[beyond], new_vertices[t.corner_vertex[c]], g);
                leaving[t.corner_vertex[next]] = beyond;
            }
        }
        set_halfedge(new_faces[f], halfedges[t.corner_halfedge[first]], g);
    }
    for (std::size_t c = 0; c < t.corners(); ++c)
        if (const std::uint32_t beyond = t.corner_halfedge[c] ^ 1; t.halfedge_corner[beyond] == t.none)
            set_next(halfedges[beyond], halfedges[leaving[t.corner_vertex[c]]], g);
    for (std::size_t v = 0; v < t.vertices; ++v) // CGAL's half-edge of a vertex leads to it
        set_halfedge(new_vertices[v], halfedges[t.corner_halfedge[t.vertex_corner[v]] ^ 1], g);
    return written_elements{new_vertices, new_edges};
}

} // namespace kith::cgal
