// SPDX-License-Identifier: BSD-3-Clause
// Refines Surface_mesh, and classes derived from it with values of many types, in place.
#include "support/failing_allocations.hpp"
#include "support/forced_way.hpp"
#include "support/property_names.hpp"
#include "support/shapes.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <kith/cgal_subdivision.hpp>
#include <kith/hierarchy.hpp>
#include <kith/refine_with_fields.hpp>
#include <kith/schemes/split/quad_split.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using point = kernel::Point_3;
using base = CGAL::Surface_mesh<point>;
using vertex = base::Vertex_index;
using edge = base::Edge_index;
using face = base::Face_index;
using halfedge = base::Halfedge_index;
using names = std::vector<std::string>;

struct own_mesh : base {
    std::string author = "unknown";
};

struct material {
    int id = -1;
    friend bool operator==(const material&, const material&) = default;
};
/// A value type that has a mean, but is not coordinates.
struct reading {
    double celsius = -300;
    friend bool operator==(const reading&, const reading&) = default;
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
    else if constexpr (std::same_as<T, CGAL::IO::Color>)
        return {static_cast<unsigned char>(n), 7, 9, 255};
    else if constexpr (std::same_as<T, point> or std::same_as<T, kernel::Vector_3>)
        return {double(n), 1, 2};
    else if constexpr (std::same_as<T, material> or std::same_as<T, reading>)
        return T{n};
    else if constexpr (std::same_as<T, bool>)
        return n % 3 == 0;
    else
        return T(n);
}

/// Returns the value of a new element that inherits none: the default of the map, or zero for points and vectors.
template <class T>
T new_value()
{
    if constexpr (std::same_as<T, point> or std::same_as<T, kernel::Vector_3>)
        return {0, 0, 0};
    else
        return value_of<T>(200);
}

template <class Mesh>
Mesh make(const shapes::shape& shape)
{
    Mesh result;
    for (const auto& [x, y, z] : shape.points)
        result.add_vertex(point(x, y, z));
    for (const auto& corners : shape.faces) {
        std::vector<vertex> handles;
        for (const std::size_t v : corners)
            handles.emplace_back(std::uint32_t(v));
        result.add_face(handles);
    }
    return result;
}
shapes::shape two_tetrahedra()
{
    auto result = shapes::both(shapes::tetrahedron(), shapes::tetrahedron());
    for (std::size_t v = 4; v < result.points.size(); ++v)
        result.points[v][0] += 10;
    return result;
}

template <class Handle, class T>
auto map_of(const base& m, const char* name)
{
    const auto found = m.property_map<Handle, T>(name);
    if constexpr (requires { found.has_value(); }) // since CGAL 6
        return found.value();
    else
        return found.first;
}

/// Calls f(name, type) for a map of each type.
template <class F>
void for_each_type(const F& f)
{
    f("float", std::type_identity<float>());
    f("int", std::type_identity<int>());
    f("bool", std::type_identity<bool>());
    f("string", std::type_identity<std::string>());
    f("material", std::type_identity<material>());
    f("list", std::type_identity<list>());
    f("point", std::type_identity<point>());
    f("vector", std::type_identity<kernel::Vector_3>());
    f("color", std::type_identity<CGAL::IO::Color>());
}
template <class Handle, class Range>
void add_maps(base& m, const Range& elements)
{
    for_each_type([&]<class T>(const char* name, std::type_identity<T>) {
        auto map = m.add_property_map<Handle, T>(name, value_of<T>(200)).first;
        for (const Handle x : elements)
            map[x] = value_of<T>(int(x.idx()));
    });
}

/// A mask that must not be called.
struct no_mask {
    template <class Element>
    void face_node(Element, point&)
    {
        ADD_FAILURE();
    }
    void edge_node(halfedge, point&) { ADD_FAILURE(); }
    void vertex_node(vertex, point&) { ADD_FAILURE(); }
    void border_node(halfedge, point&, point&) { ADD_FAILURE(); }
};

/// Returns a text with all that is visible of a mesh; points are exact to the bit.
std::string text_of(const base& m)
{
    std::string result;
    for (const auto v : m.vertices()) {
        char line[99];
        std::snprintf(line, sizeof line, "v%u %a %a %a\n", unsigned(v), m.point(v).x(), m.point(v).y(), m.point(v).z());
        result += line;
    }
    for (const auto f : m.faces())
        for (const auto v : CGAL::vertices_around_face(m.halfedge(f), m))
            result += "f" + std::to_string(f) + " " + std::to_string(v) + "\n";
    const auto add = [&]<class Handle, class T>(const char* name, const auto& elements, Handle, T) {
        const auto map = map_of<Handle, T>(m, name);
        for (const Handle x : elements)
            result += name + std::to_string(x.idx()) + (map[x] == value_of<T>(200) ? " default" : "") + "\n";
    };
    add("int", m.edges(), edge(), int());
    add("string", m.faces(), face(), std::string());
    add("material", m.faces(), face(), material());
    add("list", m.faces(), face(), list());
    add("list", m.vertices(), vertex(), list());
    add("color", m.halfedges(), halfedge(), CGAL::IO::Color());
    return result + (m.is_valid(false) ? "valid" : "broken") + std::to_string(m.number_of_removed_vertices()) + "/" +
           std::to_string(m.number_of_removed_edges()) + "/" + std::to_string(m.number_of_removed_faces());
}

} // namespace

/// The arithmetic by which kith averages `reading`.
template <>
struct kith::affine<reading> {
    using scalar = double;
    using sum = double;
    static sum load(const reading& r) { return r.celsius; }
    static reading store(sum total) { return {total}; }
    static void add(sum& total, sum more) { total += more; }
    static void scale(sum& total, double weight) { total *= weight; }
};

TEST(cgal_in_place, values_of_all_types_stay_with_what_comes_from_their_element)
{
    auto m = make<own_mesh>(two_tetrahedra());
    m.author = "me";
    const base control = m;
    add_maps<vertex>(m, m.vertices()), add_maps<edge>(m, m.edges()), add_maps<face>(m, m.faces());
    add_maps<halfedge>(m, m.halfedges());
    auto place = map_of<vertex, point>(m, "point");
    auto height = map_of<vertex, float>(m, "float");
    for (const auto v : m.vertices())
        place[v] = m.point(v), height[v] = float(m.point(v).z());

    const auto report = kith::cgal::Loop_subdivision(m, 2);
    EXPECT_EQ(names_of(report.left_out), (names{"material", "list", "material", "list"})); // new vertices, corners
    EXPECT_NE(report.left_out[0].why.find("value_types<type>()"), std::string::npos);
    EXPECT_EQ(report.carried.size(), 4 * 9 - 4U);
    EXPECT_EQ(m.author, "me");
    EXPECT_TRUE(m.is_valid(false));

    const auto scheme = kith::like<kith::loop>(kith::library::cgal);
    kith::hierarchy levels(control, scheme);
    levels.refine(2);
    ASSERT_EQ(m.number_of_faces(), levels[2].number_of_faces());
    for_each_type([&]<class T>(const char* name, std::type_identity<T>) {
        SCOPED_TRACE(name);
        const auto on_faces = map_of<face, T>(m, name);
        for (const auto f : m.faces())
            EXPECT_EQ(on_faces[f], value_of<T>(int(levels.ancestor(2, f, 0).f->idx())));
        const auto on_edges = map_of<edge, T>(m, name);
        for (const auto e : m.edges()) {
            const auto from = levels.ancestor(2, e, 0).e;
            EXPECT_EQ(on_edges[e], from ? value_of<T>(int(from->idx())) : new_value<T>());
        }
        const auto at_vertices = map_of<vertex, T>(m, name);
        if constexpr (not kith::affine_value<T> or std::integral<T>)
            for (const auto v : m.vertices()) {
                EXPECT_EQ(at_vertices[v], value_of<T>(int(v) < 8 ? int(v) : 200));
            }
        const auto at_corners = map_of<halfedge, T>(m, name);
        if constexpr (not kith::affine_value<T> or std::integral<T>)
            for (const auto h : m.halfedges()) { // half-edges along a half-edge of the same face of level 0
                const auto from = levels.ancestor(2, m.edge(h), 0).e;
                const auto parent = *levels.ancestor(2, m.face(h), 0).f;
                const auto old = not from ? halfedge()
                                 : control.face(control.halfedge(*from)) == parent
                                     ? control.halfedge(*from)
                                     : control.opposite(control.halfedge(*from));
                EXPECT_EQ(at_corners[h], value_of<T>(from ? int(old.idx()) : 200));
            }
    });
    for (const auto v : m.vertices()) {
        EXPECT_EQ(m.point(v), levels[2].point(v));
        EXPECT_EQ(place[v], m.point(v));
        EXPECT_EQ(height[v], float(m.point(v).z()));
    }
}

TEST(cgal_in_place, a_derived_mesh_is_a_mesh)
{
    const auto m = make<own_mesh>(shapes::cube());
    const own_mesh fine = kith::refine(m, kith::catmull_clark(), 2);
    const base expected = kith::refine(static_cast<const base&>(m), kith::catmull_clark(), 2);
    ASSERT_EQ(fine.number_of_vertices(), expected.number_of_vertices());
    for (const auto v : fine.vertices())
        EXPECT_EQ(fine.point(v), expected.point(v));
    auto labelled = m;
    auto label = labelled.add_property_map<face, int>("f:label", -1).first;
    for (const auto f : labelled.faces())
        label[f] = int(f);
    kith::hierarchy<own_mesh, kith::catmull_clark> levels(labelled);
    levels.refine(1);
    own_mesh first = levels[1];
    EXPECT_EQ(kith::carry_properties(levels, 0, 1, first).carried, names{"f:label"});
    EXPECT_EQ((map_of<face, int>(first, "f:label")[face(23)]), 5);
}

TEST(cgal_in_place, rules_and_types_are_named_as_in_carry_properties)
{
    base m = make<base>(shapes::cube());
    m.add_property_map<face, double>("area", 4.), m.add_property_map<face, double>("f:other", 3.);
    auto heat = m.add_property_map<vertex, reading>("heat").first;
    for (const auto v : m.vertices())
        heat[v].celsius = m.point(v).x();
    m.add_property_map<vertex, list>("list", list{{1}});
    const auto report = kith::cgal::CatmullClark_subdivision(
        m,
        CGAL::parameters::number_of_iterations(2),
        kith::by_rule<face, double>("area", kith::from_parent{[](double x) { return x / 4; }}),
        kith::by_rule<face, float>("f:other", kith::from_parent()),
        kith::by_rule<face, int>("f:none", kith::from_parent()),
        kith::value_types<reading, list>());
    EXPECT_EQ((names{report.carried}), (names{"list", "heat", "f:other", "area"}));
    ASSERT_EQ(names_of(report.left_out), (names{"f:other", "f:none"}));
    EXPECT_NE(report.left_out[0].why.find("with a type that it does not have"), std::string::npos);
    EXPECT_NE(report.left_out[1].why.find("no property has that name"), std::string::npos);
    for (const auto v : m.vertices())
        EXPECT_EQ(heat[v].celsius, m.point(v).x());
    for (const auto f : m.faces()) {
        EXPECT_EQ((map_of<face, double>(m, "area")[f]), 0.25);
        EXPECT_EQ((map_of<face, double>(m, "f:other")[f]), 3.);
    }
}

TEST(cgal_in_place, isolated_vertices_and_meshes_without_faces_stay_as_they_are)
{
    base empty;
    EXPECT_TRUE(kith::cgal::Loop_subdivision(empty, 3).carried.empty());
    empty.add_vertex(point(1, 2, 3));
    kith::cgal::PQQ(empty, no_mask(), 3);
    EXPECT_EQ(empty.number_of_vertices(), 1U);

    base m;
    const auto alone = m.add_vertex(point(7, 8, 9));
    const base cube = make<base>(shapes::cube());
    m += cube;
    auto id = m.add_property_map<vertex, int>("v:id", -1).first;
    auto own = m.add_property_map<vertex, material>("v:material").first;
    auto x = m.add_property_map<vertex, double>("v:x").first;
    for (const auto v : m.vertices())
        id[v] = int(v), own[v].id = int(v), x[v] = m.point(v).x();
    kith::cgal::CatmullClark_subdivision(m, 2);
    base expected = cube;
    kith::cgal::CatmullClark_subdivision(expected, 2);
    ASSERT_EQ(m.number_of_vertices(), expected.number_of_vertices() + 1);
    EXPECT_TRUE(m.is_isolated(alone));
    EXPECT_EQ(m.point(alone), point(7, 8, 9));
    for (const auto v : expected.vertices()) {
        EXPECT_EQ(m.point(vertex(v + 1)), expected.point(v));
        EXPECT_EQ(x[vertex(v + 1)], expected.point(v).x());
    }
    for (const auto v : m.vertices()) {
        EXPECT_EQ(id[v], int(v) < 9 ? int(v) : -1);
        EXPECT_EQ(own[v].id, id[v]);
    }
    EXPECT_THROW(kith::refine(m, kith::catmull_clark(), 1), kith::mesh_error);
}

namespace {

/// Expects that a failing call leaves either the old mesh or the new one. The mesh has removed elements of each kind
/// and maps of many types.
template <class Call>
void expect_old_or_new(const base& control, const Call& call)
{
    base done = control;
    call(done);
    const std::string before = text_of(control), after = text_of(done);
    EXPECT_NE(before, after);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(done));
    base m;
    long thrown = 0;
    failing_allocations::try_all([&] { m = control; },
                                 [&] { call(m); },
                                 [&](const failing_allocations::trial& trial) {
                                     SCOPED_TRACE(trial.text());
                                     thrown += trial.has_thrown;
                                     EXPECT_EQ(trial.other, "");
                                     EXPECT_TRUE(text_of(m) == (trial.has_thrown ? before : after));
                                 });
    EXPECT_GT(thrown, 100);
}

/// Makes a torus with a weight at each vertex and a label on each face.
base torus_with_values()
{
    const auto shape = shapes::shaken(shapes::torus(12, 24));
    base mesh;
    for (const auto& p : shape.points)
        mesh.add_vertex(point(p[0], p[1], p[2]));
    for (const auto& f : shape.faces)
        mesh.add_face(vertex(f[0]), vertex(f[1]), vertex(f[2]), vertex(f[3]));
    auto weight = mesh.add_property_map<vertex, double>("v:weight").first;
    for (const vertex v : mesh.vertices())
        weight[v] = mesh.point(v).x() / 3 + mesh.point(v).y();
    auto label = mesh.add_property_map<face, int>("f:label").first;
    for (const face f : mesh.faces())
        label[f] = int(f) * 7 + 1;
    auto uv = mesh.add_property_map<halfedge, kernel::Point_2>("h:uv").first;
    auto side = mesh.add_property_map<halfedge, int>("h:side").first;
    for (const halfedge h : mesh.halfedges()) {
        uv[h] = {std::sin(double(h)), double(h % 7) / 3};
        side[h] = int(h) + 1;
    }
    auto kind = mesh.add_property_map<edge, int>("e:kind").first;
    for (const edge e : mesh.edges())
        kind[e] = int(e) + 1;
    auto name = mesh.add_property_map<vertex, int>("v:name").first;
    for (const vertex v : mesh.vertices())
        name[v] = int(v) + 1;
    return mesh;
}

/// A state that counts levels and does not refer to elements.
struct rounds {
    int count = 0;

    friend bool operator==(const rounds&, const rounds&) = default;
    template <class Level, class Numbering>
    [[nodiscard]] rounds after(const Level&, const Numbering&) const
    {
        return {count + 1};
    }
    template <class Part>
    [[nodiscard]] rounds of_part(const Part&) const
    {
        return *this;
    }
    template <class F>
    void for_each_place(const F&) const
    {
    }
};
/// A user's scheme with this state.
struct counted {
    rounds levels{};

    friend bool operator==(const counted&, const counted&) = default;
    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "counted",
                                   .trusted = true,
                                   .reach = [](int rings) { return rings / 2 + 1; },
                                   .state = &counted::levels,
                                   .ignores_numbers = [](const counted&) { return true; }};
    }
    static constexpr auto columns() { return kith::quad_split::columns(); }
    template <kith::step_context R>
    void operator()(const R& r) const
    {
        kith::catmull_clark()(r);
    }
};

TEST(cgal_in_place, hands_on_state_that_counts_levels_made_at_once)
{
    const auto shape = shapes::shaken(shapes::torus(12, 24));
    counted scheme;
    const std::vector<std::uint32_t> none;
    kith::in_place::no_properties carried(base(), none);
    const auto fine = kith::in_place::refine(
        kith::make_mesh(shape.points, shape.faces), scheme, 5, carried, false, [](double) { return true; });
    ASSERT_TRUE(fine);
    EXPECT_TRUE(fine->keeps_vertices);
    EXPECT_EQ(fine->mesh.face_count(), 288U << 10);
    EXPECT_EQ(scheme.levels.count, 5);
}

void expect_bits_of_single_steps(unsigned levels)
{
    base mesh = torus_with_values(), expected = mesh;
    kith::cgal::subdivision(mesh, kith::catmull_clark(), kith::cgal::parameters::number_of_iterations(levels));
    for (unsigned i = 0; i < levels; ++i)
        kith::cgal::subdivision(expected, kith::catmull_clark(), kith::cgal::parameters::number_of_iterations(1));
    ASSERT_EQ(mesh.number_of_vertices(), expected.number_of_vertices());
    ASSERT_EQ(mesh.number_of_faces(), expected.number_of_faces());
    const auto weight = mesh.add_property_map<vertex, double>("v:weight").first,
               expected_weight = expected.add_property_map<vertex, double>("v:weight").first;
    for (const vertex v : mesh.vertices()) {
        ASSERT_EQ(mesh.point(v), expected.point(v)) << v;
        ASSERT_EQ(weight[v], expected_weight[v]) << v;
    }
    const auto label = mesh.add_property_map<face, int>("f:label").first,
               expected_label = expected.add_property_map<face, int>("f:label").first;
    for (const face f : mesh.faces()) {
        ASSERT_EQ(mesh.target(mesh.halfedge(f)), expected.target(expected.halfedge(f))) << f;
        ASSERT_EQ(label[f], expected_label[f]) << f;
    }
    const auto expect_same =
        [&]<class Handle, class T>(const Handle&, const T&, const char* property, const auto& all) {
            const auto made = mesh.add_property_map<Handle, T>(property).first,
                       from = expected.add_property_map<Handle, T>(property).first;
            for (const Handle h : all)
                ASSERT_EQ(made[h], from[h]) << property << ' ' << h;
        };
    expect_same(halfedge(), kernel::Point_2(), "h:uv", mesh.halfedges());
    expect_same(halfedge(), 0, "h:side", mesh.halfedges());
    expect_same(edge(), 0, "e:kind", mesh.edges());
    expect_same(vertex(), 0, "v:name", mesh.vertices());
}

TEST(cgal_in_place, makes_several_levels_at_once_with_the_bits_of_one_after_the_other)
{
    expect_bits_of_single_steps(5); // enough steps for patches
    for (const kith::refinement_way way : all_ways) {
        SCOPED_TRACE(int(way));
        const forced_way_here forced(way);
        expect_bits_of_single_steps(2);
    }
}

TEST(cgal_in_place, fields_go_along_by_each_way)
{
    const base mesh = torus_with_values();
    const auto refined = [&] {
        auto weights = kith::on_vertices(std::vector<double>(mesh.number_of_vertices(), 1), kith::by_mask{});
        auto labels = kith::on_faces(std::vector<int>(mesh.number_of_faces()));
        for (std::size_t i = 0; i < labels.size(); ++i)
            labels[i] = int(i);
        weights[3] = 7;
        auto fine = kith::refine_with_fields(mesh, kith::catmull_clark(), 2, std::tie(weights, labels));
        return std::tuple(std::move(fine), std::move(weights), std::move(labels));
    };
    const auto [expected, expected_weights, expected_labels] = [&] {
        const forced_way_here forced(kith::refinement_way::by_levels);
        return refined();
    }();
    const forced_way_here forced(kith::refinement_way::in_patches);
    const auto [fine, weights, labels] = refined();
    ASSERT_EQ(fine.number_of_vertices(), expected.number_of_vertices());
    for (const vertex v : fine.vertices())
        ASSERT_EQ(fine.point(v), expected.point(v)) << v;
    for (const face f : fine.faces())
        ASSERT_EQ(fine.target(fine.halfedge(f)), expected.target(expected.halfedge(f))) << f;
    EXPECT_TRUE(std::ranges::equal(weights.values(), expected_weights.values()));
    EXPECT_TRUE(std::ranges::equal(labels.values(), expected_labels.values()));
}

} // namespace

TEST(cgal_in_place, a_mesh_is_as_it_was_when_memory_ends)
{
    base m = make<base>(shapes::both(shapes::tetrahedron(), shapes::grid(1, 2)));
    add_maps<vertex>(m, m.vertices()), add_maps<edge>(m, m.edges()), add_maps<face>(m, m.faces());
    add_maps<halfedge>(m, m.halfedges());
    for (std::uint32_t f = 0; f < 4; ++f)
        CGAL::Euler::remove_face(m.halfedge(face(f)), m);
    ASSERT_TRUE(m.number_of_removed_vertices() != 0 and m.number_of_removed_edges() != 0);
    expect_old_or_new(m, [](base& x) { kith::cgal::CatmullClark_subdivision(x, 1, kith::value_types<list>()); });
    expect_old_or_new(m, [](base& x) { kith::cgal::DooSabin_subdivision(x, 1, kith::value_types<list>()); });
}
