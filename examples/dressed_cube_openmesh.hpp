// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>

#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>

using mesh = OpenMesh::PolyMesh_ArrayKernelT<>;

/// Makes a cube with a label and the whole texture on each face, so that all edges are seams. The edges around the top
/// are features.
inline mesh dressed_cube()
{
    mesh cube;
    cube.request_vertex_colors(), cube.request_halfedge_texcoords2D(), cube.request_edge_status();
    auto label = OpenMesh::getOrMakeProperty<OpenMesh::FaceHandle, std::string>(cube, "label");
    for (int v = 0; v < 8; ++v)
        cube.set_color(cube.add_vertex(mesh::Point(v & 1, v >> 1 & 1, v >> 2)),
                       v < 4 ? mesh::Color(0, 0, 255) : mesh::Color(255, 0, 0));
    const auto at = [](int v) { return OpenMesh::VertexHandle(v); };
    for (const auto& f : {std::array{0, 2, 3, 1},
                          std::array{4, 5, 7, 6},
                          std::array{0, 1, 5, 4},
                          std::array{1, 3, 7, 5},
                          std::array{3, 2, 6, 7},
                          std::array{2, 0, 4, 6}}) {
        const auto face = cube.add_face(at(f[0]), at(f[1]), at(f[2]), at(f[3]));
        label[face] = "side " + std::to_string(face.idx());
        int corner = 0;
        for (const auto h : cube.fh_range(face))
            cube.set_texcoord2D(h, mesh::TexCoord2D(float(corner == 1 or corner == 2), float(corner / 2))), ++corner;
    }
    for (const auto e : cube.edges())
        cube.status(e).set_feature(e.v0().idx() >= 4 and e.v1().idx() >= 4);
    return cube;
}

/// Returns true if a cube that was refined three times still has all values, and the whole texture on each side.
inline bool is_dressed(mesh smooth)
{
    const auto label = OpenMesh::getProperty<OpenMesh::FaceHandle, std::string>(smooth, "label");
    const auto first = *smooth.faces_begin();
    std::cout << label[first] << " has " << smooth.texcoord2D(smooth.halfedge_handle(first)) << '\n';
    std::size_t features = 0, on_side_0 = 0;
    for (const auto e : smooth.edges())
        features += smooth.status(e).feature();
    bool is_mixed = true; // colours mix red and blue
    for (const auto v : smooth.vertices()) {
        const auto& c = smooth.color(v);
        is_mixed = is_mixed and std::abs(c[0] + c[2] - 255) <= 1 and c[1] == 0;
    }
    double area = 0; // total area of the texture
    for (const auto f : smooth.faces()) {
        on_side_0 += label[f] == "side 0";
        const auto across = smooth.texcoord2D(f.halfedge()) - smooth.texcoord2D(f.halfedge().next().next());
        area += double(across.sqrnorm()) / 2;
    }
    return features == 4 * 8 and on_side_0 == 64 and is_mixed and std::abs(area - 6) < 1e-6;
}
