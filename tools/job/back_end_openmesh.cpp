// SPDX-License-Identifier: BSD-3-Clause
#include "foreign_back_end.hpp"

#include <kith/openmesh.hpp>

namespace kith::tool {

refined_mesh refine_openmesh(basic_mesh<> control, const refine_request& request)
{
    require_possible(request, control, mesh_kind::openmesh);
    return refine_on<OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>>(control, request);
}

} // namespace kith::tool
