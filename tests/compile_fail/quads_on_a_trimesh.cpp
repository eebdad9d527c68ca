// SPDX-License-Identifier: BSD-3-Clause
#include <kith/openmesh_subdivision.hpp>

using mesh = OpenMesh::TriMesh_ArrayKernelT<>;

kith::openmesh::CatmullClarkT<mesh> subdivide;
