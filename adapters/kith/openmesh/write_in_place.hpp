// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/in_place/carried_properties.hpp>
#include <kith/in_place/join_elements.hpp>
#include <kith/openmesh.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kith::openmesh {

/// A writer that overwrites a mesh of OpenMesh in two parts: the constructor does everything that can fail, commit()
/// the rest. Without commit() the mesh is unchanged. If vertices keep their handles, isolated vertices stay, and
/// deleted ones stay deleted. Edges and faces are numbered from 0 on. Properties get their values from
/// `in_place::carried_properties`. Points are not written.
class mesh_writer {
    using traits = kith::detail::openmesh_connectivity;
    using kernel = traits::kernel;
    using vertex = traits::vertex;

public:
    /// Makes room for the elements, and for `staged_places` if `stages_values` is true. Precondition: the arrays
    /// outlive the writer. Errors: mesh_error for more elements than OpenMesh can number, and for other faces than
    /// triangles in a triangle mesh. Cost: O(elements).
    mesh_writer(kernel& m, bool is_trimesh, const connectivity<std::uint32_t>& t, bool keeps_vertices,
                bool stages_values)
        : mesh_(&m), t_(&t), old_{m.n_vertices(), m.n_edges(), m.n_faces(), nullptr, &t}, joiner_(t)
    {
        for (std::size_t f = 0; is_trimesh and t.degree != 3 and f < t.faces; ++f)
            if (const std::size_t degree = t.first_corner(f + 1) - t.first_corner(f); degree != 3)
                traits::refuse_degree(int(f), degree);
        const std::size_t stage = stages_values ? 1 : 0;
        if (keeps_vertices)
            for (int v = 0; v < int(m.n_vertices()); ++v) {
                if (m.has_vertex_status() and m.status(vertex(v)).deleted())
                    deleted_.push_back(vertex(v));
                else if (not m.is_isolated(vertex(v)))
                    numbers_.push_back(std::uint32_t(v));
            }
        const std::size_t joined = numbers_.size();
        const std::size_t others = keeps_vertices ? old_.vertices - joined : 0; // vertices that stay, without a face
        for (std::size_t v = joined; v < t.vertices; ++v)
            numbers_.push_back(std::uint32_t(v + others));
        bound_ = t.vertices + others;
        old_.final_vertices = &numbers_;
        has_mark_ = m.get_property_handle(mark_, std::string(traits::odd_generation));
        try {
            traits::make_room(m,
                              std::max(stage * old_.vertices + t.vertices, std::max(bound_, old_.vertices)),
                              std::max(stage * old_.edges + t.edges(), old_.edges),
                              std::max(stage * old_.faces + t.faces, old_.faces));
        } catch (...) {
            undo();
            throw;
        }
    }
    mesh_writer(const mesh_writer&) = delete;
    mesh_writer& operator=(const mesh_writer&) = delete;
    ~mesh_writer()
    {
        if (not is_committed_)
            undo();
    }

    [[nodiscard]] const in_place::staged_places& places() const { return old_; }
    /// Returns the handle of the vertex with this number.
    [[nodiscard]] vertex vertex_at(std::size_t number) const { return vertex(int(numbers_[number])); }

    /// Joins the elements. Precondition: the values are in their final places.
    void commit() noexcept
    {
        is_committed_ = true;
        mesh_->resize(bound_, t_->edges(), t_->faces);
        if (has_mark_)
            mesh_->remove_property(mark_);
        for (const vertex v : deleted_)
            mesh_->set_isolated(v);
        joiner_.join<traits>(*mesh_, [this](std::size_t v) { return vertex_at(v); });
    }

private:
    void undo() noexcept { mesh_->resize(old_.vertices, old_.edges, old_.faces); }

    kernel* mesh_;
    const connectivity<std::uint32_t>* t_;
    bool is_committed_ = false, has_mark_ = false;
    OpenMesh::MPropHandleT<bool> mark_;
    in_place::staged_places old_;
    in_place::element_joiner joiner_;
    std::vector<std::uint32_t> numbers_; ///< final numbers of the vertices
    std::vector<vertex> deleted_;
    std::size_t bound_ = 0;
};

} // namespace kith::openmesh
