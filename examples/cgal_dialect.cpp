// SPDX-License-Identifier: BSD-3-Clause
// Runs a CGAL user's calls with kith::cgal instead of CGAL::Subdivision_method_3. Constrained edges stay sharp,
// property maps are carried along, and the user's own mask is called. See docs/start/cgal.md.
// Sample run: cgal_dialect

#include <kith/cgal_subdivision.hpp>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>

using kernel = CGAL::Simple_cartesian<double>;
using point = kernel::Point_3;
using mesh = CGAL::Surface_mesh<point>;
namespace params = CGAL::parameters;

/// A mask in the form that CGAL's PTQ takes: it moves midpoints outwards onto the unit sphere.
struct inflate {
    const mesh& m;

    void edge_node(mesh::Halfedge_index h, point& p) const
    {
        const auto middle = CGAL::midpoint(m.point(m.source(h)), m.point(m.target(h)));
        p = CGAL::ORIGIN + (middle - CGAL::ORIGIN) / std::sqrt((middle - CGAL::ORIGIN).squared_length());
    }
    void vertex_node(mesh::Vertex_index v, point& p) const { p = m.point(v); }
    void border_node(mesh::Halfedge_index h, point& on_edge, point& at_target) const
    {
        edge_node(h, on_edge);
        at_target = m.point(m.target(h));
    }
};

int main()
{
    mesh pmesh;
    CGAL::make_tetrahedron(point(1, 1, 1), point(1, -1, -1), point(-1, 1, -1), point(-1, -1, 1), pmesh);
    CGAL::Polyhedron_3<kernel> polyhedron;
    CGAL::make_tetrahedron(point(1, 1, 1), point(1, -1, -1), point(-1, 1, -1), point(-1, -1, 1), polyhedron);
    mesh ball = pmesh;
    for (const auto v : ball.vertices())
        ball.point(v) = CGAL::ORIGIN + (ball.point(v) - CGAL::ORIGIN) / std::sqrt(3.);

    auto sharp = pmesh.add_property_map<mesh::Edge_index, bool>("e:sharp", false).first;
    auto material = pmesh.add_property_map<mesh::Face_index, std::string>("f:material", "wood").first;
    sharp[mesh::Edge_index(0)] = true;
    material[mesh::Face_index(1)] = "glass";

    kith::cgal::Loop_subdivision(pmesh, params::number_of_iterations(3).edge_is_constrained_map(sharp));

    std::size_t creases = 0, glass = 0;
    for (const auto e : pmesh.edges())
        creases += sharp[e];
    for (const auto f : pmesh.faces())
        glass += material[f] == "glass";
    std::cout << pmesh.number_of_faces() << " faces, " << glass << " of glass; " << creases << " sharp edges\n";

    kith::cgal::Loop_subdivision(polyhedron, params::number_of_iterations(3)); // any face graph
    kith::cgal::PTQ(ball, inflate{ball}, params::number_of_iterations(3));     // a mask written for CGAL
    double farthest = 0;
    for (const auto v : ball.vertices())
        farthest = std::max(farthest, std::abs((ball.point(v) - CGAL::ORIGIN).squared_length() - 1));
    std::cout << polyhedron.size_of_facets() << " faces of the polyhedron; a ball, to " << farthest << '\n';
    return creases == 8 and glass == 64 and polyhedron.size_of_facets() == 256 and farthest < 1e-12 ? 0 : 1;
}
