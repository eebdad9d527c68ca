// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_in_library.hpp"

#include <kith/openmesh.hpp>

namespace kith {

KITH_READ_MESH_IN_LIBRARY(openmesh::kernel_view<float>)
KITH_READ_MESH_IN_LIBRARY(openmesh::kernel_view<double>)
KITH_MESH_IN_LIBRARY(OpenMesh::PolyMesh_ArrayKernelT<>)
KITH_MESH_IN_LIBRARY(OpenMesh::TriMesh_ArrayKernelT<>)
KITH_MESH_IN_LIBRARY(OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>)
KITH_MESH_IN_LIBRARY(OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>)

} // namespace kith
