// SPDX-License-Identifier: BSD-3-Clause
// Runs the usual calls of an OpenMesh user with kith::openmesh instead of OpenMesh::Subdivider::Uniform. Features stay
// sharp, and texture coordinates and properties are carried along. See docs/start/openmesh.md.
// Sample run: openmesh_dialect

#include <kith/make_creases.hpp>
#include <kith/openmesh_subdivision.hpp>

#include <OpenMesh/Core/Utils/PropertyManager.hh>

#include <array>
#include <cstddef>
#include <iostream>
#include <string>

int main()
{
    using mesh = OpenMesh::TriMesh_ArrayKernelT<>;
    mesh m;
    m.request_edge_status();
    m.request_halfedge_texcoords2D();
    const auto a = m.add_vertex({1, 1, 1}), b = m.add_vertex({1, -1, -1}), c = m.add_vertex({-1, 1, -1}),
               d = m.add_vertex({-1, -1, 1});
    for (const auto& face : {std::array{a, b, c}, std::array{a, c, d}, std::array{a, d, b}, std::array{b, d, c}})
        m.add_face(face[0], face[1], face[2]);
    auto material = OpenMesh::getOrMakeProperty<OpenMesh::FaceHandle, std::string>(m, "material");
    for (const auto f : m.faces()) {
        material[f] = f.idx() == 1 ? "glass" : "wood";
        for (const auto h : m.fh_range(f)) // one corner of the picture on each face
            m.set_texcoord2D(h, {float(f.idx()), m.to_vertex_handle(h) == d ? 1.F : 0.F});
    }
    m.status(OpenMesh::EdgeHandle(0)).set_feature(true);

    kith::openmesh::LoopT<mesh> loop;
    loop.scheme().sharpness = kith::creases_from_features(m);
    loop.attach(m);
    loop(3);
    loop.detach();

    std::size_t features = 0, glass = 0, seams_kept = 0;
    for (const auto e : m.edges())
        features += m.status(e).feature();
    for (const auto f : m.faces()) {
        glass += material[f] == "glass";
        for (const auto h : m.fh_range(f))
            seams_kept += (m.texcoord2D(h)[0] == 1) == (material[f] == "glass");
    }
    std::cout << m.n_faces() << " faces, " << glass << " of glass; " << features << " feature edges\n";

    kith::openmesh::Sqrt3T<mesh>()(m, 2); // refines without attach()
    std::cout << m.n_faces() << " faces after two steps of sqrt(3)\n";
    return features == 8 and glass == 64 and seams_kept == 3 * 256 and m.n_faces() == 9 * 256 ? 0 : 1;
}
