// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/make_mesh.hpp>
#include <kith/io/text/counted.hpp>
#include <kith/io/text/file_error.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace kith::io {

/// Appends the triangles of a strip: each vertex from the third on forms a triangle with the two before it. Every
/// second triangle is turned, so that all have the orientation of the first. Triangles with a repeated vertex, which
/// join strips, are left out. Errors: file_error, which begins with `name`, for a strip of one or two vertices.
inline void append_strip(face_list& faces, std::span<const std::size_t> strip, const std::string& name)
{
    if (not strip.empty() and strip.size() < 3)
        throw file_error(name + ": a strip of " + counted(strip.size(), "vertex") +
                         " makes no triangle; give it three or remove it");
    for (std::size_t i = 2; i < strip.size(); ++i) {
        const bool is_turned = i % 2 != 0;
        const std::array triangle{strip[is_turned ? i - 1 : i - 2], strip[is_turned ? i - 2 : i - 1], strip[i]};
        if (triangle[0] != triangle[1] and triangle[1] != triangle[2] and triangle[2] != triangle[0])
            faces.push_back(triangle);
    }
}

} // namespace kith::io
