// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/Simple_cartesian.h>

#include <kith/cgal_properties.hpp>

#include "cgal_mesh.hpp"
#include "error_text.hpp"
#include "face_varying_on.hpp"
#include "shapes.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
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

/// With maps of many types on all kinds of elements.
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
    m.add_property_map<halfedge, int>("h:mark", 1);
    for (const auto h : m.halfedges())
        texture[h] = {float(h.idx()), float(h.idx() % 5)};
    return m;
}

template <class Index, class T>
auto map_of(const mesh& m, const char* name)
{
    const auto [map, found] = m.property_map<Index, T>(name);
    EXPECT_TRUE(found) << name;
    return map;
}

/// The control mesh with a hole in its numbers: its first faces have been removed.
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
    EXPECT_EQ(report.carried,
              (names{"v:place", "v:height", "v:color", "v:id", "h:uv", "e:feature", "f:material", "f:label"}));
    EXPECT_EQ(report.left_out, names{"h:mark"});
    const auto [again,
                other] = kith::refine_with_properties(with_maps(make(shapes::open_house())), kith::catmull_clark(), 2);
    EXPECT_EQ(other.left_out, (names{"h:mark", "f:label"}));
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
            old_ones += id[v] != 0;
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
        do { // the corners of the parent that make the vertex
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

TEST(cgal_properties, of_faces_without_a_parent_and_of_another_mesh)
{
    const mesh control = with_maps(make(shapes::cube()));
    kith::hierarchy<mesh, kith::doo_sabin> levels(control);
    levels.refine(1);
    mesh fine = levels[1];
    const auto report = kith::carry_properties(levels, 0, 1, fine);
    EXPECT_EQ(report.left_out, (names{"h:mark", "f:label"}));
    const auto material = map_of<face, std::string>(fine, "f:material");
    std::size_t without = 0;
    for (const auto f : fine.faces())
        without += material[f].empty();
    EXPECT_EQ(without, 12U + 8U); // those of edges and of vertices
    mesh another = control;
    EXPECT_NE(error_text<kith::mesh_error>([&] {
                  kith::carry_properties(levels, 0, 1, another);
              }).find("is not level 1 of the hierarchy"),
              std::string::npos);
}

TEST(cgal_properties, values_at_corners_with_seams_go_as_on_the_native_mesh)
{
    expect_face_varying_as_native<mesh>(false);
    expect_face_varying_as_native<mesh>(true);
}
