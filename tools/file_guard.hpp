// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_format.hpp"
#include "mesh_tags.hpp"

#include <cstddef>
#include <string>

namespace kith::tool {

/// What a file really holds.
struct file_contents {
    std::size_t vertices = 0; ///< STL: three for each triangle, as it shares none
    std::size_t faces = 0;
    std::size_t corners = 0;
    std::size_t data_begin = 0; ///< OFF: where the first vertex stands
    bool homogeneous = false;   ///< OFF: four coordinates
    bool binary = false;
    mesh_tags tags{}; ///< OBJ
};

/// Reads a file strictly from beginning to end before a mesh library may. Readers of mesh libraries believe the counts
/// of a header before they allocate, stop at the first word they do not understand and call the rest a mesh, leave the
/// end of an index list unread, or read past what they have; whatever they could stumble over is refused here with its
/// line, and what they need not see (comments, names, texture coordinates) is blanked in place.
/// Errors: file_error. Cost: one pass, no memory beyond the bytes themselves.
file_contents guard(mesh_format format, std::string& bytes);

file_contents guard_off(std::string& bytes);
file_contents guard_obj(std::string& bytes);
file_contents guard_ply(std::string& bytes);
file_contents guard_stl(std::string& bytes);

} // namespace kith::tool
