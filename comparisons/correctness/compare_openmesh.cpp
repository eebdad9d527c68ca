// SPDX-License-Identifier: BSD-3-Clause
#include "compare_peer.hpp"
#include "peers/openmesh_peer.hpp"

int main(int count, char** words)
{
    using namespace kith::comparison;
    using polygons = openmesh_peer<OpenMesh::PolyMesh_ArrayKernelT<openmesh_doubles>>;
    using triangles = openmesh_peer<OpenMesh::TriMesh_ArrayKernelT<openmesh_doubles>>;
    return compare_files(count,
                         words,
                         "Refines meshes with OpenMesh and with kith and compares the results.",
                         [](const control_mesh& control, int levels, verdicts& verdicts) {
                             if (control.is_closed()) {
                                 compare_scheme<polygons, kith::mid_edge>(control, levels, verdicts);
                                 compare_scheme<triangles, kith::interpolatory_sqrt3>(control, levels, verdicts);
                             } else {
                                 // At a boundary, OpenMesh's mid-edge scheme drops faces, and its interpolatory sqrt(3)
                                 // takes vertices beyond the boundary from the mesh itself.
                                 verdicts.skip(control.name, kith::scheme_name<kith::mid_edge>(), "has a boundary");
                                 verdicts.skip(
                                     control.name, kith::scheme_name<kith::interpolatory_sqrt3>(), "has a boundary");
                             }
                             compare_scheme<polygons, kith::catmull_clark>(control, levels, verdicts);
                             compare_scheme<triangles, kith::butterfly>(control, levels, verdicts);
                             compare_scheme<triangles, kith::loop>(control, levels, verdicts);
                             compare_scheme<triangles, kith::sqrt3>(control, levels, verdicts);
                         });
}
