// SPDX-License-Identifier: BSD-3-Clause
// Tests the named parameters of kith::cgal, the effect on handles and property maps, and errors.
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>

#include "support/error_text.hpp"
#include "support/graph_surface.hpp"

#include <kith/cgal_subdivision.hpp>
#include <kith/compiled_schemes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using point = kernel::Point_3;
using mesh = surface_mesh<kernel>;
using polyhedron = CGAL::Polyhedron_3<kernel>;
using vertex = mesh::Vertex_index;
using edge = mesh::Edge_index;
using face = mesh::Face_index;
using halfedge = mesh::Halfedge_index;
namespace ours = kith::cgal;
namespace params = kith::cgal::parameters;

struct label {
    int number = -1;
    friend bool operator==(const label&, const label&) = default;
};

mesh house()
{
    return make_graph<mesh>(shapes::open_house());
}

/// Returns a predicate that marks every third edge inside the mesh.
auto third_edges(const mesh& m)
{
    return [&m](edge e) { return e.idx() % 3 == 0 and not m.is_border(e); };
}

template <class Scheme>
auto with_creases(Scheme scheme, kith::creases sharp)
{
    scheme.sharpness = std::move(sharp);
    return scheme;
}

struct told {
    std::vector<double> parts;
    std::size_t last = 100;

    bool progress(double done)
    {
        parts.push_back(done);
        return parts.size() < last;
    }
};

} // namespace

TEST(cgal_parameters, old_vertices_keep_their_handles_and_maps_stay)
{
    mesh control = house();
    auto weight = control.add_property_map<vertex, double>("v:weight").first;
    auto unknown = control.add_property_map<vertex, label>("v:label").first;
    auto material = control.add_property_map<face, int>("f:material", -7).first;
    auto of_edge = control.add_property_map<edge, label>("e:label", label{8}).first;
    auto texture = control.add_property_map<halfedge, std::array<float, 2>>("h:uv").first;
    for (const auto v : control.vertices())
        weight[v] = control.point(v).z(), unknown[v] = {int(v.idx())};
    for (const auto f : control.faces())
        material[f] = int(f.idx());
    for (const auto e : control.edges())
        of_edge[e] = {1};
    for (const auto h : control.halfedges())
        texture[h] = {float(control.point(control.target(h)).x()), 1};

    const mesh before = control;
    const auto expected = kith::refine_with_properties(before, kith::like<kith::catmull_clark>(kith::library::cgal), 2);
    ours::CatmullClark_subdivision(control, params::number_of_iterations(2));
    EXPECT_TRUE(same_bits(control, expected.first));
    const auto expected_uv = map_of<halfedge, std::array<float, 2>>(expected.first, "h:uv");
    for (const auto v : control.vertices()) { // through the maps that were made before refining
        EXPECT_EQ(weight[v], control.point(v).z());
        EXPECT_EQ(unknown[v], label{v.idx() < before.num_vertices() ? int(v.idx()) : -1});
    }
    const auto expected_material = map_of<face, int>(expected.first, "f:material");
    for (const auto f : control.faces())
        EXPECT_EQ(material[f], expected_material[f]);
    std::size_t along_old = 0; // values of an unknown type are copied along old edges; others are defaults
    for (const auto e : control.edges())
        if (of_edge[e] == label{1})
            ++along_old;
        else
            EXPECT_EQ(of_edge[e], label{8});
    EXPECT_EQ(along_old, 4 * before.num_edges());
    for (const auto h : control.halfedges())
        if (not control.is_border(h)) {
            EXPECT_EQ(texture[h], expected_uv[h]);
        }
}

TEST(cgal_parameters, removed_elements_stay_removed)
{
    auto shape = shapes::both(shapes::tetrahedron(), shapes::cube());
    for (std::size_t v = 4; v < shape.points.size(); ++v)
        shape.points[v][0] -= 10;
    mesh control = make_graph<mesh>(shape);
    for (std::uint32_t f = 0; f < 4; ++f)
        CGAL::Euler::remove_face(control.halfedge(face(f)), control);
    auto name = control.add_property_map<vertex, std::string>("v:name").first;
    for (const auto v : control.vertices())
        name[v] = std::to_string(v.idx());
    mesh expected = make_graph<mesh>(shapes::cube());
    ASSERT_TRUE(control.has_garbage());
    ours::CatmullClark_subdivision(control, params::number_of_iterations(2));
    ours::CatmullClark_subdivision(expected, params::number_of_iterations(2));
    EXPECT_TRUE(control.is_valid());
    EXPECT_EQ(control.number_of_vertices() + 4, control.num_vertices());
    EXPECT_EQ(control.number_of_faces(), control.num_faces());
    EXPECT_EQ(control.number_of_edges(), control.num_edges());
    EXPECT_EQ(difference(surface_of(control), surface_of(expected)), "");
    for (const auto v : expected.vertices()) // old and new elements lie behind the removed ones
        EXPECT_EQ(control.point(vertex(v.idx() + 4)), expected.point(v));
    for (const auto v : control.vertices())
        EXPECT_EQ(name[v], v.idx() < 12 ? std::to_string(v.idx()) : "");
}

TEST(cgal_parameters, errors_name_elements_by_their_handles_beside_removed_ones)
{
    mesh control = make_graph<mesh>(shapes::both(shapes::tetrahedron(), shapes::cube()));
    for (std::uint32_t f = 0; f < 4; ++f)
        CGAL::Euler::remove_face(control.halfedge(face(f)), control);
    ASSERT_EQ(control.num_vertices() - control.number_of_vertices(), 4U);
    ASSERT_EQ(control.num_edges() - control.number_of_edges(), 6U);
    const auto refusal_of = [&](const auto& parameters) {
        return error_text<kith::mesh_error>([&] { ours::CatmullClark_subdivision(control, parameters); });
    };
    auto of_edges = control.add_property_map<edge, double>("e:sharpness", 0).first;
    of_edges[edge(8)] = -1;
    EXPECT_EQ(refusal_of(params::edge_sharpness_map(of_edges)).substr(0, 28), "edge 8: its sharpness is -1.");
    auto of_vertices = control.add_property_map<vertex, double>("v:sharpness", 0).first;
    of_vertices[vertex(6)] = -1;
    EXPECT_EQ(refusal_of(params::vertex_sharpness_map(of_vertices)).substr(0, 30), "vertex 6: its sharpness is -1.");
}

TEST(cgal_parameters, maps_stay_beside_removed_elements)
{
    for (const bool recycles : {true, false}) {
        mesh control = make_graph<mesh>(shapes::open_house());
        control.set_recycle_garbage(recycles);
        auto unknown = control.add_property_map<vertex, label>("v:label").first;
        auto mine = control.add_property_map<vertex, int>().first; // CGAL chooses a free name
        for (const auto v : control.vertices())
            unknown[v] = {int(v.idx())}, mine[v] = 100 + int(v.idx());
        CGAL::Euler::remove_face(control.halfedge(face(8)), control);
        ASSERT_TRUE(control.has_garbage());
        const auto size = control.num_vertices();
        ours::CatmullClark_subdivision(control, 1);
        EXPECT_TRUE(control.is_valid());
        EXPECT_EQ(control.does_recycle_garbage(), recycles);
        EXPECT_EQ(control.number_of_removed_edges() + control.number_of_removed_faces(), 0U);
        for (const auto v : control.vertices())
            if (v.idx() < size) {
                EXPECT_EQ(unknown[v], label{int(v.idx())});
                EXPECT_EQ(mine[v], 100 + int(v.idx()));
            }
        const auto [other, is_new] = control.add_property_map<vertex, int>();
        EXPECT_TRUE(is_new);
    }
}

TEST(cgal_parameters, constrained_edges_are_creases)
{
    const mesh control = house();
    const auto expected = kith::refine(
        control,
        with_creases(kith::like<kith::catmull_clark>(kith::library::cgal),
                     kith::make_creases(control, third_edges(control), [](vertex v) { return v.idx() == 4; })),
        3);
    mesh once = control, again = control;
    for (mesh* m : {&once, &again}) {
        auto constrained = m->add_property_map<edge, bool>("e:constrained", false).first;
        auto corner = m->add_property_map<vertex, bool>("v:corner", false).first;
        std::size_t count = 0;
        for (const auto e : m->edges())
            count += constrained[e] = third_edges(*m)(e);
        corner[vertex(4)] = true;
        const auto np = params::edge_is_constrained_map(constrained).vertex_is_constrained_map(corner);
        if (m == &once)
            ours::CatmullClark_subdivision(*m, np.number_of_iterations(3));
        else
            for (int i = 0; i < 3; ++i)
                ours::CatmullClark_subdivision(*m, np);
        EXPECT_TRUE(same_bits(*m, expected));
        std::size_t children = 0, corners = 0;
        for (const auto e : m->edges())
            children += constrained[e];
        for (const auto v : m->vertices())
            corners += corner[v];
        EXPECT_EQ(children, 8 * count);
        EXPECT_EQ(corners, 1U);
    }
}

TEST(cgal_parameters, sharpness_goes_down_from_level_to_level)
{
    const mesh control = make_graph<mesh>(shapes::tetrahedron());
    const auto sharp = [](edge e) { return e.idx() == 1 ? 2.5 : 0.; };
    const auto expected = kith::refine(
        control,
        with_creases(kith::like<kith::loop>(kith::library::cgal),
                     kith::make_creases(control, sharp, [](vertex v) { return v.idx() == 3 ? 1.25 : 0.; })),
        3);
    for (const int steps : {3, 1}) {
        mesh m = control;
        auto of_edge = m.add_property_map<edge, double>("e:sharp", 0.).first;
        auto of_vertex = m.add_property_map<vertex, float>("v:sharp", 0.F).first;
        of_edge[edge(1)] = 2.5;
        of_vertex[vertex(3)] = 1.25;
        const auto np = params::edge_sharpness_map(of_edge, params::vertex_sharpness_map(of_vertex));
        for (int i = 0; i < 3; i += steps) {
            ours::Loop_subdivision(m, np.number_of_iterations(steps));
            if (i == 0 and steps == 1) {
                EXPECT_EQ(of_vertex[vertex(3)], 0.25F);
                EXPECT_EQ(std::ranges::count_if(m.edges(), [&](edge e) { return of_edge[e] == 1.5; }), 2);
            }
        }
        EXPECT_TRUE(same_bits(m, expected));
        for (const auto e : m.edges())
            EXPECT_EQ(of_edge[e], 0);
    }
}

TEST(cgal_parameters, sharpness_may_be_an_integer)
{
    mesh m = make_graph<mesh>(shapes::cube()), expected = m;
    auto sharp = m.add_property_map<edge, bool>("e:sharp", false).first;
    auto levels = m.add_property_map<edge, int>("e:levels", 0).first;
    auto number = expected.add_property_map<edge, double>("e:number", 0).first;
    for (const auto e : m.edges()) {
        sharp[e] = e.idx() % 4 == 0;
        levels[e] = int(e.idx() % 3);
        number[e] = sharp[e] ? kith::infinitely_sharp : levels[e];
    }
    for (int call = 0; call < 2; ++call) {
        ours::CatmullClark_subdivision(m, params::edge_sharpness_map(levels).edge_is_constrained_map(sharp));
        ours::CatmullClark_subdivision(expected, params::edge_sharpness_map(number));
        EXPECT_TRUE(same_bits(m, expected));
        for (const auto e : m.edges()) {
            EXPECT_EQ(levels[e], sharp[e] ? std::numeric_limits<int>::max() : int(number[e]));
            EXPECT_EQ(sharp[e], number[e] == kith::infinitely_sharp);
        }
    }
}

TEST(cgal_parameters, creases_on_a_polyhedron)
{
    mesh control = house();
    auto p = same_graph<polyhedron>(control);
    auto constrained = get(CGAL::dynamic_edge_property_t<bool>(), p);
    auto expected_map = control.add_property_map<edge, bool>("e:constrained", false).first;
    auto e = edges(p).begin();
    for (const auto f : control.edges()) {
        expected_map[f] = third_edges(control)(f);
        put(constrained, *e++, expected_map[f]);
    }
    ours::CatmullClark_subdivision(p, params::edge_is_constrained_map(constrained).number_of_iterations(2));
    ours::CatmullClark_subdivision(control, params::edge_is_constrained_map(expected_map).number_of_iterations(2));
    EXPECT_TRUE(same_bits(kith::to_native(view_of(p)), kith::to_native(view_of(control))));
    e = edges(p).begin();
    for (const auto f : control.edges())
        EXPECT_EQ(get(constrained, *e++), expected_map[f]);
}

TEST(cgal_parameters, descriptors_of_a_polyhedron_stay)
{
    auto p = same_graph<polyhedron>(house());
    std::vector<polyhedron::Vertex_handle> before;
    for (const auto v : vertices(p))
        before.push_back(v);
    mesh expected = house();
    ours::CatmullClark_subdivision(p, 2);
    ours::CatmullClark_subdivision(expected, 2);
    for (std::size_t v = 0; v < before.size(); ++v)
        EXPECT_EQ(before[v]->point(), expected.point(vertex(std::uint32_t(v))));
    EXPECT_TRUE(p.is_valid());
}

TEST(cgal_parameters, what_items_of_a_polyhedron_hold_is_on_no_other_element)
{
    using numbered = CGAL::Polyhedron_3<kernel, CGAL::Polyhedron_items_with_id_3>;
    const auto none = std::size_t(-1); // the number of an item without a number
    for (const bool keeps_vertices : {true, false}) {
        auto p = make_graph<numbered>(shapes::open_house());
        CGAL::set_halfedgeds_items_id(p);
        const std::size_t count = num_vertices(p);
        if (keeps_vertices)
            ours::CatmullClark_subdivision(p, 1);
        else
            ours::DooSabin_subdivision(p, 1);
        EXPECT_TRUE(p.is_valid());
        std::size_t v = 0;
        for (const auto x : vertices(p)) {
            EXPECT_EQ(x->id(), keeps_vertices and v < count ? v : none);
            ++v;
        }
        for (const auto f : faces(p))
            EXPECT_EQ(f->id(), none);
        for (const auto h : halfedges(p))
            EXPECT_EQ(h->id(), none);
    }
}

TEST(cgal_parameters, the_largest_integer_is_sharp_for_ever)
{
    mesh m = make_graph<mesh>(shapes::cube()), expected = m;
    auto small = m.add_property_map<edge, unsigned char>("e:small", 0).first;
    auto at_vertices = m.add_property_map<vertex, signed char>("v:small", 0).first;
    auto number = expected.add_property_map<edge, double>("e:number", 0).first;
    for (const auto e : m.edges())
        if (e.idx() % 3 == 0)
            small[e] = 255, number[e] = kith::infinitely_sharp;
    at_vertices[vertex(5)] = 127;
    auto corner = expected.add_property_map<vertex, bool>("v:corner", false).first;
    corner[vertex(5)] = true;
    for (int call = 0; call < 2; ++call) {
        ours::CatmullClark_subdivision(m, params::edge_sharpness_map(small).vertex_is_constrained_map(at_vertices));
        ours::CatmullClark_subdivision(expected, params::edge_sharpness_map(number).vertex_is_constrained_map(corner));
        EXPECT_TRUE(same_bits(m, expected));
        for (const auto e : m.edges())
            EXPECT_EQ(small[e], number[e] == kith::infinitely_sharp ? 255 : 0);
        EXPECT_EQ(at_vertices[vertex(5)], 127);
    }
}

TEST(cgal_parameters, points_may_lie_in_another_map)
{
    mesh m = house();
    auto place = m.add_property_map<vertex, point>("v:place").first;
    for (const auto v : m.vertices())
        place[v] = m.point(v) + kernel::Vector_3(0, 0, 1);
    const mesh before = m;
    mesh expected = m;
    for (const auto v : expected.vertices())
        expected.point(v) = place[v];
    ours::NasriHasbini_subdivision(expected, params::number_of_iterations(2));
    ours::NasriHasbini_subdivision(m, params::number_of_iterations(2).vertex_point_map(place));
    ASSERT_EQ(m.number_of_vertices(), expected.number_of_vertices());
    for (const auto v : m.vertices())
        EXPECT_EQ(place[v], expected.point(v));
    for (const auto v : before.vertices())
        EXPECT_EQ(m.point(v), before.point(v));
    for (std::size_t v = before.number_of_vertices(); v < m.number_of_vertices(); ++v)
        EXPECT_EQ(m.point(vertex(std::uint32_t(v))), point(0, 0, 0));
}

TEST(cgal_parameters, geometry_may_stay)
{
    mesh m = house(), expected = house();
    ours::CatmullClark_subdivision(m, params::do_not_modify_geometry(true).number_of_iterations(2));
    ours::Linear_subdivision(expected, 2);
    EXPECT_TRUE(same_bits(m, expected));
    m = expected = make_graph<mesh>(shapes::tetrahedron());
    ours::Loop_subdivision(m, params::do_not_modify_geometry(true));
    ours::LinearTriangles_subdivision(expected, 1);
    EXPECT_TRUE(same_bits(m, expected));
    ours::Loop_subdivision(m, params::do_not_modify_geometry(false));
    ours::Loop_subdivision(expected);
    EXPECT_TRUE(same_bits(m, expected));
}

TEST(cgal_parameters, triangles_back_to_back_are_refused_where_geometry_stays_too)
{
    mesh m;
    const auto a = m.add_vertex(point(0, 0, 0)), b = m.add_vertex(point(1, 0, 0)), c = m.add_vertex(point(0, 1, 0));
    m.add_face(a, b, c);
    m.add_face(a, c, b);
    EXPECT_NE(error_text<kith::mesh_error>([&] {
                  ours::Loop_subdivision(m, params::do_not_modify_geometry(true));
              }).find("lies between 2 faces only"),
              std::string::npos);
}

TEST(cgal_parameters, creases_go_along_where_geometry_stays)
{
    const auto expect = [](const auto& subdivide, mesh m) {
        mesh moved = m;
        std::map<edge, bool> kept, expected;
        for (const auto e : m.edges())
            kept[e] = expected[e] = e.idx() % 3 == 0;
        const auto map = boost::associative_property_map<std::map<edge, bool>>(kept);
        subdivide(m, params::do_not_modify_geometry(true).edge_is_constrained_map(map));
        subdivide(moved,
                  params::edge_is_constrained_map(boost::associative_property_map<std::map<edge, bool>>(expected)));
        EXPECT_EQ(kept, expected);
        EXPECT_EQ(kept.size(), m.number_of_edges());
    };
    expect([](auto& m, const auto& np) { ours::CatmullClark_subdivision(m, np); }, house());
    expect([](auto& m, const auto& np) { ours::Loop_subdivision(m, np); }, make_graph<mesh>(shapes::tetrahedron()));
}

TEST(cgal_parameters, a_visitor_is_told_and_may_stop)
{
    mesh m = make_graph<mesh>(shapes::tetrahedron()), expected = m;
    told all;
    ours::Loop_subdivision(m, params::number_of_iterations(3).visitor(std::ref(all)));
    EXPECT_EQ(all.parts, (std::vector<double>{16. / 336, 80. / 336, 1.}));
    ours::Loop_subdivision(expected, 3);
    EXPECT_TRUE(same_bits(m, expected));

    told two{.parts = {}, .last = 2};
    ours::Loop_subdivision(m, params::number_of_iterations(3).visitor(std::ref(two)));
    EXPECT_EQ(two.parts.size(), 2U);
    EXPECT_TRUE(same_bits(m, expected));
}

TEST(cgal_parameters, sqrt3_counts_anew_in_each_call_and_leaves_no_trace)
{
    const mesh control = make_graph<mesh>(shapes::umbrella(5));
    mesh m = control, expected = kith::refine(control, kith::sqrt3(), 1);
    ours::Sqrt3_subdivision(m, 1);
    EXPECT_EQ(difference(surface_of(m), surface_of(expected)), "");
    EXPECT_EQ(kith::mesh_traits<mesh>::generation(m), 0);
    ours::Sqrt3_subdivision(expected, 1); // kith knew that this mesh was between two steps
    EXPECT_EQ(kith::mesh_traits<mesh>::generation(expected), 0);
}

TEST(cgal_parameters, a_mesh_that_is_refused_stays)
{
    mesh m = house();
    const mesh before = m;
    EXPECT_NE(error_text<kith::mesh_error>([&] { ours::Loop_subdivision(m, 2); }).find("loop: face"),
              std::string::npos);
    EXPECT_NE(error_text<kith::mesh_error>([&] { ours::CatmullClark_subdivision(m, -1); }).find("ask for 0 or more"),
              std::string::npos);
    ours::Loop_subdivision(m, 0);
    EXPECT_TRUE(same_bits(m, before));
}

TEST(cgal_parameters, a_vertex_without_faces_stays)
{
    polyhedron with_vertex = make_graph<polyhedron>(shapes::open_house()), without = with_vertex;
    with_vertex.hds().vertices_push_back(polyhedron::Vertex(point(1, 2, 3)));
    ours::CatmullClark_subdivision(with_vertex);
    ours::CatmullClark_subdivision(without);
    std::vector<point> points(with_vertex.points_begin(), with_vertex.points_end());
    ASSERT_EQ(std::erase(points, point(1, 2, 3)), 1U);
    EXPECT_TRUE(std::ranges::equal(points, std::vector<point>(without.points_begin(), without.points_end())));
}

TEST(cgal_parameters, exact_points_stay_exact)
{
    using exact_mesh = surface_mesh<epeck>;
    exact_mesh m = user_mesh<exact_mesh>::make(shapes::open_house().points, shapes::open_house().faces);
    const auto expected = kith::refine(m, kith::like<kith::catmull_clark>(kith::library::cgal), 1);
    ours::CatmullClark_subdivision(m);
    EXPECT_TRUE(same_bits(m, expected));
}
