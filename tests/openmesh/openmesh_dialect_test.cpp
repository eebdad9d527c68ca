// SPDX-License-Identifier: BSD-3-Clause
// Compares kith::openmesh with OpenMesh::Subdivider::Uniform and with kith on its native mesh.
#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/openmesh_mesh.hpp"
#include "support/same_surface.hpp"

#include <kith/compiled_schemes.hpp>
#include <kith/make_creases.hpp>
#include <kith/openmesh_subdivision.hpp>

#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/MidpointT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3InterpolatingSubdividerLabsikGreinerT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>
// The next header is not self-contained: it needs the mesh headers above it.
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
namespace theirs = OpenMesh::Subdivider::Uniform;
namespace ours = kith::openmesh;

template <class M>
M make(const shapes::shape& s)
{
    return user_mesh<M>::make(s.points, s.faces);
}

template <class M>
surface surface_of(const M& m)
{
    surface result;
    std::vector<std::size_t> number(m.n_vertices());
    for (const auto v : kith::mesh_traits<M>::vertices(m)) {
        number[std::size_t(v.idx())] = result.points.size();
        result.points.push_back(coordinates(m.point(v)));
    }
    for (const auto f : kith::mesh_traits<M>::faces(m)) {
        result.faces.emplace_back();
        for (const auto v : m.fv_ccw_range(f))
            result.faces.back().push_back(number[std::size_t(v.idx())]);
    }
    return result;
}

/// Runs both subdividers, attached and in one call, one to three steps, and expects the same surfaces.
template <class Theirs, class Ours, class M, class Shapes, class Takes>
void expect_same_surfaces(const Shapes& shapes, const Takes& takes)
{
    for (const auto& [name, shape] : shapes) {
        if (shape.faces.size() > 100 or not takes(shape))
            continue;
        SCOPED_TRACE(name);
        for (std::size_t steps = 1; steps <= 3; ++steps) {
            M a = make<M>(shape), b = a, c = a;
            Theirs their_subdivider;
            if constexpr (requires { their_subdivider.init_weights(200); })
                their_subdivider.init_weights(200); // OpenMesh reads past the end of its default table
            Ours our_subdivider;
            EXPECT_TRUE(their_subdivider.attach(a) and their_subdivider(steps));
            their_subdivider.detach();
            EXPECT_TRUE(our_subdivider.attach(b) and our_subdivider(1) and our_subdivider(steps - 1));
            our_subdivider.detach();
            EXPECT_FALSE(our_subdivider(1));
            EXPECT_TRUE(Ours()(c, steps));
            EXPECT_EQ(user_mesh<M>::complaints(b), "");
            EXPECT_TRUE(same_bits(b, c));
            EXPECT_EQ(difference(surface_of(a), surface_of(b)), "") << steps << " steps";
        }
    }
}
bool is_closed(const shapes::shape& s)
{
    return kith::count(kith::make_mesh(s.points, s.faces).topology()).boundary_edges == 0;
}
const auto any = [](const shapes::shape&) { return true; };

/// Requests attributes of OpenMesh and adds a user's properties, on all kinds of elements.
template <class M>
void add_properties(M& mesh)
{
    mesh.request_vertex_colors(), mesh.request_face_colors(), mesh.request_vertex_normals(),
        mesh.request_face_normals();
    mesh.request_halfedge_texcoords2D();
    auto height = OpenMesh::getOrMakeProperty<VertexHandle, double>(mesh, "height");
    auto tag = OpenMesh::getOrMakeProperty<FaceHandle, std::string>(mesh, "tag");
    for (const auto v : mesh.vertices()) {
        height[v] = mesh.point(v)[2];
        mesh.set_color(v, typename M::Color(200, 10, 255));
    }
    for (const auto f : mesh.faces()) {
        tag[f] = "face " + std::to_string(f.idx());
        mesh.set_color(f, typename M::Color(f.idx(), 1, 2));
    }
    for (const auto e : mesh.edges())
        mesh.status(e).set_feature(e.idx() % 2 == 0);
    for (const auto h : mesh.halfedges())
        mesh.set_texcoord2D(h, {float(h.idx()), float(h.idx() % 5)});
}

/// Expects that subdividing in place carries the same values as a hierarchy of three levels.
template <class Subdivider, class M>
void expect_carried(M mesh)
{
    add_properties(mesh);
    const M control = mesh;
    const auto height = OpenMesh::getProperty<VertexHandle, double>(mesh, "height"); // made before, read after
    const auto tag = OpenMesh::getProperty<FaceHandle, std::string>(mesh, "tag");

    Subdivider subdivide;
    subdivide(mesh, 3);

    const auto scheme = subdivide.scheme();
    kith::hierarchy<M, std::remove_const_t<decltype(scheme)>> levels(control, scheme);
    levels.refine(3);
    M expected = levels[3];
    kith::carry_properties(levels, 0, 3, expected);
    const auto expected_height = OpenMesh::getProperty<VertexHandle, double>(expected, "height");
    const auto expected_tag = OpenMesh::getProperty<FaceHandle, std::string>(expected, "tag");
    EXPECT_EQ(user_mesh<M>::complaints(mesh), "");
    EXPECT_TRUE(same_bits(mesh, expected));
    const kith::level_of<M> ours(mesh), theirs(expected);
    ASSERT_EQ(ours.vertex_count(), theirs.vertex_count());
    for (std::size_t i = 0; i < ours.vertex_count(); ++i) {
        const auto v = ours.vertex_at(i), w = theirs.vertex_at(i);
        EXPECT_EQ(height[v], expected_height[w]);
        EXPECT_EQ(mesh.color(v), expected.color(w));
        EXPECT_EQ(mesh.status(v).bits(), 0U);
    }
    for (std::size_t i = 0; i < ours.face_count(); ++i) {
        const auto f = ours.face_at(i), g = theirs.face_at(i);
        EXPECT_EQ(tag[f], expected_tag[g]);
        EXPECT_EQ(mesh.color(f), expected.color(g));
        EXPECT_LT((mesh.normal(f) - mesh.calc_normal(f)).norm(), 1e-6);
    }
    for (std::size_t i = 0; i < ours.edge_count(); ++i)
        EXPECT_EQ(mesh.status(ours.edge_at(i)).feature(), expected.status(theirs.edge_at(i)).feature());
    for (std::size_t i = 0; i < ours.corner_count(); ++i) {
        const auto corner = [&](const auto& level, const auto& m) { // the half-edge that leads to the corner
            return kith::mesh_traits<M>::prev(m, level.corner_at(i).halfedge);
        };
        EXPECT_EQ(mesh.texcoord2D(corner(ours, mesh)), expected.texcoord2D(corner(theirs, expected)));
    }
}

/// Returns the native mesh of these elements in the number types for which all schemes are compiled.
template <class M>
kith::basic_mesh<> native_of(const M& mesh)
{
    const auto control = kith::to_native(mesh);
    kith::storage<std::array<double, 3>> points(control.vertex_count());
    for (std::size_t v = 0; v < points.size(); ++v)
        points[v] = coordinates(control.point(v));
    return {std::move(points), control.topology()};
}

/// Expects the bits of kith's native mesh, and the properties whose values can be checked without carrying them
/// otherwise.
template <class Subdivider, class M>
void expect_native_bits(M mesh)
{
    add_properties(mesh);
    const auto control = native_of(mesh);
    const auto height = OpenMesh::getProperty<VertexHandle, double>(mesh, "height");
    Subdivider subdivide;
    SCOPED_TRACE(subdivide.name());
    subdivide(mesh, 2);
    EXPECT_TRUE(same_bits(native_of(mesh), kith::refine(control, subdivide.scheme(), 2)));
    EXPECT_EQ(user_mesh<M>::complaints(mesh), "");
    for (const auto v : mesh.vertices()) {
        EXPECT_EQ(height[v], mesh.point(v)[2]);
        EXPECT_EQ(mesh.color(v), typename M::Color(200, 10, 255));
    }
}

} // namespace

TEST(openmesh_dialect, makes_openmeshs_surfaces)
{
    const auto triangles = shapes::triangle_shapes(), polygons = shapes::shapes_without_valence_two();
    expect_same_surfaces<theirs::LoopT<tri_mesh>, ours::LoopT<tri_mesh>, tri_mesh>(triangles, any);
    expect_same_surfaces<theirs::Sqrt3T<tri_mesh>, ours::Sqrt3T<tri_mesh>, tri_mesh>(triangles, any);
    expect_same_surfaces<theirs::ModifiedButterflyT<tri_mesh>, ours::ModifiedButterflyT<tri_mesh>, tri_mesh>(triangles,
                                                                                                             any);
    expect_same_surfaces<theirs::InterpolatingSqrt3LGT<tri_mesh>, ours::InterpolatingSqrt3LGT<tri_mesh>, tri_mesh>(
        triangles, is_closed);
    expect_same_surfaces<theirs::CatmullClarkT<poly_mesh>, ours::CatmullClarkT<poly_mesh>, poly_mesh>(
        shapes::all_shapes(), any);
    expect_same_surfaces<theirs::MidpointT<poly_mesh>, ours::MidpointT<poly_mesh>, poly_mesh>(polygons, is_closed);
}

TEST(openmesh_dialect, catmull_clark_without_new_positions_is_the_linear_split)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        poly_mesh a = make<poly_mesh>(shape), b = a;
        theirs::CatmullClarkT<poly_mesh>()(a, 2, false);
        ours::CatmullClarkT<poly_mesh>()(b, 2, false);
        EXPECT_EQ(difference(surface_of(a), surface_of(b)), "") << name;
    }
    // Other subdividers of OpenMesh leave new points at the origin or move old points; kith's keep old points.
    tri_mesh m = make<tri_mesh>(shapes::tetrahedron());
    const tri_mesh before = m;
    ours::LoopT<tri_mesh>()(m, 2, false);
    for (const auto v : before.vertices())
        EXPECT_EQ(m.point(v), before.point(v));
    // A new point on the first level is 3/8 of each end and 1/8 of each opposite vertex.
    tri_mesh one = before;
    ours::LoopT<tri_mesh>()(one, 1, false);
    const auto e = before.edge_handle(EdgeHandle(0).idx());
    const auto h = before.halfedge_handle(e, 0);
    const auto a = before.from_vertex_handle(h), b = before.to_vertex_handle(h);
    auto others = tri_mesh::Point(0, 0, 0);
    for (const auto v : before.vertices())
        if (v != a and v != b)
            others += before.point(v);
    const auto expected = 0.375 * (before.point(a) + before.point(b)) + 0.125 * others;
    EXPECT_LT((one.point(VertexHandle(4)) - expected).norm(), 1e-15);
}

TEST(openmesh_dialect, carries_everything)
{
    expect_carried<ours::LoopT<tri_mesh>>(make<tri_mesh>(shapes::umbrella(7)));
    expect_carried<ours::CatmullClarkT<poly_mesh>>(make<poly_mesh>(shapes::open_house()));
    expect_carried<ours::DooSabinT<poly_mesh>>(make<poly_mesh>(shapes::open_house()));

    expect_native_bits<ours::Sqrt3T<tri_mesh>>(make<tri_mesh>(shapes::umbrella(7)));
    expect_native_bits<ours::ModifiedButterflyT<tri_mesh>>(make<tri_mesh>(shapes::umbrella(7)));
    expect_native_bits<ours::InterpolatingSqrt3LGT<tri_mesh>>(make<tri_mesh>(shapes::tetrahedron()));
    expect_native_bits<ours::LinearTrianglesT<tri_mesh>>(make<tri_mesh>(shapes::umbrella(7)));
    expect_native_bits<ours::MidpointT<poly_mesh>>(make<poly_mesh>(shapes::cube()));
    expect_native_bits<ours::KobbeltT<poly_mesh>>(make<poly_mesh>(shapes::grid()));
    expect_native_bits<ours::QuadTriT<poly_mesh>>(make<poly_mesh>(shapes::open_house()));
    expect_native_bits<ours::NasriHasbiniT<poly_mesh>>(make<poly_mesh>(shapes::open_house()));
    expect_native_bits<ours::UnifiedT<poly_mesh>>(make<poly_mesh>(shapes::cube()));
    expect_native_bits<ours::LinearT<poly_mesh>>(make<poly_mesh>(shapes::open_house()));
}

TEST(openmesh_dialect, makes_normals_that_were_requested_without_those_of_faces)
{
    auto mesh = make<tri_mesh>(shapes::umbrella(7)), expected = mesh;
    mesh.request_vertex_normals();
    mesh.request_halfedge_normals();
    for (const auto v : mesh.vertices())
        mesh.set_normal(v, tri_mesh::Normal(9, 9, 9));
    expected.request_face_normals();
    expected.request_vertex_normals();
    expected.request_halfedge_normals();
    ours::LoopT<tri_mesh>()(mesh, 1);
    ours::LoopT<tri_mesh>()(expected, 1);
    EXPECT_FALSE(mesh.has_face_normals());
    for (const auto v : mesh.vertices())
        EXPECT_EQ(mesh.normal(v), expected.normal(v));
    for (const auto h : mesh.halfedges())
        EXPECT_EQ(mesh.normal(h), expected.normal(h));
    EXPECT_NEAR(mesh.normal(VertexHandle(0)).norm(), 1, 1e-12);
}

TEST(openmesh_dialect, leaves_deleted_elements_deleted)
{
    auto shape = shapes::both(shapes::tetrahedron(), shapes::cube());
    for (std::size_t v = 4; v < shape.points.size(); ++v)
        shape.points[v][0] -= 10;
    auto mesh = make<poly_mesh>(shape);
    for (int f = 0; f < 4; ++f)
        mesh.delete_face(FaceHandle(f), true);
    const poly_mesh control = mesh;
    expect_carried<ours::CatmullClarkT<poly_mesh>>(mesh);
    ours::CatmullClarkT<poly_mesh>()(mesh, 1);
    EXPECT_EQ(user_mesh<poly_mesh>::complaints(mesh), "");
    for (int v = 0; v < 4; ++v)
        EXPECT_TRUE(mesh.status(VertexHandle(v)).deleted());
    for (int v = 4; v < 12; ++v) // 5/9 of its corner of the cube
        EXPECT_NEAR(mesh.point(VertexHandle(v))[1], control.point(VertexHandle(v))[1] * 5 / 9, 1e-15);
    mesh.garbage_collection();
    EXPECT_EQ(mesh.n_vertices(), 26U);
}

TEST(openmesh_dialect, four_eight_starts_by_itself_and_goes_on)
{
    for (const auto& shape : {shapes::grid(), shapes::open_house(), shapes::umbrella(5)}) {
        poly_mesh once = make<poly_mesh>(shape), twice = once;
        const auto expected = kith::refine(kith::tri_quad(native_of(once)), kith::four_eight(), 3);
        ours::FourEightT<poly_mesh> subdivide;
        subdivide(once, 3);
        subdivide(twice, 1);
        subdivide(twice, 2);
        EXPECT_TRUE(same_bits(native_of(once), expected));
        EXPECT_TRUE(same_bits(once, twice));
    }
}

TEST(openmesh_dialect, creases_belong_to_the_attached_mesh)
{
    auto mesh = make<poly_mesh>(shapes::cube());
    for (const auto e : mesh.edges())
        mesh.status(e).set_feature(e.idx() < 4);
    const poly_mesh control = mesh;
    auto scheme = kith::like<kith::catmull_clark>(kith::library::openmesh);
    scheme.sharpness = kith::creases_from_features(control);
    ours::CatmullClarkT<poly_mesh> subdivide(scheme);
    subdivide.attach(mesh);
    subdivide(1);
    subdivide(1);
    EXPECT_EQ(subdivide.scheme().sharpness.edges().size(), 16U);
    EXPECT_TRUE(same_bits(native_of(mesh), kith::refine(native_of(control), scheme, 2)));
}

TEST(openmesh_dialect, can_be_stopped_and_refuses)
{
    auto mesh = make<tri_mesh>(shapes::tetrahedron());
    const tri_mesh before = mesh;
    ours::LoopT<tri_mesh> subdivide(mesh);
    EXPECT_EQ(subdivide.name(), std::string("loop"));
    std::vector<double> told;
    subdivide.on_progress([&](double done) {
        told.push_back(done);
        return told.size() < 2;
    });
    EXPECT_FALSE(subdivide(3));
    EXPECT_EQ(told, (std::vector<double>{16. / 336, 80. / 336}));
    EXPECT_TRUE(same_bits(mesh, before));

    auto open = make<tri_mesh>(shapes::umbrella(5));
    const tri_mesh control = open;
    EXPECT_NE(error_text<kith::mesh_error>([&] { ours::InterpolatingSqrt3LGT<tri_mesh>()(open, 1); }), "no error");
    EXPECT_TRUE(same_bits(open, control));
}

TEST(openmesh_dialect, faces_that_a_scheme_does_not_take_have_the_numbers_of_their_handles)
{
    using mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
    auto m = make<mesh>(shapes::both(shapes::tetrahedron(), shapes::cube()));
    m.request_vertex_status();
    m.request_edge_status();
    m.request_face_status();
    for (int f = 0; f < 4; ++f)
        m.delete_face(FaceHandle(f));
    const mesh before = m;
    EXPECT_EQ(error_text<kith::mesh_error>([&] { ours::LoopT<mesh>()(m, 1); }),
              "loop: face 4 has 4 vertices; triangulate the mesh first");
    EXPECT_TRUE(same_bits(m, before));
}

TEST(openmesh_dialect, what_a_later_step_does_not_take_has_the_number_of_its_handle)
{
    using mesh = OpenMesh::TriMesh_ArrayKernelT<>;
    auto m = make<mesh>(shapes::both(shapes::tetrahedron(), shapes::triangulated(shapes::grid(1, 1))));
    m.request_vertex_status();
    m.request_edge_status();
    m.request_face_status();
    ours::Sqrt3T<mesh> sqrt3;
    sqrt3.attach(m);
    sqrt3(1);
    for (int f = 0; f < 12; ++f) // the faces of the tetrahedron
        m.delete_face(FaceHandle(f));
    m.delete_face(FaceHandle(17)); // a neighbour now has two boundary edges
    const auto text = error_text<kith::mesh_error>([&] { sqrt3(1); });
    EXPECT_NE(text.find("face 15 has 2 boundary edges"), std::string::npos) << text;
}
