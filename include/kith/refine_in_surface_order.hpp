// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.hpp"

#include <kith/step/numbered_level.hpp>
#include <kith/step/step.hpp>

#include <concepts>
#include <utility>

namespace kith {

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
basic_mesh<Point, Index> refine_in_surface_order(basic_mesh<Point, Index> control, Scheme scheme, int levels)
{
    auto [mesh, numbers] = in_surface_order(std::exchange(control, {}));
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
