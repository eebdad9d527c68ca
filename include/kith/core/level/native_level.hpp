// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/basic_mesh.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace kith {

/// A basic_mesh as a scheme sees it: the walk is index arithmetic, and handles are the numbers themselves. `Degree` is
/// the number of corners of every face if it is known at compile time (3 or 4), else 0. If it is known, a loop over the
/// corners of an all-quad level is a flat loop with constant strides.
template <class Point, std::unsigned_integral Index, int Degree>
class native_level {
public:
    using mesh_type = basic_mesh<Point, Index>;
    using traits = mesh_traits<mesh_type>;
    using point_type = Point;
    using index_type = Index;
    using vertex_handle = typename traits::vertex;
    using edge_handle = typename traits::edge;
    using face_handle = typename traits::face;
    using corner_handle = element_id<struct corner_kind, Index>;

    static constexpr std::size_t face_degree = Degree;
    static constexpr corner_handle no_corner{connectivity<Index>::none};
    /// The flag that allows arithmetic on these points on several threads.
    static constexpr bool parallel = std::is_trivially_copyable_v<point_type>;

    /// Takes a mesh, which must outlive the view. Precondition: the mesh has its edges, and its face degrees match
    /// Degree.
    explicit native_level(const mesh_type& mesh)
        : points_(mesh.points().data())
        , corner_vertex_(mesh.topology().corner_vertex.data())
        , corner_halfedge_(mesh.topology().corner_halfedge.data())
        , halfedge_corner_(mesh.topology().halfedge_corner.data())
        , vertex_corner_(mesh.topology().vertex_corner.data())
        , face_corner_(mesh.topology().face_corner.data())
        , corner_face_(mesh.topology().corner_face.data())
        , topology_(&mesh.topology())
        , degree_(Index(mesh.topology().degree))
        , corners_(Index(mesh.topology().corners()))
    {
        KITH_ASSERT(Degree == 0 or corner_count() == Degree * face_count());
    }

    [[nodiscard]] std::size_t vertex_count() const { return topology_->vertices; }
    [[nodiscard]] std::size_t edge_count() const { return topology_->edges(); }
    [[nodiscard]] std::size_t face_count() const { return topology_->faces; }
    [[nodiscard]] std::size_t corner_count() const { return topology_->corners(); }
    [[nodiscard]] bool is_closed() const { return topology_->is_closed(); }
    [[nodiscard]] kith::counts counts() const { return count(*topology_); }

    [[nodiscard]] vertex_handle vertex_at(std::size_t i) const { return {Index(i)}; }
    [[nodiscard]] edge_handle edge_at(std::size_t i) const { return {Index(i)}; }
    [[nodiscard]] face_handle face_at(std::size_t i) const { return {Index(i)}; }
    [[nodiscard]] corner_handle corner_at(std::size_t i) const { return {Index(i)}; }

    /// Returns true if a handle belongs to an element of this level.
    [[nodiscard]] bool has(vertex_handle v) const { return v.value < vertex_count(); }
    [[nodiscard]] bool has(edge_handle e) const { return e.value < edge_count(); }
    [[nodiscard]] bool has(face_handle f) const { return f.value < face_count(); }

    template <class Kind>
    [[nodiscard]] std::size_t index(element_id<Kind, Index> x) const
    {
        return x.value;
    }
    /// Returns the number of the half-edge of a corner: 2e+s, where s is its side of edge e.
    [[nodiscard]] std::size_t halfedge(corner_handle c) const { return corner_halfedge_[c.value]; }

    [[nodiscard]] corner_handle first(vertex_handle v) const { return {vertex_corner_[v.value]}; }
    [[nodiscard]] corner_handle first(edge_handle e) const { return {halfedge_corner_[2 * std::size_t(e.value)]}; }
    /// Returns the corner on side 1 of an edge; no_corner at the boundary.
    [[nodiscard]] corner_handle second(edge_handle e) const { return {halfedge_corner_[2 * std::size_t(e.value) + 1]}; }
    [[nodiscard]] corner_handle first(face_handle f) const
    {
        if constexpr (Degree != 0)
            return {Index(f.value * Degree)};
        else
            return {degree_ != 0 ? Index(f.value * degree_) : face_corner_[f.value]};
    }
    [[nodiscard]] std::size_t degree(face_handle f) const
    {
        if constexpr (Degree != 0)
            return Degree;
        else
            return degree_ != 0 ? degree_ : face_corner_[f.value + 1] - face_corner_[f.value];
    }

    [[nodiscard]] corner_handle next(corner_handle c) const
    {
        if constexpr (Degree != 0)
            return {detail::next_of_alike(c.value, Index(Degree))};
        else { // as in connectivity, over these arrays: a call there is a twentieth slower
            const Index after = c.value + 1;
            if (degree_ != 0)
                return {after % degree_ == 0 ? Index(after - degree_) : after};
            return after < corners_ and are_in_one_face(c.value, after) ? corner_handle{after} : first(face_of(c));
        }
    }
    [[nodiscard]] corner_handle prev(corner_handle c) const
    {
        if constexpr (Degree != 0)
            return {detail::prev_of_alike(c.value, Index(Degree))};
        else {
            const Index before = c.value - 1;
            if (degree_ != 0)
                return {c.value % degree_ == 0 ? Index(before + degree_) : before};
            return {c.value != 0 and are_in_one_face(before, c.value)
                        ? before
                        : Index(face_corner_[corner_face_[c.value] + 1] - 1)};
        }
    }
    /// Returns the vertex after that of a corner of an edge, for triangles without a branch. In loops over edges the
    /// position of the corner in its face is unpredictable, unlike in a fan. With the branch of `next` Butterfly takes
    /// half as long again.
    [[nodiscard]] vertex_handle vertex_after(corner_handle c) const
    {
        if constexpr (Degree == 3)
            return vertex_of({Index(c.value + 1 - Degree * Index(c.value % Degree == Degree - 1))});
        else
            return vertex_of(next(c));
    }
    /// Returns the corner of the opposite half-edge on the same edge; no_corner at the boundary.
    [[nodiscard]] corner_handle across(corner_handle c) const
    {
        return {halfedge_corner_[corner_halfedge_[c.value] ^ 1]};
    }

    [[nodiscard]] vertex_handle vertex_of(corner_handle c) const { return {corner_vertex_[c.value]}; }
    [[nodiscard]] edge_handle edge_of(corner_handle c) const { return {Index(corner_halfedge_[c.value] >> 1)}; }
    [[nodiscard]] face_handle face_of(corner_handle c) const
    {
        if constexpr (Degree != 0)
            return {Index(c.value / Degree)};
        else
            return {degree_ != 0 ? Index(c.value / degree_) : corner_face_[c.value]};
    }
    [[nodiscard]] const Point& point(vertex_handle v) const { return points_[v.value]; }

    /// Calls f on each vertex whose fan starts in one of the faces [begin, end).
    template <class F>
    void for_vertices_of(std::size_t begin, std::size_t end, const F& f) const
    {
        if (begin == end) // a mesh without faces has no first corners
            return;
        const Index last = first(face_handle{Index(end)}).value;
        for (Index c = first(face_handle{Index(begin)}).value; c < last; ++c)
            if (const vertex_handle v = vertex_of({c}); vertex_corner_[v.value] == c)
                f(v);
    }

    /// Calls f on each edge whose left side is in one of the faces [begin, end), and on its corner there.
    template <class F>
    void for_edges_of(std::size_t begin, std::size_t end, const F& f) const
    {
        if (begin == end)
            return;
        const Index last = first(face_handle{Index(end)}).value;
        for (Index c = first(face_handle{Index(begin)}).value; c < last; ++c)
            if (const Index halfedge = corner_halfedge_[c]; halfedge % 2 == 0)
                f(edge_handle{Index(halfedge / 2)}, corner_handle{c});
    }

private:
    /// Returns true if two corners belong to one face, in meshes of mixed degrees. Comparing with the bounds of the
    /// face would be one more read that misses the cache.
    [[nodiscard]] bool are_in_one_face(Index a, Index b) const { return corner_face_[a] == corner_face_[b]; }

    const Point* points_;
    const Index* corner_vertex_;
    const Index* corner_halfedge_;
    const Index* halfedge_corner_;
    const Index* vertex_corner_;
    const Index* face_corner_;
    const Index* corner_face_;
    const connectivity<Index>* topology_;
    Index degree_;
    Index corners_;
};

} // namespace kith
