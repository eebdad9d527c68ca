// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "values_over.hpp"
#include "walk.hpp"

#include <kith/core/mask/mask.hpp>

#include <cstddef>

namespace kith {

/// A vertex in a face, and the half-edge that leaves the vertex inside the face. Thesis 4.1: the tuple (v, f).
template <walkable_level Level>
class corner {
public:
    using handle_type = typename Level::corner_handle;

    corner(const Level& level, handle_type handle) : level_(&level), handle_(handle) {}

    [[nodiscard]] handle_type handle() const { return handle_; }
    [[nodiscard]] std::size_t index() const { return level_->index(handle_); }
    /// The number of the half-edge: 2 * edge + side.
    [[nodiscard]] std::size_t halfedge() const { return level_->halfedge(handle_); }

    [[nodiscard]] vertex<Level> v() const { return {*level_, level_->vertex_of(handle_)}; }
    [[nodiscard]] face<Level> f() const { return {*level_, level_->face_of(handle_)}; }
    [[nodiscard]] corner next() const { return {*level_, level_->next(handle_)}; }
    [[nodiscard]] corner prev() const { return {*level_, level_->prev(handle_)}; }
    /// The edge to the next vertex of the face, and the edge from the previous one, each seen from this face.
    [[nodiscard]] edge<Level> next_edge() const { return {*level_, level_->edge_of(handle_), handle_}; }
    [[nodiscard]] edge<Level> prev_edge() const { return prev().next_edge(); }
    /// Nothing lies across the next edge; as a tuple the corner is at the boundary then.
    [[nodiscard]] bool is_boundary() const { return level_->across(handle_) == Level::no_corner; }
    /// The corner whose half-edge runs the other way along the next edge. Precondition: not is_boundary().
    [[nodiscard]] corner across() const { return {*level_, level_->across(handle_)}; }

    /// The corners around the vertex, counter-clockwise from this one. At the boundary those before it are left out.
    [[nodiscard]] auto fan_from_here() const { return walk(*level_, detail::fan_step<Level>{handle_}); }
    /// The vertices around the vertex in the same order: the other ends of its edges, and in each face the vertex after
    /// the next. At the boundary those before this corner and the last neighbour are left out.
    [[nodiscard]] auto neighbors_from_here() const
    {
        return fan_from_here().map([](const corner& c) { return c.next().v(); });
    }
    [[nodiscard]] auto opposites_from_here() const
    {
        return fan_from_here().map([](const corner& c) { return c.next().next().v(); });
    }
    /// The vertices of the face, counter-clockwise from this corner's.
    [[nodiscard]] auto vertices_from_here() const
    {
        return walk(*level_, detail::face_step<Level>{handle_}).map([](const corner& c) { return c.v(); });
    }

    friend bool operator==(const corner& a, const corner& b) { return a.handle_ == b.handle_; }

private:
    const Level* level_;
    handle_type handle_;
};

/// An edge; `lface` lies to the left of org -> dst. A boundary edge has its face on the left.
template <walkable_level Level>
class edge {
public:
    using handle_type = typename Level::edge_handle;
    using corner_handle = typename Level::corner_handle;

    edge(const Level& level, handle_type handle) : edge(level, handle, level.first(handle)) {}
    edge(const Level& level, handle_type handle, corner_handle seen_from)
        : edge(level, handle, seen_from, level.first(handle))
    {
    }
    edge(const Level& level, handle_type handle, corner_handle seen_from, corner_handle left)
        : level_(&level), handle_(handle), seen_from_(seen_from), left_(left)
    {
    }

    [[nodiscard]] handle_type handle() const { return handle_; }
    [[nodiscard]] std::size_t index() const { return level_->index(handle_); }
    [[nodiscard]] bool is_boundary() const { return level_->second(handle_) == Level::no_corner; }

    [[nodiscard]] vertex<Level> org() const { return lcorner().v(); }
    [[nodiscard]] vertex<Level> dst() const
    {
        if constexpr (requires { level_->vertex_after(left_); })
            return {*level_, level_->vertex_after(left_)};
        else
            return lcorner().next().v();
    }
    [[nodiscard]] face<Level> lface() const { return lcorner().f(); }
    /// Precondition: not is_boundary().
    [[nodiscard]] face<Level> rface() const { return rcorner().f(); }
    /// The corner of org in lface; the corner of dst in rface (precondition: not is_boundary()).
    [[nodiscard]] corner<Level> lcorner() const { return {*level_, left_}; }
    [[nodiscard]] corner<Level> rcorner() const { return {*level_, level_->second(handle_)}; }
    /// The corner through which this edge was reached: from a face, its half-edge in that face; else lcorner().
    [[nodiscard]] corner<Level> seen_from() const { return {*level_, seen_from_}; }

    friend bool operator==(const edge& a, const edge& b) { return a.handle_ == b.handle_; }

private:
    const Level* level_;
    handle_type handle_;
    corner_handle seen_from_;
    corner_handle left_;
};

/// A vertex. Its fan is the cycle of its corners, counter-clockwise; at the boundary from boundary edge to boundary
/// edge.
template <walkable_level Level>
class vertex : public mask_base {
public:
    using handle_type = typename Level::vertex_handle;

    vertex(const Level& level, handle_type handle) : level_(&level), handle_(handle) {}

    [[nodiscard]] handle_type handle() const { return handle_; }
    [[nodiscard]] std::size_t index() const { return level_->index(handle_); }
    [[nodiscard]] decltype(auto) point() const { return level_->point(handle_); }
    [[nodiscard]] bool is_boundary() const { return first_corner().is_boundary(); }

    [[nodiscard]] corner<Level> first_corner() const { return {*level_, level_->first(handle_)}; }
    [[nodiscard]] auto corners() const { return walk(*level_, detail::fan_step<Level>{level_->first(handle_)}); }
    [[nodiscard]] auto faces() const
    {
        return corners().map([](const corner<Level>& c) { return c.f(); });
    }
    /// The edges counter-clockwise, the last boundary edge included; each seen from the face to its left or,
    /// for that last one, from its only face.
    [[nodiscard]] auto edges() const
    {
        return spokes().map([](const auto& spoke) { return spoke.edge; });
    }
    /// The other ends of edges(), in the same order.
    [[nodiscard]] auto neighbors() const
    {
        return spokes().map([](const auto& spoke) { return spoke.end; });
    }
    /// In each face the vertex after the next, counter-clockwise: in quads the one opposite this vertex.
    [[nodiscard]] auto opposites() const { return first_corner().opposites_from_here(); }
    /// The number of edges.
    [[nodiscard]] std::size_t valence() const { return face_count() + (is_boundary() ? 1 : 0); }
    /// Cost: O(the smaller of n and the valence).
    [[nodiscard]] bool has_valence(std::size_t n) const
    {
        std::size_t found = is_boundary() ? 1 : 0;
        for (auto c = corners().begin(); not(c == corners().end()) and found <= n; ++c)
            ++found;
        return found == n;
    }
    /// The number of faces, one less than the edges at the boundary.
    [[nodiscard]] std::size_t face_count() const
    {
        std::size_t result = 0;
        for ([[maybe_unused]] const auto& c : corners())
            ++result;
        return result;
    }
    /// The corner before the boundary: its prev_edge() is the last of edges(). Precondition: is_boundary().
    [[nodiscard]] corner<Level> last_corner() const
    {
        auto last = first_corner();
        for (auto p = last.prev(); not p.is_boundary(); p = last.prev())
            last = p.across();
        return last;
    }
    /// The two neighbours along the boundary, first and last of neighbors(). Precondition: is_boundary().
    [[nodiscard]] vertex first_rim() const { return first_corner().next().v(); }
    [[nodiscard]] vertex last_rim() const { return last_corner().prev().v(); }

    template <values_over<Level> Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        return values.coarse(*this);
    }

    friend bool operator==(const vertex& a, const vertex& b) { return a.handle_ == b.handle_; }

private:
    [[nodiscard]] auto spokes() const { return walk(*level_, detail::spoke_step<Level>{level_->first(handle_)}); }

    const Level* level_;
    handle_type handle_;
};

/// A face; its corners and vertices are counter-clockwise from the first corner.
template <walkable_level Level>
class face {
public:
    using handle_type = typename Level::face_handle;

    face(const Level& level, handle_type handle) : level_(&level), handle_(handle) {}

    [[nodiscard]] handle_type handle() const { return handle_; }
    [[nodiscard]] std::size_t index() const { return level_->index(handle_); }
    /// The number of corners.
    [[nodiscard]] std::size_t degree() const { return level_->degree(handle_); }
    /// One of its edges is a boundary edge.
    [[nodiscard]] bool is_boundary() const
    {
        for (const auto& c : corners())
            if (c.is_boundary())
                return true;
        return false;
    }

    [[nodiscard]] corner<Level> first_corner() const { return {*level_, level_->first(handle_)}; }
    [[nodiscard]] auto corners() const { return walk(*level_, detail::face_step<Level>{level_->first(handle_)}); }
    [[nodiscard]] auto vertices() const
    {
        return corners().map([](const corner<Level>& c) { return c.v(); });
    }
    [[nodiscard]] auto edges() const
    {
        return corners().map([](const corner<Level>& c) { return c.next_edge(); });
    }

    friend bool operator==(const face& a, const face& b) { return a.handle_ == b.handle_; }

private:
    const Level* level_;
    handle_type handle_;
};

} // namespace kith
