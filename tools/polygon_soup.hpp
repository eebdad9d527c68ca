// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_tags.hpp"

#include <kith/make_mesh.hpp>

#include <array>
#include <vector>

namespace kith::tool {

/// A file's content as it stands: nothing is known yet about how the faces hang together.
struct polygon_soup {
    std::vector<std::array<double, 3>> points;
    face_list faces;
    mesh_tags tags{};
};

} // namespace kith::tool
