// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using mesh = CGAL::Surface_mesh<kernel::Point_3>;

/// Makes a cube with a label and the whole texture on each face, so that all edges are seams. The edges around the top
/// are constrained.
inline mesh dressed_cube()
{
    mesh cube;
    const auto at = [](int x, int y, int z) { return kernel::Point_3(x, y, z); };
    CGAL::make_hexahedron(
        at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), cube);
    auto colour = cube.add_property_map<mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
    auto texture = cube.add_property_map<mesh::Halfedge_index, kernel::Point_2>("h:uv").first;
    auto label = cube.add_property_map<mesh::Face_index, std::string>("f:label").first;
    auto constrained = cube.add_property_map<mesh::Edge_index, bool>("e:is_constrained", false).first;
    const auto is_top = [&](auto v) { return cube.point(v).z() == 1; };
    for (const auto v : cube.vertices())
        colour[v] = is_top(v) ? CGAL::IO::Color(255, 0, 0) : CGAL::IO::Color(0, 0, 255);
    for (const auto f : cube.faces()) {
        label[f] = "side " + std::to_string(f);
        int corner = 0;
        for (const auto h : cube.halfedges_around_face(cube.halfedge(f)))
            texture[h] = kernel::Point_2(corner == 1 or corner == 2, corner / 2), ++corner;
    }
    for (const auto e : cube.edges())
        constrained[e] = is_top(cube.vertex(e, 0)) and is_top(cube.vertex(e, 1));
    return cube;
}

/// Returns true if a cube that was refined three times still has all values, and the whole texture on each side.
inline bool is_dressed(mesh smooth)
{
    const auto label = smooth.add_property_map<mesh::Face_index, std::string>("f:label").first;
    const auto texture = smooth.add_property_map<mesh::Halfedge_index, kernel::Point_2>("h:uv").first;
    const auto constrained = smooth.add_property_map<mesh::Edge_index, bool>("e:is_constrained").first;
    const auto colour = smooth.add_property_map<mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
    const auto first = *smooth.faces().begin();
    std::cout << label[first] << " has " << colour[smooth.target(smooth.halfedge(first))] << " at "
              << texture[smooth.halfedge(first)] << '\n';
    std::size_t sharp = 0, on_side_0 = 0;
    for (const auto e : smooth.edges())
        sharp += constrained[e];
    for (const auto f : smooth.faces())
        on_side_0 += label[f] == "side 0";
    bool is_mixed = true; // colours mix red and blue
    for (const auto v : smooth.vertices())
        is_mixed = is_mixed and std::abs(colour[v].red() + colour[v].blue() - 255) <= 1 and colour[v].green() == 0;
    double area = 0; // total area of the texture
    for (const auto f : smooth.faces()) {
        const auto h = smooth.halfedge(f), opposite = smooth.next(smooth.next(h));
        area += kernel::Vector_2(texture[h], texture[opposite]).squared_length() / 2;
    }
    return sharp == 4 * 8 and on_side_0 == 64 and is_mixed and std::abs(area - 6) < 1e-12;
}
