// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/make_mesh.hpp>
#include <kith/io/format/mesh_attributes.hpp>
#include <kith/io/format/mesh_tags.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace kith::io {

/// The content of a file as it stands. Nothing is known yet about how the faces are connected, but all their vertices
/// exist and all coordinates are finite.
struct polygon_soup {
    std::vector<std::array<double, 3>> points;
    face_list faces;
    mesh_tags tags{};
    mesh_attributes attributes{};
    std::vector<std::string> not_kept{}; ///< other content of the file: "lines", "weights of vertices"
    std::vector<std::string> notes{};    ///< oddities of the file that do no harm
    std::size_t first_number = 0;        ///< where the format begins to number vertices and faces: 1 in OBJ
};

} // namespace kith::io
