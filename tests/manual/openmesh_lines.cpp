// SPDX-License-Identifier: BSD-3-Clause
// docs/start/openmesh.md: the lines of an object that attaches.
#include <kith/openmesh_subdivision.hpp>

int main()
{
    using mesh_type = OpenMesh::TriMesh_ArrayKernelT<>;
    mesh_type mesh;
    const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}), c = mesh.add_vertex({0, 1, 0});
    mesh.add_face(a, b, c);

    // @block@

    return mesh.n_faces() == 64 ? 0 : 1;
}
