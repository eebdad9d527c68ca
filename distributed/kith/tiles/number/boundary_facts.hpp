// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "column_facts.hpp"
#include "global_tuple.hpp"

#include <kith/core/level/to_native.hpp>
#include <kith/numbering/association/column_numbers.hpp>
#include <kith/tiles/part/tile_like.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace kith {

/// A tuple at the boundary of the whole mesh that a column visits, and its new element.
struct boundary_fact {
    std::uint64_t column = 0; ///< index of the column among the columns of one kind of new elements
    global_id tuple = 0;
    std::int64_t corners_more = 0; ///< if the new face has no fixed degree: its corners minus the faces of the tuple
    std::uint64_t is_kept = 0;     ///< 1 if the tuple makes an element; a whole word, so that a fact has no padding

    friend auto operator<=>(const boundary_fact&, const boundary_fact&) = default;
};

namespace detail {

template <tile_like Tile, level Level>
bool is_owned(const Tile& rim, const vertex<Level>& v)
{
    return rim.owns_vertex(v.index());
}
template <tile_like Tile, level Level>
bool is_owned(const Tile& rim, const edge<Level>& e)
{
    return rim.owns_edge(e.index());
}
template <tile_like Tile, level Level>
bool is_owned(const Tile& rim, const face<Level>& f)
{
    return rim.owns_face(f.index());
}
template <tile_like Tile, level Level>
bool is_owned(const Tile& rim, const corner<Level>& c)
{
    return rim.owns_face(c.f().index());
}

/// Calls f with the number, in the tile, of each owned tuple at the boundary of the whole mesh. At a vertex, an edge or
/// a corner that the tile owns, the boundary edges of the tile are those of the whole mesh.
template <tuple_kind Kind, tile_like Tile, level Level, class F>
void for_boundary_tuples(const Tile& rim, const Level& level, const F& f)
{
    for (std::size_t tuple = 0; tuple < tuple_count(level, Kind); ++tuple) {
        const auto element = tuple_element<Kind>(level, tuple);
        if (element.is_boundary() and is_owned(rim, element))
            f(tuple);
    }
}

template <tuple_kind Kind, class Where, class Degree, tile_like Tile, level Level>
void add_boundary_facts(const column<Kind, Where, Degree>& c, std::uint64_t i, const Tile& part, const Level& level,
                        std::vector<boundary_fact>& facts)
{
    if constexpr (picks_at_boundary<Where>)
        for_boundary_tuples<Kind>(part, level, [&](std::size_t tuple) {
            const auto element = tuple_element<Kind>(level, tuple);
            const bool keep = c.where.keep(element);
            std::int64_t more = 0;
            if constexpr (has_degree<Degree> and fixed_degree_of<Degree> == 0)
                more = (keep ? std::int64_t(c.degree(element)) : 0) - std::int64_t(element.face_count());
            if (Where::inner or keep)
                facts.push_back({i, in_whole<Kind>(part, parent(level, Kind, tuple), tuple).id, more, keep});
        });
}

} // namespace detail

/// Returns the facts of the owned boundary for the columns of one kind of new elements. Precondition: the tile has a
/// ring of ghosts. Cost: O(elements).
template <template <class...> class List, class... Columns, tile_like Tile>
std::vector<boundary_fact> boundary_facts(const List<Columns...>& columns, const Tile& part)
{
    const level_of<basic_mesh<typename Tile::point_type, typename Tile::index_type>> level(part.mesh);
    std::vector<boundary_fact> facts;
    std::uint64_t i = 0;
    std::apply([&](const auto&... column) { (detail::add_boundary_facts(column, i++, part, level, facts), ...); },
               columns.list);
    return facts;
}

} // namespace kith
