// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbered_tile.hpp"
#include "global_levels.hpp"

#include <kith/numbering/step/step.hpp>
#include <kith/tiles/number/new_elements.hpp>

#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith {

/// Makes the last step of a refinement: returns the owned faces and their vertices, without edges and ghosts, in half
/// of the memory. Errors and cost: as refine_once.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
tile<Point, Index> refine_last(const tile<Point, Index>& coarse, const Scheme& scheme, int level,
                               const global_levels_of<Scheme>& whole)
{
    constexpr Index none = connectivity<Index>::none;
    numbering_of<Scheme, Index> ids;
    const auto fine = refine_mesh<connect::faces>(coarse.mesh, scheme, ids);
    const detail::new_elements elements(coarse, ids, whole.numbering(level));

    const std::vector<unsigned char> owned = elements.owned_faces();
    std::vector<Index> faces;
    for (std::size_t f = 0; f < owned.size(); ++f)
        if (owned[f] != 0)
            faces.push_back(Index(f));
    std::vector<Index> here(fine.vertex_count(), none), vertices;
    for (const Index f : faces)
        for (const Index v : fine.face(f))
            here[v] = 0;
    for (std::size_t v = 0; v < here.size(); ++v)
        if (here[v] != none) {
            here[v] = Index(vertices.size());
            vertices.push_back(Index(v));
        }

    tile<Point, Index> result;
    elements.number_faces(result, faces, owned);
    const auto first_is_owned = detail::owned_first_faces(fine, owned);
    elements.number_vertices(result, vertices, [&](Index v) { return first_is_owned[v] != 0; });

    connectivity<Index> t;
    t.vertices = vertices.size();
    const auto degree_of = [&](std::size_t i) { return fine.face(faces[i]).size(); };
    const int degree = fine.topology().degree;
    t.allocate_faces(faces.size(), degree != 0 ? degree : detail::degree_if_alike(faces.size(), degree_of), degree_of);
    Index corner = 0;
    for (const Index f : faces)
        for (const Index v : fine.face(f))
            t.corner_vertex[corner++] = here[v];
    storage<Point> points(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        points[i] = fine.point(vertices[i]);
    result.mesh = {std::move(points), std::move(t), fine.generation()};
    return result;
}

} // namespace kith
