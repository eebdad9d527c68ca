// SPDX-License-Identifier: BSD-3-Clause
// Refines meshes of OpenMesh that have their own traits and values of many types, in place.
#include "support/failing_allocations.hpp"
#include "support/openmesh_mesh.hpp"
#include "support/property_names.hpp"
#include "support/same_surface.hpp"
#include "support/shapes.hpp"

#include <kith/openmesh_subdivision.hpp>

#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LongestEdgeT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/MidpointT.hh>

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
using names = std::vector<std::string>;

struct own_traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
    FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Color);
    EdgeAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D);
    VertexTraits { int id = -7; };
    HalfedgeTraits { int side = -7; };
    EdgeTraits { int kind = -7; };
    FaceTraits { std::string tag = "a name that is too long for no allocation"; };
};
struct own_triangles : OpenMesh::TriMesh_ArrayKernelT<own_traits> {
    std::string author;
};
using own_polygons = OpenMesh::PolyMesh_ArrayKernelT<own_traits>;

struct material {
    int id = -1;
    friend bool operator==(const material&, const material&) = default;
};
struct list {
    std::vector<int> numbers;
    friend bool operator==(const list&, const list&) = default;
};

/// Returns a value of any type that stands for the number n.
template <class T>
T value_of(int n)
{
    if constexpr (std::same_as<T, std::string>)
        return "a name that is too long for no allocation " + std::to_string(n);
    else if constexpr (std::same_as<T, list>)
        return {{n, n + 1}};
    else if constexpr (std::same_as<T, material>)
        return T{n};
    else if constexpr (std::same_as<T, bool>)
        return n % 3 == 0;
    else
        return T(n);
}
template <class F>
void for_each_type(const F& f)
{
    f("my int", std::type_identity<int>());
    f("my bool", std::type_identity<bool>());
    f("my string", std::type_identity<std::string>());
    f("my material", std::type_identity<material>());
    f("my list", std::type_identity<list>());
}

template <class M>
M make(const shapes::shape& shape)
{
    M result;
    for (const auto& [x, y, z] : shape.points)
        result.add_vertex({x, y, z});
    for (const auto& corners : shape.faces) {
        std::vector<VertexHandle> handles;
        for (const std::size_t v : corners)
            handles.emplace_back(int(v));
        result.add_face(handles);
    }
    return result;
}
template <class Handle, class M, class Range>
void add_maps(M& m, const Range& elements)
{
    for_each_type([&]<class T>(const char* name, std::type_identity<T>) {
        auto map = OpenMesh::getOrMakeProperty<Handle, T>(m, name);
        for (const auto x : elements)
            map[x] = value_of<T>(x.idx());
    });
}
template <class M>
void add_values(M& m)
{
    add_maps<VertexHandle>(m, m.vertices()), add_maps<HalfedgeHandle>(m, m.halfedges());
    add_maps<EdgeHandle>(m, m.edges()), add_maps<FaceHandle>(m, m.faces());
    auto height = OpenMesh::getOrMakeProperty<VertexHandle, double>(m, "height");
    for (const auto v : m.vertices())
        m.data(v).id = v.idx(), height[v] = m.point(v)[2];
    for (const auto h : m.halfedges())
        m.data(h).side = h.idx(), m.set_texcoord2D(h, {float(h.idx()), 1});
    for (const auto e : m.edges())
        m.data(e).kind = e.idx(), m.status(e).set_feature(e.idx() % 2 == 0);
    for (const auto f : m.faces())
        m.data(f).tag = value_of<std::string>(f.idx()), m.set_color(f, {f.idx(), 1, 2});
}

template <class M>
surface surface_of(const M& m)
{
    surface result;
    for (const auto v : m.vertices())
        result.points.push_back({m.point(v)[0], m.point(v)[1], m.point(v)[2]});
    for (const auto f : m.faces()) {
        result.faces.emplace_back();
        for (const auto v : m.fv_ccw_range(f))
            result.faces.back().push_back(std::size_t(v.idx()));
    }
    return result;
}

/// Returns a text with all that is visible of a mesh; points are exact to the bit.
template <class M>
std::string text_of(M& m)
{
    std::string result;
    const auto height = OpenMesh::getProperty<VertexHandle, double>(m, "height");
    const auto on_faces = OpenMesh::getProperty<FaceHandle, list>(m, "my list");
    const auto at_vertices = OpenMesh::getProperty<VertexHandle, list>(m, "my list");
    for (const auto v : m.vertices()) {
        const auto& p = m.point(v);
        char line[199];
        std::snprintf(line, sizeof line, "v%d %a %a %a %a %d\n", v.idx(), p[0], p[1], p[2], height[v], m.data(v).id);
        result += line + std::to_string(at_vertices[v].numbers.size());
    }
    for (const auto f : m.faces()) {
        for (const auto h : m.fh_range(f))
            result += std::to_string(h.to().idx()) + "," + std::to_string(m.texcoord2D(h)[0]) + "," +
                      std::to_string(m.data(h).side) + " ";
        result += m.data(f).tag + std::to_string(m.color(f)[0]) + "," +
                  std::to_string(on_faces[f].numbers.empty() ? -1 : on_faces[f].numbers[0]) + "\n";
    }
    for (const auto e : m.edges())
        result += std::to_string(m.data(e).kind) + (m.status(e).feature() ? "f " : " ");
    return result;
}

} // namespace

TEST(openmesh_in_place, values_of_all_types_and_items_of_traits_stay_with_what_comes_from_their_element)
{
    auto m = make<own_triangles>(shapes::both(shapes::tetrahedron(), shapes::umbrella(6)));
    m.author = "me";
    add_values(m);
    const own_triangles control = m;
    const auto height = OpenMesh::getProperty<VertexHandle, double>(m, "height");
    kith::openmesh::LoopT<own_triangles> loop;
    EXPECT_TRUE(loop(m, 2));
    EXPECT_EQ(m.author, "me");
    EXPECT_EQ(names_of(loop.report().left_out),
              (names{"<vprop>", "my material", "my list", "<hprop>", "my material", "my list"}));

    kith::hierarchy levels(control, loop.scheme());
    levels.refine(2);
    ASSERT_EQ(m.n_faces(), levels[2].n_faces());
    for (const auto v : m.vertices()) {
        EXPECT_EQ(m.point(v), levels[2].point(v));
        EXPECT_EQ(height[v], m.point(v)[2]);
        EXPECT_EQ(m.data(v).id, std::size_t(v.idx()) < control.n_vertices() ? v.idx() : -7);
    }
    for (const auto f : m.faces())
        EXPECT_EQ(m.data(f).tag, control.data(*levels.ancestor(2, f, 0).f).tag);
    for (const auto e : m.edges()) {
        const auto from = levels.ancestor(2, e, 0).e;
        EXPECT_EQ(m.data(e).kind, from ? from->idx() : -7);
        EXPECT_EQ(m.status(e).feature(), from and from->idx() % 2 == 0);
    }
    const auto numbers = OpenMesh::getProperty<HalfedgeHandle, int>(m, "my int");
    for_each_type([&]<class T>(const char* name, std::type_identity<T>) {
        SCOPED_TRACE(name);
        const auto on_faces = OpenMesh::getProperty<FaceHandle, T>(m, name);
        for (const auto f : m.faces())
            EXPECT_EQ(on_faces[f], value_of<T>(levels.ancestor(2, f, 0).f->idx()));
        const auto on_edges = OpenMesh::getProperty<EdgeHandle, T>(m, name);
        for (const auto e : m.edges()) {
            const auto from = levels.ancestor(2, e, 0).e;
            EXPECT_EQ(on_edges[e], from ? value_of<T>(from->idx()) : T());
        }
        const auto at_vertices = OpenMesh::getProperty<VertexHandle, T>(m, name);
        for (const auto v : m.vertices())
            EXPECT_EQ(at_vertices[v], std::size_t(v.idx()) < control.n_vertices() ? value_of<T>(v.idx()) : T());
        const auto at_corners = OpenMesh::getProperty<HalfedgeHandle, T>(m, name);
        for (const auto h : m.halfedges()) {
            const auto from = levels.ancestor(2, m.edge_handle(h), 0).e;
            if (m.is_boundary(h) or not from) {
                EXPECT_EQ(at_corners[h], T());
                EXPECT_EQ(m.data(h).side, -7);
            } else {
                const HalfedgeHandle first = control.halfedge_handle(*from, 0);
                const bool is_first = not control.is_boundary(first) and
                                      control.face_handle(first) == *levels.ancestor(2, m.face_handle(h), 0).f;
                const HalfedgeHandle old = is_first ? first : control.opposite_halfedge_handle(first);
                EXPECT_EQ(at_corners[h], value_of<T>(old.idx()));
                EXPECT_EQ(m.data(h).side, old.idx());
            }
        }
    });
}

TEST(openmesh_in_place, an_object_is_one_of_openmeshs_base_class)
{
    using base = OpenMesh::Subdivider::Uniform::SubdividerT<own_triangles, double>;
    const std::unique_ptr<base> loop = std::make_unique<kith::openmesh::LoopT<own_triangles>>();
    EXPECT_STREQ(loop->name(), "loop");
    auto m = make<own_triangles>(shapes::tetrahedron());
    EXPECT_FALSE((*loop)(1));
    EXPECT_TRUE(loop->attach(m) and (*loop)(1) and (*loop)(1));
    loop->detach();
    EXPECT_EQ(m.n_faces(), 64U);
    EXPECT_TRUE((*loop)(m, 1));
    EXPECT_EQ(m.n_faces(), 256U);

    // Steps of sqrt(3) at a boundary are counted from attach() on, also if called through the base class.
    const auto umbrella = make<own_triangles>(shapes::umbrella(7));
    own_triangles a = umbrella, b = umbrella, c = umbrella;
    kith::openmesh::Sqrt3T<own_triangles> sqrt3;
    base& through_base = sqrt3;
    sqrt3(a, 2);
    EXPECT_TRUE(through_base.attach(b) and through_base(1) and through_base(1));
    through_base.detach();
    EXPECT_TRUE(through_base(c, 2));
    EXPECT_TRUE(same_bits(a, b));
    EXPECT_TRUE(same_bits(a, c));
}

TEST(openmesh_in_place, long_edges_are_split_as_openmesh_does)
{
    auto m = make<own_triangles>(shapes::shaken(shapes::umbrella(7)));
    add_values(m);
    auto theirs = m;
    const own_triangles control = m;
    const auto height = OpenMesh::getProperty<VertexHandle, double>(m, "height");
    const auto ids = OpenMesh::getProperty<FaceHandle, int>(m, "my int");
    OpenMesh::Subdivider::Uniform::LongestEdgeT<own_triangles, double> their_split;
    their_split.set_max_edge_length(0.3);
    EXPECT_TRUE(their_split(theirs, 1));
    kith::openmesh::LongestEdgeT<own_triangles, double> split;
    EXPECT_TRUE(split(m, 1));
    EXPECT_EQ(m.n_faces(), control.n_faces()); // no maximal length is set yet
    split.set_max_edge_length(0);
    EXPECT_THROW(split(m, 1), kith::mesh_error);
    split.set_max_edge_length(0.3);
    EXPECT_TRUE(split.attach(m) and split(1));
    split.detach();
    EXPECT_EQ(difference(surface_of(m), surface_of(theirs)), "");
    EXPECT_GT(m.n_faces(), 5 * control.n_faces());
    for (const auto e : m.edges()) {
        EXPECT_LE(m.calc_edge_length(e), 0.3);
        EXPECT_TRUE(m.data(e).kind == -7 or m.status(e).feature() == (m.data(e).kind % 2 == 0));
    }
    for (const auto v : m.vertices())
        EXPECT_NEAR(height[v], m.point(v)[2], 1e-12);
    for (const auto f : m.faces()) {
        EXPECT_EQ(m.data(f).tag, value_of<std::string>(ids[f]));
        const auto parent = FaceHandle(ids[f]);
        EXPECT_GT(dot(m.calc_face_normal(f), control.calc_face_normal(parent)), 0.999999);
    }
    // Corners of old vertices keep their values; a boundary edge keeps its kind on all its parts.
    for (const auto h : m.halfedges())
        if (not m.is_boundary(h) and std::size_t(m.to_vertex_handle(h).idx()) < control.n_vertices()) {
            const auto parent = FaceHandle(ids[m.face_handle(h)]);
            for (const auto old : control.fh_range(parent))
                if (old.to().idx() == m.to_vertex_handle(h).idx()) {
                    EXPECT_EQ(m.texcoord2D(h), control.texcoord2D(old));
                }
        }
    for (const auto e : m.edges())
        if (m.is_boundary(e)) {
            EXPECT_TRUE(control.is_boundary(EdgeHandle(m.data(e).kind)));
        }
}

TEST(openmesh_in_place, midpoints_of_triangles_are_cut_into_triangles)
{
    auto m = make<own_triangles>(shapes::tetrahedron());
    add_values(m);
    const own_triangles control = m;
    auto theirs = control;
    kith::openmesh::MidpointT<own_triangles>()(m, 1);
    OpenMesh::Subdivider::Uniform::MidpointT<own_triangles>()(theirs, 1);
    EXPECT_EQ(difference(surface_of(m), surface_of(theirs)), ""); // an octahedron: no face has more corners
    const auto ids = OpenMesh::getProperty<FaceHandle, int>(m, "my int");
    const auto height = OpenMesh::getProperty<VertexHandle, double>(m, "height");
    for (const auto f : m.faces())
        if (std::size_t(f.idx()) < control.n_faces()) {
            EXPECT_EQ(m.data(f).tag, value_of<std::string>(ids[f]));
        }
    kith::openmesh::MidpointT<own_triangles> midpoints;
    EXPECT_TRUE(midpoints.attach(m) and midpoints(1)); // a vertex of valence 4 makes two triangles
    midpoints.detach();
    EXPECT_EQ(m.n_vertices(), 12U);
    EXPECT_EQ(m.n_faces(), 8 + 6 * 2U);
    for (const auto v : m.vertices())
        EXPECT_EQ(height[v], m.point(v)[2]);
    for (const auto f : m.faces())
        EXPECT_EQ(m.valence(f), 3U);
}

TEST(openmesh_in_place, isolated_vertices_and_meshes_without_faces_stay_as_they_are)
{
    kith::openmesh::LoopT<own_triangles> loop;
    own_triangles empty;
    EXPECT_TRUE(loop(empty, 2));
    empty.add_vertex({1, 2, 3});
    EXPECT_TRUE(loop(empty, 2));
    EXPECT_EQ(empty.n_vertices(), 1U);

    auto shape = shapes::tetrahedron();
    shape.points.push_back({7, 8, 9});
    auto m = make<own_triangles>(shape), expected = make<own_triangles>(shapes::tetrahedron());
    m.data(VertexHandle(4)).id = 5;
    loop(m, 2), loop(expected, 2);
    ASSERT_EQ(m.n_vertices(), expected.n_vertices() + 1);
    EXPECT_EQ(m.point(VertexHandle(4)), own_traits::Point(7, 8, 9));
    EXPECT_EQ(m.data(VertexHandle(4)).id, 5);
    EXPECT_TRUE(m.is_isolated(VertexHandle(4)));
    for (const auto v : expected.vertices())
        EXPECT_EQ(m.point(VertexHandle(v.idx() < 4 ? v.idx() : v.idx() + 1)), expected.point(v));
    EXPECT_THROW(kith::refine(m, kith::loop(), 1), kith::mesh_error);
}

TEST(openmesh_in_place, rules_and_types_are_named_as_in_carry_properties)
{
    auto m = make<own_polygons>(shapes::cube());
    auto area = OpenMesh::getOrMakeProperty<FaceHandle, double>(m, "area");
    auto other = OpenMesh::getOrMakeProperty<FaceHandle, double>(m, "other");
    for (const auto f : m.faces())
        area[f] = 4, other[f] = 3;
    OpenMesh::getOrMakeProperty<VertexHandle, list>(m, "list");
    kith::openmesh::CatmullClarkT<own_polygons> subdivide;
    subdivide(m,
              2,
              true,
              kith::by_rule<FaceHandle, double>("area", kith::from_parent{[](double x) { return x / 4; }}),
              kith::by_rule<FaceHandle, float>("other", kith::from_parent()),
              kith::value_types<list>());
    ASSERT_EQ(names_of(subdivide.report().left_out), (names{"<vprop>", "<hprop>", "other"}));
    EXPECT_NE(subdivide.report().left_out[2].why.find("with a type that it does not have"), std::string::npos);
    for (const auto f : m.faces()) {
        EXPECT_EQ(area[f], 0.25);
        EXPECT_EQ(other[f], 3);
    }
}

namespace {

template <class Subdivider, class M>
void expect_old_or_new(M control)
{
    M done = control;
    Subdivider()(done, 1);
    const std::string before = text_of(control), after = text_of(done);
    EXPECT_NE(before, after);
    M m = control;
    long thrown = 0;
    failing_allocations::try_all([&] { m = control; },
                                 [&] { Subdivider()(m, 1); },
                                 [&](const failing_allocations::trial& trial) {
                                     SCOPED_TRACE(trial.text());
                                     thrown += trial.has_thrown;
                                     EXPECT_EQ(trial.other, "");
                                     EXPECT_TRUE(text_of(m) == (trial.has_thrown ? before : after));
                                 });
    EXPECT_GT(thrown, 100);
}

} // namespace

TEST(openmesh_in_place, a_mesh_is_as_it_was_when_memory_ends)
{
    auto m = make<own_polygons>(shapes::both(shapes::grid(1, 1), shapes::grid(1, 2)));
    add_values(m);
    m.request_halfedge_status();
    m.delete_face(FaceHandle(0));
    expect_old_or_new<kith::openmesh::CatmullClarkT<own_polygons>>(m);
    expect_old_or_new<kith::openmesh::DooSabinT<own_polygons>>(m);

    auto triangles = make<own_triangles>(shapes::umbrella(5));
    add_values(triangles);
    struct split : kith::openmesh::LongestEdgeT<own_triangles> {
        split() { set_max_edge_length(1.1); }
    };
    expect_old_or_new<split>(triangles);
}
