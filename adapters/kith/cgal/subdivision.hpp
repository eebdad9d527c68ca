// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_graph.hpp"
#include "named_parameters.hpp"
#include "write_face_graph.hpp"
#include "write_surface_mesh.hpp"

#include <kith/cgal_properties.hpp>
#include <kith/core/base/affine.hpp>
#include <kith/fields/property/map_value.hpp>
#include <kith/in_place/properties_of.hpp>
#include <kith/in_place/refine_in_place.hpp>
#include <kith/linear.hpp>
#include <kith/make_creases.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::cgal {

namespace detail {

template <class Graph, class Np>
auto points_of(Graph& g, const Np& np)
{
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    return choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                            CGAL::get_property_map(CGAL::vertex_point, g));
}

template <class Np>
int steps_of(const Np& np)
{
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    const auto steps = choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), 1);
    using limits = std::numeric_limits<int>;
    if (const auto n = static_cast<long double>(steps); not(n >= limits::min() and n <= limits::max()))
        throw mesh_error(std::to_string(steps) + (n < 0 ? " iterations were asked for; ask for 0 or more"
                                                        : " iterations are too many; ask for fewer"));
    return int(steps);
}

template <class Np>
inline constexpr bool has_sharp_elements = is_given<Np, CGAL::internal_np::edge_is_constrained_t> or
                                           is_given<Np, CGAL::internal_np::vertex_is_constrained_t> or
                                           is_given<Np, parameters::edge_sharpness_t> or
                                           is_given<Np, parameters::vertex_sharpness_t>;

/// Returns true if elements of this type can be keys of the map. A map without a key type takes any element. Other maps
/// do not compile.
template <class Map, class Element>
constexpr bool has_key()
{
    using key = typename boost::property_traits<Map>::key_type;
    constexpr bool fits = std::is_void_v<key> or std::is_convertible_v<Element, key>;
    static_assert(fits,
                  "kith::cgal: this map has keys of another kind: edge_is_constrained_map and edge_sharpness_map take "
                  "maps of edge descriptors, vertex_is_constrained_map and vertex_sharpness_map of vertex descriptors");
    return fits;
}

/// Calls f(map) for each of the two maps that the caller passed.
template <class Constrained, class Sharpness, class Np, class F>
void for_each_map(const Np& np, const F& f)
{
    if constexpr (is_given<Np, Constrained>)
        f(CGAL::parameters::get_parameter(np, Constrained()));
    if constexpr (is_given<Np, Sharpness>)
        f(CGAL::parameters::get_parameter(np, Sharpness()));
}
template <class Constrained, class Sharpness, class Np, class Element>
double sharpness_in(const Np& np, const Element& x, std::size_t number, const char* kind)
{
    double result = 0;
    for_each_map<Constrained, Sharpness>(np, [&]<class Map>(const Map& map) {
        if constexpr (has_key<Map, Element>())
            result = std::max(result, kith::detail::sharpness_from(map, x, number, kind));
    });
    return result;
}

/// Adds the sharpness in the maps to the creases of a scheme. Messages have the numbers that the graph's handles hold,
/// if they hold any. After removals these numbers differ from those of the level.
template <mesh View, class Np>
void read_creases(const View& view, const Np& np, creases& sharp)
{
    namespace tags = CGAL::internal_np;
    using traits = mesh_traits<View>;
    const level_of<View> level(view);
    const auto& g = view.graph();
    for (const auto e : level.edges())
        if (const double s = sharpness_in<tags::edge_is_constrained_t, parameters::edge_sharpness_t>(
                np, graph_calls::edge_along(g, view.directing(e.handle())), traits::index(view, e.handle()), "edge");
            s > 0)
            sharp.sharpen_edge(e.index(), s);
    for (const auto v : level.vertices())
        if (const double s = sharpness_in<tags::vertex_is_constrained_t, parameters::vertex_sharpness_t>(
                np, v.handle(), traits::index(view, v.handle()), "vertex");
            s > 0)
            sharp.sharpen_vertex(v.index(), s);
}

/// Returns a sharpness as a value of a map. Integers have no infinity; their largest value stands for it.
template <class Value>
Value as_sharpness(double sharpness)
{
    if constexpr (std::same_as<Value, bool>)
        return sharpness == infinitely_sharp;
    else if constexpr (std::integral<Value>)
        return rounded<Value>(sharpness);
    else
        return Value(sharpness);
}

/// Writes the sharpness of the elements of the refined mesh into the maps that can be written.
template <class Vertices, class Edges, class Np>
void write_creases(const written_elements<Vertices, Edges>& written, const Np& np, const creases& sharp)
{
    namespace tags = CGAL::internal_np;
    const auto write = [](const auto& maps, const auto& elements, const auto& sharpness) {
        maps([&]<class Map>(const Map& map) {
            using element = std::remove_cvref_t<decltype(*elements.begin())>;
            if constexpr (is_writable<Map>() and has_key<Map, element>()) {
                using value = typename boost::property_traits<Map>::value_type;
                std::size_t i = 0;
                for (const auto& x : elements) {
                    put(map, x, as_sharpness<value>(sharpness(i++)));
                }
            }
        });
    };
    write([&](const auto& f) { for_each_map<tags::edge_is_constrained_t, parameters::edge_sharpness_t>(np, f); },
          written.edges,
          [&](std::size_t e) { return sharp.of_edge(e); });
    write([&](const auto& f) { for_each_map<tags::vertex_is_constrained_t, parameters::vertex_sharpness_t>(np, f); },
          written.vertices,
          [&](std::size_t v) { return sharp.of_vertex(v); });
}

/// Sets the Surface_mesh's own points of new vertices, which CGAL leaves unset, to zero. Does nothing if `points` is
/// the map of the own points, and for other graphs.
template <class Graph, class VertexPointMap>
void clear_own_points(Graph&, const VertexPointMap&, std::size_t)
{
}
template <class Point, class VertexPointMap>
void clear_own_points(CGAL::Surface_mesh<Point>& m, const VertexPointMap& points, std::size_t first)
{
    using mesh = CGAL::Surface_mesh<Point>;
    using vertex = typename mesh::Vertex_index;
    if constexpr (std::same_as<VertexPointMap, typename mesh::template Property_map<vertex, Point>>)
        if (points.data() == m.points().data())
            return;
    if constexpr (std::constructible_from<Point, CGAL::Origin>)
        for (std::size_t v = first; v < m.num_vertices(); ++v)
            m.point(vertex(typename mesh::size_type(v))) = Point(CGAL::ORIGIN);
}

/// Puts a point into a map. Own points of OpenMesh are set directly: CGAL's map of them would round to floats.
template <class Graph, class VertexPointMap, class Vertex, class Point>
void put_point(Graph& g, const VertexPointMap& points, Vertex v, const Point& p)
{
    using own_points = decltype(CGAL::get_property_map(CGAL::vertex_point, g));
    if constexpr (has_arrays<Graph> and std::same_as<VertexPointMap, std::remove_cvref_t<own_points>>)
        g.set_point(v, typename Graph::Point(p[0], p[1], p[2]));
    else
        put(points, v, p);
}

/// Overwrites the graph with a refined mesh; point_of(i) is the point of vertex i. Returns the graph's elements in the
/// order of that mesh. Errors occur before a Surface_mesh is changed, except errors of maps that the caller passes.
template <class Graph, class VertexPointMap, class Point, class Carried, class PointOf>
auto write(Graph& g, VertexPointMap points, const in_place::refined<Point>& fine, Carried& carried,
           const PointOf& point_of)
{
    const std::size_t first_new = fine.keeps_vertices ? num_vertices(g) : 0;
    auto written = [&] {
        if constexpr (surface_mesh_or_derived<Graph>) {
            surface_mesh_writer<typename Graph::Point> writer(
                g, fine.mesh.topology(), fine.keeps_vertices, not carried.empty());
            if (not carried.empty()) {
                carried.stage(g, writer.places());
                carried.commit(writer.places());
            }
            return writer.commit();
        } else {
            auto result = write_connectivity(g, fine.mesh.topology(), fine.keeps_vertices);
            carried.write(g, result.vertices);
            return result;
        }
    }();
    clear_own_points(g, points, first_new);
    std::size_t i = 0;
    for (const auto v : written.vertices)
        put_point(g, points, v, point_of(i++));
    return written;
}

/// Returns the graph to refine: the Surface_mesh from which a class is derived, or else the graph itself.
template <class Graph>
auto& graph_of(Graph& g)
{
    if constexpr (surface_mesh_or_derived<Graph>)
        return static_cast<surface_mesh_of<Graph>&>(g);
    else
        return g;
}

template <class Graph, scheme Scheme, class Np, class... Argument>
property_report refine(Graph& g, Scheme& scheme, const Np& np, const Argument&... arguments)
{
    const int steps = steps_of(np);
    kith::detail::require_levels<Scheme>(steps);
    if (steps == 0 or graph_calls::all_faces(g).begin() == graph_calls::all_faces(g).end())
        return {};
    const auto points = points_of(g, np);
    std::vector<std::uint32_t> joined;
    auto control = [&] {
        const face_graph view(std::as_const(g), points);
        auto lifted = to_native_valid(view); // before all else, as it checks that this is a mesh
        in_place::require_faces(view, lifted, scheme);
        if constexpr (scheme_with_creases<Scheme> and has_sharp_elements<Np>)
            read_creases(view, np, scheme.sharpness);
        joined = view.joined();
        return lifted;
    }();
    typename in_place::properties_of<Graph, Argument...>::type carried(g, joined, arguments...);
    auto visitor = CGAL::parameters::get_parameter(np, CGAL::internal_np::visitor);
    const auto go_on = [&](double done) {
        if constexpr (is_given<Np, CGAL::internal_np::visitor_t>)
            return tell(visitor, done);
        else
            return true;
    };
    const auto fine = in_place::refine(std::move(control), scheme, steps, carried.values(), false, go_on);
    if (not fine)
        return {};
    auto report = carried.report(numbering_of<Scheme, std::uint32_t>::has_edges); // before the mesh is changed
    [[maybe_unused]] const auto written = write(g, points, *fine, carried, [&](std::size_t v) {
        return face_graph<Graph, std::remove_const_t<decltype(points)>>::to_graph(fine->mesh.point(v));
    });
    if constexpr (scheme_with_creases<Scheme> and has_sharp_elements<Np>)
        write_creases(written, np, scheme.sharpness);
    return report;
}

} // namespace detail

/// Subdivides a mesh in place by any scheme of kith or of the caller: subdivision(pmesh, kith::kobbelt(), np).
/// The graph is any model of CGAL's MutableFaceGraph and FaceListGraph. In schemes with a vertex for each old vertex,
/// old vertices keep their descriptors and come before the new ones. They do not come first in a graph that makes new
/// vertices of removed ones, such as a Linear_cell_complex. Edges and faces are replaced. Property maps of a
/// Surface_mesh are carried by the rules of `carry_properties`.
///
///   number_of_iterations(n)         1
///   vertex_point_map(map)           get(CGAL::vertex_point, pmesh)
///   edge_is_constrained_map(map), vertex_is_constrained_map(map)
///                                   creases and corners, infinitely sharp where true; numbers are a sharpness, of
///                                   which the largest integer is infinite
///   edge_sharpness_map(map), vertex_sharpness_map(map)
///                                   the same with numbers, in parameters of this namespace
///   visitor(v)                      v.progress(share of the work done) after each level; if it returns false, the
///                                   mesh is not changed
///
/// Crease maps that can be written then get the sharpness of the refined mesh, so that it can be refined again.
/// Further arguments set how property maps are carried: kith::by_rule<face, type>(name, rule),
/// kith::value_types<type...>(). Values of other types are copied from the parent to faces, and to edges and half-edges
/// along old ones; old vertices keep theirs. A mesh without faces is not changed; isolated vertices stay if old
/// vertices stay.
/// Returns which property maps were carried and which were left out, with the reason. Errors: those of kith::refine.
/// After an error, also when memory runs out, a Surface_mesh is unchanged. Exceptions are errors in copies of values of
/// unnamed types and in the caller's maps, as both come last. Cost: that of kith::refine.
template <class Graph, scheme Scheme, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report subdivision(Graph& pmesh, Scheme scheme, const Np& np = CGAL::parameters::default_values(),
                            const Argument&... arguments)
{
    if constexpr (steps<Np>) {
        return subdivision(pmesh, scheme, CGAL::parameters::number_of_iterations(np), arguments...);
    } else {
        static_assert(scheme_with_creases<Scheme> or not detail::has_sharp_elements<Np>,
                      "kith::cgal: Catmull-Clark and Loop have creases, this scheme has none; leave out the maps of "
                      "constrained edges, constrained vertices and sharpness");
        static_assert(not detail::is_given<Np, parameters::do_not_modify_geometry_t>,
                      "kith::cgal: only CatmullClark_subdivision and Loop_subdivision take do_not_modify_geometry; "
                      "leave it out, or call Linear_subdivision");
        return detail::refine(detail::graph_of(pmesh), scheme, np, arguments...);
    }
}

} // namespace kith::cgal
