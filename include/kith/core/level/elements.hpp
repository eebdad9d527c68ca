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
    /// Returns the number of the half-edge: 2 * edge + side.
    [[nodiscard]] std::size_t halfedge() const { return level_->halfedge(handle_); }

    [[nodiscard]] vertex<Level> v() const { return {*level_, level_->vertex_of(handle_)}; }
    [[nodiscard]] face<Level> f() const { return {*level_, level_->face_of(handle_)}; }
    [[nodiscard]] corner next() const { return {*level_, level_->next(handle_)}; }
    [[nodiscard]] corner prev() const { return {*level_, level_->prev(handle_)}; }
    /// Returns the edge to the next vertex of the face, or from the previous one, seen from this face.
    [[nodiscard]] edge<Level> next_edge() const { return {*level_, level_->edge_of(handle_), handle_}; }
    [[nodiscard]] edge<Level> prev_edge() const { return prev().next_edge(); }
    /// Returns true if the next edge is a boundary edge. The corner then counts as a boundary tuple.
    [[nodiscard]] bool is_boundary() const { return level_->across(handle_) == Level::no_corner; }
    /// Returns the corner of the opposite half-edge of the next edge. Precondition: not is_boundary().
    [[nodiscard]] corner across() const { return {*level_, level_->across(handle_)}; }

    /// Returns the corners around the vertex, counter-clockwise from this one. At the boundary, the corners before this
    /// one are left out.
    [[nodiscard]] auto fan_from_here() const { return walk(*level_, detail::fan_step<Level>{handle_}); }
    /// Returns vertices around the vertex in the order of fan_from_here(). The neighbours are the other ends of its
    /// edges; the opposites are in each face the vertex after the next. At the boundary, the vertices before this
    /// corner and the last neighbour are left out.
    [[nodiscard]] auto neighbors_from_here() const
    {
        return fan_from_here().map([](const corner& c) { return c.next().v(); });
    }
    [[nodiscard]] auto opposites_from_here() const
    {
        return fan_from_here().map([](const corner& c) { return c.next().next().v(); });
    }
    /// Returns the vertices of the face, counter-clockwise from the vertex of this corner.
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
    /// Returns the face on the right. Precondition: not is_boundary().
    [[nodiscard]] face<Level> rface() const { return rcorner().f(); }
    /// Returns the corner of org in lface, or the corner of dst in rface (precondition: not is_boundary()).
    [[nodiscard]] corner<Level> lcorner() const { return {*level_, left_}; }
    [[nodiscard]] corner<Level> rcorner() const { return {*level_, level_->second(handle_)}; }
    /// Returns the corner through which this edge was reached. From a face, it is the corner of the edge's half-edge in
    /// that face; otherwise it is lcorner().
    [[nodiscard]] corner<Level> seen_from() const { return {*level_, seen_from_}; }

    friend bool operator==(const edge& a, const edge& b) { return a.handle_ == b.handle_; }

private:
    const Level* level_;
    handle_type handle_;
    corner_handle seen_from_;
    corner_handle left_;
};

/// A vertex. Its fan is the sequence of its corners, counter-clockwise. At the boundary, the fan runs from one boundary
/// edge to the other.
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
    /// Returns the edges counter-clockwise, including the last boundary edge. Each is seen from the face to its left;
    /// the last boundary edge is seen from its only face.
    [[nodiscard]] auto edges() const
    {
        return spokes().map([](const auto& spoke) { return spoke.edge; });
    }
    /// Returns the other ends of edges(), in the same order.
    [[nodiscard]] auto neighbors() const
    {
        return spokes().map([](const auto& spoke) { return spoke.end; });
    }
    /// Returns in each face the vertex after the next, counter-clockwise: in a quad the vertex opposite this one.
    [[nodiscard]] auto opposites() const { return first_corner().opposites_from_here(); }
    /// Returns the number of edges.
    [[nodiscard]] std::size_t valence() const { return face_count() + (is_boundary() ? 1 : 0); }
    /// Returns true if the valence is n. Cost: O(the smaller of n and the valence).
    [[nodiscard]] bool has_valence(std::size_t n) const
    {
        std::size_t found = is_boundary() ? 1 : 0;
        for (auto c = corners().begin(); not(c == corners().end()) and found <= n; ++c)
            ++found;
        return found == n;
    }
    /// Returns the number of faces, which at the boundary is one less than the number of edges.
    [[nodiscard]] std::size_t face_count() const
    {
        std::size_t result = 0;
        for ([[maybe_unused]] const auto& c : corners())
            ++result;
        return result;
    }
    /// Returns the last corner of the fan; its prev_edge() is the last of edges(). Precondition: is_boundary().
    [[nodiscard]] corner<Level> last_corner() const
    {
        auto last = first_corner();
        for (auto p = last.prev(); not p.is_boundary(); p = last.prev())
            last = p.across();
        return last;
    }
    /// Returns the first or the last of neighbors(): the two boundary neighbours. Precondition: is_boundary().
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
    /// Returns the number of corners.
    [[nodiscard]] std::size_t degree() const { return level_->degree(handle_); }
    /// Returns true if one of its edges is a boundary edge.
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
