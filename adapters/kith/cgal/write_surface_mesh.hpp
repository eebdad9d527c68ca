// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "write_face_graph.hpp"

#include <kith/cgal_properties.hpp>
#include <kith/in_place/carried_properties.hpp>
#include <kith/in_place/join_elements.hpp>

#include <CGAL/Surface_mesh/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kith::cgal {

namespace detail {

/// A helper that makes removed elements of a mesh valid again, so that the mesh has no count or list of them. undo()
/// removes them again.
template <class Point>
class taken_back_elements {
    using mesh = CGAL::Surface_mesh<Point>;
    using size = typename mesh::size_type;

public:
    explicit taken_back_elements(mesh& m)
        : mesh_(&m)
        , vertices_(removed<typename mesh::Vertex_index>(m, m.num_vertices(), m.number_of_removed_vertices()))
        , edges_(removed<typename mesh::Edge_index>(m, m.num_edges(), m.number_of_removed_edges()))
        , faces_(removed<typename mesh::Face_index>(m, m.num_faces(), m.number_of_removed_faces()))
    {
        const bool recycles = m.does_recycle_garbage();
        m.set_recycle_garbage(true);
        try {
            while (m.number_of_removed_vertices() > 0)
                m.add_vertex();
            while (m.number_of_removed_edges() > 0)
                m.add_edge();
            while (m.number_of_removed_faces() > 0)
                m.add_face();
        } catch (...) {
            m.set_recycle_garbage(recycles);
            undo();
            throw;
        }
        m.set_recycle_garbage(recycles);
    }
    void undo() noexcept
    {
        for (const auto v : vertices_)
            if (not mesh_->is_removed(v))
                mesh_->remove_vertex(v);
        for (const auto e : edges_)
            if (not mesh_->is_removed(e))
                mesh_->remove_edge(e);
        for (const auto f : faces_)
            if (not mesh_->is_removed(f))
                mesh_->remove_face(f);
    }

private:
    template <class Handle>
    static std::vector<Handle> removed(const mesh& m, size bound, size count)
    {
        std::vector<Handle> result;
        for (size i = 0; count != 0 and i < bound; ++i)
            if (m.is_removed(Handle(i)))
                result.push_back(Handle(i));
        return result;
    }

    mesh* mesh_;
    std::vector<typename mesh::Vertex_index> vertices_;
    std::vector<typename mesh::Edge_index> edges_;
    std::vector<typename mesh::Face_index> faces_;
};

} // namespace detail

/// A writer that overwrites a Surface_mesh in two parts: the constructor does everything that can fail, commit() the
/// rest. Without commit() the mesh is unchanged. If vertices keep their indices, isolated vertices stay, and removed
/// ones stay removed. Edges and faces are numbered from 0 on. Property maps stay, and get their values from
/// `in_place::carried_properties`. Points are not written.
template <class Point>
class surface_mesh_writer {
    using mesh = CGAL::Surface_mesh<Point>;
    using vertex = typename mesh::Vertex_index;
    using face = typename mesh::Face_index;
    using size = typename mesh::size_type;
    using traits = mesh_traits<mesh>;

public:
    /// Makes room for the elements, and for `staged_places` if `stages_values` is true. Precondition: the arrays
    /// outlive the writer. Cost: O(elements).
    surface_mesh_writer(mesh& m, const connectivity<std::uint32_t>& t, bool keeps_vertices, bool stages_values)
        : mesh_(&m)
        , t_(&t)
        , had_garbage_(m.has_garbage())
        , old_{m.num_vertices(), m.num_edges(), m.num_faces(), nullptr, &t}
        , joiner_(t)
    {
        if (keeps_vertices)
            for (size v = 0; v < m.num_vertices(); ++v) {
                if (m.is_removed(vertex(v)))
                    removed_.push_back(vertex(v));
                else if (not m.is_isolated(vertex(v)))
                    numbers_.push_back(v);
            }
        const std::size_t joined = numbers_.size();
        const std::size_t others = keeps_vertices ? old_.vertices - joined : 0; // vertices that stay, without a face
        for (std::size_t v = joined; v < t.vertices; ++v)
            numbers_.push_back(std::uint32_t(v + others));
        bound_ = t.vertices + others;
        handles_.reserve(numbers_.size());
        for (const std::uint32_t v : numbers_)
            handles_.emplace_back(v);
        old_.final_vertices = &numbers_;
        const std::string mark = traits::odd_generation;
        if (traits::generation(m) != 0)
            odd_ = m.template add_property_map<face, bool>(mark).first;
        // Without staged values everything goes to its final place at once.
        const std::size_t stage = stages_values ? 1 : 0;
        taken_back_.emplace(m);
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
    surface_mesh_writer(const surface_mesh_writer&) = delete;
    surface_mesh_writer& operator=(const surface_mesh_writer&) = delete;
    ~surface_mesh_writer()
    {
        if (not is_committed_)
            undo();
    }

    [[nodiscard]] const in_place::staged_places& places() const { return old_; }

    /// Joins the elements. Returns them in the order of the arrays. Precondition: the values are in their final places.
    auto commit() noexcept
    {
        is_committed_ = true;
        mesh& m = *mesh_;
        m.resize(size(bound_), size(t_->edges()), size(t_->faces));
        if (odd_)
            m.remove_property_map(odd_);
        for (const vertex v : removed_)
            m.remove_vertex(v);
        joiner_.template join<traits>(m, [&](std::size_t v) { return handles_[v]; });
        if (had_garbage_ and removed_.empty())
            forget_garbage();
        return written_elements{std::move(handles_), m.edges()};
    }

private:
    void undo() noexcept
    {
        mesh_->resize(size(old_.vertices), size(old_.edges), size(old_.faces));
        taken_back_->undo();
    }
    /// Makes the mesh forget that it had removed elements, as it has none any more. If memory runs out, the mesh will
    /// look for them once more.
    void forget_garbage() noexcept
    {
        try {
            mesh_->collect_garbage();
        } catch (const std::bad_alloc&) {
            remove_map<vertex>(maps_of_garbage_[0]);
            remove_map<typename mesh::Halfedge_index>(maps_of_garbage_[1]);
            remove_map<face>(maps_of_garbage_[2]);
        }
    }
    template <class Handle>
    void remove_map(const std::string& name)
    {
        if (auto map = property_access<mesh>::template find<Handle, Handle>(*mesh_, name))
            mesh_->remove_property_map(map);
    }

    mesh* mesh_;
    const connectivity<std::uint32_t>* t_;
    bool had_garbage_, is_committed_ = false;
    in_place::staged_places old_;
    in_place::element_joiner joiner_;
    std::vector<std::uint32_t> numbers_; ///< final indices of the vertices
    std::vector<vertex> handles_, removed_;
    std::size_t bound_ = 0;
    typename mesh::template Property_map<face, bool> odd_;
    std::optional<detail::taken_back_elements<Point>> taken_back_;
    /// Names of the maps that CGAL adds during a garbage collection and leaves behind if it fails.
    std::array<std::string, 3> maps_of_garbage_{"v:garbage-collection", "h:garbage-collection", "f:garbage-collection"};
};

/// Overwrites a Surface_mesh with these elements, without values of property maps. Cost: O(elements).
template <class Point>
auto write_connectivity(CGAL::Surface_mesh<Point>& m, const connectivity<std::uint32_t>& t, bool keeps_vertices)
{
    return surface_mesh_writer<Point>(m, t, keeps_vertices, false).commit();
}

} // namespace kith::cgal
