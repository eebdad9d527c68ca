// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"
#include "support/openmesh_mesh.hpp"
#include "support/same_mesh.hpp"
#include "support/some_maps.hpp"

#include <kith/openmesh_properties.hpp>
#include <kith/sqrt3.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace some_maps;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
using native = kith::property_mesh<>;

struct label {
    int number = -1;
    friend bool operator==(const label&, const label&) = default;
};

void expect_same_maps(const cgal_mesh& a, const cgal_mesh& b)
{
    const auto expect_same = [&]<class Handle, class T>(Handle, T, const char* name) {
        EXPECT_EQ((values<Handle, T>(a, name)), (values<Handle, T>(b, name))) << name;
    };
    expect_same(vertex(), CGAL::IO::Color(), "v:color");
    expect_same(vertex(), kernel::Vector_3(), "v:normal");
    expect_same(vertex(), kernel::Point_3(), "v:place");
    expect_same(edge(), bool(), "e:is_sharp");
    expect_same(face(), std::string(), "f:material");
    expect_same(halfedge(), uv(), "h:uv");
}

/// Returns two solids. Tests remove the first one, so that unused numbers precede those of the second.
shapes::shape two_solids()
{
    auto shape = shapes::both(shapes::tetrahedron(), shapes::cube());
    for (std::size_t v = 4; v < shape.points.size(); ++v)
        shape.points[v][0] -= 10;
    return shape;
}

} // namespace

TEST(convert, native_to_cgal_to_openmesh_and_back_is_what_it_was)
{
    for (const auto& shape : {shapes::cube(), shapes::open_house(), shapes::grid()}) {
        native control = kith::make_mesh(shape.points, shape.faces);
        const std::size_t corners = control.native().corner_count();
        std::vector<std::string> material;
        std::vector<uv> texture;
        std::vector<std::array<unsigned char, 3>> color;
        std::vector<int> id;
        for (std::size_t f = 0; f < shape.faces.size(); ++f)
            material.push_back("material " + std::to_string(f));
        for (std::size_t c = 0; c < corners; ++c)
            texture.push_back({float(c), float(c % 7)});
        for (std::size_t v = 0; v < shape.points.size(); ++v)
            color.push_back({std::uint8_t(v), 0, 255});
        for (std::size_t e = 0; e < control.native().edge_count(); ++e)
            id.push_back(int(3 * e));
        control.set("f:material", kith::on_faces(material));
        control.set("h:uv", kith::on_corners(texture));
        control.set("v:color", kith::on_vertices(color));
        control.set("e:id", kith::on_edges(id));

        const auto first = kith::convert<cgal_mesh>(control);
        EXPECT_EQ(first.report.carried, (names{"v:color", "h:uv", "e:id", "f:material"}));
        EXPECT_TRUE(first.report.left_out.empty() and first.report.narrowed.empty());
        EXPECT_EQ(user_mesh<cgal_mesh>::complaints(first.mesh), "");
        EXPECT_EQ((property<vertex, CGAL::IO::Color>(first.mesh, "v:color")[vertex(2)]), CGAL::IO::Color(2, 0, 255));

        const auto second = kith::convert<poly_mesh, label>(first.mesh);
        EXPECT_EQ(user_mesh<poly_mesh>::complaints(second.mesh), "");
        EXPECT_TRUE(second.report.left_out.empty() and second.report.narrowed.empty());
        ASSERT_TRUE(second.mesh.has_vertex_colors());
        EXPECT_EQ(second.mesh.color(VertexHandle(2)), poly_mesh::Color(2, 0, 255));

        const auto third = kith::convert<cgal_mesh>(second.mesh);
        EXPECT_TRUE(same_bits(first.mesh, third.mesh));
        EXPECT_EQ((values<vertex, CGAL::IO::Color>(first.mesh, "v:color")),
                  (values<vertex, CGAL::IO::Color>(third.mesh, "v:color")));

        const auto back = kith::convert<native>(third.mesh).mesh;
        EXPECT_TRUE(same_bits(back.native(), control.native()));
        EXPECT_TRUE(std::ranges::equal(back.get<kith::field_on::faces, std::string>("f:material"), material));
        EXPECT_TRUE(std::ranges::equal(back.get<kith::field_on::corners, uv>("h:uv"), texture));
        EXPECT_TRUE(std::ranges::equal(back.get<kith::field_on::edges, int>("e:id"), id));
        const auto colors = back.get<kith::field_on::vertices, CGAL::IO::Color>("v:color");
        for (std::size_t v = 0; v < color.size(); ++v)
            EXPECT_EQ(colors[v], CGAL::IO::Color(color[v][0], 0, 255));
    }
}

TEST(convert, cgal_to_openmesh_and_back_keeps_types_and_values)
{
    for (const auto& shape : {shapes::cube(), shapes::open_house(), shapes::grid()}) {
        const auto control = with_maps(cgal(shape));
        const auto there = kith::convert<poly_mesh, label>(control);
        EXPECT_EQ(there.report.carried, (names{"v:color", "v:normal", "v:place", "h:uv", "e:is_sharp", "f:material"}));
        EXPECT_TRUE(there.report.narrowed.empty());
        const auto back = kith::convert<cgal_mesh>(there.mesh);
        EXPECT_TRUE(back.report.narrowed.empty());
        EXPECT_TRUE(same_bits(control, back.mesh));
        expect_same_maps(control, back.mesh);
    }
}

TEST(convert, half_edges_are_told_by_their_ends)
{
    const auto control = with_maps(cgal(shapes::open_house()));
    const auto there = kith::convert<poly_mesh, label>(control).mesh;
    const auto texture = property<HalfedgeHandle, uv>(there, "h:uv");
    const auto expected = property<halfedge, uv>(control, "h:uv");
    std::size_t beyond = 0;
    for (const auto h : control.halfedges()) {
        const VertexHandle from(int(control.source(h))), to(int(control.target(h)));
        EXPECT_EQ(texture[there.find_halfedge(from, to)], expected[h]);
        beyond += control.is_border(h);
    }
    EXPECT_EQ(beyond, 2 * control.number_of_edges() - kith::to_native(control).corner_count());
    EXPECT_GT(beyond, 0U);
}

TEST(convert, removed_elements_are_skipped)
{
    const auto shape = two_solids();
    auto control = with_maps(cgal(shape));
    for (std::uint32_t f = 0; f < 4; ++f)
        CGAL::Euler::remove_face(control.halfedge(face(f)), control);
    const auto there = kith::convert<poly_mesh, label>(control).mesh;
    ASSERT_EQ(there.n_faces(), shape.faces.size() - 4);
    EXPECT_EQ((property<FaceHandle, std::string>(there, "f:material")[FaceHandle(0)]), "material 4");
    EXPECT_EQ(there.point(VertexHandle(0)),
              poly_mesh::Point(shape.points[4][0], shape.points[4][1], shape.points[4][2]));
    const auto back = kith::convert<cgal_mesh>(there).mesh;
    EXPECT_FALSE(back.has_garbage());
    EXPECT_TRUE(same_bits(control, back));
    expect_same_maps(control, back);

    auto deleted = kith::convert<poly_mesh, label>(with_maps(cgal(shape))).mesh;
    for (int f = 0; f < 4; ++f)
        deleted.delete_face(FaceHandle(f), true);
    const auto kept = kith::convert<cgal_mesh>(deleted).mesh;
    EXPECT_TRUE(same_bits(kept, back));
    expect_same_maps(kept, back);
}

TEST(convert, what_is_left_out_is_named_with_the_reason)
{
    auto control = with_maps(cgal(shapes::cube()));
    auto labels = control.add_property_map<face, label>("f:label").first;
    for (const auto f : control.faces())
        labels[f] = {int(f)};
    const auto with = kith::convert<poly_mesh, label>(control);
    EXPECT_TRUE(with.report.left_out.empty());
    EXPECT_EQ((values<FaceHandle, label>(with.mesh, "f:label")), (values<face, label>(control, "f:label")));
    const auto without = kith::convert<cgal_mesh>(with.mesh).report;
    ASSERT_EQ(without.left_out.size(), 1U);
    EXPECT_EQ(without.left_out[0].name, "f:label");
    EXPECT_NE(without.left_out[0].why.find("its type"), std::string::npos);

    const auto plain = kith::convert<kith::basic_mesh<>>(control).report;
    EXPECT_TRUE(plain.carried.empty());
    ASSERT_EQ(plain.left_out.size(), 7U);
    EXPECT_NE(plain.left_out[0].why.find("no properties"), std::string::npos);

    control.add_property_map<vertex, int>("v:points", 1);
    control.add_property_map<vertex, int>("v:colors", 1);
    control.add_property_map<vertex, int>("v:status", 1);
    const auto taken = kith::convert<poly_mesh, label>(control).report.left_out;
    ASSERT_EQ(taken.size(), 3U);
    EXPECT_NE(taken[0].why.find("reserves that name"), std::string::npos);
    EXPECT_EQ(taken[1].why, "another property is now named 'v:colors'");
    EXPECT_EQ(taken[2].why, "the new mesh has 'v:status' in another type");
}

TEST(convert, attributes_of_openmesh_are_attributes_again)
{
    auto control = user_mesh<poly_mesh>::make(shapes::open_house().points, shapes::open_house().faces);
    control.request_vertex_texcoords2D(), control.request_face_colors(), control.request_vertex_normals();
    control.request_vertex_texcoords3D(), control.request_face_texture_index();
    control.request_face_normals(), control.update_normals();
    for (const auto v : control.vertices()) {
        control.set_texcoord2D(v, {float(v.idx()), 0.1F});
        control.set_texcoord3D(v, {1, 2, float(v.idx())});
    }
    for (const auto f : control.faces()) {
        control.set_color(f, {255, 3, std::uint8_t(f.idx())});
        control.set_texture_index(f, 5 + f.idx());
    }
    control.status(VertexHandle(3)).set_selected(true);

    const auto there = kith::convert<cgal_mesh>(control);
    EXPECT_EQ(there.report.narrowed, names());
    for (const auto& each : there.report.left_out)
        ADD_FAILURE() << each.name << ": " << each.why;
    EXPECT_EQ((property<face, CGAL::IO::Color>(there.mesh, "f:color")[face(4)]), CGAL::IO::Color(255, 3, 4));
    EXPECT_EQ((property<vertex, kernel::Point_2>(there.mesh, "v:texcoord")[vertex(6)]), kernel::Point_2(6, 0.1F));

    const auto back = kith::convert<poly_mesh, label>(there.mesh).mesh;
    ASSERT_TRUE(back.has_vertex_texcoords2D() and back.has_vertex_texcoords3D() and back.has_face_colors() and
                back.has_vertex_normals() and back.has_face_texture_index());
    EXPECT_TRUE(same_bits(control, back));
    for (const auto v : control.vertices()) {
        EXPECT_EQ(back.texcoord2D(v), control.texcoord2D(v));
        EXPECT_EQ(back.texcoord3D(v), control.texcoord3D(v));
        EXPECT_EQ(back.normal(v), control.normal(v));
        EXPECT_EQ(back.status(v).selected(), v.idx() == 3);
    }
    for (const auto f : control.faces()) {
        EXPECT_EQ(back.color(f), control.color(f));
        EXPECT_EQ(back.texture_index(f), control.texture_index(f));
    }
}

TEST(convert, the_generation_of_a_mesh_survives)
{
    const auto odd = kith::refine(
        user_mesh<poly_mesh>::make(shapes::tetrahedron().points, {{0, 1, 2}, {0, 2, 3}}), kith::sqrt3(), 1);
    const auto there = kith::convert<cgal_mesh>(odd).mesh;
    EXPECT_TRUE(same_bits(kith::refine(there, kith::sqrt3(), 1),
                          kith::convert<cgal_mesh>(kith::refine(odd, kith::sqrt3(), 1)).mesh));
}

TEST(convert, what_is_no_mesh_is_refused)
{
    auto isolated = cgal(shapes::cube());
    isolated.add_vertex(kernel::Point_3(0, 0, 0));
    EXPECT_NE(
        error_text<kith::mesh_error>([&] { kith::convert<poly_mesh, label>(isolated); }).find("belongs to no face"),
        std::string::npos);
}

TEST(convert, fans_that_only_meet_in_a_vertex_are_refused)
{
    auto cube = cgal(shapes::cube());
    using vertex_index = cgal_mesh::Vertex_index;
    const auto turned = cube.halfedge(vertex_index(7), vertex_index(6));
    cube.set_halfedge(vertex_index(6), cube.prev(cube.opposite(turned))); // which comes to it still
    cube.set_target(turned, vertex_index(0));
    EXPECT_NE(error_text<kith::mesh_error>([&] { kith::convert<poly_mesh>(cube); }).find("several fans"),
              std::string::npos);
}

TEST(convert, properties_of_the_mesh_as_a_whole_are_copied_or_told)
{
    auto mesh = kith::convert<poly_mesh>(cgal(shapes::cube())).mesh;
    OpenMesh::MPropHandleT<std::string> author;
    mesh.add_property(author, "author");
    mesh.property(author) = "me";
    const auto copy = kith::convert<poly_mesh>(mesh);
    ASSERT_TRUE(copy.mesh.get_property_handle(author, "author"));
    EXPECT_EQ(copy.mesh.property(author), "me");
    EXPECT_EQ(std::ranges::count(copy.report.carried, "author"), 1);
    const auto there = kith::convert<cgal_mesh>(mesh);
    ASSERT_EQ(there.report.left_out.size(), 1U);
    EXPECT_EQ(there.report.left_out[0].name, "author");
}

TEST(convert, properties_of_one_name_and_several_types_all_go)
{
    auto control = cgal(shapes::cube());
    auto numbers = control.add_property_map<vertex, int>("v:x", 1).first;
    auto lengths = control.add_property_map<vertex, double>("v:x", 2.5).first;
    for (const auto v : control.vertices())
        numbers[v] = int(v), lengths[v] = int(v) / 2.;
    const auto made = kith::convert<poly_mesh>(control);
    EXPECT_TRUE(made.report.left_out.empty());
    const auto back = kith::convert<cgal_mesh>(made.mesh).mesh;
    EXPECT_EQ((values<vertex, int>(back, "v:x")), (values<vertex, int>(control, "v:x")));
    EXPECT_EQ((values<vertex, double>(back, "v:x")), (values<vertex, double>(control, "v:x")));
    const auto native = kith::convert<kith::property_mesh<>>(control).report; // holds one property per name
    EXPECT_EQ(native.carried, std::vector<std::string>{"v:x"});
    ASSERT_EQ(native.left_out.size(), 1U);
    EXPECT_EQ(native.left_out[0].why, "another property is now named 'v:x'");
}

namespace {

struct own_cgal_mesh : cgal_mesh {};
struct own_openmesh_mesh : poly_mesh {};

} // namespace

TEST(convert, derived_classes_are_meshes)
{
    const cgal_mesh control = with_maps(cgal(shapes::open_house()));
    const own_cgal_mesh own = kith::convert<own_cgal_mesh>(control).mesh;
    expect_same_maps(own, control);
    const own_openmesh_mesh there = kith::convert<own_openmesh_mesh>(own).mesh;
    expect_same_maps(kith::convert<cgal_mesh>(there).mesh, control);
}
