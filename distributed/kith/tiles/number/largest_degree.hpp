// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary_facts.hpp"

#include <kith/core/level/to_native.hpp>
#include <kith/numbering/association/column_numbers.hpp>
#include <kith/numbering/association/numbering.hpp>
#include <kith/numbering/step/scheme.hpp>
#include <kith/tiles/part/tile_like.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <tuple>

namespace kith {

namespace detail {

/// Returns true if a column makes a face from this element.
template <class Where, class Element>
bool makes_face(const Where& where, const Element& element)
{
    if constexpr (std::same_as<Where, everywhere>)
        return true;
    else if constexpr (std::same_as<Where, all_or_none>)
        return where.all;
    else if constexpr (picks_at_boundary<Where>)
        return element.is_boundary() ? bool(where.keep(element)) : Where::inner;
    else
        return bool(where.keep(element));
}

/// Returns the largest degree of the faces that a column makes from the elements for which `is_ours` holds.
template <tuple_kind Kind, class Where, class Degree, level Level, class IsOurs>
std::size_t largest_degree_in(const column<Kind, Where, Degree>& c, const Level& level, const IsOurs& is_ours)
{
    if constexpr (fixed_degree_of<Degree> != 0) {
        return fixed_degree_of<Degree>;
    } else {
        std::size_t result = 0;
        for (const auto element : tuple_elements_of<Kind>(level))
            if (is_ours(element) and makes_face(c.where, element))
                result = std::max(result, std::size_t(c.degree(element)));
        return result;
    }
}

template <scheme Scheme, class Point, std::unsigned_integral Index, class IsOurs>
std::size_t largest_degree(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels,
                           const IsOurs& is_ours)
{
    const level_of<basic_mesh<Point, Index>> level(mesh);
    std::size_t result = 0;
    if (levels == 0) {
        for (const auto face : level.faces())
            if (is_ours(face))
                result = std::max(result, std::size_t(face.degree()));
        return result;
    }
    const auto columns = columns_of(scheme, mesh.generation());
    std::apply(
        [&](const auto&... column) { ((result = std::max(result, largest_degree_in(column, level, is_ours))), ...); },
        columns.faces.list);
    return result;
}

} // namespace detail

/// Returns the largest degree of the faces of level `levels`, at least if it is larger than that of a regular mesh. The
/// type in which PLY counts corners follows from it. Larger faces come from faces and vertices of the control mesh in
/// the first step, and later steps keep their degree. Precondition: the mesh has its edges. Cost: O(elements).
template <scheme Scheme, class Point, std::unsigned_integral Index>
std::size_t largest_degree(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels)
{
    return detail::largest_degree(control, scheme, levels, [](const auto&) { return true; });
}
/// Returns the largest degree for the elements that a tile of the control mesh owns; the maximum over all tiles is that
/// of the mesh. Precondition: the tile has a ring of ghosts. Local.
template <scheme Scheme, tile_like Tile>
std::size_t largest_degree(const Tile& part, const Scheme& scheme, int levels)
{
    return detail::largest_degree(
        part.mesh, scheme, levels, [&](const auto& element) { return detail::is_owned(part, element); });
}

} // namespace kith
