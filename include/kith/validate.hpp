// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lift.hpp"
#include "make_mesh.hpp"
#include "mesh_report.hpp"

#include <string>
#include <vector>

namespace kith {

/// Everything that is wrong with a mesh that can be built but not refined. Elements are named by the index that their
/// library gives them. Nothing is changed. Cost: O(elements).
template <mesh M>
mesh_report validate(const M& mesh)
{
    using traits = mesh_traits<M>;
    mesh_report report;
    const auto number = [&](const auto& handle) { return std::to_string(std::size_t(traits::index(mesh, handle))); };
    std::vector<std::size_t> faces_at(traits::vertex_bound(mesh), 0);
    std::vector<typename traits::vertex> corners;
    bool empty = true;
    for (const auto f : traits::faces(mesh)) {
        empty = false;
        corners.clear();
        const auto first = traits::halfedge_of(mesh, f);
        auto h = first;
        do {
            const auto v = traits::source(mesh, h);
            if (std::find(corners.begin(), corners.end(), v) != corners.end())
                report.add(problem::degenerate_face, [&] {
                    return "face " + number(f) + ": comes to vertex " + number(v) +
                           " twice; remove the repeated corner or the face";
                });
            corners.push_back(v);
            ++faces_at[traits::index(mesh, v)];
            h = traits::next(mesh, h);
        } while (h != first and corners.size() <= traits::halfedge_bound(mesh));
        if (corners.size() < 3)
            report.add(problem::degenerate_face, [&] {
                return "face " + number(f) + ": has " + std::to_string(corners.size()) + " corners; remove it";
            });
    }
    if (empty)
        report.add(problem::empty_mesh, [] { return std::string("the mesh has no faces; nothing can be refined"); });
    for (const auto e : traits::edges(mesh)) {
        const auto h = traits::halfedge_of(mesh, e);
        if (traits::is_boundary(mesh, h) and traits::is_boundary(mesh, traits::opposite(mesh, h)))
            report.add(problem::nonmanifold_edge,
                       [&] { return "edge " + number(e) + ": has no face; remove it or give it a face"; });
    }
    for (const auto v : traits::vertices(mesh)) {
        if (not detail::point_is_finite(typename traits::point(traits::point_of(mesh, v))))
            report.add(problem::not_finite, [&] {
                return "vertex " + number(v) + ": a coordinate is not a finite number; give it a place";
            });
        if (traits::is_isolated(mesh, v) or faces_at[traits::index(mesh, v)] == 0) {
            report.add(problem::isolated_vertex,
                       [&] { return "vertex " + number(v) + ": belongs to no face; remove it or give it a face"; });
            continue;
        }
        std::size_t fan = 0, gaps = 0;
        const auto first = traits::halfedge_of(mesh, v);
        auto h = first;
        do { // clockwise through the faces and, at the boundary, on to the other side of it, or to the next fan
            ++(traits::is_boundary(mesh, h) ? gaps : fan);
            h = traits::next(mesh, traits::opposite(mesh, h));
        } while (h != first and fan <= faces_at[traits::index(mesh, v)]);
        if (fan != faces_at[traits::index(mesh, v)] or gaps > 1)
            report.add(problem::nonmanifold_vertex, [&] {
                return "vertex " + number(v) + ": its " + std::to_string(faces_at[traits::index(mesh, v)]) +
                       " faces form several fans; split the vertex, one copy per fan";
            });
    }
    return report;
}

/// The native mesh cannot be made with bad connectivity, so only its points and loose vertices are looked at.
template <class Point, class Index>
mesh_report validate(const basic_mesh<Point, Index>& mesh)
{
    mesh_report report;
    detail::check_points(mesh.points(), report);
    if (mesh.face_count() == 0)
        report.add(problem::empty_mesh, [] { return std::string("the mesh has no faces; nothing can be refined"); });
    return report;
}

} // namespace kith
