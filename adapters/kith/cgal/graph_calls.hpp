// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/cgal.hpp>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

namespace kith::cgal::graph_calls {

// CGAL's functions on graphs, under names that no class of kith has. Each call finds the function of the graph's own
// library. The deleted functions hide kith's classes of these names; beside a class the compiler would look for no
// function.
void edge() = delete;
void face() = delete;
void target() = delete;

inline constexpr auto all_vertices = [](const auto& g) { return vertices(g); };
inline constexpr auto all_edges = [](const auto& g) { return edges(g); };
inline constexpr auto all_faces = [](const auto& g) { return faces(g); };
inline constexpr auto next_of = [](const auto& g, auto h) { return next(h, g); };
inline constexpr auto prev_of = [](const auto& g, auto h) { return prev(h, g); };
inline constexpr auto opposite_of = [](const auto& g, auto h) { return opposite(h, g); };
inline constexpr auto source_of = [](const auto& g, auto h) { return source(h, g); };
inline constexpr auto target_of = [](const auto& g, auto h) { return target(h, g); };
inline constexpr auto face_beside = [](const auto& g, auto h) { return face(h, g); };
inline constexpr auto edge_along = [](const auto& g, auto h) { return edge(h, g); };
inline constexpr auto halfedge_at = [](const auto& g, auto element) { return halfedge(element, g); };

template <class Graph>
bool has_no_face(const Graph& g, typename boost::graph_traits<Graph>::halfedge_descriptor h)
{
    return face(h, g) == boost::graph_traits<Graph>::null_face();
}
/// Returns true if a half-edge of a Surface_mesh has no face, or refers to a face that was removed.
template <class Point>
bool has_no_face(const CGAL::Surface_mesh<Point>& m, typename CGAL::Surface_mesh<Point>::Halfedge_index h)
{
    return mesh_traits<CGAL::Surface_mesh<Point>>::is_boundary(m, h);
}

/// Returns true if no edge leads to the vertex.
inline constexpr auto is_alone = []<class Graph>(const Graph& g, auto v) {
    return halfedge(v, g) == boost::graph_traits<Graph>::null_halfedge();
};

} // namespace kith::cgal::graph_calls
