// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.hpp"

#include <kith/step/numbered_level.hpp>
#include <kith/step/step.hpp>

#include <concepts>
#include <tuple>
#include <utility>

namespace kith {

namespace detail {

/// Whether ids follow from tuples in one way in meshes that differ in the order of their elements: no column picks tuples by
/// a condition or, in a closed mesh, none but by the boundary.
template <class... Columns>
constexpr bool is_free_of_order(const std::tuple<Columns...>*, bool closed)
{
    const auto column_is_free = []<tuple_kind K, class W, class D>(const column<K, W, D>*, bool without_boundary) {
        if constexpr (requires { W::inner; })
            return without_boundary;
        else
            return std::same_as<W, everywhere> or std::same_as<W, all_or_none>;
    };
    return (column_is_free(static_cast<const Columns*>(nullptr), closed) and ...);
}

template <scheme Scheme>
constexpr bool is_free_of_order(bool closed)
{
    using columns = decltype(columns_of(std::declval<const Scheme&>(), 0));
    return is_free_of_order(static_cast<const decltype(columns::vertices.list)*>(nullptr), closed) and
           is_free_of_order(static_cast<const decltype(columns::edges.list)*>(nullptr), closed) and
           is_free_of_order(static_cast<const decltype(columns::faces.list)*>(nullptr), closed);
}

} // namespace detail

/// A scheme that may refine a mesh in another order of its elements, with the numbers of the given one on the last level:
/// the same bits, with fewer reads from outside the caches.
template <class Scheme, class Index>
concept orderable_scheme = is_trusted<Scheme> and countable_scheme<Scheme> and
                           numbering_of<Scheme, Index>::has_edges and
                           numbering_of<Scheme, Index>::common_degree != 0 and
                           detail::is_free_of_order<Scheme>(true) and
                           detail::says_ignores_numbers<Scheme, traits_type<Scheme>>;

/// Whether a refinement to face-vertex lists gains by the order of the surface: the first level alone is not worth the
/// sorting, and where edges are asked for, too, writing here and there costs what reading does not. Cost: O(edges).
template <scheme Scheme, std::unsigned_integral Index>
    requires orderable_scheme<Scheme, Index>
bool is_worth_ordering(const connectivity<Index>& control, const Scheme& scheme, int levels)
{
    const bool closed = control.corners() == 2 * control.edges();
    return levels >= 2 and ignores_numbers(scheme) and detail::is_free_of_order<Scheme>(closed) and
           is_scattered(control);
}

/// What `refine` makes of a mesh with `connect::faces`, to the bit, by way of the mesh in the order of its surface.
/// Preconditions: levels > 1, and is_worth_ordering but for the part about scattered meshes; the mesh has its edges.
/// Cost: that of the levels, and for each element of the last but one its number.
template <class Point, std::unsigned_integral Index, scheme Scheme>
    requires orderable_scheme<Scheme, Index>
basic_mesh<Point, Index> refine_in_surface_order(const basic_mesh<Point, Index>& control, Scheme scheme, int levels)
{
    auto [mesh, numbers] = in_surface_order(control);
    numbering_of<Scheme, Index> ids;
    for (int level = 1; level < levels; ++level) {
        auto fine = refine_mesh<connect::everything>(mesh, scheme, ids);
        const level_of<basic_mesh<Point, Index>> coarse(mesh);
        numbers = after(numbers, coarse, ids, columns_of(scheme, mesh.generation()));
        advance(scheme, coarse, mesh.generation(), ids, fine);
        mesh = std::move(fine);
    }
    constexpr int degree = int(numbering_of<Scheme, Index>::common_degree);
    const level_elements<numbered_level<Point, Index, degree>> coarse(mesh, numbers);
    return refine_level<connect::faces>(coarse, scheme, mesh.generation(), ids);
}

} // namespace kith
