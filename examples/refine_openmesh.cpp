// SPDX-License-Identifier: BSD-3-Clause
// Refines a mesh of OpenMesh and keeps all levels. Asks for relations between their elements by OpenMesh's own handles,
// then saves the levels and loads them again. Sample run: refine_openmesh

#include <kith/hierarchy.hpp>
#include <kith/loop.hpp>
#include <kith/openmesh.hpp>
#include <kith/saved_levels.hpp>

#include <iostream>
#include <sstream>

int main()
{
    using mesh = OpenMesh::TriMesh_ArrayKernelT<>;
    mesh tetrahedron;
    const auto a = tetrahedron.add_vertex({1, 1, 1}), b = tetrahedron.add_vertex({1, -1, -1}),
               c = tetrahedron.add_vertex({-1, 1, -1}), d = tetrahedron.add_vertex({-1, -1, 1});
    for (const auto& face : {std::array{a, b, c}, std::array{a, c, d}, std::array{a, d, b}, std::array{b, d, c}})
        tetrahedron.add_face(face[0], face[1], face[2]);

    using namespace kith::targets;
    kith::hierarchy<mesh, kith::loop> levels(tetrahedron);
    levels.refine(3);

    const OpenMesh::EdgeHandle edge(0);
    const OpenMesh::VertexHandle child = levels.assoc(0, edge, V); // the vertex of level 1 that edge 0 made
    const auto parents = levels.origin(1, child);                  // and from the vertex back to the edge
    std::cout << "edge 0 -> vertex " << child << " at " << levels[1].point(child) << ", born of edge " << *parents.e
              << '\n';

    OpenMesh::FaceHandle face(100); // goes from a face of level 3 up to the face of level 0 that contains it
    for (int level = 3; level > 0; --level)
        face = *levels.origin(level, face).f;
    std::cout << "face 100 of level 3 lies in face " << face << " of level 0\n";

    std::stringstream file;
    kith::io::write_levels(file, levels);
    const auto again = kith::io::read_levels<mesh, kith::loop>(file);
    for (const auto v : levels.finest().vertices())
        if (again.finest().point(v) != levels.finest().point(v))
            return 1;
    return *parents.e == edge and levels.finest().n_faces() == 256 ? 0 : 1;
}
