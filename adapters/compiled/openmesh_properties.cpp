// SPDX-License-Identifier: BSD-3-Clause
#include "properties_in_library.hpp"

#include <kith/openmesh_properties.hpp>

namespace kith {

KITH_PROPERTIES_IN_LIBRARY(openmesh::kernel_view<float>, OpenMesh::BaseKernel) // serves all meshes

} // namespace kith
