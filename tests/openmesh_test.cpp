// SPDX-License-Identifier: BSD-3-Clause
#include "openmesh_mesh.hpp"

#include "mesh_statements.hpp"

#include <kith/make_creases.hpp>

#include <OpenMesh/Core/Utils/PropertyManager.hh>

INSTANTIATE_TYPED_TEST_SUITE_P(poly_mesh, mesh_statements, testing::Types<poly_mesh>);
INSTANTIATE_TYPED_TEST_SUITE_P(tri_mesh, mesh_statements, testing::Types<tri_mesh>);

namespace {

poly_mesh make(const shapes::shape& s)
{
    return user_mesh<poly_mesh>::make(s.points, s.faces);
}

/// The first four faces and vertices are marked as deleted and still there.
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

} // namespace

TEST(openmesh, deleted_elements_are_left_out)
{
    const auto with_deleted = cube_after_deleted_tetrahedron();
    ASSERT_EQ(with_deleted.n_faces(), 10U);
    EXPECT_TRUE(same_bits(kith::refine(with_deleted, kith::catmull_clark(), 2),
                          kith::refine(make(shapes::cube()), kith::catmull_clark(), 2)));
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
    // A vertex of sharpness 1 stays for one step, and is smooth from then on.
    EXPECT_EQ(levels[1].point(OpenMesh::VertexHandle(0)), OpenMesh::Vec3d(-1, -1, -1));
    EXPECT_EQ(levels.scheme(0).sharpness.edges().size(), 1U);
    EXPECT_EQ(levels.scheme(0).sharpness.vertices().size(), 1U);
    EXPECT_TRUE(levels.scheme(1).sharpness.empty());
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
