// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/core/mesh/dense_numbers.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/core/mesh/mesh_report.hpp>
#include <kith/core/mesh/mesh_traits.hpp>

#include <concepts>
#include <cstddef>
#include <vector>

namespace kith {

namespace detail {

/// Returns true if a half-edge lies in a face or at the boundary; reports it otherwise.
template <mesh M>
bool check_side(const M& mesh, typename mesh_traits<M>::halfedge h, bool is_in_face, mesh_report& report)
{
    using traits = mesh_traits<M>;
    if (is_in_face or traits::is_boundary(mesh, h))
        return true;
    report.add_lost_side(std::size_t(traits::index(mesh, h)),
                         std::size_t(traits::index(mesh, traits::face_of(mesh, h))));
    return false;
}

/// Returns true if a vertex, which has an edge, starts at a half-edge that leaves it; reports the vertex otherwise.
template <mesh M>
bool check_start(const M& mesh, typename mesh_traits<M>::vertex v, mesh_report& report)
{
    using traits = mesh_traits<M>;
    if (starts_at_its_own(mesh, v))
        return true;
    const auto number = std::size_t(traits::index(mesh, v));
    if (const auto start = traits::halfedge_of(mesh, v); has_halfedge(mesh, start))
        report.add_foreign_start(number,
                                 std::size_t(traits::index(mesh, start)),
                                 std::size_t(traits::index(mesh, traits::source(mesh, start))));
    else
        report.add_lost_fan(number);
    return false;
}

/// Returns the number of faces that the half-edges of a vertex lead to, or more than `most` if the walk does not end
/// before. The walk is clockwise. At the boundary, beyond which nothing is promised, it returns to the start and goes
/// the other way.
/// Precondition: v has an edge. Cost: O(most).
template <mesh M>
std::size_t faces_in_fan(const M& mesh, typename mesh_traits<M>::vertex v, std::size_t most)
{
    using traits = mesh_traits<M>;
    const auto is_inside = [&](const auto& h) { return has_halfedge(mesh, h) and not traits::is_boundary(mesh, h); };
    const auto start = traits::halfedge_of(mesh, v);
    std::size_t faces = is_inside(start) ? 1 : 0;
    auto in = traits::opposite(mesh, start);
    auto out = start;
    while (is_inside(in) and (out = traits::next(mesh, in)) != start and faces <= most) {
        ++faces;
        in = traits::opposite(mesh, out);
    }
    if (not is_inside(in))
        for (out = start; is_inside(out) and faces <= most;) {
            out = traits::opposite(mesh, traits::prev(mesh, out));
            faces += is_inside(out) ? 1 : 0;
        }
    return faces;
}

} // namespace detail

/// Reports everything that is wrong with a mesh that can be built but not refined. All functions of the library that
/// read a mesh reject it with this text. Elements are named by the index that their library gives them. The mesh is not
/// changed.
/// Cost: O(elements), and a logarithm more for faces with many corners.
template <mesh M>
[[gnu::cold]] mesh_report validate(const M& mesh)
{
    using traits = mesh_traits<M>;
    mesh_report report;
    const auto number = [&](const auto& handle) { return std::size_t(traits::index(mesh, handle)); };
    const dense_numbers<M, typename traits::vertex> all_vertices(
        mesh, traits::vertices(mesh), traits::vertex_bound(mesh));
    const dense_numbers<M, typename traits::edge> all_edges(mesh, traits::edges(mesh), traits::edge_bound(mesh));
    std::vector<std::size_t> faces_at(traits::vertex_bound(mesh), 0);
    std::vector<bool> is_in_face(traits::halfedge_bound(mesh));
    std::vector<std::size_t> corners; // of a face, by number
    bool empty = true, all_are_closed = true, boundary_is_said = true;
    for (const auto f : traits::faces(mesh)) {
        empty = false;
        corners.clear();
        bool is_joined = true, has_its_edges = true, has_its_vertices = true;
        const bool comes_back = detail::for_each_side(mesh, f, [&](const auto& h) {
            is_joined = is_joined and detail::is_side_of(mesh, h, f);
            is_in_face[number(h)] = true;
            has_its_edges = has_its_edges and all_edges.has(mesh, traits::edge_of(mesh, h));
            has_its_vertices = has_its_vertices and all_vertices.has(mesh, traits::source(mesh, h));
            corners.push_back(number(traits::source(mesh, h)));
            if (corners.back() < faces_at.size())
                ++faces_at[corners.back()];
        });
        const bool is_closed = comes_back and is_joined;
        all_are_closed = all_are_closed and is_closed;
        if (is_closed or corners.empty())
            report.add_face_faults(number(f), corners);
        else if (comes_back)
            report.add_unjoined_face(number(f));
        else
            report.add_open_face(number(f));
        if (is_closed and not has_its_edges)
            report.add_removed_edge(number(f));
        if (is_closed and not has_its_vertices)
            report.add_removed_vertex(number(f));
    }
    if (empty)
        report.add_no_faces();
    for (const auto e : traits::edges(mesh)) {
        const typename traits::halfedge h = traits::halfedge_of(mesh, e), o = traits::opposite(mesh, h);
        if (traits::is_boundary(mesh, h) and traits::is_boundary(mesh, o))
            report.add_edge_without_face(number(e));
        for (const auto side : {h, o})
            if (all_are_closed and not detail::check_side(mesh, side, is_in_face[number(side)], report))
                boundary_is_said = false;
    }
    for (const auto v : traits::vertices(mesh)) {
        if (not detail::point_is_finite(typename traits::point(traits::point_of(mesh, v))))
            report.add_not_finite(number(v));
        if (traits::is_isolated(mesh, v) or faces_at[number(v)] == 0) {
            report.add_isolated(number(v));
            continue;
        }
        // The fans are unknown if half-edges may lead anywhere.
        if (not detail::check_start(mesh, v, report) or not all_are_closed or not boundary_is_said)
            continue;
        if (const std::size_t all = faces_at[number(v)]; detail::faces_in_fan(mesh, v, all) != all)
            report.add_several_fans(number(v), all);
    }
    return report;
}

namespace detail {

/// Checks the corners at which the vertices of a native mesh start. Cost: O(vertices + edges).
template <std::unsigned_integral Index>
void check_starts(const connectivity<Index>& mesh, mesh_report& report)
{
    if (mesh.faces_only())
        return;
    for (std::size_t v = 0; v < mesh.vertex_corner.size(); ++v) {
        const Index start = mesh.vertex_corner[v];
        if (start < mesh.corners() and mesh.corner_vertex[start] == v)
            continue;
        if (start == mesh.none)
            report.add_isolated(v);
        else if (start < mesh.corners())
            report.add_foreign_start(v, mesh.corner_halfedge[start], mesh.corner_vertex[start]);
        else
            report.add_lost_fan(v);
    }
    if (mesh.is_closed())
        return;
    for (std::size_t h = 0; h < mesh.halfedge_corner.size(); ++h)
        if (mesh.halfedge_corner[h] == mesh.none and mesh.halfedge_corner[h ^ 1] < mesh.corners()) {
            const Index first = mesh.halfedge_corner[h ^ 1], v = mesh.corner_vertex[first];
            if (const Index start = mesh.vertex_corner[v];
                start != first and start < mesh.corners() and mesh.corner_vertex[start] == v)
                report.add_late_start(v, mesh.corner_halfedge[start], mesh.corner_halfedge[first]);
        }
}

} // namespace detail

/// Reports what is wrong with a native mesh. Its connectivity was correct when it was made, so three things are
/// checked: the points, that there are faces, and the start of each vertex. Code that moves corners by hand easily
/// forgets the starts. Cost: O(vertices + edges).
template <class Point, std::unsigned_integral Index>
mesh_report validate(const basic_mesh<Point, Index>& mesh)
{
    mesh_report report;
    detail::check_points(mesh.points(), report);
    detail::check_starts(mesh.topology(), report);
    if (mesh.face_count() == 0)
        report.add_no_faces();
    return report;
}

namespace detail {

/// Throws mesh_error with what `validate` finds in a mesh that could not be read.
template <mesh M>
[[noreturn, gnu::cold]] void refuse_mesh(const M& mesh)
{
    validate(mesh).require_ok();
    throw mesh_error("the half-edges of the mesh do not pair its faces at edges; rebuild the mesh from its faces");
}

} // namespace detail

} // namespace kith
