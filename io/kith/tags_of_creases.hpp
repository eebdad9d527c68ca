// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/io/format/mesh_tags.hpp>
#include <kith/schemes/crease/creases.hpp>

namespace kith::io {

/// Returns the creases of these tags on a mesh. Errors: mesh_error for an edge or vertex that the mesh does not have.
creases creases_of(const mesh_tags& tags, const basic_mesh<>& mesh);

/// Returns the tags of creases: the sharpness of the edges and vertices of a level, by the numbers of its vertices.
template <level Level>
mesh_tags tags_of(const creases& sharpness, const Level& level)
{
    mesh_tags result;
    for (const auto& [edge, s] : sharpness.edges()) {
        const auto e = level.edges()[edge];
        result.edges.push_back({e.org().index(), e.dst().index(), s});
    }
    result.vertices = sharpness.vertices();
    if (not sharpness.empty() and sharpness.method != crease_method::uniform)
        result.method = sharpness.method;
    return result;
}

} // namespace kith::io
