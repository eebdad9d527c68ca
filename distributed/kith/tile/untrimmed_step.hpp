// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbered_tile.hpp"
#include "whole_levels.hpp"

#include <kith/base/storage.hpp>
#include <kith/neighbourhood/affine_columns.hpp>
#include <kith/neighbourhood/descents.hpp>
#include <kith/step/step.hpp>

#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace kith::detail {

/// Refines a tile of level `level` once and keeps all that the step makes, also what is wrong at the rim. The tile knows
/// the numbers of its elements and which it owns, and says nothing of cuts. `scheme` becomes that of the next level.
/// Preconditions: numbers are affine with and without a boundary, and all faces have the degree of refined ones.
/// Errors: as `refine`. Cost: that of the step.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
    requires faces_descend_from_faces<Scheme, Index>
tile<Point, Index> refine_untrimmed(const tile<Point, Index>& coarse, Scheme& scheme, int level,
                                    const whole_levels<Scheme>& whole)
{
    constexpr std::size_t degree = numbering_of<Scheme, Index>::common_degree;
    const int generation = coarse.mesh.generation();
    const column_bases here = bases_of_columns(scheme, count(coarse.mesh.topology()), generation);
    const column_bases there = bases_of_columns(scheme, whole.counts(level).as_counts(), generation);
    tile<Point, Index> result;
    result.mesh = coarse.mesh;
    make_levels(result.mesh, scheme, 1);

    const auto number = [&](tuple_kind made, std::size_t size, auto& ids, auto& marks, auto&& each) {
        const auto ways = descents_of(made, std::span(&here, 1), degree);
        const auto ways_there = descents_of(made, std::span(&there, 1), degree);
        ids = storage<global_id>(size);
        marks = storage<unsigned char>(size);
        for (std::size_t i = 0; i < ways.size(); ++i) {
            const auto parents = ids_of(coarse, parent_kind(ways[i].from));
            const auto marks_of_parents = marks_of(coarse, parent_kind(ways[i].from));
            std::size_t next = ways[i].first;
            for (std::size_t parent = 0; parent < parents.size(); ++parent)
                for (std::size_t which = 0; which < ways[i].each; ++which, ++next) {
                    ids[next] = ways_there[i].first + ways_there[i].each * parents[parent] + which;
                    marks[next] = marks_of_parents[parent] & owned_mark;
                    each(next, parent);
                }
        }
    };
    const auto nothing_more = [](std::size_t, std::size_t) {};
    number(tuple_kind::v, result.mesh.vertex_count(), result.vertex_ids, result.vertex_marks, nothing_more);
    number(tuple_kind::e, result.mesh.edge_count(), result.edge_ids, result.edge_marks, nothing_more);
    result.roots = coarse.roots;
    result.root_of = storage<Index>(result.mesh.face_count());
    number(tuple_kind::f,
           result.mesh.face_count(),
           result.face_ids,
           result.face_marks,
           [&](std::size_t face, std::size_t parent) { result.root_of[face] = coarse.root_of[parent]; });
    return result;
}

} // namespace kith::detail
