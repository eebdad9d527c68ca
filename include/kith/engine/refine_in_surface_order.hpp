// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/numbered_level.hpp>
#include <kith/numbering/step/step.hpp>

#include <concepts>
#include <utility>

namespace kith {

/// Returns true if a refinement can be made in the order of the surface. The first level alone is not worth the
/// sorting. Cost: O(1).
template <std::unsigned_integral Index, scheme Scheme>
    requires orderable_scheme<Scheme, Index>
bool can_be_ordered(const connectivity<Index>& control, const Scheme& scheme, int levels)
{
    return levels >= 2 and ignores_numbers(scheme) and detail::is_free_of_order<Scheme>(control.is_closed());
}

/// Refines a mesh that is in another order, so that it becomes a later level, in that order, with the numbers that
/// its elements have where the given mesh is refined, and the scheme that of this level. Precondition:
/// can_be_ordered. Cost: that of the steps, and for each element of their levels its number.
template <class Point, std::unsigned_integral Index, scheme Scheme>
    requires orderable_scheme<Scheme, Index>
void refine_ordered(ordered_mesh<Point, Index>& mesh, Scheme& scheme, int steps)
{
    numbering_of<Scheme, Index> ids;
    for (; steps > 0; --steps) {
        const int generation = mesh.mesh.generation();
        auto fine = refine_mesh<connect::everything>(mesh.mesh, scheme, ids);
        const level_of<basic_mesh<Point, Index>> coarse(mesh.mesh);
        mesh.numbers = after(mesh.numbers, coarse, ids, columns_of(scheme, generation));
        advance(scheme, coarse, generation, ids, fine);
        mesh.mesh = std::move(fine);
    }
}

/// Makes the last level of a refinement by one step from a mesh in another order, as if it had the given one.
/// Precondition: can_be_ordered.
template <class Point, std::unsigned_integral Index, scheme Scheme, class LastLevel>
    requires orderable_scheme<Scheme, Index>
void step_to_last(const ordered_mesh<Point, Index>& mesh, const Scheme& scheme, LastLevel& last)
{
    constexpr int degree = int(numbering_of<Scheme, Index>::common_degree);
    const level_elements<numbered_level<Point, Index, degree>> coarse(mesh.mesh, mesh.numbers);
    last.step(coarse, mesh.mesh.generation(), scheme);
}

} // namespace kith
