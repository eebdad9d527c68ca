// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/numbered_level.hpp>
#include <kith/numbering/step/step.hpp>

#include <concepts>
#include <utility>

namespace kith {

/// Returns true if a refinement can be made in the order of the surface, and if sorting pays: not for a single level.
/// Cost: O(1).
template <std::unsigned_integral Index, scheme Scheme>
    requires orderable_scheme<Scheme, Index>
bool can_be_ordered(const connectivity<Index>& control, const Scheme& scheme, int levels)
{
    return levels >= 2 and ignores_numbers(scheme) and detail::is_free_of_order<Scheme>(control.is_closed());
}

/// Refines a reordered mesh `steps` times in place. Its `numbers` then map each element to its number in the refinement
/// of the original mesh. `scheme` is advanced to the new level. Precondition: can_be_ordered. Cost: that of the steps,
/// and of one number for each element of their levels.
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

/// Makes the last level of a refinement by one step from a reordered mesh. Its elements get the numbers that follow
/// from the original mesh. Precondition: can_be_ordered.
template <class Point, std::unsigned_integral Index, scheme Scheme, class LastLevel>
    requires orderable_scheme<Scheme, Index>
void step_to_last(const ordered_mesh<Point, Index>& mesh, const Scheme& scheme, LastLevel& last)
{
    constexpr int degree = int(numbering_of<Scheme, Index>::common_degree);
    const level_elements<numbered_level<Point, Index, degree>> coarse(mesh.mesh, mesh.numbers);
    last.step(coarse, mesh.mesh.generation(), scheme);
}

} // namespace kith
