// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/Simple_cartesian.h>

#include <kith/cgal_properties.hpp>

#include "support/cgal_mesh.hpp"
#include "support/error_text.hpp"
#include "support/face_varying_on.hpp"
#include "support/property_names.hpp"
#include "support/shapes.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/face_varying.hpp>
#include <kith/linear.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using mesh = surface_mesh<kernel>;
using vertex = mesh::Vertex_index;
using edge = mesh::Edge_index;
using face = mesh::Face_index;
using halfedge = mesh::Halfedge_index;
using uv = std::array<float, 2>;

struct label {
    int number = -1;
    friend bool operator==(const label&, const label&) = default;
};

mesh make(const shapes::shape& s)
{
    return user_mesh<mesh>::make(s.points, s.faces);
}

/// Returns the mesh with maps of many types on all kinds of elements.
mesh with_maps(mesh m)
{
    auto place = m.add_property_map<vertex, kernel::Point_3>("v:place").first;
    auto height = m.add_property_map<vertex, float>("v:height").first;
    auto color = m.add_property_map<vertex, CGAL::IO::Color>("v:color").first;
    auto id = m.add_property_map<vertex, int>("v:id", -1).first;
    for (const auto v : m.vertices()) {
        place[v] = m.point(v);
        height[v] = float(m.point(v).z());
        color[v] = CGAL::IO::Color(200, 0, 255, 10);
        id[v] = 10 + int(v);
    }
    auto feature = m.add_property_map<edge, bool>("e:feature", false).first;
    for (const auto e : m.edges())
        feature[e] = e.idx() % 3 == 0;
    auto material = m.add_property_map<face, std::string>("f:material").first;
    auto labels = m.add_property_map<face, label>("f:label").first;
    for (const auto f : m.faces()) {
        material[f] = "material " + std::to_string(f.idx());
        labels[f] = {int(f)};
    }
    auto texture = m.add_property_map<halfedge, uv>("h:uv").first;
    auto mark = m.add_property_map<halfedge, int>("h:mark").first;
    for (const auto h : m.halfedges()) {
        texture[h] = {float(h.idx()), float(h.idx() % 5)};
        mark[h] = 1 + int(h);
    }
    return m;
}

/// Makes a control mesh whose numbers begin with a gap: its first faces have been removed.
mesh after_removed_tetrahedron()
{
    auto shape = shapes::both(shapes::tetrahedron(), shapes::cube());
    for (std::size_t v = 4; v < shape.points.size(); ++v)
        shape.points[v][0] -= 10;
    auto result = make(shape);
    for (std::uint32_t f = 0; f < 4; ++f)
        CGAL::Euler::remove_face(result.halfedge(face(f)), result);
    return result;
}

using names = std::vector<std::string>;

} // namespace

TEST(cgal_properties, are_carried_by_name_and_told)
{
    const auto [fine, report] = kith::refine_with_properties<label>(
        with_maps(make(shapes::open_house())), kith::catmull_clark(), 2);
    EXPECT_EQ(
        report.carried,
        (names{"v:place", "v:height", "v:color", "v:id", "h:uv", "h:mark", "e:feature", "f:material", "f:label"}));
    EXPECT_TRUE(report.left_out.empty());
    const auto [again,
                other] = kith::refine_with_properties(with_maps(make(shapes::open_house())), kith::catmull_clark(), 2);
    EXPECT_EQ(names_of(other.left_out), names{"f:label"});
}

TEST(cgal_properties, only_names_of_the_mesh_itself_are_kept_from_the_user)
{
    using access = kith::property_access<mesh>;
    auto control = make(shapes::cube());
    const std::vector<std::string> own = control.properties<vertex>();
    for (const std::string& name : own)
        EXPECT_TRUE(access::is_reserved(name)) << name;
    control.add_property_map<face, int>("f:was:removed", 0).first[face(3)] = 7;
    control.add_property_map<vertex, double>("v:kith:height", 2.);
    control.add_property_map<halfedge, int>("h:other:connectivity", 1);
    const auto fine = kith::refine_with_properties(control, kith::catmull_clark(), 1);
    EXPECT_EQ(fine.second.carried, (names{"v:kith:height", "h:other:connectivity", "f:was:removed"}));
    const auto was = map_of<face, int>(fine.first, "f:was:removed");
    int sum = 0;
    for (const auto f : fine.first.faces())
        sum += was[f];
    EXPECT_EQ(sum, 28);
    EXPECT_EQ((map_of<vertex, double>(fine.first, "v:kith:height")[vertex(20)]), 2);
}

TEST(cgal_properties, without_a_name_are_left_out_of_another_mesh)
{
    auto control = make(shapes::cube());
    control.add_property_map<vertex, int>("", 5);
    control.add_property_map<face, label>("", label{});
    control.add_property_map<vertex, int>("v:id", 6);
    auto [fine, report] = kith::refine_with_properties<label>(control, kith::catmull_clark(), 1);
    EXPECT_EQ(report.carried, names{"v:id"});
    EXPECT_EQ(names_of(report.left_out), (names{"anonymous-property-0", "anonymous-property-1"}));
    const auto [made, is_new] = fine.add_property_map<vertex, int>("", 9);
    EXPECT_TRUE(is_new);
    EXPECT_EQ(made[vertex(3)], 9);
}

TEST(cgal_properties, by_rule_are_told_by_the_elements_they_lie_on)
{
    auto control = make(shapes::cube());
    control.add_property_map<vertex, label>("label", label{});
    control.add_property_map<face, label>("label", label{});
    const auto [fine, report] = kith::refine_with_properties(
        control, kith::catmull_clark(), 1, kith::by_rule<face, label>("label", kith::from_parent()));
    EXPECT_EQ(report.carried, names{"label"});
    EXPECT_EQ(names_of(report.left_out), names{"label"}); // that of vertices
    const auto other = kith::refine_with_properties(
        control, kith::catmull_clark(), 1, kith::by_rule<edge, label>("label", kith::along_edges()));
    EXPECT_EQ(names_of(other.second.left_out), (names{"label", "label", "label"})); // the last as there is none
}

namespace {

/// A value type that counts how often values are copied.
struct counted {
    static inline std::size_t copies = 0;

    counted() = default;
    counted(const counted&) { ++copies; }
    counted& operator=(const counted&)
    {
        ++copies;
        return *this;
    }
};

} // namespace

TEST(cgal_properties, are_read_with_one_copy_of_the_mesh)
{
    auto control = make(shapes::torus(8, 8));
    control.add_property_map<vertex, counted>("v:counted");
    control.add_property_map<vertex, int>("v:id", 1);
    control.add_property_map<halfedge, int>("h:id", 2);
    control.add_property_map<edge, int>("e:id", 3);
    control.add_property_map<face, int>("f:id", 4);
    kith::hierarchy<mesh, kith::doo_sabin> levels(control, kith::doo_sabin());
    levels.refine(1);
    mesh fine = levels[1];
    counted::copies = 0;
    const auto report = kith::carry_properties(
        levels, 0, 1, fine, kith::by_rule<face, int>("f:id", kith::from_parent()));
    EXPECT_EQ(names_of(report.left_out), names{"v:counted"});
    EXPECT_LT(counted::copies, 2 * control.number_of_vertices());
    const auto id = map_of<face, int>(fine, "f:id");
    EXPECT_EQ(id[face(0)], 4);
}

TEST(cgal_properties, at_vertices_go_as_the_points_do)
{
    for (const mesh& control : {with_maps(make(shapes::open_house())), with_maps(after_removed_tetrahedron())}) {
        const auto [fine, report] = kith::refine_with_properties(control, kith::catmull_clark(), 2);
        const mesh expected = kith::refine(control, kith::catmull_clark(), 2);
        const auto place = map_of<vertex, kernel::Point_3>(fine, "v:place");
        const auto height = map_of<vertex, float>(fine, "v:height");
        const auto color = map_of<vertex, CGAL::IO::Color>(fine, "v:color");
        ASSERT_EQ(fine.number_of_vertices(), expected.number_of_vertices());
        for (const auto v : fine.vertices()) {
            EXPECT_EQ(fine.point(v), expected.point(v));
            EXPECT_EQ(place[v], fine.point(v));
            EXPECT_EQ(height[v], float(fine.point(v).z()));
            EXPECT_EQ(color[v], CGAL::IO::Color(200, 0, 255, 10));
        }
    }
}

TEST(cgal_properties, inherit_from_the_element_that_an_element_comes_from)
{
    for (const mesh& control : {with_maps(make(shapes::open_house())), with_maps(after_removed_tetrahedron())}) {
        kith::hierarchy<mesh, kith::catmull_clark> levels(control);
        levels.refine(2);
        mesh fine = levels[2];
        kith::carry_properties<label>(levels, 0, 2, fine);
        const auto id = map_of<vertex, int>(fine, "v:id");
        std::size_t old_ones = 0;
        for (const auto v : control.vertices()) {
            const auto child = levels.assoc(1, levels.assoc(0, v, kith::targets::V), kith::targets::V);
            EXPECT_EQ(id[child], 10 + int(v));
        }
        for (const auto v : fine.vertices())
            old_ones += id[v] != -1; // the map's default for new elements
        EXPECT_EQ(old_ones, control.number_of_vertices());

        const auto material = map_of<face, std::string>(fine, "f:material");
        const auto labels = map_of<face, label>(fine, "f:label");
        for (const auto f : fine.faces()) {
            const face parent = *levels.origin(1, *levels.origin(2, f).f).f;
            EXPECT_EQ(material[f], "material " + std::to_string(parent.idx()));
            EXPECT_EQ(labels[f], label{int(parent)});
        }
        const auto feature = map_of<edge, bool>(fine, "e:feature");
        const auto before = map_of<edge, bool>(control, "e:feature");
        std::size_t features = 0, expected = 0;
        for (const auto e : fine.edges())
            features += feature[e];
        for (const auto e : control.edges())
            expected += 4 * before[e];
        EXPECT_EQ(features, expected);
    }
}

TEST(cgal_properties, at_half_edges_are_linear_in_each_face)
{
    const mesh control = with_maps(make(shapes::open_house()));
    kith::hierarchy<mesh, kith::catmull_clark> levels(control);
    levels.refine(1);
    mesh fine = levels[1];
    kith::carry_properties(levels, 0, 1, fine);
    const auto before = map_of<halfedge, uv>(control, "h:uv"), after = map_of<halfedge, uv>(fine, "h:uv");
    for (const auto h : fine.halfedges()) {
        if (fine.is_border(h))
            continue;
        const face parent = *levels.origin(1, fine.face(h)).f;
        const auto born = levels.origin(1, fine.target(h));
        double u = 0, corners = 0, mean = 0, degree = 0;
        const auto begin = control.halfedge(parent);
        auto g = begin;
        do { // over the corners of the parent that make the vertex
            mean += before[g][0];
            ++degree;
            const bool at_vertex = born.kind == kith::tuple_kind::v and control.target(g) == *born.v;
            const bool on_edge = born.kind == kith::tuple_kind::e and
                                 (control.edge(g) == *born.e or control.edge(control.next(g)) == *born.e);
            if (at_vertex or on_edge) {
                u += before[g][0];
                ++corners;
            }
            g = control.next(g);
        } while (g != begin);
        EXPECT_FLOAT_EQ(after[h][0], float(born.kind == kith::tuple_kind::f ? mean / degree : u / corners));
    }
}

TEST(cgal_properties, marks_of_half_edges_stay_with_those_that_lie_along_them)
{
    const mesh control = with_maps(make(shapes::open_house()));
    kith::hierarchy<mesh, kith::catmull_clark> levels(control);
    levels.refine(2);
    mesh fine = levels[2];
    kith::carry_properties(levels, 0, 2, fine);
    const auto mark = map_of<halfedge, int>(fine, "h:mark");
    std::vector<int> heirs(control.num_halfedges() + 1);
    for (const auto h : fine.halfedges()) {
        if (fine.is_border(h))
            continue;
        ++heirs[std::size_t(mark[h])];
        const auto from = levels.ancestor(2, fine.edge(h), 0);
        ASSERT_EQ(mark[h] != 0, from.e.has_value());
        if (from.e) {
            const halfedge old(mark[h] - 1);
            EXPECT_EQ(control.edge(old), *from.e);
            EXPECT_EQ(control.face(old), *levels.ancestor(2, fine.face(h), 0).f);
        }
    }
    for (const auto h : control.halfedges())
        EXPECT_EQ(heirs[std::size_t(h) + 1], control.is_border(h) ? 0 : 4);
}

TEST(cgal_properties, of_half_edges_beyond_the_boundary_are_zero)
{
    mesh control = make(shapes::open_house());
    control.add_property_map<halfedge, kernel::Point_2>("h:texcoord", kernel::Point_2(3, 4));
    const auto fine = kith::refine_with_properties(control, kith::catmull_clark(), 1).first;
    const auto after = map_of<halfedge, kernel::Point_2>(fine, "h:texcoord");
    for (const auto h : fine.halfedges())
        EXPECT_EQ(after[h], fine.is_border(h) ? kernel::Point_2(0, 0) : kernel::Point_2(3, 4));
}

TEST(cgal_properties, elements_that_inherit_nothing_have_what_the_map_gives_to_new_ones)
{
    mesh control = make(shapes::open_house());
    auto patch = control.add_property_map<face, int>("f:patch", -1).first;
    auto id = control.add_property_map<edge, std::size_t>("e:id", 77).first;
    auto name = control.add_property_map<vertex, std::string>("v:name", "new").first;
    control.add_property_map<halfedge, double>("h:angle", -2);
    for (const auto f : control.faces())
        patch[f] = int(f);
    for (const auto e : control.edges())
        id[e] = e;
    for (const auto v : control.vertices())
        name[v] = "old";

    const auto as_expected = [](mesh fine, std::size_t faces_without) {
        const auto fine_patch = map_of<face, int>(fine, "f:patch");
        const auto fine_id = map_of<edge, std::size_t>(fine, "e:id");
        const auto fine_name = map_of<vertex, std::string>(fine, "v:name");
        const auto angle = map_of<halfedge, double>(fine, "h:angle");
        std::size_t without = 0, unnamed = 0, inside = 0;
        for (const auto f : fine.faces())
            without += fine_patch[f] == -1;
        for (const auto e : fine.edges())
            inside += fine_id[e] == 77;
        for (const auto v : fine.vertices())
            unnamed += fine_name[v] == "";
        for (const auto h : fine.halfedges())
            EXPECT_EQ(angle[h], -2);
        EXPECT_EQ(without, faces_without);
        EXPECT_EQ(unnamed, 0U);
        EXPECT_GT(inside, 0U);
        const auto v = fine.add_vertex(); // the maps are unchanged
        EXPECT_EQ(fine_name[v], "new");
    };
    as_expected(kith::refine_with_properties(control, kith::catmull_clark(), 2).first, 0);
    const auto dual = kith::refine_with_properties(control, kith::doo_sabin(), 1).first;
    as_expected(dual, dual.number_of_faces() - control.number_of_faces());
}

TEST(cgal_properties, of_one_name_and_several_types_are_all_carried)
{
    mesh control = make(shapes::cube());
    control.add_property_map<face, int>("f:patch", 3);
    control.add_property_map<face, std::string>("f:patch", "three");
    control.add_property_map<face, label>("f:patch", label{3});
    const auto [fine, report] = kith::refine_with_properties(control, kith::catmull_clark(), 1);
    EXPECT_EQ(report.carried, (names{"f:patch", "f:patch"}));
    EXPECT_EQ(names_of(report.left_out), names{"f:patch"});
    const auto number = map_of<face, int>(fine, "f:patch");
    const auto word = map_of<face, std::string>(fine, "f:patch");
    for (const auto f : fine.faces()) {
        EXPECT_EQ(number[f], 3);
        EXPECT_EQ(word[f], "three");
    }
}

TEST(cgal_properties, of_faces_without_a_parent_and_of_another_mesh)
{
    const mesh control = with_maps(make(shapes::cube()));
    kith::hierarchy<mesh, kith::doo_sabin> levels(control);
    levels.refine(1);
    mesh fine = levels[1];
    const auto report = kith::carry_properties(levels, 0, 1, fine);
    EXPECT_EQ(names_of(report.left_out), names{"f:label"});
    const auto material = map_of<face, std::string>(fine, "f:material");
    std::size_t without = 0;
    for (const auto f : fine.faces())
        without += material[f].empty();
    EXPECT_EQ(without, 12U + 8U); // faces of edges and of vertices
    mesh another = control;
    EXPECT_NE(error_text<kith::mesh_error>([&] {
                  kith::carry_properties(levels, 0, 1, another);
              }).find("is not level 1 of the hierarchy"),
              std::string::npos);
}

TEST(cgal_properties, of_any_map_go_by_a_rule_of_the_user)
{
    const mesh control = with_maps(make(shapes::open_house()));
    kith::hierarchy levels(control, kith::catmull_clark());
    levels.refine(2);
    mesh fine = levels[2];

    const auto dynamic = get(CGAL::dynamic_vertex_property_t<label>(), control);
    for (const auto v : control.vertices())
        put(dynamic, v, label{int(v)});
    const auto fine_dynamic = get(CGAL::dynamic_vertex_property_t<label>(), fine);
    kith::carry_map<vertex>(levels, 0, 2, dynamic, fine_dynamic);
    for (const auto v : fine.vertices()) {
        const auto from = levels.ancestor(2, v, 0);
        EXPECT_EQ(get(fine_dynamic, v), from.v ? label{int(*from.v)} : label());
    }

    const auto texture = map_of<halfedge, uv>(control, "h:uv");
    auto fine_texture = fine.add_property_map<halfedge, uv>("h:uv").first;
    const kith::face_varying smooth(kith::face_varying_linear::corners_only);
    kith::carry_map<halfedge>(levels, 0, 2, texture, fine_texture, smooth);
    std::vector<uv> corners, fine_corners;
    kith::detail::for_each_handle<halfedge>(control, [&](halfedge h) { corners.push_back(texture[h]); });
    kith::detail::for_each_handle<halfedge>(fine, [&](halfedge h) { fine_corners.push_back(fine_texture[h]); });
    EXPECT_TRUE(std::ranges::equal(levels.carry(0, 2, kith::on_corners(corners, smooth)).values(), fine_corners));

    auto share = fine.add_property_map<face, double>("f:share").first;
    const auto quarter = [](double x) { return x / 4; };
    kith::carry_map<face>(levels, 0, 2, [](face f) { return double(f.idx() + 1); }, share, kith::from_parent{quarter});
    for (const auto f : fine.faces())
        EXPECT_EQ(share[f], double(levels.ancestor(2, f, 0).f->idx() + 1) / 16);

    const auto feature = map_of<edge, bool>(control, "e:feature");
    auto fine_feature = fine.add_property_map<edge, bool>("e:feature").first;
    kith::carry_map<edge>(levels, 0, 2, feature, fine_feature);
    for (const auto e : fine.edges()) {
        const auto from = levels.ancestor(2, e, 0);
        EXPECT_EQ(fine_feature[e], from.e and feature[*from.e]);
    }
}

TEST(cgal_properties, values_of_cgal_are_values_of_masks)
{
    using CGAL::IO::Color;
    using number = epeck::FT;
    kith::hierarchy levels(make(shapes::cube()), kith::catmull_clark());
    levels.refine(1);
    const auto at_first = [&]<class T>(const T& first, const T& others) {
        std::vector<T> values(8, others);
        values[0] = first;
        return levels.carry(0, 1, std::span<const T>(values))[0]; // 5/12 of the first value
    };
    const auto near = [](const auto& a, const auto& b) { return (a - b) * (a - b) < 1e-28; };
    EXPECT_EQ(at_first(Color(255, 0, 16, 255), Color(255, 160, 0, 255)), Color(255, 93, 7, 255)); // 93.3, 6.7
    EXPECT_PRED2(near, at_first(kernel::Point_2(12, 0), kernel::Point_2(0, 24)), kernel::Point_2(5, 14));
    EXPECT_PRED2(near, at_first(kernel::Vector_2(12, 0), kernel::Vector_2(0, 24)), kernel::Vector_2(5, 14));
    EXPECT_PRED2(near, at_first(kernel::Vector_3(12, 0, 1), kernel::Vector_3(0, 24, 1)), kernel::Vector_3(5, 14, 1));
    EXPECT_EQ(at_first(epeck::Point_2(1, 0), epeck::Point_2(0, 1)), epeck::Point_2(number(5) / 12, number(7) / 12));
    EXPECT_EQ(at_first(number(1) / 3, number(0)), number(5) / 36);
}

TEST(cgal_properties, numbers_of_exact_kernels_stay_exact)
{
    using exact_mesh = surface_mesh<epeck>;
    const auto shape = shapes::cube();
    exact_mesh cube = user_mesh<exact_mesh>::make(shape.points, shape.faces);
    auto heat = cube.add_property_map<exact_mesh::Vertex_index, epeck::FT>("v:heat", 0).first;
    heat[exact_mesh::Vertex_index(0)] = epeck::FT(1) / 3;
    auto [fine, report] = kith::refine_with_properties(cube, kith::catmull_clark(), 1);
    EXPECT_EQ(report.carried, names{"v:heat"});
    const auto after = fine.add_property_map<exact_mesh::Vertex_index, epeck::FT>("v:heat").first;
    EXPECT_EQ(after[exact_mesh::Vertex_index(0)], epeck::FT(5) / 36);
}

TEST(cgal_properties, of_exact_kernels_are_zero_beyond_the_boundary)
{
    using exact_mesh = surface_mesh<epeck>;
    const auto shape = shapes::open_house();
    exact_mesh house = user_mesh<exact_mesh>::make(shape.points, shape.faces);
    auto heat = house.add_property_map<exact_mesh::Halfedge_index, epeck::FT>("h:heat", 7).first;
    auto texture = house.add_property_map<exact_mesh::Halfedge_index, epeck::Point_2>("h:uv", epeck::Point_2(1, 2))
                       .first;
    auto [fine, report] = kith::refine_with_properties(house, kith::linear(), 1);
    heat = fine.add_property_map<exact_mesh::Halfedge_index, epeck::FT>("h:heat").first;
    texture = fine.add_property_map<exact_mesh::Halfedge_index, epeck::Point_2>("h:uv").first;
    for (const auto h : fine.halfedges()) {
        EXPECT_EQ(heat[h], epeck::FT(fine.is_border(h) ? 0 : 7));
        EXPECT_EQ(texture[h], fine.is_border(h) ? epeck::Point_2(0, 0) : epeck::Point_2(1, 2));
    }
}

TEST(cgal_properties, values_at_corners_with_seams_go_as_on_the_native_mesh)
{
    expect_face_varying_as_native<mesh>(false);
    expect_face_varying_as_native<mesh>(true);
}
