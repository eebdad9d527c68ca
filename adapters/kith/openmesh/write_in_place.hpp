// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/in_place/join_elements.hpp>
#include <kith/openmesh.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith::openmesh {

/// Overwrites a mesh of OpenMesh with these elements. Vertices keep their handles if they are to, and deleted ones stay
/// deleted; edges and faces are numbered from 0 on. What was requested and properties stay, with zeros and T() on all
/// but the vertices that were there. Points are not written. Errors: mesh_error for more elements than OpenMesh can
/// number, before anything is changed. Cost: O(elements).
template <fillable_mesh M>
void write_connectivity(M& m, const connectivity<std::uint32_t>& t, bool keeps_vertices)
{
    std::vector<OpenMesh::VertexHandle> handles, deleted;
    if (keeps_vertices)
        for (int v = 0; v < int(m.n_vertices()); ++v) {
            const OpenMesh::VertexHandle handle(v);
            (m.has_vertex_status() and m.status(handle).deleted() ? deleted : handles).push_back(handle);
        }
    mesh_traits<M>::require_room(t.edges());
    const std::size_t old = handles.size() + deleted.size(), all = t.vertices + deleted.size();
    for (std::size_t v = old; v < all; ++v)
        handles.emplace_back(int(v));
    m.resize(old, 0, 0);
    m.resize(all, t.edges(), t.faces);
    mesh_traits<M>::clear_attributes(m, old);
    mesh_traits<M>::forget_generation(m);
    for (const auto v : deleted)
        m.set_isolated(v);
    in_place::join_elements(m, t, [&](std::size_t v) { return handles[v]; });
}

} // namespace kith::openmesh
