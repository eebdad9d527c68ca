// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "subdivision.hpp"

#include <kith/core/base/error.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/sqrt3.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::cgal {

namespace detail {

/// Makes one step in place. place(view, native mesh, numbering, new points) computes the new points from the graph
/// before the step. The masks of `scheme`, which defines the connectivity, compute the carried properties.
template <class Graph, class VertexPointMap, scheme Scheme, class Place>
void step_by_mask(Graph& g, VertexPointMap points, Scheme scheme, int generation, const Place& place)
{
    using view_type = face_graph<Graph, VertexPointMap>;
    const view_type view(std::as_const(g), points);
    if (view.faces().empty())
        return;
    auto control = to_native_valid(view); // before all else, as it checks that this is a mesh
    typename in_place::properties_of<Graph>::type carried(g, view.joined());
    control = {storage<typename view_type::point>(control.points()), control.topology(), generation};
    in_place::require_faces(view, control, scheme);
    in_place::refined<typename view_type::point> surface{std::move(control), true};
    kith::detail::require_refinable(surface.mesh, scheme, 1, {});
    std::vector<typename view_type::graph_point> made;
    in_place::step(surface, scheme, carried.values(), false, [&](const auto& ids, const auto& new_points) {
        made.resize(new_points.size());
        place(view, surface.mesh, ids, std::span(made));
    });
    write(g, points, surface, carried, [&](std::size_t v) { return made[v]; });
}

/// Returns the half-edge of an edge that has a face if the edge lies at the boundary. Returns CGAL's half-edge of any
/// other edge.
template <mesh View>
typename View::halfedge inner_side(const View& view, typename View::edge e)
{
    const auto h = view.directing(e);
    return graph_calls::has_no_face(view.graph(), h) ? graph_calls::opposite_of(view.graph(), h) : h;
}

/// Makes the edge points and the vertex points by a mask with CGAL's interface. At a boundary edge, border_node makes
/// the edge point and the point of the vertex at the edge's end.
template <mesh View, class Mask, element_ids Ids, class Points>
void place_edges_and_vertices(const View& view, Mask& mask, const Ids& ids, const Points& points)
{
    const auto& g = view.graph();
    const level_of<View> level(view);
    std::vector<bool> is_placed(level.vertex_count());
    for (const auto e : level.edges()) {
        auto& point = points[ids.template id<tuple_kind::e>(e.index())];
        const auto h = inner_side(view, e.handle());
        if (not e.is_boundary()) {
            mask.edge_node(h, point);
        } else {
            const std::size_t end = level.index(graph_calls::target_of(g, h));
            mask.border_node(h, point, points[ids.template id<tuple_kind::v>(end)]);
            is_placed[end] = true;
        }
    }
    for (const auto v : level.vertices())
        if (not is_placed[v.index()])
            mask.vertex_node(v.handle(), points[ids.template id<tuple_kind::v>(v.index())]);
}
template <mesh View, class Mask, element_ids Ids, class Points>
void place_faces(const View& view, Mask& mask, const Ids& ids, const Points& points)
{
    std::size_t i = 0;
    for (const auto f : view.faces())
        mask.face_node(f, points[ids.template id<tuple_kind::f>(i++)]);
}

template <mesh View, class Mask, element_ids Ids, class Points>
void place_corners(const View& view, Mask& mask, const Ids& ids, const Points& points)
{
    std::size_t corner = 0;
    for (const auto f : view.faces())
        kith::detail::for_each_side(view, f, [&](const auto& h) { // which leaves the corner
            mask.corner_node(graph_calls::prev_of(view.graph(), h), points[ids.template id<tuple_kind::vf>(corner++)]);
        });
}

template <class Graph, class Np, class Step>
void repeat(Graph& g, const Np& np, const Step& step)
{
    if constexpr (cgal::steps<Np>) {
        repeat(g, CGAL::parameters::number_of_iterations(np), step);
    } else {
        const int steps = steps_of(np);
        if (steps < 0)
            throw mesh_error(std::to_string(steps) + " steps by a mask were asked for; ask for 0 or more");
        const auto points = points_of(g, np);
        for (int i = 0; i < steps; ++i)
            step(points, i);
    }
}
/// Makes the steps of a scheme whose steps are all alike.
template <class Graph, class Np, scheme Scheme, class Place>
void repeat_by_mask(Graph& g, const Np& np, const Scheme& scheme, const Place& place)
{
    repeat(g, np, [&](const auto& points, int) { step_by_mask(g, points, scheme, 0, place); });
}

} // namespace detail

// NOLINTBEGIN(readability-identifier-naming)

/// Subdivides by the quad split with a mask of the caller, like CGAL::Subdivision_method_3::PQQ. The mask is a model of
/// CGAL's PQQMask_3; its face_node, edge_node, vertex_node and border_node see the mesh before the step. Takes the
/// named parameters number_of_iterations and vertex_point_map, or a number of steps. Property maps of a Surface_mesh
/// are carried linearly; for everything else see `subdivision`.
/// Errors: as kith::refine; the mesh keeps the steps before the error. Cost: O(corners) and the cost of the mask, per
/// step.
template <class Graph, class Mask, class Np = CGAL::parameters::Default_named_parameters>
void PQQ(Graph& pmesh, Mask mask, const Np& np = CGAL::parameters::default_values())
{
    detail::repeat_by_mask(
        detail::graph_of(pmesh), np, linear(), [&](const auto& view, const auto&, const auto& ids, const auto& points) {
            detail::place_faces(view, mask, ids.vertices, points);
            detail::place_edges_and_vertices(view, mask, ids.vertices, points);
        });
}

/// Subdivides triangles like PQQ, but by the split of triangles into triangles. The mask is a model of CGAL's
/// PTQMask_3, with edge_node, vertex_node and border_node.
template <class Graph, class Mask, class Np = CGAL::parameters::Default_named_parameters>
void PTQ(Graph& pmesh, Mask mask, const Np& np = CGAL::parameters::default_values())
{
    detail::repeat_by_mask(detail::graph_of(pmesh),
                           np,
                           linear_triangles(),
                           [&](const auto& view, const auto&, const auto& ids, const auto& points) {
                               detail::place_edges_and_vertices(view, mask, ids.vertices, points);
                           });
}

/// Subdivides like PQQ, but by the dual split. The mask is a model of CGAL's DQQMask_3, whose corner_node takes the
/// half-edge that leads to the corner in its face.
template <class Graph, class Mask, class Np = CGAL::parameters::Default_named_parameters>
void DQQ(Graph& pmesh, Mask mask, const Np& np = CGAL::parameters::default_values())
{
    detail::repeat_by_mask(detail::graph_of(pmesh),
                           np,
                           doo_sabin{.boundary = doo_sabin_boundary::drop},
                           [&](const auto& view, const auto&, const auto& ids, const auto& points) {
                               detail::place_corners(view, mask, ids.vertices, points);
                           });
}

/// Subdivides like PQQ, but by the sqrt(3) split. The mask is a model of CGAL's Sqrt3Mask_3, with face_node,
/// vertex_node and border_node. Every second step of a call uses border_node(half-edge, point near its target, point
/// near its source, point of its target).
template <class Graph, class Mask, class Np = CGAL::parameters::Default_named_parameters>
void Sqrt3(Graph& pmesh, Mask mask, const Np& np = CGAL::parameters::default_values())
{
    detail::repeat(detail::graph_of(pmesh), np, [&](const auto& vpm, int step) {
        const auto place = [&](const auto& view, const auto& mesh, const auto& ids, const auto& points) {
            const auto& numbers = ids.vertices;
            const level_of<std::remove_cvref_t<decltype(view)>> level(view);
            for (const auto v : level.vertices()) {
                auto& point = points[numbers.template id<tuple_kind::v>(v.index())];
                if (v.is_boundary())
                    point = get(vpm, v.handle());
                else
                    mask.vertex_node(v.handle(), point);
            }
            for (const auto f : level.faces())
                if (const auto id = numbers.template id<tuple_kind::f>(f.index()); id != numbers.none)
                    mask.face_node(f.handle(), points[id]);
            if (mesh.generation() % 2 == 0)
                return;
            for (const auto e : level.edges())
                if (e.is_boundary()) {
                    const auto h = detail::inner_side(view, e.handle());
                    const std::size_t end = level.index(graph_calls::target_of(view.graph(), h));
                    mask.border_node(h,
                                     points[numbers.template id<tuple_kind::ve>(2 * e.index() + 1)],
                                     points[numbers.template id<tuple_kind::ve>(2 * e.index())],
                                     points[numbers.template id<tuple_kind::v>(end)]);
                }
        };
        detail::step_by_mask(detail::graph_of(pmesh), vpm, sqrt3(), step % 2, place);
    });
}

// NOLINTEND(readability-identifier-naming)

} // namespace kith::cgal
