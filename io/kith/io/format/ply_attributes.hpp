// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_attributes.hpp"

#include <kith/tiles/ply/ply_header.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace kith::io {

/// Returns the properties of vertices or faces that are numbers and no coordinates, in increasing order.
std::vector<std::size_t> attributes_in(const ply_element& element);

/// The list of a face's texture coordinates, two per corner, as MeshLab has them; without one the number of properties.
std::size_t texture_list(const ply_element& element);

/// Words for numbers of faces, where the comments of the header have them for all; and where the materials are.
void take_words(const ply_header& header, mesh_attributes& attributes);

/// The numbers that a PLY file has at vertices and faces, without their values, and its words.
mesh_attributes kinds_in(const ply_header& header);

/// Which property of the element is such an attribute. Precondition: one is.
std::size_t property_of(const ply_element& element, const attribute& a);

/// What else a PLY file holds besides places and faces: "the property 'weights' of faces", "the elements 'edge'".
std::vector<std::string> not_kept(const ply_header& header);

} // namespace kith::io
