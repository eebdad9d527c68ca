// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/slices/ply_header.hpp>

#include <string>
#include <vector>

namespace kith::io {

/// What a PLY file holds besides places and faces: "normals", "colours", "the property 'quality' of vertices".
std::vector<std::string> not_kept(const ply_header& header);

} // namespace kith::io
