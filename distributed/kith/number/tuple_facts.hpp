// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/association/columns.hpp>
#include <kith/level/lift.hpp>
#include <kith/part/tile_like.hpp>
#include <kith/step/children.hpp>

#include <cstddef>

namespace kith::detail {

/// Where a tuple belongs in a tile: to whom, and to which face.
template <tile_like Tile>
class tuple_facts {
public:
    using level_type = level_of<basic_mesh<typename Tile::point_type, typename Tile::index_type>>;

    explicit tuple_facts(const Tile& coarse) : coarse_(coarse), level_(coarse.mesh) {}

    [[nodiscard]] const level_type& level() const { return level_; }

    [[nodiscard]] bool is_owned(tuple_kind kind, std::size_t tuple) const
    {
        const std::size_t x = parent(level_, kind, tuple);
        switch (parent_kind(kind)) {
        case element_kind::vertex: return coarse_.owns_vertex(x);
        case element_kind::edge: return coarse_.owns_edge(x);
        default: return coarse_.owns_face(x);
        }
    }
    /// Of the faces at the tuple the one with the smallest number.
    [[nodiscard]] std::size_t face(tuple_kind kind, std::size_t tuple) const
    {
        return parent_face(level_, kind, tuple);
    }
    /// Whether a rim that a tuple gives birth to is the boundary of the whole mesh. Precondition: it is a rim here.
    [[nodiscard]] bool is_at_true_boundary(tuple_kind kind, std::size_t tuple) const
    {
        switch (kind) {
        case tuple_kind::v: return is_complete(level_.vertices()[tuple]);
        case tuple_kind::e: return not coarse_.is_cut(tuple);
        case tuple_kind::ve: return not coarse_.is_cut(tuple / 2);
        case tuple_kind::f: return true;
        case tuple_kind::vfe: tuple /= 2; [[fallthrough]];
        default: return not coarse_.is_cut(level_.corners()[tuple].next_edge().index());
        }
    }
    /// All faces that a vertex or an edge has in the whole mesh are here.
    [[nodiscard]] bool is_complete(tuple_kind kind, std::size_t tuple) const
    {
        const std::size_t x = parent(level_, kind, tuple);
        return kind == tuple_kind::v ? is_complete(level_.vertices()[x]) : not coarse_.is_cut(x);
    }
    [[nodiscard]] bool is_complete(const vertex<level_type>& v) const
    {
        return not v.is_boundary() or not(coarse_.is_cut(v.first_corner().next_edge().index()) or
                                          coarse_.is_cut(v.last_corner().prev_edge().index()));
    }

private:
    const Tile& coarse_;
    level_type level_;
};

} // namespace kith::detail
