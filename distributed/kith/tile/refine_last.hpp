// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "whole_levels.hpp"

#include <kith/number/new_elements.hpp>
#include <kith/step/step.hpp>

#include <concepts>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith {

/// The last step of all: the faces that the tile owns and their vertices, without edges and shadows, in half of the
/// memory.
/// Errors and cost: as refine_once.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
tile<Point, Index> refine_last(const tile<Point, Index>& coarse, const Scheme& scheme, int level,
                               const whole_levels<Scheme>& whole)
{
    constexpr Index none = connectivity<Index>::none;
    numbering_of<Scheme, Index> ids;
    const auto fine = refine_mesh<connect::faces>(coarse.mesh, scheme, ids);
    const detail::new_elements<tile<Point, Index>, Scheme> elements(coarse, ids, whole.numbering(level));

    std::vector<unsigned char> owned(fine.face_count());
    std::size_t faces = 0;
    for (std::size_t f = 0; f < fine.face_count(); ++f) {
        owned[f] = elements.owns_face(f);
        faces += owned[f];
    }
    std::vector<unsigned char> is_met(fine.vertex_count(), 0), first_face_is_owned(fine.vertex_count(), 0);
    std::vector<Index> here(fine.vertex_count(), none);
    for (std::size_t f = 0; f < fine.face_count(); ++f)
        for (const Index v : fine.face(f)) {
            if (is_met[v] == 0)
                first_face_is_owned[v] = owned[f];
            is_met[v] = 1;
            if (owned[f] != 0)
                here[v] = 0;
        }
    Index vertices = 0;
    for (Index& v : here)
        if (v != none)
            v = vertices++;

    tile<Point, Index> result;
    connectivity<Index> t;
    t.vertices = vertices;
    t.allocate_faces(faces, fine.topology().degree, [&, f = std::size_t(0)](std::size_t) mutable {
        while (owned[f] == 0)
            ++f;
        return fine.face(f++).size();
    });
    elements.begin_faces(result, faces);
    std::fill(result.face_marks.begin(), result.face_marks.end(), owned_mark);
    Index corner = 0;
    for (std::size_t f = 0, n = 0; f < fine.face_count(); ++f) {
        if (owned[f] == 0)
            continue;
        elements.number_face(result, n, f);
        for (const Index v : fine.face(f))
            t.corner_vertex[corner++] = here[v];
        ++n;
    }
    storage<Point> points(vertices);
    result.vertex_ids = storage<global_id>(vertices);
    result.vertex_marks = storage<unsigned char>(vertices);
    for (std::size_t v = 0; v < fine.vertex_count(); ++v) {
        if (here[v] == none)
            continue;
        points[here[v]] = fine.point(v);
        result.vertex_ids[here[v]] = elements.vertex_id(v);
        const bool mine = elements.owns_vertex(v, [&] { return first_face_is_owned[v] != 0; });
        result.vertex_marks[here[v]] = mine ? owned_mark : 0;
    }
    result.mesh = {std::move(points), std::move(t), fine.generation()};
    return result;
}

} // namespace kith
