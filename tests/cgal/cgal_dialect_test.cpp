// SPDX-License-Identifier: BSD-3-Clause
// Compares kith::cgal with CGAL::Subdivision_method_3 and with kith on its native mesh.
#include <CGAL/Simple_cartesian.h>

#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/graph_surface.hpp"
#include "support/native_shape.hpp"

#include <kith/cgal_subdivision.hpp>
#include <kith/compiled_schemes.hpp>

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/subdivision_method_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using mesh = surface_mesh<kernel>;
using polyhedron = CGAL::Polyhedron_3<kernel>;
using openmesh = OpenMesh::PolyMesh_ArrayKernelT<>;
namespace params = CGAL::parameters;
namespace theirs = CGAL::Subdivision_method_3;
namespace ours = kith::cgal;

/// Calls both functions with copies of the same graph, one to three steps, and expects the same surface.
template <class Graph, class Theirs, class Ours>
void expect_same_surface(const shapes::shape& s, const Theirs& their_function, const Ours& our_function)
{
    for (unsigned steps = 1; steps <= 3; ++steps) {
        auto a = make_graph<Graph>(s), b = make_graph<Graph>(s);
        their_function(a, steps);
        our_function(b, steps);
        EXPECT_TRUE(CGAL::is_valid_polygon_mesh(b));
        EXPECT_EQ(difference(surface_of(a), surface_of(b)), "") << steps << " steps";
    }
}

template <class Graph>
void expect_cgals_surfaces()
{
    const auto on = [](const auto& shapes, const auto& their_function, const auto& our_function) {
        for (const auto& [name, shape] : shapes) {
            SCOPED_TRACE(name);
            if (shape.faces.size() <= 100)
                expect_same_surface<Graph>(shape, their_function, our_function);
        }
    };
    on(
        shapes::all_shapes(),
        [](auto& m, unsigned n) { theirs::CatmullClark_subdivision(m, params::number_of_iterations(n)); },
        [](auto& m, unsigned n) { ours::CatmullClark_subdivision(m, params::number_of_iterations(n)); });
    on(
        shapes::shapes_without_valence_two(),
        [](auto& m, unsigned n) { theirs::DooSabin_subdivision(m, params::number_of_iterations(n)); },
        [](auto& m, unsigned n) { ours::DooSabin_subdivision(m, params::number_of_iterations(n)); });
    on(
        shapes::triangle_shapes(),
        [](auto& m, unsigned n) { theirs::Loop_subdivision(m, params::number_of_iterations(n)); },
        [](auto& m, unsigned n) { ours::Loop_subdivision(m, params::number_of_iterations(n)); });
    on(
        shapes::triangle_shapes(),
        [](auto& m, unsigned n) { theirs::Sqrt3_subdivision(m, params::number_of_iterations(n)); },
        [](auto& m, unsigned n) { ours::Sqrt3_subdivision(m, params::number_of_iterations(n)); });
}

/// Calls test(name, function of a graph and of a number of steps, scheme, shape) for every scheme and a shape that the
/// scheme takes.
template <class Test>
void for_each_function(const Test& test)
{
    const auto open = shapes::open_house(), triangles = shapes::umbrella(7), closed = shapes::torus(4, 5),
               fan = shapes::umbrella(7);
    using kith::like, kith::library;
    test([](auto& m, int n) { ours::CatmullClark_subdivision(m, n); }, like<kith::catmull_clark>(library::cgal), open);
    test([](auto& m, int n) { ours::DooSabin_subdivision(m, n); }, like<kith::doo_sabin>(library::cgal), closed);
    test([](auto& m, int n) { ours::Loop_subdivision(m, n); }, like<kith::loop>(library::cgal), fan);
    test([](auto& m, int n) { ours::Sqrt3_subdivision(m, n); }, kith::sqrt3(), fan);
    test([](auto& m, int n) { ours::Butterfly_subdivision(m, n); }, kith::butterfly(), fan);
    test([](auto& m, int n) { ours::InterpolatorySqrt3_subdivision(m, n); },
         kith::interpolatory_sqrt3(),
         shapes::tetrahedron());
    test([](auto& m, int n) { ours::Kobbelt_subdivision(m, n); }, kith::kobbelt(), shapes::grid());
    test([](auto& m, int n) { ours::FourEight_subdivision(m, n); }, kith::four_eight(), open);
    test([](auto& m, int n) { ours::FourEight_subdivision(m, n); }, kith::four_eight(), shapes::grid());
    test([](auto& m, int n) { ours::FourEight_subdivision(m, n); }, kith::four_eight(), triangles);
    test([](auto& m, int n) { ours::QuadTri_subdivision(m, n); }, kith::quad_tri(), open);
    test([](auto& m, int n) { ours::QuadTri_subdivision(m, n); }, kith::quad_tri(), closed);
    test([](auto& m, int n) { ours::NasriHasbini_subdivision(m, n); }, kith::nasri_hasbini(), open);
    test([](auto& m, int n) { ours::MidEdge_subdivision(m, n); }, kith::mid_edge(), closed);
    test([](auto& m, int n) { ours::Unified_subdivision(m, 4, n); }, kith::unified{.degree = 4}, closed);
    test([](auto& m, int n) { ours::Unified_subdivision(m, 5, n); }, kith::unified{.degree = 5}, closed);
    test([](auto& m, int n) { ours::Linear_subdivision(m, n); }, kith::linear(), open);
    test([](auto& m, int n) { ours::LinearTriangles_subdivision(m, n); }, kith::linear_triangles(), fan);
}

template <class Graph>
void expect_native_bits()
{
    for_each_function([](const auto& function, const auto& scheme, const shapes::shape& shape) {
        SCOPED_TRACE(std::string(kith::scheme_name<std::remove_cvref_t<decltype(scheme)>>()));
        auto g = same_graph<Graph>(make_graph<mesh>(shape));
        auto control = kith::to_native(view_of(std::as_const(g)));
        EXPECT_TRUE(same_bits(control, kith::to_native(view_of(make_graph<mesh>(shape)))));
        if constexpr (std::same_as<std::remove_cvref_t<decltype(scheme)>, kith::four_eight>)
            control = kith::tri_quad(control);
        function(g, 2);
        EXPECT_TRUE(CGAL::is_valid_polygon_mesh(g));
        EXPECT_TRUE(same_bits(kith::to_native(view_of(std::as_const(g))), kith::refine(control, scheme, 2)));
    });
}

/// A mask of the user: it is not symmetric, and it records where it was called.
template <class Graph>
struct lifting_mask {
    using vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
    using halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;
    using face = typename boost::graph_traits<Graph>::face_descriptor;
    using point = kernel::Point_3;

    const Graph* g;

    auto at(vertex v) const { return get(CGAL::vertex_point, *g, v); }
    void face_node(face f, point& p) const
    {
        kernel::Vector_3 sum(0, 0, 5);
        for (const auto v : CGAL::vertices_around_face(halfedge_of(f), *g))
            sum = sum + (at(v) - point(0, 0, 0));
        p = point(0, 0, 0) + sum / 4;
    }
    void edge_node(halfedge h, point& p) const
    {
        p = CGAL::midpoint(CGAL::midpoint(at(source(h, *g)), at(target(h, *g))), point(1, 0, 0));
    }
    void vertex_node(vertex v, point& p) const { p = at(v) + kernel::Vector_3(0, 0, 1. / double(degree(v, *g))); }
    void border_node(halfedge h, point& edge_point, point& vertex_point) const
    {
        edge_point = CGAL::barycenter(at(source(h, *g)), 1. / 4, at(target(h, *g)), 3. / 4);
        vertex_point = at(target(h, *g)) + kernel::Vector_3(0, 1, 0);
    }
    void border_node(halfedge h, point& near_target, point& near_source, point& vertex_point) const
    {
        near_target = CGAL::barycenter(at(source(h, *g)), 1. / 5, at(target(h, *g)), 4. / 5);
        near_source = CGAL::barycenter(at(source(h, *g)), 2. / 3, at(target(h, *g)), 1. / 3);
        vertex_point = at(target(h, *g)) + kernel::Vector_3(0, 1, 0);
    }
    void corner_node(halfedge h, point& p) const
    {
        p = CGAL::barycenter(at(target(h, *g)), 3. / 4, at(source(h, *g)), 1. / 4);
    }
    halfedge halfedge_of(face f) const { return kith::cgal::graph_calls::halfedge_at(*g, f); }
};

} // namespace

TEST(cgal_dialect, makes_cgals_surfaces)
{
    expect_cgals_surfaces<mesh>();
    expect_cgals_surfaces<polyhedron>();
}

TEST(cgal_dialect, makes_the_bits_of_kith_on_every_graph)
{
    expect_native_bits<mesh>();
    expect_native_bits<polyhedron>();
}

TEST(cgal_dialect, keeps_the_doubles_of_openmesh)
{
    using mesh_of_doubles = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
    auto g = make_graph<mesh_of_doubles>(shapes::open_house());
    const auto control = kith::to_native(view_of(std::as_const(g)));
    ours::CatmullClark_subdivision(g, 2);
    const auto expected = kith::refine(control, kith::like<kith::catmull_clark>(kith::library::cgal), 2);
    EXPECT_TRUE(same_bits(kith::to_native(view_of(std::as_const(g))), expected));
}

TEST(cgal_dialect, takes_openmesh_through_cgals_wrapper)
{
    // OpenMesh's points are floats; CGAL's wrapper reads them as doubles.
    auto g = make_graph<openmesh>(shapes::open_house());
    auto expected = make_graph<mesh>(shapes::open_house());
    ours::CatmullClark_subdivision(g, params::number_of_iterations(2));
    ours::CatmullClark_subdivision(expected, params::number_of_iterations(2));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(g));
    EXPECT_EQ(difference(surface_of(g), surface_of(expected), 1e-6), "");
}

TEST(cgal_dialect, leaves_no_values_of_openmesh_on_other_elements)
{
    const auto run = [](const auto& subdivide, bool keeps_vertices) {
        auto g = make_graph<openmesh>(shapes::cube());
        g.request_face_colors(), g.request_edge_colors(), g.request_vertex_colors();
        OpenMesh::VPropHandleT<int> at_vertices;
        OpenMesh::FPropHandleT<int> on_faces;
        OpenMesh::EPropHandleT<int> on_edges;
        g.add_property(at_vertices, "at vertices"), g.add_property(on_faces, "on faces");
        g.add_property(on_edges, "on edges");
        for (const auto v : g.vertices())
            g.property(at_vertices, v) = 1, g.set_color(v, {9, 9, 9});
        for (const auto f : g.faces())
            g.property(on_faces, f) = 2, g.set_color(f, {9, 9, 9});
        for (const auto e : g.edges())
            g.property(on_edges, e) = 3, g.set_color(e, {9, 9, 9});
        subdivide(g);
        EXPECT_TRUE(CGAL::is_valid_polygon_mesh(g));
        for (const auto v : g.vertices()) {
            const bool is_old = keeps_vertices and v.idx() < 8;
            EXPECT_EQ(g.property(at_vertices, v), is_old ? 1 : 0);
            EXPECT_EQ(g.color(v), is_old ? openmesh::Color(9, 9, 9) : openmesh::Color(0, 0, 0));
        }
        for (const auto f : g.faces()) {
            EXPECT_EQ(g.property(on_faces, f), 0);
            EXPECT_EQ(g.color(f), openmesh::Color(0, 0, 0));
        }
        for (const auto e : g.edges()) {
            EXPECT_EQ(g.property(on_edges, e), 0);
            EXPECT_EQ(g.color(e), openmesh::Color(0, 0, 0));
        }
    };
    run([](auto& g) { ours::CatmullClark_subdivision(g, 1); }, true);
    run([](auto& g) { ours::DooSabin_subdivision(g, 1); }, false);
}

/// Returns the faces as lists of points, independent of their order and of their first corners.
std::multiset<std::vector<shapes::point>> faces_in_space(const surface& s)
{
    std::multiset<std::vector<shapes::point>> result;
    for (const auto& face : s.faces) {
        std::vector<shapes::point> points;
        for (const std::size_t v : face)
            points.push_back(s.points[v]);
        std::rotate(points.begin(), std::ranges::min_element(points), points.end());
        result.insert(std::move(points));
    }
    return result;
}

TEST(cgal_dialect, takes_graphs_that_make_new_elements_of_removed_ones)
{
    using graph = CGAL::
        Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, CGAL::Linear_cell_complex_traits<3, kernel>>::type;
    using vertex = boost::graph_traits<graph>::vertex_descriptor;
    auto g = make_graph<graph>(shapes::shaken(shapes::grid(3, 4)));
    for (int i = 0; i < 2; ++i) { // the one face at the lowest vertex, which lies at a corner of the grid
        const auto at = [&](vertex v) { return get(CGAL::vertex_point, g, v); };
        const auto all = vertices(g);
        const vertex lowest = *std::min_element(
            all.begin(), all.end(), [&](vertex a, vertex b) { return at(a) < at(b); });
        const auto h = halfedge(lowest, g);
        CGAL::Euler::remove_face(is_border(h, g) ? opposite(next(h, g), g) : h, g);
    }
    std::map<vertex, bool> is_corner;
    const auto lifted = kith::to_native(view_of(std::as_const(g)));
    kith::catmull_clark scheme;
    std::size_t number = 0;
    for (const auto v : vertices(g)) {
        is_corner[v] = number % 3 == 0;
        if (is_corner[v])
            scheme.sharpness.sharpen_vertex(number, kith::infinitely_sharp);
        ++number;
    }
    const auto corners_before = is_corner;
    std::map<vertex, kernel::Point_3> before;
    for (const auto v : vertices(g))
        before.emplace(v, get(CGAL::vertex_point, g, v));

    const boost::associative_property_map<std::map<vertex, bool>> corner_map(is_corner);
    ours::subdivision(g, kith::catmull_clark(), params::number_of_iterations(2).vertex_is_constrained_map(corner_map));
    const auto fine = kith::refine(lifted, scheme, 2);
    EXPECT_EQ(faces_in_space(surface_of(g)),
              faces_in_space({{fine.points().begin(), fine.points().end()}, faces_of(fine)}));
    for (const auto v : vertices(g)) {
        const auto old = corners_before.find(v);
        EXPECT_EQ(is_corner[v], old != corners_before.end() and old->second);
        if (is_corner[v]) {
            EXPECT_EQ(get(CGAL::vertex_point, g, v), before.at(v));
        }
    }
}

TEST(cgal_dialect, runs_masks_of_cgals_kind)
{
    const auto vpm = [](auto& m) { return get(CGAL::vertex_point, m); };
    const auto run = [&]<class Graph>(Graph*) {
        for (const auto& shape : {shapes::open_house(), shapes::cube()}) {
            expect_same_surface<Graph>(
                shape,
                [](auto& m, unsigned n) { theirs::PQQ(m, lifting_mask<Graph>{&m}, params::number_of_iterations(n)); },
                [](auto& m, unsigned n) { ours::PQQ(m, lifting_mask<Graph>{&m}, params::number_of_iterations(n)); });
            expect_same_surface<Graph>(
                shape,
                [](auto& m, unsigned n) { theirs::DQQ(m, lifting_mask<Graph>{&m}, params::number_of_iterations(n)); },
                [](auto& m, unsigned n) { ours::DQQ(m, lifting_mask<Graph>{&m}, int(n)); });
        }
        for (const auto& shape : {shapes::umbrella(5), shapes::tetrahedron()}) {
            expect_same_surface<Graph>(
                shape,
                [](auto& m, unsigned n) { theirs::PTQ(m, lifting_mask<Graph>{&m}, params::number_of_iterations(n)); },
                [&](auto& m, unsigned n) {
                    ours::PTQ(m, lifting_mask<Graph>{&m}, params::number_of_iterations(n).vertex_point_map(vpm(m)));
                });
            expect_same_surface<Graph>(
                shape,
                [](auto& m, unsigned n) { theirs::Sqrt3(m, lifting_mask<Graph>{&m}, params::number_of_iterations(n)); },
                [](auto& m, unsigned n) { ours::Sqrt3(m, lifting_mask<Graph>{&m}, params::number_of_iterations(n)); });
        }
    };
    run(static_cast<mesh*>(nullptr));
    run(static_cast<polyhedron*>(nullptr));
}

TEST(cgal_dialect, masks_write_points_to_another_map_and_leave_those_of_new_vertices_at_zero)
{
    using vertex = mesh::Vertex_index;
    const auto before = make_graph<mesh>(shapes::umbrella(5));
    auto m = before, expected = before;
    auto place = m.add_property_map<vertex, kernel::Point_3>("v:place").first;
    for (const auto v : m.vertices())
        place[v] = m.point(v);
    ours::PTQ(expected, lifting_mask<mesh>{&expected});
    ours::PTQ(m, lifting_mask<mesh>{&m}, params::number_of_iterations(1).vertex_point_map(place));
    ASSERT_EQ(m.number_of_vertices(), expected.number_of_vertices());
    for (const auto v : m.vertices()) {
        EXPECT_EQ(place[v], expected.point(v));
        EXPECT_EQ(m.point(v), v.idx() < before.number_of_vertices() ? before.point(v) : kernel::Point_3(0, 0, 0));
    }
}

TEST(cgal_dialect, faces_that_a_scheme_does_not_take_have_the_numbers_of_their_handles)
{
    auto m = make_graph<mesh>(shapes::both(shapes::tetrahedron(), shapes::cube()));
    for (std::uint32_t f = 0; f < 4; ++f)
        CGAL::Euler::remove_face(m.halfedge(mesh::Face_index(f)), m);
    const lifting_mask<mesh> mask{&m};
    const std::string triangles_only = "face 4 has 4 vertices; triangulate the mesh first";
    EXPECT_EQ(error_text<kith::mesh_error>([&] { ours::Loop_subdivision(m); }), "loop: " + triangles_only);
    EXPECT_NE(error_text<kith::mesh_error>([&] { ours::PTQ(m, mask); }).find(triangles_only), std::string::npos);
    EXPECT_NE(error_text<kith::mesh_error>([&] { ours::Sqrt3(m, mask); }).find(triangles_only), std::string::npos);
    EXPECT_EQ(m.number_of_faces(), 6U);
}

TEST(cgal_dialect, refuses_fewer_steps_than_none)
{
    auto m = make_graph<surface_mesh<kernel>>(shapes::cube());
    for (const int steps : {-1, -100}) {
        const lifting_mask<surface_mesh<kernel>> mask{&m};
        const std::string expected = std::to_string(steps) + " steps by a mask were asked for; ask for 0 or more";
        EXPECT_EQ(error_text<kith::mesh_error>([&] { ours::PQQ(m, mask, steps); }), expected);
        EXPECT_EQ(error_text<kith::mesh_error>([&] { ours::DQQ(m, mask, params::number_of_iterations(steps)); }),
                  expected);
    }
}

TEST(cgal_dialect, refuses_more_steps_than_can_be_counted)
{
    auto m = make_graph<surface_mesh<kernel>>(shapes::cube());
    const auto faces = m.number_of_faces();
    EXPECT_EQ(error_text<kith::mesh_error>([&] { ours::CatmullClark_subdivision(m, (1LL << 32) + 1); }),
              "4294967297 iterations are too many; ask for fewer");
    EXPECT_EQ(
        error_text<kith::mesh_error>([&] { ours::DooSabin_subdivision(m, params::number_of_iterations(4294967295U)); }),
        "4294967295 iterations are too many; ask for fewer");
    EXPECT_EQ(m.number_of_faces(), faces);
}
