// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_attributes.hpp"

#include <kith/tiles/ply/ply_header.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace kith::io {

/// Returns the properties of vertices or faces that are numbers but no coordinates, in increasing order.
std::vector<std::size_t> attributes_in(const ply_element& element);

/// Returns the property that lists a face's texture coordinates, two per corner, as MeshLab writes them. Returns the
/// number of properties if there is none.
std::size_t texture_list(const ply_element& element);

/// Gives attributes of faces their words if the comments of the header have words for all their numbers. Also takes the
/// lines that name the files of materials.
void take_words(const ply_header& header, mesh_attributes& attributes);

/// Returns the attributes of vertices and faces in a PLY file, without values, and its words.
mesh_attributes kinds_in(const ply_header& header);

/// Returns the property of the element that becomes this attribute. Precondition: there is one.
std::size_t property_of(const ply_element& element, const attribute& a);

/// Returns what a PLY file holds besides places, faces and attributes: "the property 'weights' of faces", "the elements
/// 'edge'".
std::vector<std::string> not_kept(const ply_header& header);

} // namespace kith::io
