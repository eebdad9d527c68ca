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

/// A file's content as it stands: nothing is known yet about how the faces hang together, but all their vertices are
/// there and all coordinates are finite.
struct polygon_soup {
    std::vector<std::array<double, 3>> points;
    face_list faces;
    mesh_tags tags{};
    mesh_attributes attributes{};
    std::vector<std::string> not_kept{}; ///< what else the file holds: "lines", "weights of vertices"
    std::vector<std::string> notes{};    ///< what is odd about it and does no harm
    std::size_t first_number = 0;        ///< from which the format numbers vertices and faces: 1 in OBJ
};

} // namespace kith::io
