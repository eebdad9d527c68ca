// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/cgal.hpp>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

namespace kith::cgal::graph_calls {

// CGAL's functions on graphs, found where each library has them, under names that no class of kith has. These hide the
// classes, beside which the compiler would look for no functions.
void edge() = delete;
void face() = delete;
void target() = delete;

template <class Graph>
auto all_vertices(const Graph& g)
{
    return vertices(g);
}
template <class Graph>
auto all_edges(const Graph& g)
{
    return edges(g);
}
template <class Graph>
auto all_faces(const Graph& g)
{
    return faces(g);
}
template <class Graph, class Halfedge>
auto next_of(const Graph& g, Halfedge h)
{
    return next(h, g);
}
template <class Graph, class Halfedge>
auto prev_of(const Graph& g, Halfedge h)
{
    return prev(h, g);
}
template <class Graph, class Halfedge>
auto opposite_of(const Graph& g, Halfedge h)
{
    return opposite(h, g);
}
template <class Graph, class Halfedge>
auto source_of(const Graph& g, Halfedge h)
{
    return source(h, g);
}
template <class Graph, class Halfedge>
auto target_of(const Graph& g, Halfedge h)
{
    return target(h, g);
}
template <class Graph, class Halfedge>
auto face_beside(const Graph& g, Halfedge h)
{
    return face(h, g);
}
template <class Graph, class Element>
auto halfedge_at(const Graph& g, Element x) // of a vertex, an edge or a face
{
    return halfedge(x, g);
}
template <class Graph, class Halfedge>
auto edge_along(const Graph& g, Halfedge h)
{
    return edge(h, g);
}
template <class Graph>
bool has_no_face(const Graph& g, typename boost::graph_traits<Graph>::halfedge_descriptor h)
{
    return face(h, g) == boost::graph_traits<Graph>::null_face();
}
/// Here nor do half-edges whose face was removed, which name it still.
template <class Point>
bool has_no_face(const CGAL::Surface_mesh<Point>& m, typename CGAL::Surface_mesh<Point>::Halfedge_index h)
{
    return mesh_traits<CGAL::Surface_mesh<Point>>::is_boundary(m, h);
}

} // namespace kith::cgal::graph_calls
