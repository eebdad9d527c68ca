// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon_soup.hpp"

#include <kith/core/mesh/basic_mesh.hpp>

namespace kith::io {

/// Returns the attributes of a file in the order of the corners of the mesh that `make_mesh` has made of it: there
/// faces begin with their smallest vertex. Precondition: the mesh has the faces of the soup. Cost: O(values).
mesh_attributes attributes_of(const polygon_soup& soup, const basic_mesh<>& mesh);

} // namespace kith::io
