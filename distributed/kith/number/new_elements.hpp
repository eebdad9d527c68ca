// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tuple_facts.hpp"
#include "whole_numbering.hpp"
#include "whole_tuple.hpp"

#include <kith/part/tile_like.hpp>
#include <kith/step/step.hpp>

#include <cstddef>
#include <utility>

namespace kith::detail {

/// What one step makes of a tile: the numbers of the new elements in the whole mesh, and whether the tile owns them.
/// A new face belongs to whom the coarse face belongs that it came from. So does a vertex or an edge that a face, or a
/// corner of it, gave birth to; every other one belongs to the first of the new faces around it. They are all here when
/// all old ones around the tuple are.
template <tile_like Tile, scheme Scheme>
class new_elements {
    using index = typename Tile::index_type;
    using numbers = numbering_of<Scheme, index>;

public:
    using whole_type = whole_numbering<columns_type<Scheme>>;

    new_elements(const Tile& coarse, const numbers& ids, const whole_type& whole)
        : coarse_(coarse), ids_(ids), whole_(whole), facts_(coarse)
    {
    }

    [[nodiscard]] const tuple_facts<Tile>& facts() const { return facts_; }

    [[nodiscard]] global_id vertex_id(std::size_t vertex) const
    {
        return whole_.vertices.id(in_whole(ids_.vertices.origin(vertex)));
    }
    [[nodiscard]] global_id edge_id(std::size_t edge) const
    {
        return whole_.edges.id(in_whole(ids_.edges.origin(edge)));
    }
    [[nodiscard]] bool owns_face(std::size_t face) const
    {
        const auto [kind, tuple] = ids_.faces.origin(face);
        return facts_.is_owned(kind, tuple);
    }
    /// `owns_first_face()` says whether the first of the new faces around the vertex is owned.
    template <class F>
    [[nodiscard]] bool owns_vertex(std::size_t vertex, const F& owns_first_face) const
    {
        return owns(ids_.vertices.origin(vertex), owns_first_face);
    }
    template <class F>
    [[nodiscard]] bool owns_edge(std::size_t edge, const F& owns_first_face) const
    {
        return owns(ids_.edges.origin(edge), owns_first_face);
    }

    /// Makes room for the faces of the next tile.
    void begin_faces(Tile& next, std::size_t faces) const
    {
        next.face_ids = storage<global_id>(faces);
        next.face_marks = storage<unsigned char>(faces);
        next.root_of = storage<index>(faces);
        if constexpr (is_mixed)
            next.first_corner_ids = storage<global_id>(faces);
        next.roots = coarse_.roots;
    }
    /// Numbers face `at` of the next tile, which is new face `face`.
    void number_face(Tile& next, std::size_t at, std::size_t face) const
    {
        const auto origin = ids_.faces.origin(face);
        const whole_tuple tuple = in_whole(origin);
        next.face_ids[at] = whole_.faces.id(tuple);
        next.root_of[at] = coarse_.root_of[facts_.face(origin.first, origin.second)];
        if constexpr (is_mixed)
            next.first_corner_ids[at] = whole_.faces.first_corner(tuple);
    }

private:
    static constexpr bool is_mixed = numbers::common_degree == 0; // if not here, then elsewhere

    [[nodiscard]] whole_tuple in_whole(const std::pair<tuple_kind, std::size_t>& origin) const
    {
        return detail::in_whole(coarse_, facts_.level(), origin.first, origin.second);
    }
    template <class F>
    [[nodiscard]] bool owns(const std::pair<tuple_kind, std::size_t>& origin, const F& owns_first_face) const
    {
        const auto [kind, tuple] = origin;
        return parent_kind(kind) == element_kind::face ? facts_.is_owned(kind, tuple)
                                                       : facts_.is_complete(kind, tuple) and owns_first_face();
    }

    const Tile& coarse_;
    const numbers& ids_;
    const whole_type& whole_;
    tuple_facts<Tile> facts_;
};

} // namespace kith::detail
