// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drop_bad_faces.hpp"
#include "drop_conflicts.hpp"
#include "mended_soup.hpp"
#include "repair_options.hpp"
#include "repair_report.hpp"
#include "sides_by_edge.hpp"
#include "split_fans.hpp"
#include "weld_points.hpp"

#include <kith/core/base/in_library.hpp>
#include <kith/core/mesh/make_mesh.hpp>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// The faces after a repair, and the original elements from which they come.
struct mended_faces {
    face_list faces{};
    std::vector<std::size_t> from_vertex{}, from_face{}, from_corner{}, vertex_at{};
    repair_report report{};
};

/// Returns the repaired faces. The repair looks at their vertices only; `points` are used only for welding.
/// Precondition: all vertices exist. Cost: O(corners log corners).
mended_faces mend_faces(std::size_t vertices, const face_list& faces, const point_coordinates& points,
                        const repair_options& options, std::size_t first_number);

/// Returns the pairs of vertices that welding joins; the vertex that is removed comes first.
std::vector<std::pair<std::size_t, std::size_t>> pairs_to_weld(const face_list& faces, const point_coordinates& points,
                                                               double tolerance);

#ifdef KITH_HAS_BODIES

/// Returns the vertices that may be joined: first those on an edge with one side, then those without a face. A vertex
/// that faces surround is never joined, as it would have several fans.
KITH_IN_LIBRARY std::vector<std::size_t> vertices_to_weld(std::size_t vertices, const face_list& faces)
{
    enum : unsigned char { isolated, inner, outer };
    std::vector<unsigned char> kind(vertices, isolated);
    for (const std::size_t v : faces.vertices)
        kind[v] = inner;
    sides_by_edge(faces).for_each_edge([&](std::span<const face_side> at) {
        if (at.size() == 1)
            kind[at[0].low] = kind[at[0].high] = outer;
    });
    std::vector<std::size_t> result;
    for (const auto wanted : {outer, isolated})
        for (std::size_t v = 0; v < vertices; ++v)
            if (kind[v] == wanted)
                result.push_back(v);
    return result;
}

KITH_IN_LIBRARY std::vector<std::pair<std::size_t, std::size_t>>
pairs_to_weld(const face_list& faces, const point_coordinates& points, double tolerance)
{
    const auto into = joined_points(points, vertices_to_weld(points.size(), faces), tolerance);
    std::vector<std::pair<std::size_t, std::size_t>> result;
    for (std::size_t v = 0; v < into.size(); ++v)
        if (into[v] != v)
            result.emplace_back(v, into[v]);
    return result;
}

/// Joins vertices by welding. It must be called before other vertices are added.
inline void weld_vertices(mended_soup& s, const point_coordinates& points)
{
    const auto into = joined_points(points, vertices_to_weld(points.size(), s.faces), *s.options.weld);
    for (std::size_t v = 0; v < into.size(); ++v)
        if (into[v] != v) {
            s.is_joined[v] = true;
            s.report.add_joined(v, into[v]);
        }
    for (std::size_t& v : s.faces.vertices)
        v = into[v];
}

/// Leaves out the joined vertices and, with `drop`, the vertices without a face; completes the maps and returns the
/// result.
inline mended_faces result_of(mended_soup& s, std::size_t corners)
{
    std::vector<bool> is_used(s.from_vertex.size(), false);
    for (const std::size_t v : s.faces.vertices)
        is_used[v] = true;
    mended_faces result;
    std::vector<std::size_t> new_number(s.from_vertex.size(), s.none);
    for (std::size_t v = 0; v < s.from_vertex.size(); ++v) {
        if (v < s.is_joined.size() and s.is_joined[v])
            continue;
        if (not is_used[v] and s.options.drop) {
            s.report.add_dropped_vertex(s.from_vertex[v]);
            continue;
        }
        new_number[v] = result.from_vertex.size();
        result.from_vertex.push_back(s.from_vertex[v]);
    }
    for (std::size_t& v : s.faces.vertices)
        v = new_number[v];
    result.vertex_at.assign(corners, s.none);
    for (std::size_t c = 0; c < s.from_corner.size(); ++c)
        result.vertex_at[s.from_corner[c]] = s.faces.vertices[c];
    for (std::size_t c = 0; c < s.kept_as.size(); ++c) {
        std::size_t kept = c;
        while (s.kept_as[kept] != kept)
            kept = s.kept_as[kept];
        result.vertex_at[c] = result.vertex_at[kept];
    }
    result.faces = std::move(s.faces);
    result.from_face = std::move(s.from_face);
    result.from_corner = std::move(s.from_corner);
    result.report = std::move(s.report);
    return result;
}

KITH_IN_LIBRARY mended_faces mend_faces(std::size_t vertices, const face_list& faces, const point_coordinates& points,
                                        const repair_options& options, std::size_t first_number)
{
    mended_soup s(vertices, faces, options, first_number);
    if (options.drop or options.split or options.weld)
        clean_faces(s, false);
    if (options.weld) {
        weld_vertices(s, points);
        clean_faces(s, true);
    }
    if (options.drop)
        drop_repeated_faces(s);
    if (options.drop and options.orient and not options.split)
        drop_conflicts(s, false);
    if (options.orient)
        turn_faces(s);
    if (options.split) {
        split_fans(s);
        if (options.drop and drop_folded_faces(s))
            split_fans(s);
    } else if (options.drop) {
        drop_conflicts(s, true);
        drop_fans(s);
    }
    return result_of(s, faces.vertices.size());
}

#endif

} // namespace kith::detail
