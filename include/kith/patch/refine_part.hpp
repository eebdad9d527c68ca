// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_numbers.hpp"

#include <kith/lane/tape.hpp>
#include <kith/neighbourhood/placed_state.hpp>
#include <kith/step/step.hpp>
#include <kith/step/submesh.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// Tells what patches make for the vertices of the last level: their points, or other values in the place of points,
/// such as limits.
template <class Point, std::unsigned_integral Index, class Scheme>
struct patch_output_kind {
    using is_wanted = std::function<bool(std::size_t)>;
    /// Puts the values of wanted vertices in the place of their points, in a part of the last level.
    template <class Value>
    using replace = std::function<void(basic_mesh<Value, Index>& last, const Scheme&, const is_wanted&)>;

    std::size_t key = 0;             ///< a distinct constant per kind; it is part of the key of the template cache
    replace<Point> replace_points{}; ///< empty for points
    replace<recorded<scalar_of<Point>>> replace_recorded{}; ///< same, but for values that are recorded

    [[nodiscard]] bool are_points() const { return key == 0; }
};

/// The rings around some faces that are enough on each level before a step, if there are to be `last` on the last
/// level. At least one, so that the fans of all their vertices are whole.
template <reaching_scheme Scheme>
std::vector<int> rings_before_steps(const Scheme& scheme, std::size_t steps, int last)
{
    std::vector<int> rings(steps + 1, last);
    for (std::size_t step = steps; step > 0; --step)
        rings[step - 1] = std::max(1,
                                   detail::says_reach_of_steps<Scheme, traits_type<Scheme>>
                                       ? reach_of(scheme, last, int(steps - step + 1))
                                       : reach_of(scheme, rings[step]));
    rings.pop_back();
    return rings;
}

/// Makes of a part of a level that of the level before the last one, with a step for each of the bases but the last, of
/// its scheme the scheme there and of its numbers those there. `refine(mesh, scheme, ids)` makes a step. `is_own` tells
/// by the number of a face whether it is wanted; after a step all is cut off that no wanted face needs, where that
/// costs less than refining it: for a wanted face as much as making `cost_of_cut` faces. Precondition: the rings of the
/// first step are there.
/// Errors and cost: those of the steps.
template <reaching_scheme Scheme, class Point, std::unsigned_integral Index, inherited_number Number, class IsOwn,
          class Refine>
basic_mesh<Point, Index> refine_part(basic_mesh<Point, Index> part, Scheme& scheme, part_of_whole<Number>& numbers,
                                     std::span<const column_bases> bases, std::span<const int> rings,
                                     const IsOwn& is_own, double cost_of_cut, const Refine& refine)
{
    numbering_of<Scheme, Index> ids;
    for (std::size_t step = 0; step + 1 < bases.size(); ++step) {
        basic_mesh<Point, Index> fine = refine(part, scheme, ids);
        advance(scheme, level_of<basic_mesh<Point, Index>>(part), part.generation(), ids, fine);
        numbers = numbers.next(part.topology(), ids, bases[step]);
        const double made_of_each = std::pow(double(fine.face_count()) / double(part.face_count()),
                                             bases.size() - step - 1);
        part = std::move(fine);
        std::vector<Index> own;
        for (std::size_t f = 0; f < numbers.faces.size(); ++f)
            if (is_own(numbers.faces[f]))
                own.push_back(Index(f));
        if (double(part.face_count() - own.size()) * made_of_each <= cost_of_cut * double(own.size()))
            continue;
        submesh_cutter<Point, Index> cutter(part);
        auto cut = cutter.cut(cutter.faces_around(own, rings[step + 1]));
        numbers = numbers.template of_part<Index>(cut.vertex_from, cut.edge_from, cut.face_from);
        take_state_of_part(scheme, scheme, cut.numbers());
        part = std::move(cut.mesh);
    }
    return part;
}

} // namespace kith
