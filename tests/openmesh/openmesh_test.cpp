// SPDX-License-Identifier: BSD-3-Clause
#include "support/openmesh_mesh.hpp"

#include "support/mesh_statements.hpp"

#include <kith/doo_sabin.hpp>
#include <kith/make_creases.hpp>
#include <kith/surface/quadrature.hpp>
#include <kith/tri_quad.hpp>

#include <OpenMesh/Core/Utils/PropertyManager.hh>

#include <malloc.h>

#include <array>
#include <cstddef>
#include <type_traits>

INSTANTIATE_TYPED_TEST_SUITE_P(poly_mesh, mesh_statements, testing::Types<poly_mesh>);
INSTANTIATE_TYPED_TEST_SUITE_P(tri_mesh, mesh_statements, testing::Types<tri_mesh>);

namespace {

poly_mesh make(const shapes::shape& s)
{
    return user_mesh<poly_mesh>::make(s.points, s.faces);
}

/// Makes a cube behind a tetrahedron, whose four faces and vertices are marked as deleted but still stored.
poly_mesh cube_after_deleted_tetrahedron()
{
    auto shape = shapes::both(shapes::tetrahedron(), shapes::cube());
    for (std::size_t v = 4; v < shape.points.size(); ++v)
        shape.points[v][0] -= 10;
    auto result = make(shape);
    for (int f = 0; f < 4; ++f)
        result.delete_face(OpenMesh::FaceHandle(f), true);
    return result;
}

/// The traits with all attributes that OpenMesh can keep with elements.
struct attributed_traits : OpenMesh::DefaultTraitsDouble {
    static constexpr unsigned texture = OpenMesh::Attributes::TexCoord1D | OpenMesh::Attributes::TexCoord2D |
                                        OpenMesh::Attributes::TexCoord3D;
    static constexpr unsigned all = OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal |
                                    OpenMesh::Attributes::Color;
    VertexAttributes(all | texture);
    HalfedgeAttributes(all | texture | OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Color);
    FaceAttributes(all | OpenMesh::Attributes::TextureIndex);
};

/// Requests all attributes of OpenMesh at run time.
template <class M>
void request_everything(M& mesh)
{
    mesh.request_vertex_status(), mesh.request_halfedge_status(), mesh.request_edge_status();
    mesh.request_face_status(), mesh.request_face_texture_index();
    mesh.request_vertex_normals(), mesh.request_halfedge_normals(), mesh.request_face_normals();
    mesh.request_vertex_colors(), mesh.request_halfedge_colors(), mesh.request_edge_colors();
    mesh.request_face_colors();
    mesh.request_vertex_texcoords1D(), mesh.request_vertex_texcoords2D(), mesh.request_vertex_texcoords3D();
    mesh.request_halfedge_texcoords1D(), mesh.request_halfedge_texcoords2D(), mesh.request_halfedge_texcoords3D();
}

template <class M>
void expect_everything_zero(const M& mesh)
{
    ASSERT_TRUE(mesh.has_vertex_status() and mesh.has_halfedge_status() and mesh.has_edge_status());
    ASSERT_TRUE(mesh.has_face_status() and mesh.has_face_texture_index());
    ASSERT_TRUE(mesh.has_vertex_normals() and mesh.has_halfedge_normals() and mesh.has_face_normals());
    ASSERT_TRUE(mesh.has_vertex_colors() and mesh.has_halfedge_colors() and mesh.has_edge_colors());
    ASSERT_TRUE(mesh.has_face_colors() and mesh.has_vertex_texcoords1D() and mesh.has_vertex_texcoords2D());
    ASSERT_TRUE(mesh.has_vertex_texcoords3D() and mesh.has_halfedge_texcoords1D());
    ASSERT_TRUE(mesh.has_halfedge_texcoords2D() and mesh.has_halfedge_texcoords3D());
    const typename M::Normal normal(0);
    const typename M::Color color(0);
    for (const auto v : mesh.vertices()) {
        EXPECT_EQ(mesh.status(v).bits(), 0U);
        EXPECT_EQ(mesh.normal(v), normal);
        EXPECT_EQ(mesh.color(v), color);
        EXPECT_EQ(mesh.texcoord1D(v), 0);
        EXPECT_EQ(mesh.texcoord2D(v), typename M::TexCoord2D(0));
        EXPECT_EQ(mesh.texcoord3D(v), typename M::TexCoord3D(0));
    }
    for (const auto h : mesh.halfedges()) {
        EXPECT_EQ(mesh.status(h).bits(), 0U);
        EXPECT_EQ(mesh.normal(h), normal);
        EXPECT_EQ(mesh.color(h), color);
        EXPECT_EQ(mesh.texcoord1D(h), 0);
        EXPECT_EQ(mesh.texcoord2D(h), typename M::TexCoord2D(0));
        EXPECT_EQ(mesh.texcoord3D(h), typename M::TexCoord3D(0));
    }
    for (const auto e : mesh.edges()) {
        EXPECT_EQ(mesh.status(e).bits(), 0U);
        EXPECT_EQ(mesh.color(e), color);
    }
    for (const auto f : mesh.faces()) {
        EXPECT_EQ(mesh.status(f).bits(), 0U);
        EXPECT_EQ(mesh.normal(f), normal);
        EXPECT_EQ(mesh.color(f), color);
        EXPECT_EQ(mesh.texture_index(f), 0);
    }
}

/// A scheme that is not trusted, so that it is refined on a native mesh, which is copied.
struct untrusted : kith::catmull_clark {
    static constexpr auto traits()
    {
        auto result = kith::catmull_clark::traits();
        result.trusted = false;
        return result;
    }
};

/// A guard that fills unused memory with a pattern, so that fresh memory does not hold zeros by chance.
struct dirty_memory {
    dirty_memory() { mallopt(M_PERTURB, 0x5a); }
    dirty_memory(const dirty_memory&) = delete;
    dirty_memory& operator=(const dirty_memory&) = delete;
    ~dirty_memory() { mallopt(M_PERTURB, 0); }
};

} // namespace

TEST(openmesh, points_that_are_arrays_are_refined_as_arrays)
{
    static_assert(kith::array_point<OpenMesh::Vec3f> and kith::array_point<OpenMesh::Vec3d>);
    static_assert(not kith::array_point<OpenMesh::Vec3i>);
    const auto cage = make(shapes::shaken(shapes::house()));
    const auto expected = kith::refine(kith::to_native_valid(cage), kith::doo_sabin(), 2);
    static_assert(std::is_same_v<decltype(expected)::point_type, std::array<poly_mesh::Scalar, 3>>);
    EXPECT_TRUE(same_bits(kith::to_native_valid(kith::refine(cage, kith::doo_sabin(), 2)), expected));
}

TEST(openmesh, requested_attributes_are_kept_and_have_values)
{
    const dirty_memory dirty;
    const auto [points, faces] = shapes::l_shape();
    auto mesh = user_mesh<poly_mesh_float>::make(points, faces);
    request_everything(mesh);
    mesh.set_color(OpenMesh::VertexHandle(0), {1, 2, 3});
    mesh.status(OpenMesh::FaceHandle(0)).set_selected(true);
    for (const int levels : {0, 1, 2})
        expect_everything_zero(kith::refine(mesh, kith::catmull_clark(), levels));
    kith::hierarchy levels(mesh, kith::catmull_clark());
    levels.refine(2);
    expect_everything_zero(levels[1]);
    expect_everything_zero(levels[2]);
    expect_everything_zero(kith::tri_quad(mesh));
    expect_everything_zero(kith::refine(mesh, untrusted(), 1));
}

TEST(openmesh, attributes_of_traits_have_values)
{
    const dirty_memory dirty;
    const auto [points, faces] = shapes::tetrahedron();
    using poly = OpenMesh::PolyMesh_ArrayKernelT<attributed_traits>;
    using tri = OpenMesh::TriMesh_ArrayKernelT<attributed_traits>;
    expect_everything_zero(kith::refine(user_mesh<poly>::make(points, faces), kith::catmull_clark(), 2));
    expect_everything_zero(kith::refine(user_mesh<tri>::make(points, faces), kith::loop(), 2));
    expect_everything_zero(kith::mesh_traits<tri>::build(kith::to_native(user_mesh<tri>::make(points, faces))));
}

TEST(openmesh, nothing_is_requested_that_the_source_does_not_have)
{
    const auto [points, faces] = shapes::cube();
    auto mesh = user_mesh<poly_mesh_float>::make(points, faces);
    mesh.request_face_colors();
    const auto fine = kith::refine(mesh, kith::catmull_clark(), 1);
    EXPECT_TRUE(fine.has_face_colors());
    EXPECT_FALSE(fine.has_vertex_colors() or fine.has_face_status() or fine.has_vertex_normals());
}

TEST(openmesh, a_refined_mesh_can_be_edited_as_its_source)
{
    const auto edit = [](auto mesh, const auto& scheme) {
        mesh.request_vertex_status();
        mesh.request_edge_status();
        mesh.request_face_status();
        mesh = kith::refine(mesh, scheme, 1);
        const std::size_t faces = mesh.n_faces();
        mesh.delete_face(OpenMesh::FaceHandle(0), true);
        mesh.garbage_collection();
        EXPECT_EQ(mesh.n_faces(), faces - 1);
        EXPECT_EQ(user_mesh<decltype(mesh)>::complaints(mesh), "");
    };
    using tri_mesh_float = OpenMesh::TriMesh_ArrayKernelT<>;
    const auto [points, faces] = shapes::tetrahedron();
    edit(user_mesh<tri_mesh_float>::make(points, faces), kith::loop());
    edit(user_mesh<poly_mesh_float>::make(points, faces), kith::catmull_clark());
    edit(user_mesh<tri_mesh>::make(points, faces), kith::loop());
}

TEST(openmesh, deleted_elements_are_left_out)
{
    const auto with_deleted = cube_after_deleted_tetrahedron();
    ASSERT_EQ(with_deleted.n_faces(), 10U);
    EXPECT_TRUE(same_bits(kith::refine(with_deleted, kith::catmull_clark(), 2),
                          kith::refine(make(shapes::cube()), kith::catmull_clark(), 2)));
}

TEST(openmesh, deleted_elements_have_no_places_of_quadrature)
{
    const auto quadrature = kith::quadrature_places(cube_after_deleted_tetrahedron(), kith::catmull_clark(), 2);
    ASSERT_EQ(quadrature.places.size(), 24U);
    for (std::size_t i = 0; i < quadrature.places.size(); ++i) {
        EXPECT_EQ(quadrature.places[i].face, i / 4);
        EXPECT_EQ(quadrature.weights[i], .25);
    }
}

TEST(openmesh, deleted_elements_do_not_shift_associations)
{
    kith::hierarchy levels(cube_after_deleted_tetrahedron(), kith::catmull_clark());
    levels.refine();
    const OpenMesh::FaceHandle bottom(4); // the first face of the cube
    const auto centre = levels.assoc(0, bottom, kith::targets::V);
    EXPECT_EQ(levels[1].point(centre), OpenMesh::Vec3d(0, 0, -1));
    EXPECT_EQ(levels.origin(1, centre).f, bottom);
}

TEST(openmesh, features_are_creases_and_corners)
{
    auto mesh = make(shapes::cube());
    const auto edge = mesh.edge_handle(mesh.find_halfedge(OpenMesh::VertexHandle(5), OpenMesh::VertexHandle(6)));
    mesh.status(edge).set_feature(true);
    mesh.status(OpenMesh::VertexHandle(0)).set_feature(true);
    kith::hierarchy levels(mesh, kith::catmull_clark{.corners = {}, .sharpness = kith::creases_from_features(mesh, 1)});
    levels.refine();
    EXPECT_EQ(levels[1].point(levels.assoc(0, edge, kith::targets::V)), OpenMesh::Vec3d(1, 0, 1));
    // A vertex of sharpness 1 stays for one step and is smooth from then on.
    EXPECT_EQ(levels[1].point(OpenMesh::VertexHandle(0)), OpenMesh::Vec3d(-1, -1, -1));
    EXPECT_EQ(levels.scheme(0).sharpness.edges().size(), 1U);
    EXPECT_EQ(levels.scheme(0).sharpness.vertices().size(), 1U);
    EXPECT_TRUE(levels.scheme(1).sharpness.empty());
    expect_handed_on(mesh, levels.scheme(0));
}

TEST(openmesh, features_of_deleted_elements_do_not_count)
{
    auto mesh = make(shapes::both(shapes::tetrahedron(), shapes::cube()));
    mesh.find_feature_edges(OpenMesh::deg_to_rad(89.));
    mesh.delete_face(OpenMesh::FaceHandle(0), true);
    mesh.delete_face(OpenMesh::FaceHandle(1), true);
    mesh.delete_face(OpenMesh::FaceHandle(2), true);
    mesh.delete_face(OpenMesh::FaceHandle(3), true);
    const auto fine = kith::refine(
        mesh, kith::catmull_clark{.corners = {}, .sharpness = kith::creases_from_features(mesh)}, 2);
    for (int v = 0; v < 8; ++v)
        EXPECT_EQ(fine.point(OpenMesh::VertexHandle(v)), mesh.point(OpenMesh::VertexHandle(4 + v)));
}

TEST(openmesh, one_status_is_enough_for_features)
{
    const auto [points, faces] = shapes::cube();
    auto mesh = user_mesh<poly_mesh_float>::make(points, faces);
    mesh.request_vertex_status();
    mesh.status(OpenMesh::VertexHandle(3)).set_feature(true);
    const auto sharp = kith::creases_from_features(mesh);
    EXPECT_TRUE(sharp.edges().empty());
    EXPECT_EQ(sharp.of_vertex(3), kith::infinitely_sharp);
    EXPECT_EQ(sharp.vertices().size(), 1U);
}

TEST(openmesh, features_need_a_status)
{
    const auto [points, faces] = shapes::cube();
    const auto mesh = user_mesh<poly_mesh_float>::make(points, faces);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::creases_from_features(mesh); }),
              "neither edges nor vertices have a status, where features are marked; call request_edge_status() or "
              "request_vertex_status() and mark them");
}

TEST(openmesh, properties_hold_sharpness)
{
    auto mesh = make(shapes::cube());
    OpenMesh::EProp<double> of_edge(mesh);
    for (const auto e : mesh.edges())
        of_edge[e] = e.idx() == 4 ? 2.5 : 0;
    const auto sharp = kith::make_creases(mesh, of_edge);
    EXPECT_EQ(sharp.edges().size(), 1U);
    EXPECT_EQ(sharp.of_edge(4), 2.5);
}

TEST(openmesh, fields_are_those_of_the_native_mesh)
{
    expect_same_fields(make(shapes::open_house()), kith::catmull_clark());
    expect_same_fields(make(shapes::open_house()), kith::doo_sabin());
}

TEST(openmesh, a_class_derived_from_its_meshes_is_a_mesh)
{
    struct own_mesh : poly_mesh {
        std::string name;
    };
    EXPECT_TRUE(kith::refinable_mesh<own_mesh>);
}

TEST(openmesh, meshes_without_marks_are_read)
{
    const auto [points, faces] = shapes::cube();
    const auto fine = kith::refine(user_mesh<poly_mesh_float>::make(points, faces), kith::catmull_clark(), 1);
    EXPECT_EQ(fine.point(OpenMesh::VertexHandle(6)), OpenMesh::Vec3f(5.F / 9, 5.F / 9, 5.F / 9));
}

TEST(openmesh, deleted_elements_and_invalid_handles_are_refused)
{
    using namespace kith::targets;
    kith::hierarchy levels(cube_after_deleted_tetrahedron(), kith::catmull_clark());
    levels.refine(1);
    const auto asked = [&](const auto&... x) {
        return error_text<kith::mesh_error>([&] { static_cast<void>(levels.assoc(0, x..., V)); });
    };
    EXPECT_EQ(asked(OpenMesh::VertexHandle(0)),
              "level 0 has no vertex 0, it was removed or is of another mesh; take handles from level 0");
    EXPECT_EQ(asked(OpenMesh::EdgeHandle(5)).find("level 0 has no edge 5, it was removed"), 0U);
    EXPECT_EQ(asked(OpenMesh::FaceHandle(3)).find("level 0 has no face 3, it was removed"), 0U);
    EXPECT_EQ(
        asked(OpenMesh::VertexHandle(4), OpenMesh::FaceHandle(100)).find("level 0 has no face 100, it was removed"),
        0U);
    EXPECT_EQ(asked(OpenMesh::VertexHandle()),
              "level 0 has no vertex with this handle, which is invalid; take handles from level 0");
    EXPECT_EQ(asked(OpenMesh::EdgeHandle()).find("level 0 has no edge with this handle"), 0U);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(levels.origin(1, OpenMesh::FaceHandle())); }),
              "level 1 has no face with this handle, which is invalid; take handles from level 1");
    EXPECT_EQ(asked(OpenMesh::VertexHandle(4)), "no error");
}

TEST(openmesh, an_inner_vertex_of_valence_two_is_refined)
{
    const auto fine = kith::refine(make(shapes::valence_two()), kith::catmull_clark(), 1);
    EXPECT_EQ(fine.point(OpenMesh::VertexHandle(3)), OpenMesh::Vec3d(0.46875, 0, 0.475));
}

TEST(openmesh, a_mesh_of_triangles_refuses_to_become_one_of_quads)
{
    const auto [points, faces] = shapes::tetrahedron();
    EXPECT_EQ(error_text<kith::mesh_error>(
                  [&] { kith::refine(user_mesh<tri_mesh>::make(points, faces), kith::catmull_clark(), 1); }),
              "OpenMesh's TriMesh holds triangles only, face 0 has 4 vertices; refine a PolyMesh instead");
}

TEST(openmesh, more_half_edges_than_it_can_number_are_refused)
{
    poly_mesh mesh;
    EXPECT_EQ(error_text<kith::mesh_error>(
                  [&] { kith::mesh_traits<poly_mesh>::make_room(mesh, 1, std::size_t(1) << 30, 1); }),
              "OpenMesh numbers half-edges with int, the next level has 1073741824 edges; refine fewer times");
    EXPECT_EQ(mesh.n_edges(), 0U);
}

TEST(openmesh, edges_without_a_face_are_refused)
{
    auto mesh = make(shapes::cube());
    mesh.new_edge(OpenMesh::VertexHandle(0), OpenMesh::VertexHandle(6));
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::refine(mesh, kith::catmull_clark(), 1); }),
              "edge 12: has no face; remove it or give it a face");
}

TEST(openmesh, boundary_vertices_enter_at_the_boundary)
{
    const auto fine = kith::refine(make(shapes::l_shape()), kith::catmull_clark(), 2);
    for (const auto v : fine.vertices())
        EXPECT_EQ(fine.is_boundary(fine.halfedge_handle(v)), fine.is_boundary(v));
}
