// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_numbers.hpp"
#include "placed_state.hpp"

#include <kith/step/step.hpp>
#include <kith/step/submesh.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// The rings around some faces that are needed on each level before a step, if there are to be none on the last level. At least
/// one, so that the fans of all their vertices are whole.
template <reaching_scheme Scheme>
std::vector<int> rings_before_steps(const Scheme& scheme, std::size_t steps)
{
    std::vector<int> rings(steps + 1, 0);
    for (std::size_t step = steps; step > 0; --step)
        rings[step - 1] = std::max(1, reach_of(scheme, rings[step]));
    rings.pop_back();
    return rings;
}

/// Refines a part of a level by the scheme of the part, a step for each of the bases, and makes its numbers those of the last level.
/// `refine(mesh, scheme, ids)` makes a step, `refine_last(mesh, scheme, ids)` the last one. `is_own` tells by the number of a face
/// whether it is wanted; in between all is cut off that no wanted face needs. Precondition: the rings of the first step are there.
/// Errors and cost: those of the steps.
template <scheme Scheme, class Point, std::unsigned_integral Index, inherited_number Number, class IsOwn, class Refine,
          class RefineLast>
basic_mesh<Point, Index> refine_part(basic_mesh<Point, Index> part, Scheme scheme, part_of_whole<Number>& numbers,
                                     std::span<const column_bases> bases, std::span<const int> rings,
                                     const IsOwn& is_own, const Refine& refine, const RefineLast& refine_last)
{
    numbering_of<Scheme, Index> ids;
    for (std::size_t step = 0; step + 1 < bases.size(); ++step) {
        const basic_mesh<Point, Index> fine = refine(part, scheme, ids);
        advance(scheme, level_of<basic_mesh<Point, Index>>(part), part.generation(), ids, fine);
        const auto all = numbers.next(ids, bases[step]);
        std::vector<Index> own;
        for (std::size_t f = 0; f < all.faces.size(); ++f)
            if (is_own(all.faces[f]))
                own.push_back(Index(f));
        submesh_cutter<Point, Index> cutter(fine);
        auto cut = cutter.cut(cutter.faces_around(own, rings[step + 1]));
        numbers = all.template of_part<Index>(cut.vertex_from, cut.edge_from, cut.face_from);
        take_state_of_part(scheme, scheme, cut.numbers());
        part = std::move(cut.mesh);
    }
    basic_mesh<Point, Index> last = refine_last(part, scheme, ids);
    numbers = numbers.next(ids, bases.back());
    return last;
}

} // namespace kith
