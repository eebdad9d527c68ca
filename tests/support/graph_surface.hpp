// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cgal_mesh.hpp"
#include "same_surface.hpp"
#include "shapes.hpp"

#include <kith/cgal/write_face_graph.hpp>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

/// Returns the points and faces of a face graph of CGAL.
template <class Graph>
surface surface_of(const Graph& g)
{
    surface result;
    std::map<typename boost::graph_traits<Graph>::vertex_descriptor, std::size_t> number;
    for (const auto v : vertices(g)) {
        number.emplace(v, number.size());
        const auto p = get(CGAL::vertex_point, g, v);
        result.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    for (const auto f : faces(g)) {
        result.faces.emplace_back();
        for (const auto v : CGAL::vertices_around_face(halfedge(f, g), g))
            result.faces.back().push_back(number.at(v));
    }
    return result;
}

/// Returns the view through which kith reads a face graph and its points.
template <class Graph>
auto view_of(const Graph& g)
{
    const auto points = get(CGAL::vertex_point, g);
    return kith::cgal::face_graph<Graph, std::remove_const_t<decltype(points)>>(g, points);
}

/// Makes a graph of any type from a shape, by CGAL's own functions.
template <class Graph>
Graph make_graph(const shapes::shape& s)
{
    const auto mesh = user_mesh<surface_mesh<CGAL::Simple_cartesian<double>>>::make(s.points, s.faces);
    if constexpr (std::is_same_v<Graph, std::remove_const_t<decltype(mesh)>>) {
        return mesh;
    } else {
        Graph result;
        CGAL::copy_face_graph(mesh, result);
        return result;
    }
}

/// Returns a graph with the elements of `source`, with equal numbers, edge directions and first half-edges.
template <class Graph, class Source>
Graph same_graph(const Source& source)
{
    const auto native = kith::to_native(view_of(source));
    Graph result;
    kith::cgal::write_connectivity(result, native.topology(), false);
    const auto points = get(CGAL::vertex_point, result);
    std::size_t i = 0;
    for (const auto v : vertices(result)) {
        const auto& [x, y, z] = native.point(i++);
        put(points, v, typename boost::property_traits<std::remove_const_t<decltype(points)>>::value_type(x, y, z));
    }
    return result;
}
