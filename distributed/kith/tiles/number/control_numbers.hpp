// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "column_facts.hpp"
#include "prefix_sums.hpp"

#include <kith/core/level/to_native.hpp>
#include <kith/tiles/part/tile_like.hpp>

#include <concepts>
#include <cstddef>
#include <vector>

namespace kith {

/// The numbers of a control mesh for which there is no formula, since its faces have any degrees and its edges any
/// order. They are the corners of the faces before a face. If the scheme needs them, they are also the faces at the
/// vertices before a vertex (numbers_corners_at_vertices) and the marked edges before an edge (marks_edges). They are
/// stored in runs: one run for a mesh of one degree, otherwise one for each change of degree.
struct control_numbers {
    prefix_sums corners_of_faces, faces_at_vertices, marked_edges;
};

/// The runs of control_numbers, as far as they are known.
struct control_runs {
    std::vector<equal_run> corners_of_faces, faces_at_vertices, marked_edges;

    void append(const control_runs& more)
    {
        const auto to = [](auto& all, const auto& list) { all.insert(all.end(), list.begin(), list.end()); };
        to(corners_of_faces, more.corners_of_faces);
        to(faces_at_vertices, more.faces_at_vertices);
        to(marked_edges, more.marked_edges);
    }
    /// Returns the numbers. Precondition: all runs of the mesh are here.
    [[nodiscard]] control_numbers joined() const
    {
        return {prefix_sums(corners_of_faces), prefix_sums(faces_at_vertices), prefix_sums(marked_edges)};
    }
};

/// Returns all runs of a whole control mesh. Cost: O(elements).
template <scheme Scheme, class Point, std::unsigned_integral Index>
control_runs control_runs_of(const basic_mesh<Point, Index>& mesh)
{
    const level_of<basic_mesh<Point, Index>> level(mesh);
    const auto runs = [](const auto& elements, const auto& count) {
        run_builder result;
        global_id before = 0;
        for (std::size_t x = 0; x < elements.size(); ++x) {
            const global_id each = count(elements[x]);
            result.add(x, before, each);
            before += each;
        }
        return result.take();
    };
    control_runs result;
    result.corners_of_faces = runs(level.faces(), [](const auto& f) { return f.degree(); });
    if constexpr (numbers_corners_at_vertices<Scheme>)
        result.faces_at_vertices = runs(level.vertices(), [](const auto& v) { return v.face_count(); });
    if constexpr (marks_edges<Scheme>)
        result.marked_edges = runs(level.edges(), [](const auto& e) { return traits_of<Scheme>.is_marked(e) ? 1 : 0; });
    return result;
}

/// Returns the runs of the elements that a tile of level 0 owns. Preconditions: the tile has a ring of ghosts, and the
/// scheme marks no edges. Cost: O(elements).
template <scheme Scheme, tile_like Tile>
control_runs control_runs_of(const Tile& part)
{
    static_assert(not marks_edges<Scheme>, "marked edges can be counted only on a whole mesh; cut it on one rank");
    control_runs result;
    run_builder faces, vertices;
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
        if (part.owns_face(f))
            faces.add(part.face_ids[f], part.corner_id(f, 0), part.mesh.face(f).size());
    result.corners_of_faces = faces.take();
    if constexpr (numbers_corners_at_vertices<Scheme>) {
        const level_of<basic_mesh<typename Tile::point_type, typename Tile::index_type>> level(part.mesh);
        for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v)
            if (part.owns_vertex(v))
                vertices.add(part.vertex_ids[v], part.corners_before[v], level.vertices()[v].face_count());
        result.faces_at_vertices = vertices.take();
    }
    return result;
}

} // namespace kith
