// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>
#include <kith/core/level/level_elements.hpp>
#include <kith/core/level/values.hpp>

#include <cstddef>
#include <span>

namespace kith {

/// A level whose vertices remember the corner at which they were met. A mask can then be evaluated over values at
/// corners: a neighbour has its value in the face through which the walk came to it. A vertex is still one element,
/// with one number, whatever the corner.
template <level Level>
class walk_by_corners {
public:
    using point_type = typename Level::point_type;
    using index_type = typename Level::index_type;
    using edge_handle = typename Level::edge_handle;
    using face_handle = typename Level::face_handle;
    using corner_handle = typename Level::corner_handle;
    struct vertex_handle {
        typename Level::vertex_handle vertex;
        corner_handle corner;

        friend bool operator==(const vertex_handle& a, const vertex_handle& b) { return a.vertex == b.vertex; }
    };
    static inline const corner_handle no_corner = Level::no_corner;
    static constexpr bool parallel = Level::parallel;

    /// Takes a level, which must outlive the view.
    explicit walk_by_corners(const Level& level) : level_(&level) {}

    [[nodiscard]] std::size_t vertex_count() const { return level_->vertex_count(); }
    [[nodiscard]] std::size_t edge_count() const { return level_->edge_count(); }
    [[nodiscard]] std::size_t face_count() const { return level_->face_count(); }
    [[nodiscard]] std::size_t corner_count() const { return level_->corner_count(); }
    [[nodiscard]] bool is_closed() const { return level_->is_closed(); }

    /// Returns a vertex, met at the first corner of its fan.
    [[nodiscard]] vertex_handle vertex_at(std::size_t i) const
    {
        const auto v = level_->vertex_at(i);
        return {v, level_->first(v)};
    }
    [[nodiscard]] edge_handle edge_at(std::size_t i) const { return level_->edge_at(i); }
    [[nodiscard]] face_handle face_at(std::size_t i) const { return level_->face_at(i); }
    [[nodiscard]] corner_handle corner_at(std::size_t i) const { return level_->corner_at(i); }

    [[nodiscard]] std::size_t index(const vertex_handle& v) const { return level_->index(v.vertex); }
    [[nodiscard]] std::size_t index(edge_handle e) const { return level_->index(e); }
    [[nodiscard]] std::size_t index(face_handle f) const { return level_->index(f); }
    [[nodiscard]] std::size_t index(corner_handle c) const { return level_->index(c); }
    [[nodiscard]] std::size_t halfedge(corner_handle c) const { return level_->halfedge(c); }

    [[nodiscard]] corner_handle first(const vertex_handle& v) const { return level_->first(v.vertex); }
    [[nodiscard]] corner_handle first(edge_handle e) const { return level_->first(e); }
    [[nodiscard]] corner_handle second(edge_handle e) const { return level_->second(e); }
    [[nodiscard]] corner_handle first(face_handle f) const { return level_->first(f); }
    [[nodiscard]] std::size_t degree(face_handle f) const { return level_->degree(f); }

    [[nodiscard]] corner_handle next(corner_handle c) const { return level_->next(c); }
    [[nodiscard]] corner_handle prev(corner_handle c) const { return level_->prev(c); }
    [[nodiscard]] corner_handle across(corner_handle c) const { return level_->across(c); }

    [[nodiscard]] vertex_handle vertex_of(corner_handle c) const { return {level_->vertex_of(c), c}; }
    [[nodiscard]] edge_handle edge_of(corner_handle c) const { return level_->edge_of(c); }
    [[nodiscard]] face_handle face_of(corner_handle c) const { return level_->face_of(c); }
    [[nodiscard]] decltype(auto) point(const vertex_handle& v) const { return level_->point(v.vertex); }

private:
    const Level* level_;
};
template <level Level>
using level_by_corners = level_elements<walk_by_corners<Level>>;

/// Values at the corners of a level, for masks over the vertices of level_by_corners.
template <affine_value T, level Level>
class corner_values : public fine_values<T> {
public:
    /// Takes a level and the values at its corners; both must outlive this.
    corner_values(const Level& level, std::span<const T> coarse) : level_(&level), coarse_(coarse) {}

    /// Returns empty values over the same coarse level, for another pass of a step.
    [[nodiscard]] corner_values another() const { return {*level_, coarse_}; }

    [[nodiscard]] decltype(auto) coarse(const vertex<level_by_corners<Level>>& v) const
    {
        return affine<T>::load(coarse_[level_->index(v.handle().corner)]);
    }

private:
    const Level* level_;
    std::span<const T> coarse_;
};

} // namespace kith
