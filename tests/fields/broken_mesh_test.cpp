// SPDX-License-Identifier: BSD-3-Clause
// Meshes of CGAL and OpenMesh that were linked wrongly by hand. All functions that read a mesh refuse them.
#include <CGAL/Simple_cartesian.h>

#include "support/cgal_mesh.hpp"
#include "support/error_text.hpp"
#include "support/openmesh_mesh.hpp"
#include "support/shapes.hpp"

#include <kith/cgal_subdivision.hpp>
#include <kith/convert.hpp>
#include <kith/hierarchy.hpp>
#include <kith/make_creases.hpp>
#include <kith/openmesh_subdivision.hpp>
#include <kith/repair.hpp>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using cgal_mesh = surface_mesh<kernel>;
using polyhedron = CGAL::Polyhedron_3<kernel>;
using vertex = cgal_mesh::Vertex_index;
using halfedge = cgal_mesh::Halfedge_index;
using edge = cgal_mesh::Edge_index;
using face = cgal_mesh::Face_index;

cgal_mesh cgal(const shapes::shape& s)
{
    return user_mesh<cgal_mesh>::make(s.points, s.faces);
}
template <class M = tri_mesh>
M openmesh(const shapes::shape& s)
{
    return user_mesh<M>::make(s.points, s.faces);
}

/// The errors of all functions that read a mesh.
struct refusals {
    std::string refine, report, hierarchy, dialect, creases, convert;
};
template <class F>
std::string refusal(const F& f)
{
    return error_text<kith::mesh_error>(f);
}
template <class Other, class M, class Dialect>
refusals refusals_of(const M& mesh, const Dialect& dialect)
{
    return {refusal([&] { kith::refine(mesh, kith::loop(), 1); }),
            refusal([&] { kith::validate(mesh).require_ok(); }),
            refusal([&] { kith::hierarchy<M, kith::loop>(mesh, kith::loop()).refine(1); }),
            refusal([&] {
                M copy = mesh;
                dialect(copy);
            }),
            refusal([&] { kith::creases_by_angle(mesh, 30); }),
            refusal([&] { kith::convert<Other>(mesh); })};
}
refusals refusals_of(const cgal_mesh& mesh)
{
    return refusals_of<tri_mesh>(mesh, [](auto& copy) { kith::cgal::Loop_subdivision(copy, 1); });
}
refusals refusals_of(const tri_mesh& mesh)
{
    return refusals_of<cgal_mesh>(mesh, [](auto& copy) { kith::openmesh::LoopT<tri_mesh>()(copy, 1); });
}
void expect_all(const refusals& told, const std::string& text)
{
    EXPECT_EQ(told.refine, text);
    EXPECT_EQ(told.report, text);
    EXPECT_EQ(told.hierarchy, text);
    EXPECT_EQ(told.dialect, text);
    EXPECT_EQ(told.creases, text);
    EXPECT_EQ(told.convert, text);
}

/// A mask whose functions must not be called.
struct no_mask {
    template <class Face>
    void face_node(Face, kernel::Point_3&)
    {
        ADD_FAILURE();
    }
    template <class Edge>
    void edge_node(Edge, kernel::Point_3&)
    {
        ADD_FAILURE();
    }
    template <class Vertex>
    void vertex_node(Vertex, kernel::Point_3&)
    {
        ADD_FAILURE();
    }
    template <class Halfedge>
    void border_node(Halfedge, kernel::Point_3&, kernel::Point_3&)
    {
        ADD_FAILURE();
    }
};

const std::string open_face = ": its half-edges do not lead back to the first; relink them or remove the face";

} // namespace

TEST(broken_mesh, a_face_whose_half_edges_run_back_to_another_than_its_first)
{
    auto ours = openmesh(shapes::tetrahedron());
    const auto first = ours.halfedge_handle(OpenMesh::FaceHandle(2)), second = ours.next_halfedge_handle(first);
    ours.set_next_halfedge_handle(ours.next_halfedge_handle(second), second);
    expect_all(refusals_of(ours), "face 2" + open_face);

    auto theirs = cgal(shapes::tetrahedron());
    theirs.add_property_map<halfedge, int>("h:label", 1);
    const auto h = theirs.next(theirs.halfedge(face(1)));
    theirs.set_next(theirs.next(h), h);
    expect_all(refusals_of(theirs), "face 1" + open_face);
    EXPECT_EQ(refusal([&] { kith::cgal::PTQ(theirs, no_mask(), 1); }), "face 1" + open_face);

    // The walk along half-edges in the order of corners ends, too.
    std::size_t met = 0;
    kith::detail::for_each_handle<halfedge>(theirs, [&](halfedge) { ++met; });
    EXPECT_LE(met, 4 * theirs.number_of_halfedges());
}

TEST(broken_mesh, a_face_of_a_removed_vertex)
{
    for (const std::size_t removed : {3U, 1U}) {
        auto mesh = cgal(shapes::tetrahedron());
        mesh.remove_vertex(vertex(cgal_mesh::size_type(removed)));
        std::string text;
        for (const auto f : removed == 3 ? std::vector{1, 2, 3} : std::vector{0, 2, 3})
            text += (text.empty() ? "face " : "\nface ") + std::to_string(f) +
                    ": one of its vertices has been removed; remove the face, too";
        expect_all(refusals_of(mesh), text);
        EXPECT_EQ(refusal([&] { kith::cgal::PTQ(mesh, no_mask(), 1); }), text);
    }
}

TEST(broken_mesh, a_face_without_half_edges)
{
    auto theirs = cgal(shapes::tetrahedron());
    theirs.add_face();
    expect_all(refusals_of(theirs), "face 4: has 0 corners; remove it");

    auto ours = openmesh(shapes::tetrahedron());
    ours.new_face();
    expect_all(refusals_of(ours), "face 4: has 0 corners; remove it");

    polyhedron graph;
    CGAL::copy_face_graph(cgal(shapes::tetrahedron()), graph);
    add_face(graph);
    EXPECT_EQ(refusal([&] { kith::cgal::Loop_subdivision(graph, 1); }), "face 4: has 0 corners; remove it");
}

/// A face without half-edges is refused beside a boundary, too, where there are enough half-edges for its corners.
TEST(broken_mesh, a_bare_face_beside_a_boundary)
{
    const std::string text = "face 1: has 0 corners; remove it";
    const shapes::shape triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    auto theirs = cgal(triangle);
    theirs.add_face();
    expect_all(refusals_of(theirs), text);
    auto ours = openmesh(triangle);
    ours.new_face();
    expect_all(refusals_of(ours), text);
    polyhedron graph;
    CGAL::copy_face_graph(cgal(triangle), graph);
    add_face(graph);
    EXPECT_EQ(refusal([&] { kith::cgal::Loop_subdivision(graph, 1); }), text);

    // The first bare face is removed again, the second one remains.
    theirs = cgal(triangle);
    const auto removed = theirs.add_face();
    theirs.add_face();
    theirs.remove_face(removed);
    expect_all(refusals_of(theirs), "face 2: has 0 corners; remove it");
    auto with_status = openmesh(triangle);
    with_status.request_face_status();
    with_status.status(with_status.new_face()).set_deleted(true);
    with_status.new_face();
    expect_all(refusals_of(with_status), "face 2: has 0 corners; remove it");

    // The bare face is alone, or beside a quad.
    cgal_mesh alone;
    alone.add_face();
    expect_all(refusals_of(alone), "face 0: has 0 corners; remove it");
    auto quad = cgal({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}});
    quad.add_face();
    EXPECT_EQ(refusal([&] { kith::refine(quad, kith::loop(), 1); }), text);
    EXPECT_EQ(refusal([&] { kith::cgal::CatmullClark_subdivision(quad, 1); }), text);
}

TEST(broken_mesh, repair_takes_meshes_of_other_libraries)
{
    auto bare = cgal(shapes::tetrahedron());
    bare.add_face();
    const auto dropped = kith::repair(bare, {.drop = true});
    EXPECT_EQ(dropped.report.text(), "face 4: left out, as it has 0 corners");
    EXPECT_EQ(kith::convert<tri_mesh>(kith::make_mesh(dropped.points, dropped.faces)).mesh.n_faces(), 4U);

    auto two = cgal(shapes::both(shapes::tetrahedron(), shapes::tetrahedron()));
    for (const auto h : two.halfedges_around_target(two.halfedge(vertex(4)))) // the second one gets vertex 0, too
        two.set_target(h, vertex(0));
    two.remove_vertex(vertex(4));
    EXPECT_NE(kith::validate(two).text().find("vertex 0: its 6 faces form several fans"), std::string::npos);
    const auto split = kith::repair(two, {.split = true});
    EXPECT_EQ(split.report.text(), "vertex 0: split into 2 vertices, one for each fan of faces");
    const auto apart = kith::convert<cgal_mesh>(kith::make_mesh(split.points, split.faces)).mesh;
    EXPECT_EQ(apart.number_of_vertices(), 8U);
    EXPECT_EQ(apart.point(vertex(7)), two.point(vertex(0)));
    EXPECT_TRUE(user_mesh<cgal_mesh>::complaints(apart).empty());
}

TEST(broken_mesh, an_edge_without_faces)
{
    const shapes::shape triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    const std::string text = "edge 3: has no face; remove it or give it a face";
    auto theirs = cgal(triangle);
    theirs.add_edge();
    expect_all(refusals_of(theirs), text);
    theirs = cgal(triangle);
    theirs.add_edge(vertex(0), vertex(1));
    expect_all(refusals_of(theirs), text);
    auto ours = openmesh(triangle);
    ours.new_edge(OpenMesh::VertexHandle(0), OpenMesh::VertexHandle(1));
    expect_all(refusals_of(ours), text);
    polyhedron graph;
    CGAL::copy_face_graph(cgal(triangle), graph);
    add_edge(graph);
    EXPECT_EQ(refusal([&] { kith::cgal::Loop_subdivision(graph, 1); }), text);
}

TEST(broken_mesh, points_that_are_not_finite)
{
    auto theirs = cgal(shapes::tetrahedron());
    theirs.point(vertex(2)) = kernel::Point_3(0, std::nan(""), 0);
    const auto told = refusals_of(theirs);
    const std::string text = "vertex 2: a coordinate is not a finite number; give finite coordinates";
    EXPECT_EQ(told.refine, text);
    EXPECT_EQ(told.report, text);
    EXPECT_EQ(told.hierarchy, text);
    EXPECT_EQ(told.dialect, text);
    EXPECT_EQ(told.convert, text);
}

TEST(broken_mesh, a_mesh_without_elements_is_converted)
{
    EXPECT_EQ(kith::convert<tri_mesh>(cgal_mesh()).mesh.n_vertices(), 0U);
    EXPECT_EQ(kith::convert<cgal_mesh>(tri_mesh()).mesh.number_of_vertices(), 0U);
    cgal_mesh points_only;
    points_only.add_vertex(kernel::Point_3(0, 0, 0));
    EXPECT_EQ(refusal([&] { kith::convert<tri_mesh>(points_only); }), kith::validate(points_only).text());
}

TEST(broken_mesh, a_face_of_a_removed_edge)
{
    for (cgal_mesh::size_type removed = 0; removed < 6; ++removed) {
        auto mesh = cgal(shapes::tetrahedron());
        mesh.remove_edge(edge(removed));
        const auto open = std::size_t(mesh.face(halfedge(2 * removed)));
        const auto other = std::size_t(mesh.face(halfedge(2 * removed + 1)));
        const std::string of_open = "face " + std::to_string(open) + open_face;
        const std::string of_other = "face " + std::to_string(other) +
                                     ": one of its edges has been removed; remove the face, too";
        const std::string text = open < other ? of_open + "\n" + of_other : of_other + "\n" + of_open;
        const auto told = refusals_of(mesh);
        EXPECT_EQ(told.refine, text);
        EXPECT_EQ(told.report, text);
        EXPECT_EQ(told.hierarchy, text);
        EXPECT_EQ(told.creases, text);
        EXPECT_EQ(told.convert, text);
        EXPECT_NE(told.dialect.find(of_open), std::string::npos)
            << told.dialect; // the copy has another list of free edges
    }
    // Here the half-edges still lead around all faces.
    auto mesh = cgal(shapes::tetrahedron());
    const auto next = mesh.next(halfedge(6));
    mesh.remove_edge(edge(3));
    mesh.set_next(halfedge(6), next);
    const auto faces = std::minmax({std::size_t(mesh.face(halfedge(6))), std::size_t(mesh.face(halfedge(7)))});
    const std::string removed_edge = ": one of its edges has been removed; remove the face, too";
    expect_all(refusals_of(mesh),
               "face " + std::to_string(faces.first) + removed_edge + "\nface " + std::to_string(faces.second) +
                   removed_edge);
}

TEST(broken_mesh, a_vertex_that_starts_at_no_half_edge_of_the_mesh)
{
    auto mesh = openmesh(shapes::tetrahedron());
    mesh.set_halfedge_handle(OpenMesh::VertexHandle(2), OpenMesh::HalfedgeHandle(40));
    const auto told = refusals_of(mesh);
    EXPECT_NE(told.refine.find("vertex 2: "), std::string::npos) << told.refine;
    EXPECT_NE(told.hierarchy.find("vertex 2: "), std::string::npos) << told.hierarchy;
    EXPECT_NE(told.dialect.find("vertex 2: "), std::string::npos) << told.dialect;
    EXPECT_EQ(refusal([&] { kith::creases_by_angle(mesh, 30); }),
              "vertex 2: its half-edge leads to none of its faces; give it an outgoing half-edge of one of its faces");
}

TEST(broken_mesh, a_vertex_that_starts_at_a_half_edge_of_another)
{
    auto open = shapes::tetrahedron();
    open.faces.pop_back();
    for (const auto& shape : {shapes::tetrahedron(), open}) {
        const auto says = [](std::size_t h, std::size_t of) {
            return "vertex 2: its half-edge " + std::to_string(h) + " leaves vertex " + std::to_string(of) +
                   "; give it an outgoing half-edge of one of its faces";
        };
        for (const int other : {0, 1, 3}) {
            auto ours = openmesh(shape);
            const auto leaving = ours.halfedge_handle(OpenMesh::VertexHandle(other));
            ours.set_halfedge_handle(OpenMesh::VertexHandle(2), leaving);
            const auto text = says(std::size_t(leaving.idx()), std::size_t(other));
            expect_all(refusals_of(ours), text);
            EXPECT_EQ(refusal([&] { kith::creases_by_angle(ours, 30); }), text);

            auto theirs = cgal(shape);
            const auto coming = theirs.halfedge(vertex(cgal_mesh::size_type(other)));
            theirs.set_halfedge(vertex(2), coming);
            expect_all(refusals_of(theirs), says(std::size_t(theirs.opposite(coming)), std::size_t(other)));
        }
    }
    auto ours = openmesh(open); // at the boundary, too
    ours.set_halfedge_handle(OpenMesh::VertexHandle(2), OpenMesh::HalfedgeHandle(40));
    expect_all(refusals_of(ours),
               "vertex 2: its half-edge leads to none of its faces; give it an outgoing half-edge of one of its faces");
}

const std::string unjoined = ": its half-edges name another face, or contradict each other about the next and the "
                             "previous one; relink them or remove the face";

TEST(broken_mesh, a_half_edge_that_names_another_face)
{
    auto ours = openmesh(shapes::tetrahedron());
    const auto inner = ours.halfedge_handle(OpenMesh::FaceHandle(1));
    ours.set_face_handle(inner, ours.face_handle(ours.opposite_halfedge_handle(inner)));
    expect_all(refusals_of(ours), "face 1" + unjoined);
    auto theirs = cgal(shapes::tetrahedron());
    const auto side = theirs.halfedge(face(1));
    theirs.set_face(side, theirs.face(theirs.opposite(side)));
    expect_all(refusals_of(theirs), "face 1" + unjoined);
}

TEST(broken_mesh, a_half_edge_in_a_face_that_names_none)
{
    auto ours = openmesh(shapes::tetrahedron());
    ours.set_boundary(ours.halfedge_handle(OpenMesh::FaceHandle(2)));
    expect_all(refusals_of(ours), "face 2" + unjoined);
    auto theirs = cgal(shapes::tetrahedron());
    theirs.set_face(theirs.halfedge(face(2)), cgal_mesh::null_face());
    expect_all(refusals_of(theirs), "face 2" + unjoined);
}

TEST(broken_mesh, a_half_edge_that_does_not_come_before_its_next)
{
    auto open = shapes::tetrahedron();
    open.faces.pop_back();
    auto ours = openmesh(open);
    OpenMesh::HalfedgeHandle rim;
    for (const auto h : ours.halfedges())
        if (ours.is_boundary(h))
            rim = h;
    const auto inner = ours.opposite_halfedge_handle(rim);
    const auto named = "face " + std::to_string(ours.face_handle(inner).idx());
    ours.set_next_halfedge_handle(rim, inner);
    expect_all(refusals_of(ours), named + unjoined);
}

TEST(broken_mesh, half_edges_of_a_removed_face_lie_at_the_boundary)
{
    // Removing a face at a low level leaves its half-edges as they are.
    for (cgal_mesh::size_type removed = 0; removed < 4; ++removed) {
        auto s = shapes::tetrahedron();
        auto mesh = cgal(s);
        mesh.remove_face(face(removed));
        s.faces.erase(s.faces.begin() + std::ptrdiff_t(removed));
        const auto open = cgal(s);
        EXPECT_TRUE(kith::validate(mesh).ok()) << kith::validate(mesh).text();
        const auto expected = kith::refine(open, kith::loop(), 1), fine = kith::refine(mesh, kith::loop(), 1);
        ASSERT_EQ(fine.number_of_faces(), 12U);
        EXPECT_TRUE(user_mesh<cgal_mesh>::complaints(fine).empty());
        kith::hierarchy<cgal_mesh, kith::loop> levels(mesh, kith::loop());
        levels.refine(1);
        for (const auto v : mesh.vertices()) {
            EXPECT_EQ(fine.point(v), levels[1].point(v));
            for (int i = 0; i < 3; ++i) // sums begin with another operand
                EXPECT_NEAR(fine.point(v)[i], expected.point(v)[i], 1e-15);
        }
        kith::cgal::Loop_subdivision(mesh, 1);
        EXPECT_EQ(mesh.number_of_faces(), 12U);
        EXPECT_TRUE(user_mesh<cgal_mesh>::complaints(mesh).empty());
    }
}

namespace {

std::string lost_side(std::size_t halfedge, std::size_t of)
{
    return "half-edge " + std::to_string(halfedge) + ": names face " + std::to_string(of) +
           ", which has been removed or does not contain it; reset its face, as the mesh library does when it removes "
           "a face";
}

} // namespace

TEST(broken_mesh, a_half_edge_of_the_boundary_that_names_a_face)
{
    auto open = shapes::tetrahedron();
    open.faces.pop_back();
    const auto good = openmesh(open);
    for (const auto h : good.halfedges()) {
        if (not good.is_boundary(h))
            continue;
        for (const int named : {0, 1, 7}) {
            auto ours = good;
            ours.set_face_handle(h, OpenMesh::FaceHandle(named));
            expect_all(refusals_of(ours), lost_side(std::size_t(h.idx()), std::size_t(named)));
        }
    }
    const auto other = cgal(open);
    for (const auto h : other.halfedges()) {
        if (not other.is_border(h))
            continue;
        auto theirs = other;
        theirs.set_face(h, face(1));
        expect_all(refusals_of(theirs), lost_side(std::size_t(h), 1));
    }
}

TEST(broken_mesh, elements_of_openmesh_that_are_marked_as_deleted_by_hand)
{
    const auto with_status = [](const shapes::shape& s) {
        auto mesh = openmesh(s);
        mesh.request_vertex_status();
        mesh.request_halfedge_status();
        mesh.request_edge_status();
        mesh.request_face_status();
        return mesh;
    };
    const auto good = with_status(shapes::tetrahedron());
    for (const auto f : good.faces()) { // its half-edges still refer to it
        auto mesh = good;
        mesh.status(f).set_deleted(true);
        std::string text;
        for (const auto h : good.halfedges())
            if (good.face_handle(h) == f)
                text += (text.empty() ? "" : "\n") + lost_side(std::size_t(h.idx()), std::size_t(f.idx()));
        expect_all(refusals_of(mesh), text);

        mesh = good;
        mesh.delete_face(f);
        EXPECT_EQ(kith::refine(mesh, kith::loop(), 1).n_faces(), 12U);
        kith::hierarchy<tri_mesh, kith::loop> levels(mesh, kith::loop());
        levels.refine(1);
        EXPECT_EQ(levels[1].n_faces(), 12U);
    }
    for (const auto e : good.edges()) {
        auto mesh = good;
        mesh.status(e).set_deleted(true);
        const auto faces = std::minmax(
            {good.face_handle(good.halfedge_handle(e, 0)).idx(), good.face_handle(good.halfedge_handle(e, 1)).idx()});
        const std::string removed_edge = ": one of its edges has been removed; remove the face, too";
        expect_all(refusals_of(mesh),
                   "face " + std::to_string(faces.first) + removed_edge + "\nface " + std::to_string(faces.second) +
                       removed_edge);
    }
    for (const auto v : good.vertices()) {
        auto mesh = good;
        mesh.status(v).set_deleted(true);
        const auto told = refusals_of(mesh);
        EXPECT_NE(told.refine.find(": one of its vertices has been removed; remove the face, too"), std::string::npos);
        expect_all(told, told.refine);
    }
    // A component whose elements are all marked as deleted is left out.
    auto mesh = with_status(shapes::both(shapes::tetrahedron(), shapes::tetrahedron()));
    for (int i = 0; i < 4; ++i) {
        mesh.status(OpenMesh::FaceHandle(i)).set_deleted(true);
        mesh.status(OpenMesh::VertexHandle(i)).set_deleted(true);
    }
    for (int i = 0; i < 6; ++i)
        mesh.status(OpenMesh::EdgeHandle(i)).set_deleted(true);
    const auto fine = kith::refine(mesh, kith::loop(), 2);
    kith::hierarchy<tri_mesh, kith::loop> levels(mesh, kith::loop());
    levels.refine(2);
    EXPECT_EQ(fine.n_faces(), 64U);
    ASSERT_EQ(fine.n_vertices(), levels[2].n_vertices());
    for (const auto v : fine.vertices())
        EXPECT_EQ(fine.point(v), levels[2].point(v));
}
