// SPDX-License-Identifier: BSD-3-Clause
#include "support/cgal_mesh.hpp"

#include "support/mesh_statements.hpp"

#include <kith/doo_sabin.hpp>
#include <kith/four_eight.hpp>
#include <kith/make_creases.hpp>
#include <kith/refine_with_fields.hpp>
#include <kith/unified.hpp>

#include <CGAL/Cartesian.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>

INSTANTIATE_TYPED_TEST_SUITE_P(cgal, mesh_statements, testing::Types<surface_mesh<CGAL::Simple_cartesian<double>>>);

namespace {

using mesh = surface_mesh<CGAL::Simple_cartesian<double>>;
using point = mesh::Point;
using exact_mesh = surface_mesh<epeck>;
using exact = epeck::FT;

mesh make(const shapes::shape& s)
{
    return user_mesh<mesh>::make(s.points, s.faces);
}
mesh cube_after_removed_tetrahedron()
{
    auto shape = shapes::both(shapes::tetrahedron(), shapes::cube());
    for (std::size_t v = 4; v < shape.points.size(); ++v)
        shape.points[v][0] -= 10;
    auto result = make(shape);
    for (std::uint32_t f = 0; f < 4; ++f)
        CGAL::Euler::remove_face(result.halfedge(mesh::Face_index(f)), result);
    return result;
}
exact_mesh make_exact(const shapes::shape& s)
{
    return user_mesh<exact_mesh>::make(s.points, s.faces);
}
epeck::Point_3 exact_point(const exact& x, const exact& y, const exact& z)
{
    return {x, y, z};
}
std::string refusal(const mesh& m)
{
    return error_text<kith::mesh_error>([&] { kith::refine(m, kith::catmull_clark(), 1); });
}

} // namespace

TEST(cgal, points_that_are_arrays_are_refined_as_arrays)
{
    using kernel_of_handles = CGAL::Cartesian<double>;
    static_assert(kith::array_point<point> and kith::array_point<epick::Point_3>);
    static_assert(not kith::array_point<epeck::Point_3> and not kith::array_point<kernel_of_handles::Point_3>);
    const auto native = kith::to_native_valid(make(shapes::shaken(shapes::cube())));
    static_assert(std::is_same_v<decltype(native), const kith::basic_mesh<>>);
    EXPECT_EQ(native.point(7)[2], make(shapes::shaken(shapes::cube())).point(mesh::Vertex_index(7)).z());
}

TEST(cgal, faces_of_many_corners_are_written_whole)
{
    const auto cage = make(shapes::shaken(shapes::umbrella(20))); // its middle vertex becomes a face
    const auto fine = kith::refine(cage, kith::doo_sabin(), 2);
    EXPECT_TRUE(
        same_bits(kith::to_native_valid(fine), kith::refine(kith::to_native_valid(cage), kith::doo_sabin(), 2)));
    std::size_t largest = 0;
    for (const auto f : fine.faces())
        largest = std::max<std::size_t>(largest, fine.degree(f));
    EXPECT_EQ(largest, 20U);
}

TEST(cgal, removed_elements_are_left_out)
{
    const mesh with_garbage = cube_after_removed_tetrahedron();
    ASSERT_TRUE(with_garbage.has_garbage());
    EXPECT_TRUE(same_bits(kith::refine(with_garbage, kith::catmull_clark(), 2),
                          kith::refine(make(shapes::cube()), kith::catmull_clark(), 2)));
}

TEST(cgal, faces_of_removed_vertices_are_refused)
{
    auto cube = make(shapes::cube());
    cube.remove_vertex(mesh::Vertex_index(7));
    EXPECT_EQ(refusal(cube),
              "face 1: one of its vertices has been removed; remove the face, too\n"
              "face 4: one of its vertices has been removed; remove the face, too\n"
              "face 5: one of its vertices has been removed; remove the face, too");
}

TEST(cgal, half_edges_that_lead_elsewhere_are_refused)
{
    auto cube = make(shapes::cube());
    const auto h = cube.halfedge(mesh::Vertex_index(7), mesh::Vertex_index(6));
    cube.set_target(h, mesh::Vertex_index(0));
    EXPECT_NE(refusal(cube).find("faces form several fans"), std::string::npos);
}

TEST(cgal, collecting_garbage_changes_no_more_than_numbers)
{
    auto m = cube_after_removed_tetrahedron();
    m.collect_garbage();
    EXPECT_EQ(kith::validate(m).text(), "");
    EXPECT_EQ(kith::refine(m, kith::catmull_clark(), 2).number_of_faces(), 96U);
}

TEST(cgal, removed_elements_do_not_shift_associations)
{
    kith::hierarchy levels(cube_after_removed_tetrahedron(), kith::catmull_clark());
    levels.refine();
    const mesh::Face_index bottom(4); // the first face of the cube
    const auto centre = levels.assoc(0, bottom, kith::targets::V);
    EXPECT_EQ(levels[1].point(centre), point(0, 0, -1));
    EXPECT_EQ(levels.origin(1, centre).f, bottom);
}

TEST(cgal, errors_count_removed_elements)
{
    const auto cube = cube_after_removed_tetrahedron();
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::hierarchy(cube, kith::loop()); }),
              "loop: face 4 has 4 vertices; triangulate the mesh first");
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::refine(cube, kith::loop(), 1); }),
              "loop: face 4 has 4 vertices; triangulate the mesh first");
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::make_creases(cube, [](auto) { return -1; }); }),
              "edge 6: its sharpness is -1.000000; give 0 or more, or infinitely_sharp");
    EXPECT_EQ(error_text<kith::mesh_error>(
                  [&] { kith::make_creases(cube, [](auto) { return false; }, [](auto) { return -1; }); }),
              "vertex 4: its sharpness is -1.000000; give 0 or more, or infinitely_sharp");

    auto open_cube = cube;
    CGAL::Euler::remove_face(open_cube.halfedge(mesh::Face_index(4)), open_cube);
    const std::string closed_only = error_text<kith::mesh_error>([&] { kith::hierarchy(open_cube, kith::unified()); });
    const auto number_of = [](std::size_t v) { return std::to_string(v); };
    bool names_a_boundary_edge = false;
    for (const auto e : open_cube.edges()) {
        const auto h = open_cube.halfedge(e);
        const auto a = number_of(open_cube.source(h)), b = number_of(open_cube.target(h));
        const std::string start = "unified: edge " + number_of(e) + " between vertices ";
        if (open_cube.is_border(e))
            names_a_boundary_edge |= closed_only.starts_with(start + a + " and " + b + " ") or
                                     closed_only.starts_with(start + b + " and " + a + " ");
    }
    EXPECT_TRUE(names_a_boundary_edge) << closed_only;
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::refine(open_cube, kith::unified(), 1); }), closed_only);
    kith::unified with_state;
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::refine_with_fields(open_cube, with_state, 1); }), closed_only);

    const auto tetrahedra = make(shapes::both(shapes::tetrahedron(), shapes::tetrahedron()));
    auto unmarked = tetrahedra;
    CGAL::Euler::remove_face(unmarked.halfedge(mesh::Face_index(0)), unmarked);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::hierarchy(unmarked, kith::four_eight()); }),
              "4-8: faces 1 and 2 do not both start with the edge between them; make a tri-quad mesh first (tri_quad)");
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::refine(unmarked, kith::four_eight(), 1); }),
              "4-8: faces 1 and 2 do not both start with the edge between them; make a tri-quad mesh first (tri_quad)");
}

TEST(cgal, what_the_options_of_a_scheme_refuse_has_the_numbers_of_handles)
{
    // A house whose front edge has one more vertex in its middle, the last vertex, between two faces.
    const shapes::shape house{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {.5, .5, 1}, {.5, 0, 0}},
                              {{0, 5, 1, 2, 3}, {1, 5, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}}};
    auto beside_removed = make(shapes::both(shapes::tetrahedron(), house));
    for (unsigned f = 0; f < 4; ++f)
        CGAL::Euler::remove_face(beside_removed.halfedge(mesh::Face_index(f)), beside_removed);
    const kith::unified even{.degree = 2};
    const std::string text =
        "unified: vertex 9 lies between 2 faces only, the scheme needs three; merge its two edges into one first";
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::refine(beside_removed, even, 1); }), text);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::hierarchy(beside_removed, even); }), text);
    EXPECT_NO_THROW(kith::hierarchy(beside_removed, kith::unified{.degree = 3}));
}

TEST(cgal, removed_elements_and_invalid_handles_are_refused)
{
    using namespace kith::targets;
    kith::hierarchy levels(cube_after_removed_tetrahedron(), kith::catmull_clark());
    levels.refine(1);
    const auto asked = [&](const auto&... x) {
        return error_text<kith::mesh_error>([&] { static_cast<void>(levels.assoc(0, x..., V)); });
    };
    EXPECT_EQ(asked(mesh::Vertex_index(0)),
              "level 0 has no vertex 0, it was removed or is of another mesh; take handles from level 0");
    EXPECT_EQ(asked(mesh::Edge_index(5)).find("level 0 has no edge 5, it was removed"), 0U);
    EXPECT_EQ(asked(mesh::Face_index(3)).find("level 0 has no face 3, it was removed"), 0U);
    EXPECT_EQ(asked(mesh::Vertex_index(4), mesh::Face_index(100)).find("level 0 has no face 100, it was removed"), 0U);
    EXPECT_EQ(asked(mesh::Vertex_index()),
              "level 0 has no vertex with this handle, which is invalid; take handles from level 0");
    EXPECT_EQ(asked(mesh::Edge_index()).find("level 0 has no edge with this handle"), 0U);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(levels.origin(1, mesh::Face_index())); }),
              "level 1 has no face with this handle, which is invalid; take handles from level 1");
    EXPECT_EQ(asked(mesh::Vertex_index(4)), "no error");
}

TEST(cgal, an_inner_vertex_of_valence_two_is_refined)
{
    const auto fine = kith::refine(make(shapes::valence_two()), kith::catmull_clark(), 1);
    EXPECT_EQ(fine.point(mesh::Vertex_index(3)), point(0.46875, 0, 0.475));
}

TEST(cgal, points_that_are_not_finite_are_refused)
{
    auto m = make(shapes::cube());
    m.point(mesh::Vertex_index(6)) = point(0, std::nan(""), 0);
    EXPECT_EQ(refusal(m), "vertex 6: a coordinate is not a finite number; give finite coordinates");
}

TEST(cgal, edges_without_a_face_are_refused)
{
    auto m = make(shapes::cube());
    m.add_edge(mesh::Vertex_index(0), mesh::Vertex_index(6));
    EXPECT_EQ(refusal(m), "edge 12: has no face; remove it or give it a face");
}

TEST(cgal, faces_that_do_not_fit_the_scheme_are_refused)
{
    EXPECT_EQ(error_text<kith::mesh_error>([] { kith::refine(make(shapes::cube()), kith::loop(), 1); }),
              "loop: face 0 has 4 vertices; triangulate the mesh first");
}

TEST(cgal, constrained_edges_are_creases)
{
    auto m = make(shapes::cube());
    auto constrained = m.add_property_map<mesh::Edge_index, bool>("e:is_constrained", false).first;
    CGAL::Polygon_mesh_processing::detect_sharp_edges(m, 89, constrained);
    const auto fine = kith::refine(
        m, kith::catmull_clark{.corners = {}, .sharpness = kith::make_creases(m, constrained)}, 3);
    for (const auto v : m.vertices())
        EXPECT_EQ(fine.point(v), m.point(v));
    EXPECT_EQ(kith::make_creases(m, constrained).edges().size(), 12U);
}

TEST(cgal, properties_hold_sharpness)
{
    auto m = cube_after_removed_tetrahedron(); // numbers of its elements differ from their handles
    auto of_edge = m.add_property_map<mesh::Edge_index, double>("e:sharpness", 0).first;
    auto of_vertex = m.add_property_map<mesh::Vertex_index, double>("v:sharpness", 0).first;
    // The edge goes from (1,-1,1) to (1,1,1); the vertex is (-1,-1,-1).
    const auto edge = m.edge(m.halfedge(mesh::Vertex_index(4 + 5), mesh::Vertex_index(4 + 6)));
    of_edge[edge] = 1;
    of_vertex[mesh::Vertex_index(4)] = kith::infinitely_sharp;
    kith::hierarchy levels(m,
                           kith::catmull_clark{.corners = {}, .sharpness = kith::make_creases(m, of_edge, of_vertex)});
    levels.refine();
    EXPECT_EQ(levels[1].point(levels.assoc(0, edge, kith::targets::V)), point(1, 0, 1));
    EXPECT_EQ(levels[1].point(levels.assoc(0, mesh::Vertex_index(4), kith::targets::V)), point(-1, -1, -1));
    EXPECT_EQ(levels.scheme(0).sharpness.edges().size(), 1U);
    EXPECT_EQ(levels.scheme(1).sharpness.edges().size(), 0U);
    expect_handed_on(m, levels.scheme(0));
}

TEST(cgal, fields_are_those_of_the_native_mesh)
{
    expect_same_fields(make(shapes::open_house()), kith::catmull_clark());
    expect_same_fields(make(shapes::open_house()), kith::doo_sabin());
    expect_same_fields(cube_after_removed_tetrahedron(), kith::catmull_clark());
}

TEST(cgal, exact_numbers_are_refined_exactly)
{
    kith::hierarchy levels(make_exact(shapes::cube()), kith::catmull_clark());
    levels.refine();
    const exact_mesh& fine = levels[1];
    const exact_mesh::Vertex_index corner(6);
    EXPECT_EQ(fine.point(corner), exact_point(exact(5) / 9, exact(5) / 9, exact(5) / 9));
    const auto edge = edge_between(levels.elements(0), 5, 6); // from (1,-1,1) to (1,1,1)
    EXPECT_EQ(fine.point(levels.assoc(0, edge, kith::targets::V)), exact_point(exact(3) / 4, 0, exact(3) / 4));
}

TEST(cgal, the_second_exact_level_is_exact_too)
{
    // Around the corner (5/9, 5/9, 5/9) there are edge points like (3/4, 3/4, 0). Its quads have face points like (1,
    // 0, 0) at their opposite corners. The quads' centres have x = (5/9 + 3/4 + 1 + 3/4) / 4 once. They have x = (5/9 +
    // 3/4 + 0 + 0) / 4 twice. So the new corner has x = 1/3 * 5/9 + 1/9 * (3/4 + 3/4 + 0) + 1/9 * 17/12 = 55/108.
    const auto fine = kith::refine(make_exact(shapes::cube()), kith::catmull_clark(), 2);
    const exact x = exact(55) / 108;
    EXPECT_EQ(fine.point(exact_mesh::Vertex_index(6)), exact_point(x, x, x));
}
