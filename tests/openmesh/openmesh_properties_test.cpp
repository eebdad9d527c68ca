// SPDX-License-Identifier: BSD-3-Clause
#include "support/openmesh_mesh.hpp"
#include "support/face_varying_on.hpp"
#include "support/same_mesh.hpp"
#include "support/property_names.hpp"
#include "support/shapes.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/loop.hpp>
#include <kith/openmesh_properties.hpp>
#include <kith/sqrt3.hpp>

#include <OpenMesh/Core/Utils/PropertyManager.hh>

#include <gtest/gtest.h>

#include <map>
#include <span>
#include <string>
#include <vector>

namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
using names = std::vector<std::string>;

/// Returns the mesh with requested attributes and a user's properties on all kinds of elements.
template <class M>
M with_properties(M mesh)
{
    mesh.request_vertex_colors(), mesh.request_face_colors(), mesh.request_vertex_normals();
    mesh.request_halfedge_texcoords2D(), mesh.request_edge_status();
    auto height = OpenMesh::getOrMakeProperty<VertexHandle, double>(mesh, "height");
    auto tag = OpenMesh::getOrMakeProperty<FaceHandle, std::string>(mesh, "tag");
    auto hard = OpenMesh::getOrMakeProperty<EdgeHandle, bool>(mesh, "hard");
    for (const auto v : mesh.vertices()) {
        height[v] = mesh.point(v)[2];
        mesh.set_color(v, typename M::Color(200, 10, 255));
    }
    for (const auto f : mesh.faces()) {
        tag[f] = "face " + std::to_string(f.idx());
        mesh.set_color(f, typename M::Color(f.idx(), 1, 2));
    }
    for (const auto e : mesh.edges()) {
        hard[e] = e.idx() % 3 == 0;
        mesh.status(e).set_feature(e.idx() % 2 == 0);
    }
    for (const auto h : mesh.halfedges())
        mesh.set_texcoord2D(h, {float(h.idx()), float(h.idx() % 5)});
    return mesh;
}

template <class M, class Scheme>
void expect_carried(const M& control, const Scheme& scheme)
{
    kith::hierarchy<M, Scheme> levels(control, scheme);
    levels.refine(2);
    M fine = levels[2];
    const auto report = kith::carry_properties(levels, 0, 2, fine);
    for (const char* name : {"height", "tag", "hard", "v:colors", "f:colors", "h:texcoords2D", "e:status"})
        EXPECT_EQ(std::ranges::count(report.carried, name), 1) << name;
    EXPECT_EQ(std::ranges::count(names_of(report.left_out), "v:normals"), 1);

    const auto height = OpenMesh::getProperty<VertexHandle, double>(fine, "height");
    for (const auto v : fine.vertices()) {
        EXPECT_EQ(height[v], fine.point(v)[2]);
        EXPECT_EQ(fine.color(v), typename M::Color(200, 10, 255));
    }
    const auto tag = OpenMesh::getProperty<FaceHandle, std::string>(fine, "tag");
    for (const auto f : fine.faces()) {
        const FaceHandle parent = *levels.origin(1, *levels.origin(2, f).f).f;
        EXPECT_EQ(tag[f], "face " + std::to_string(parent.idx()));
        EXPECT_EQ(fine.color(f), typename M::Color(parent.idx(), 1, 2));
    }
    const auto hard = OpenMesh::getProperty<EdgeHandle, bool>(fine, "hard");
    std::size_t found = 0, features = 0, expected = 0, expected_features = 0;
    for (const auto e : fine.edges()) {
        found += hard[e];
        features += fine.status(e).feature();
    }
    for (const auto e : control.edges()) {
        expected += 4 * (e.idx() % 3 == 0);
        expected_features += 4 * control.status(e).feature();
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(features, expected_features);

    // Every corner at an old vertex has the coordinates that this vertex has in the old face.
    std::size_t old_corners = 0;
    for (const auto h : fine.halfedges()) {
        if (fine.is_boundary(h))
            continue;
        const auto born = levels.origin(2, fine.to_vertex_handle(h));
        if (not born.v)
            continue;
        const auto before = levels.origin(1, *born.v);
        if (not before.v)
            continue;
        const FaceHandle parent = *levels.origin(1, *levels.origin(2, fine.face_handle(h)).f).f;
        for (auto g = control.cfh_iter(parent); g.is_valid(); ++g)
            if (control.to_vertex_handle(*g) == *before.v) {
                EXPECT_EQ(fine.texcoord2D(h), control.texcoord2D(*g));
                ++old_corners;
            }
    }
    EXPECT_GT(old_corners, 0U);
}

} // namespace

TEST(openmesh_properties, are_carried_by_name_and_told)
{
    const auto quads = user_mesh<poly_mesh>::make(shapes::cube().points, shapes::cube().faces);
    expect_carried(with_properties(quads), kith::catmull_clark());

    auto shape = shapes::both(shapes::tetrahedron(), shapes::cube());
    for (std::size_t v = 4; v < shape.points.size(); ++v)
        shape.points[v][0] -= 10;
    auto with_deleted = user_mesh<poly_mesh>::make(shape.points, shape.faces);
    for (int f = 0; f < 4; ++f)
        with_deleted.delete_face(FaceHandle(f), true);
    expect_carried(with_properties(with_deleted), kith::catmull_clark());
}

TEST(openmesh_properties, of_triangles)
{
    const auto shape = shapes::triangulated(shapes::cube());
    auto [fine, report] = kith::refine_with_properties(
        with_properties(user_mesh<tri_mesh>::make(shape.points, shape.faces)), kith::loop(), 2);
    const auto height = OpenMesh::getProperty<VertexHandle, double>(fine, "height");
    for (const auto v : fine.vertices())
        EXPECT_EQ(height[v], fine.point(v)[2]);
    EXPECT_EQ(std::ranges::count(report.carried, "h:texcoords2D"), 1);
}

TEST(openmesh_properties, of_property_managers_are_carried_to_others)
{
    const auto shape = shapes::cube();
    auto control = user_mesh<poly_mesh>::make(shape.points, shape.faces);
    OpenMesh::FProp<std::string> tag(control);
    OpenMesh::EProp<bool> hard(false, control);
    for (const auto f : control.faces())
        tag[f] = "face " + std::to_string(f.idx());
    hard[EdgeHandle(3)] = true;
    kith::hierarchy levels(control, kith::catmull_clark());
    levels.refine(2);
    poly_mesh fine = levels[2];
    OpenMesh::FProp<std::string> fine_tag(fine);
    OpenMesh::EProp<bool> fine_hard(fine);
    kith::carry_map<FaceHandle>(levels, 0, 2, tag, fine_tag);
    kith::carry_map<EdgeHandle>(levels, 0, 2, hard, fine_hard);
    int hard_ones = 0;
    for (const auto f : fine.faces())
        EXPECT_EQ(fine_tag[f], "face " + std::to_string(levels.ancestor(2, FaceHandle(f), 0).f->idx()));
    for (const auto e : fine.edges()) {
        EXPECT_TRUE(not fine_hard[e] or levels.ancestor(2, EdgeHandle(e), 0).e == EdgeHandle(3));
        hard_ones += fine_hard[e];
    }
    EXPECT_EQ(hard_ones, 4);
}

TEST(openmesh_properties, of_one_name_and_several_types_are_not_taken_for_one_another)
{
    const auto shape = shapes::cube();
    auto control = user_mesh<poly_mesh>::make(shape.points, shape.faces);
    OpenMesh::VPropHandleT<double> first, second;
    OpenMesh::VPropHandleT<float> third;
    control.add_property(first, "x"), control.add_property(second, "x"), control.add_property(third, "x");
    for (const auto v : control.vertices())
        control.property(first, v) = 1, control.property(second, v) = 2, control.property(third, v) = 3;
    auto [fine, report] = kith::refine_with_properties(control, kith::catmull_clark(), 1);
    EXPECT_EQ(std::ranges::count(report.carried, "x"), 2);
    EXPECT_EQ(names_of(report.left_out), names{"x"});
    const auto doubles = OpenMesh::getProperty<VertexHandle, double>(fine, "x");
    const auto floats = OpenMesh::getProperty<VertexHandle, float>(fine, "x");
    for (const auto v : fine.vertices()) {
        EXPECT_EQ(doubles[v], 1);
        EXPECT_EQ(floats[v], 3);
    }
}

TEST(openmesh_properties, without_a_name_are_left_out_of_another_mesh)
{
    const auto shape = shapes::cube();
    auto control = user_mesh<poly_mesh>::make(shape.points, shape.faces);
    OpenMesh::VPropHandleT<double> of_vertices; // OpenMesh calls it "<vprop>"
    OpenMesh::FPropHandleT<int> of_faces;
    OpenMesh::MPropHandleT<int> of_mesh;
    control.add_property(of_vertices), control.add_property(of_faces), control.add_property(of_mesh);
    const auto [fine, report] = kith::refine_with_properties(control, kith::catmull_clark(), 1);
    EXPECT_EQ(names_of(report.left_out), (names{"<vprop>", "<fprop>", "<mprop>"}));
    EXPECT_FALSE(fine.get_property_handle(of_vertices, "<vprop>"));
    EXPECT_FALSE(fine.get_property_handle(of_faces, "<fprop>"));
    EXPECT_FALSE(fine.get_property_handle(of_mesh, "<mprop>"));
}

namespace {

struct weighted_traits : OpenMesh::DefaultTraits {
    VertexTraits { int weight = 3; };
};

} // namespace

TEST(openmesh_properties, of_the_traits_are_carried_where_their_type_is_named)
{
    using weighted_mesh = OpenMesh::PolyMesh_ArrayKernelT<weighted_traits>;
    const auto shape = shapes::cube();
    auto control = user_mesh<weighted_mesh>::make(shape.points, shape.faces);
    for (const auto v : control.vertices())
        control.data(v).weight = 10 + v.idx();
    const auto [fine,
                report] = kith::refine_with_properties<weighted_mesh::VertexData>(control, kith::catmull_clark(), 1);
    EXPECT_EQ(report.carried, names{"<vprop>"});
    for (const auto v : fine.vertices())
        EXPECT_EQ(fine.data(v).weight, v.idx() < 8 ? 10 + v.idx() : 3);
}

TEST(openmesh_properties, of_the_mesh_as_a_whole_are_copied)
{
    using pictures = std::map<int, std::string>;
    const auto shape = shapes::cube();
    auto control = user_mesh<poly_mesh>::make(shape.points, shape.faces);
    OpenMesh::MPropHandleT<pictures> textures;
    OpenMesh::MPropHandleT<std::string> author;
    OpenMesh::MPropHandleT<std::vector<VertexHandle>> path;
    control.add_property(textures, "TextureMapping");
    control.add_property(author, "author");
    control.add_property(path, "path");
    control.property(textures) = {{1, "skin.png"}};
    control.property(author) = "me";
    auto [fine, report] = kith::refine_with_properties(control, kith::catmull_clark(), 1);
    EXPECT_EQ(names_of(report.left_out), names{"path"});
    EXPECT_EQ(std::ranges::count(report.carried, "TextureMapping"), 1);
    ASSERT_TRUE(fine.get_property_handle(textures, "TextureMapping") and fine.get_property_handle(author, "author"));
    EXPECT_EQ(fine.property(textures), (pictures{{1, "skin.png"}}));
    EXPECT_EQ(fine.property(author), "me");
}

TEST(openmesh_properties, marks_of_steps_are_not_carried)
{
    const auto shape = shapes::grid();
    const auto control = user_mesh<tri_mesh>::make(shapes::triangulated(shape).points,
                                                   shapes::triangulated(shape).faces);
    kith::hierarchy<tri_mesh, kith::sqrt3> levels(control);
    levels.refine(3);
    tri_mesh fine = levels[2];
    const auto report = kith::carry_properties(levels, 1, 2, fine); // to a level that an odd step made
    EXPECT_TRUE(std::ranges::none_of(report.carried, [](const auto& name) { return name.starts_with("kith:"); }));
    EXPECT_TRUE(same_bits(kith::refine(fine, kith::sqrt3(), 1), levels[3]));
}

TEST(openmesh_properties, colours_are_values_of_masks)
{
    const auto shape = shapes::cube();
    kith::hierarchy levels(user_mesh<poly_mesh>::make(shape.points, shape.faces), kith::catmull_clark());
    levels.refine(1);
    using colour = OpenMesh::Vec3uc;
    std::vector<colour> colours(8, colour(0, 40, 0));
    colours[0] = colour(255, 40, 0);
    const auto fine = levels.carry(0, 1, std::span<const colour>(colours));
    EXPECT_EQ(fine[0], colour(106, 40, 0)); // 255 * 5/12 = 106.25
    EXPECT_EQ(fine[20], colour(64, 40, 0)); // a quarter of the first face
}

TEST(openmesh_properties, values_at_corners_with_seams_go_as_on_the_native_mesh)
{
    expect_face_varying_as_native<poly_mesh>(false);
    expect_face_varying_as_native<poly_mesh>(true);
}

TEST(openmesh_properties, what_inherits_nothing_is_zero_and_never_left_open)
{
    using vector = OpenMesh::Vec3f;
    auto control = user_mesh<poly_mesh>::make(shapes::grid().points, shapes::grid().faces);
    OpenMesh::HPropHandleT<vector> at_sides;
    OpenMesh::EPropHandleT<vector> at_edges;
    control.add_property(at_sides, "sides");
    control.add_property(at_edges, "edges");
    for (const auto h : control.halfedges())
        control.property(at_sides, h) = {1, 2, 3};
    for (const auto e : control.edges())
        control.property(at_edges, e) = {1, 2, 3};
    kith::hierarchy<poly_mesh, kith::catmull_clark> levels(control);
    levels.refine(1);
    const auto expect = [](const poly_mesh& fine) {
        OpenMesh::HPropHandleT<vector> sides;
        OpenMesh::EPropHandleT<vector> edges;
        ASSERT_TRUE(fine.get_property_handle(edges, "edges"));
        ASSERT_TRUE(fine.get_property_handle(sides, "sides"));
        std::size_t inside = 0;
        for (const auto e : fine.edges()) {
            const vector value = fine.property(edges, e);
            inside += value == vector(0, 0, 0);
            EXPECT_TRUE(value == vector(0, 0, 0) or value == vector(1, 2, 3));
        }
        EXPECT_EQ(inside, 4 * shapes::grid().faces.size());
        for (const auto h : fine.halfedges()) {
            if (fine.is_boundary(h)) {
                EXPECT_EQ(fine.property(sides, h), vector(0, 0, 0));
            }
        }
    };
    const auto soil = [] { // fills memory, so that later allocations are not zero
        std::vector<std::vector<unsigned char>> blocks;
        for (std::size_t size = 64; size < 40000; size += 64)
            blocks.emplace_back(size, 0x7b);
    };
    poly_mesh all = levels[1], by_rule = levels[1];
    soil();
    kith::carry_properties(levels, 0, 1, all);
    expect(all);
    soil();
    kith::carry_properties(levels,
                           0,
                           1,
                           by_rule,
                           kith::by_rule<OpenMesh::EdgeHandle, vector>("edges", kith::along_edges<>()),
                           kith::by_rule<OpenMesh::HalfedgeHandle, vector>("sides", kith::linear_in_faces()));
    expect(by_rule);
}
