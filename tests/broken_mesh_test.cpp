// SPDX-License-Identifier: BSD-3-Clause
// Meshes of CGAL and OpenMesh that were joined by hand, and not well: whatever reads them refuses them.
#include <CGAL/Simple_cartesian.h>

#include "cgal_mesh.hpp"
#include "error_text.hpp"
#include "openmesh_mesh.hpp"
#include "shapes.hpp"

#include <kith/cgal_subdivision.hpp>
#include <kith/crease/make_creases.hpp>
#include <kith/hierarchy.hpp>
#include <kith/openmesh_subdivision.hpp>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
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

/// What is said of a mesh, by all that reads one.
struct refusals {
    std::string refine, report, hierarchy, dialect;
};
template <class F>
std::string refusal(const F& f)
{
    return error_text<kith::mesh_error>(f);
}
template <class M, class Dialect>
refusals refusals_of(const M& mesh, const Dialect& dialect)
{
    return {refusal([&] { kith::refine(mesh, kith::loop(), 1); }),
            refusal([&] { kith::validate(mesh).require_ok(); }),
            refusal([&] { kith::hierarchy<M, kith::loop>(mesh, kith::loop()).refine(1); }),
            refusal([&] {
                M copy = mesh;
                dialect(copy);
            })};
}
refusals refusals_of(const cgal_mesh& mesh)
{
    EXPECT_NE(refusal([&] { kith::creases_by_angle(mesh, 30); }), "no error");
    return refusals_of(mesh, [](auto& copy) { kith::cgal::Loop_subdivision(copy, 1); });
}
refusals refusals_of(const tri_mesh& mesh)
{
    EXPECT_NE(refusal([&] { kith::creases_by_angle(mesh, 30); }), "no error");
    return refusals_of(mesh, [](auto& copy) { kith::openmesh::LoopT<tri_mesh>()(copy, 1); });
}
void expect_all(const refusals& told, const std::string& text)
{
    EXPECT_EQ(told.refine, text);
    EXPECT_EQ(told.report, text);
    EXPECT_EQ(told.hierarchy, text);
    EXPECT_EQ(told.dialect, text);
}

/// A mask that is not asked for anything.
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

const std::string open_face = ": its half-edges do not lead back to the first; join them anew or remove the face";

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

    // What walks along half-edges in the order of corners comes to an end, too.
    std::size_t met = 0;
    kith::detail::for_each_handle<halfedge>(theirs, [&](halfedge) { ++met; });
    EXPECT_LE(met, 4 * theirs.number_of_halfedges());
}

TEST(broken_mesh, a_face_of_a_removed_vertex)
{
    for (const std::size_t removed : {3U, 1U}) {
        auto mesh = cgal(shapes::tetrahedron());
        mesh.remove_vertex(vertex(cgal_mesh::size_type(removed)));
        const auto told = refusals_of(mesh);
        const std::string text = std::string(removed == 3 ? "face 1" : "face 0") +
                                 ": one of its vertices has been removed; repair the mesh";
        EXPECT_EQ(told.refine, text);
        EXPECT_EQ(told.hierarchy, text);
        EXPECT_EQ(told.dialect, text);
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

TEST(broken_mesh, a_face_of_a_removed_edge)
{
    for (cgal_mesh::size_type removed = 0; removed < 6; ++removed) {
        auto mesh = cgal(shapes::tetrahedron());
        mesh.remove_edge(edge(removed));
        const std::string of_face = "face " + std::to_string(std::size_t(mesh.face(halfedge(2 * removed))));
        const auto told = refusals_of(mesh);
        EXPECT_EQ(told.refine, of_face + open_face);
        EXPECT_EQ(told.report, of_face + open_face);
        EXPECT_EQ(told.hierarchy, of_face + open_face);
        EXPECT_NE(told.dialect.find(of_face + open_face), std::string::npos) << told.dialect;
    }
    // Where the half-edges lead around all faces still.
    auto mesh = cgal(shapes::tetrahedron());
    const auto next = mesh.next(halfedge(6));
    mesh.remove_edge(edge(3));
    mesh.set_next(halfedge(6), next);
    const auto told = refusals_of(mesh);
    const auto faces = {std::size_t(mesh.face(halfedge(6))), std::size_t(mesh.face(halfedge(7)))};
    const std::string text = "face " + std::to_string(std::min(faces)) +
                             ": one of its edges has been removed; repair the mesh";
    EXPECT_EQ(told.refine, text);
    EXPECT_EQ(told.hierarchy, text);
    EXPECT_EQ(told.dialect, text);
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
              "vertex 2: its half-edge leads to none of its faces; give it one that leaves it in a face");
}

TEST(broken_mesh, a_vertex_that_starts_at_a_half_edge_of_another)
{
    auto open = shapes::tetrahedron();
    open.faces.pop_back();
    for (const auto& shape : {shapes::tetrahedron(), open}) {
        const auto says = [](std::size_t h, std::size_t of) {
            return "vertex 2: its half-edge " + std::to_string(h) + " leaves vertex " + std::to_string(of) +
                   "; give it one that leaves it in a face";
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
               "vertex 2: its half-edge leads to none of its faces; give it one that leaves it in a face");
}

const std::string unjoined =
    ": its half-edges do not all name it as their face and come before their next; join them anew or "
    "remove the face";

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
            for (int i = 0; i < 3; ++i) // the sum begins elsewhere
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
           ", which has been removed or does not come to it; let it have no face, as the library's own function that "
           "removes a face does";
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
    for (const auto f : good.faces()) { // its half-edges name it still
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
        const auto faces = {good.face_handle(good.halfedge_handle(e, 0)).idx(),
                            good.face_handle(good.halfedge_handle(e, 1)).idx()};
        const auto text = "face " + std::to_string(std::min(faces)) +
                          ": one of its edges has been removed; repair the mesh";
        const auto told = refusals_of(mesh);
        EXPECT_EQ(told.refine, text);
        EXPECT_EQ(told.hierarchy, text);
        EXPECT_EQ(told.dialect, text);
    }
    for (const auto v : good.vertices()) {
        auto mesh = good;
        mesh.status(v).set_deleted(true);
        const auto told = refusals_of(mesh);
        EXPECT_NE(told.refine.find(": one of its vertices has been removed; repair the mesh"), std::string::npos);
        EXPECT_EQ(told.hierarchy, told.refine);
        EXPECT_EQ(told.dialect, told.refine);
    }
    // A component that is marked as a whole has gone, however that was said.
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
