// SPDX-License-Identifier: BSD-3-Clause
#include <kith/engine/refine_in_patches.hpp>

#include <kith/evaluator.hpp>
#include <kith/numbering/step/rules.hpp>
#include <kith/refine.hpp>
#include <kith/schemes/split/dual_split.hpp>
#include <kith/schemes/split/quad_split.hpp>

#include "support/every_scheme.hpp"
#include "support/patch_templates.hpp"
#include "support/refined_by_levels.hpp"
#include "support/same_mesh.hpp"
#include "support/shuffled.hpp"
#include "support/thread_count.hpp"
#include "support/under_sanitizers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using kith::connect;

constexpr kith::strategy_costs no_templates = with_cost_of_template(std::numeric_limits<double>::infinity());

template <class Scheme>
constexpr bool has_patches = kith::patchable_scheme<Scheme, std::array<double, 3>, std::uint32_t>;

template <class Point, class Index>
bool same_level(const kith::basic_mesh<Point, Index>& a, const kith::basic_mesh<Point, Index>& b)
{
    return same_bits(a, b) and a.generation() == b.generation();
}

/// Expects the levels of single steps from patches, for several costs. Returns false if there was nothing to compare.
template <class Point, class Index, class Scheme>
bool compare(const kith::basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels)
{
    std::optional<kith::basic_mesh<Point, Index>> faces, everything;
    for (const auto& costs : {all_templates, no_templates, some_templates}) {
        kith::patch_refinement<Point, Index, Scheme> patches(mesh, scheme, levels, connect::everything, costs);
        if (not patches.is_worth_looking())
            continue;
        if (not faces) {
            faces = refined_by_levels(mesh, scheme, levels, connect::faces);
            everything = refined_by_levels(mesh, scheme, levels, connect::everything);
        }
        EXPECT_TRUE(same_level(made_by_patches(mesh, scheme, levels, connect::faces, costs), *faces)) << levels;
        EXPECT_TRUE(same_level(made_by_patches(mesh, scheme, levels, connect::everything, costs), *everything))
            << levels;
        EXPECT_TRUE(same_level(written_by_patches(mesh, scheme, levels, costs), *everything)) << levels;
    }
    return faces.has_value();
}

TEST(refine_in_patches, makes_the_same_bits)
{
    std::size_t compared = 0;
    const int most_levels = under_sanitizers ? 2 : 3;
    for_each_of_all_schemes_and_shape([&](const auto& scheme, const mesh3d& mesh) {
        if constexpr (has_patches<std::remove_cvref_t<decltype(scheme)>>)
            for (int levels = 1; levels <= most_levels; ++levels)
                compared += compare(mesh, scheme, levels);
    });
    EXPECT_GT(compared, 50U * unsigned(most_levels));
}

TEST(refine_in_patches, makes_the_same_bits_of_irregular_meshes_in_any_order)
{
    const auto quads = native(shapes::shaken(shapes::shuffled(shapes::torus(7, 9), 3)));
    const auto polygons = native(shapes::shaken(shapes::both(shapes::house(), shapes::pentacube())));
    const auto triangles = native(shapes::shaken(shapes::shuffled(shapes::triangulated(shapes::pentacube()), 5)));
    const auto open = native(shapes::shaken(shapes::shuffled(shapes::triangulated(shapes::grid(5, 6)), 7)));
    const int levels = under_sanitizers ? 3 : 4;
    const int most_levels = under_sanitizers ? 4 : 7; // for schemes that double the number of faces
    EXPECT_TRUE(compare(quads, kith::catmull_clark{}, levels));
    EXPECT_TRUE(compare(polygons, kith::catmull_clark{}, levels));
    EXPECT_TRUE(compare(triangles, kith::loop{.weights = kith::loop_weights::warren, .sharpness = {}}, levels));
    EXPECT_TRUE(compare(triangles, kith::butterfly{}, levels));
    EXPECT_TRUE(compare(triangles, kith::sqrt3{}, levels + 1));
    EXPECT_TRUE(compare(open, kith::loop{}, levels));
    EXPECT_TRUE(compare(open, kith::butterfly{}, levels));
    EXPECT_TRUE(compare(quads, kith::kobbelt{}, levels - 1));
    for (const auto& mesh : {quads, polygons, triangles}) {
        EXPECT_TRUE(compare(mesh, kith::doo_sabin{}, levels));
        for (int levels = 2; levels <= most_levels; ++levels)
            EXPECT_TRUE(compare(mesh, kith::mid_edge{}, levels));
        EXPECT_TRUE(compare(mesh, kith::nasri_hasbini{}, levels - 1));
    }
    EXPECT_TRUE(compare(open, kith::nasri_hasbini{}, levels - 1));
    for (const auto& mesh : {quads, polygons, triangles, open})
        for (int levels = 2; levels <= most_levels; ++levels)
            EXPECT_TRUE(compare(kith::tri_quad(mesh), kith::four_eight{}, levels));
}

template <class Scheme>
void expect_hierarchy_in_patches(const mesh3d& control, const Scheme& scheme, int levels)
{
    kith::patch_refinement<std::array<double, 3>, std::uint32_t, Scheme> patches(
        control, scheme, levels, connect::everything);
    ASSERT_TRUE(patches.is_worth_looking());
    ASSERT_LT(patches.begin(), levels - 1);
    kith::hierarchy surface(control, scheme);
    surface.refine(levels);
    for (int level = 1; level <= levels; ++level)
        EXPECT_TRUE(same_level(surface[level], refined_by_levels(control, scheme, level, connect::everything)))
            << level;
    using handles = kith::mesh_traits<mesh3d>;
    kith::hierarchy last_step(surface[levels - 1], surface.scheme(levels - 1));
    last_step.refine();
    for (std::uint32_t v = 0; v < surface[levels].vertex_count(); v += 1009)
        EXPECT_EQ(surface.origin(levels, handles::vertex{v}), last_step.origin(1, handles::vertex{v})) << v;

    std::vector<std::array<double, 3>> moved(surface[levels - 1].points().begin(), surface[levels - 1].points().end());
    moved[100][1] += .25;
    surface.undo();
    surface.move_points(levels - 1, moved);
    surface.refine();
    auto before = surface[levels - 1];
    EXPECT_EQ(before.point(100)[1], moved[100][1]);
    EXPECT_TRUE(same_level(surface[levels],
                           refined_by_levels(std::move(before), surface.scheme(levels - 1), 1, connect::everything)))
        << "what was moved counts, not the level from which patches begin";
}

TEST(refine_in_patches, makes_the_last_levels_of_a_hierarchy)
{
    if (under_sanitizers)
        GTEST_SKIP() << "levels that are large enough take minutes";
    const auto torus = native(shapes::torus(24, 12));
    expect_hierarchy_in_patches(torus, kith::catmull_clark{}, 5);
    expect_hierarchy_in_patches(torus, kith::doo_sabin{}, 5);
    auto creased = kith::catmull_clark{};
    creased.sharpness.sharpen_edge(5, 2.5);
    creased.sharpness.sharpen_edge(77, kith::infinitely_sharp);
    expect_hierarchy_in_patches(torus, creased, 5);
    expect_hierarchy_in_patches(native(shapes::triangulated(shapes::torus(24, 12))), kith::loop{}, 5);
}

/// Returns the last level, computed with registers of `lane_bytes` bytes.
template <class Point, class Index, class Scheme>
kith::basic_mesh<Point, Index> filled_by_lanes(kith::basic_mesh<Point, Index> mesh, Scheme scheme, int levels,
                                               std::size_t lane_bytes)
{
    const int last_generation = mesh.generation() + levels;
    const auto plan = kith::plan_patches(
        kith::count(mesh.topology()), mesh.topology().degree, scheme, levels, mesh.generation());
    make_levels(mesh, scheme, plan->begin);
    const kith::face_classes<Index> classes(
        mesh.topology(), plan->rings, kith::state_marks<Index>(mesh.topology(), scheme));
    const auto made = kith::make_patches(mesh, classes, scheme, *plan, all_templates, true);
    kith::storage<Point> points(plan->last().vertices);
    kith::connectivity<Index> fine;
    fine.vertices = points.size();
    kith::allocate_faces(fine, mesh.topology(), plan->bases);
    fine.corner_halfedge = kith::storage<Index>(fine.corners());
    fine.halfedge_corner = kith::storage<Index>(2 * plan->last().edges);
    fine.vertex_corner = kith::storage<Index>(fine.vertices);
    made->fill(mesh,
               {.points = points.data(),
                .corner_vertex = fine.corner_vertex.data(),
                .corner_halfedge = fine.corner_halfedge.data(),
                .halfedge_corner = fine.halfedge_corner.data(),
                .vertex_corner = fine.vertex_corner.data(),
                .lane_bytes = lane_bytes});
    return {std::move(points), std::move(fine), last_generation};
}

TEST(refine_in_patches, makes_the_same_bits_with_registers_of_any_width)
{
    const auto compare_widths = [](const auto& mesh, const auto& scheme, int levels) {
        const auto expected = refined_by_levels(mesh, scheme, levels, connect::everything);
        for (const std::size_t bytes : {16, 32, 64})
            if (bytes <= kith::lane_bytes()) {
                EXPECT_TRUE(same_level(filled_by_lanes(mesh, scheme, levels, bytes), expected)) << bytes << " bytes";
            }
    };
    const auto open = native(shapes::shaken(shapes::shuffled(shapes::triangulated(shapes::grid(9, 8)), 7)));
    compare_widths(native(shapes::shaken(shapes::torus(7, 9))), kith::catmull_clark{}, 3);
    compare_widths(open, kith::loop{}, 3);
    compare_widths(open, kith::catmull_clark{}, 3);
    kith::storage<std::array<float, 3>> points(open.vertex_count());
    for (std::size_t v = 0; v < points.size(); ++v)
        points[v] = {float(open.point(v)[0]), float(open.point(v)[1]), float(open.point(v)[2])};
    compare_widths(
        kith::basic_mesh<std::array<float, 3>>(std::move(points), open.topology()), kith::catmull_clark{}, 3);
}

/// Returns a mesh in which neighbours on the surface have distant numbers.
mesh3d scattered_triangles()
{
    return native(shapes::shaken(shapes::shuffled(shapes::triangulated(shapes::torus(64, 64)), 3)));
}

TEST(refine_in_patches, makes_the_same_bits_of_a_scattered_mesh_in_the_order_of_its_surface)
{
    const auto compare_scattered = [](const mesh3d& mesh, const auto& scheme, int levels, double share_if_alike) {
        using scheme_type = std::remove_cvref_t<decltype(scheme)>;
        ASSERT_TRUE(can_be_ordered(mesh.topology(), scheme, levels) and is_scattered(mesh.topology()));
        auto costs = all_templates;
        costs.share_if_alike = share_if_alike;
        kith::patch_refinement<std::array<double, 3>, std::uint32_t, scheme_type> patches(
            mesh, scheme, levels, connect::everything, costs);
        ASSERT_TRUE(patches.is_worth_looking());
        const auto everything = refined_by_levels(mesh, scheme, levels, connect::everything);
        EXPECT_TRUE(same_level(made_by_patches(mesh, scheme, levels, connect::everything, costs), everything));
        EXPECT_TRUE(same_level(made_by_patches(mesh, scheme, levels, connect::faces, costs),
                               refined_by_levels(mesh, scheme, levels, connect::faces)));
        EXPECT_TRUE(same_level(written_by_patches(mesh, scheme, levels, costs), everything));
    };
    constexpr double from_control_mesh = 1, later = 0; // values of share_if_alike: where patches begin
    const auto triangles = scattered_triangles();
    compare_scattered(triangles, kith::catmull_clark{}, 3, later);
    if (under_sanitizers)
        return;
    const auto quads = native(shapes::shaken(shapes::shuffled(shapes::torus(91, 90), 5)));
    const auto open = native(shapes::shaken(shapes::shuffled(shapes::triangulated(shapes::grid(64, 64)), 7)));
    compare_scattered(open, kith::loop{}, 3, later);
    compare_scattered(open, kith::loop{}, 2, from_control_mesh);
    compare_scattered(open, kith::catmull_clark{}, 2, from_control_mesh);
    compare_scattered(triangles, kith::sqrt3{}, 3, from_control_mesh);
    compare_scattered(triangles, kith::butterfly{}, 2, from_control_mesh);
    compare_scattered(quads, kith::kobbelt{}, 2, from_control_mesh);
}

TEST(refine_in_patches, leaves_a_scattered_mesh_as_it_is_where_patches_are_no_gain)
{
    auto costs = all_templates;
    costs.in_patch = 1;
    costs.to_be_cheaper = 0;
    const auto mesh = scattered_triangles();
    kith::loop scheme;
    kith::refinement_run run(mesh, scheme, 2, costs);
    kith::native_last_level<std::array<double, 3>, std::uint32_t> last(connect::faces);
    EXPECT_FALSE(run.make_in_patches(last));
    EXPECT_TRUE(same_level(run.mesh(), mesh));
}

TEST(refine_in_patches, leaves_small_patches_of_a_scattered_mesh_to_the_order_of_its_surface)
{
    const kith::strategy_costs usual;
    auto costs = all_templates;
    costs.least_if_ordered = usual.least_if_ordered;
    costs.least_if_ordered_with_edges = usual.least_if_ordered_with_edges;
    costs.least_faces_if_scattered = usual.least_faces_if_scattered;
    const auto makes = [&](auto mesh, auto scheme, int levels, connect last) {
        kith::patch_refinement<std::array<double, 3>, std::uint32_t, decltype(scheme)> patches(
            mesh, scheme, levels, last, costs);
        EXPECT_TRUE(patches.is_worth_looking()) << levels;
        kith::no_last_level none(last);
        return kith::refinement_run(mesh, scheme, levels, costs).make_in_patches(none).has_value();
    };
    // No other test refines meshes of these sizes: after a vain look, meshes of equal size are not looked at again.
    const auto scattered = native(shapes::shuffled(shapes::triangulated(shapes::torus(62, 66)), 3));
    EXPECT_FALSE(makes(scattered, kith::loop{}, 1, connect::everything)); // patches of 4 faces
    EXPECT_FALSE(makes(scattered, kith::loop{}, 2, connect::faces));      // patches of 16 faces
    EXPECT_TRUE(makes(scattered, kith::loop{}, 2, connect::everything));
    if (not under_sanitizers) { // the result is large
        EXPECT_TRUE(makes(scattered, kith::loop{}, 3, connect::faces));
    }
    EXPECT_TRUE(makes(native(shapes::triangulated(shapes::torus(61, 66))), kith::loop{}, 1, connect::everything));
    // Doo-Sabin has no surface order.
    EXPECT_TRUE(makes(scattered, kith::doo_sabin{}, 2, connect::faces)); // patches begin with the first level
    costs.share_if_alike = 0;
    EXPECT_FALSE(makes(scattered, kith::doo_sabin{}, 3, connect::faces));
    EXPECT_TRUE(makes(native(shapes::torus(62, 65)), kith::doo_sabin{}, 3, connect::faces));
}

/// A user-defined scheme with masks inside masks, weights by valence, and a ring that is walked twice.
struct own_scheme {
    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "own",
                                   .trusted = true,
                                   .reach = [](int rings) { return rings / 2 + 1; },
                                   .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return kith::quad_split::columns(); }

    template <kith::step_context R>
    void operator()(const R& r) const
    {
        const auto ends = [](auto v) { return v.corners().map([](auto c) { return c.next().v(); }); };
        kith::subdivide(
            kith::quad_split(),
            r,
            kith::at_faces([](auto f) { return average(f.vertices()); }),
            kith::at_edges([](auto e) { return .7 * average(e.org(), e.dst()) + .3 * (.9 * e.org() + .1 * e.dst()); }),
            kith::at_vertices([&](auto v) {
                return kith::around(v, ends(v), [&](auto n, auto v, auto sum) {
                    return .8 * (v + .1 / n * sum) + .2 * (.6 * v + .4 / n * (sum + v));
                });
            }));
    }
};

/// A scheme that only moves points. Each face has one child, so that any number of steps would fit into a patch.
struct smoothing {
    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "smoothing",
                                   .faces = kith::face_shape::quads,
                                   .trusted = true,
                                   .reach = [](int rings) { return rings + 1; },
                                   .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex),
                             kith::new_edges(kith::per_edge),
                             kith::new_faces(quads(kith::per_face)));
    }

    template <kith::step_context R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) {
            assoc(v, V) = .5 * v + .5 * average(v.corners().map([](auto c) { return c.next().v(); }));
        });
        for_each(coarse.faces(), [&](auto f) {
            assoc(f, F) = polygon(
                f.corners(), [&](auto c) { return assoc(c.v(), V) >> assoc(c.next_edge(), E).along(c.next_edge()); });
        });
        for_each_by_number(coarse.vertices(), [&](auto v) {
            const auto c = v.first_corner();
            const auto f = c.f();
            const auto side = assoc(c.next_edge(), E).along(c.next_edge());
            assoc(v, V).starts_at(assoc(f, F).corner(c.index() - f.first_corner().index()), side);
        });
    }
};

TEST(refine_in_patches, takes_more_steps_than_a_patch_has)
{
    static_assert(has_patches<smoothing>);
    const auto mesh = native(shapes::shaken(shapes::torus(8, 9)));
    const auto plan = kith::plan_patches(count(mesh.topology()), 4, smoothing(), 13, 0);
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->bases.size(), std::size_t(kith::column_path::most_columns));
    EXPECT_TRUE(compare(mesh, smoothing(), 13));
}

TEST(refine_in_patches, begins_where_classes_of_faces_can_be_numbered)
{
    const kith::catmull_clark scheme;
    const std::uint64_t quads = std::uint64_t(1) << 26; // a torus of 2^28 half-edges
    const auto plan = kith::plan_patches(kith::counts{quads, 2 * quads, quads, 0}, 4, scheme, 3, 0);
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->begin, 0);
    auto later = *plan;
    later.begin_at(1, scheme, 0); // 2^30
    EXPECT_TRUE(later.has_room_for_classes());
    later.begin_at(2, scheme, 0);
    EXPECT_FALSE(later.has_room_for_classes());
}

TEST(refine_in_patches, knows_where_the_columns_of_as_many_steps_begin_as_a_path_has_room_for)
{
    using kith::tuple_kind;
    std::vector<kith::column_bases> bases(kith::column_path::most_columns);
    kith::column_path path;
    std::uint64_t expected = 0;
    for (std::size_t step = 0; step < bases.size(); ++step) {
        bases[step].faces[std::size_t(tuple_kind::vfe)] = 7 + step;
        bases[step].faces_of_each[std::size_t(tuple_kind::vfe)] = 2 * 4;
        path = path.then(tuple_kind::vfe);
        expected = 7 + step + 2 * 4 * expected; // two children for each corner of a quad
    }
    EXPECT_EQ(path.base(tuple_kind::f, bases, 4), expected);
    EXPECT_EQ(kith::column_path().base(tuple_kind::f, bases, 4), 0U);

    // The path: a face of a corner, its side of an edge, the vertex there.
    std::vector<kith::column_bases> three(3);
    three[0].faces[std::size_t(tuple_kind::vf)] = 5;
    three[0].faces_of_each[std::size_t(tuple_kind::vf)] = 4;
    three[1].edges[std::size_t(tuple_kind::ef)] = 100;
    three[1].edges_of_each[std::size_t(tuple_kind::ef)] = 4;
    three[2].vertices[std::size_t(tuple_kind::e)] = 1000;
    three[2].vertices_of_each[std::size_t(tuple_kind::e)] = 1;
    path = kith::column_path().then(tuple_kind::vf).then(tuple_kind::ef).then(tuple_kind::e);
    EXPECT_EQ(path.base(tuple_kind::v, three, 4), 1000U + 100 + 4 * 5);
}

TEST(refine_in_patches, takes_a_scheme_of_a_users_own)
{
    static_assert(has_patches<own_scheme>);
    EXPECT_TRUE(compare(native(shapes::shaken(shapes::house())), own_scheme(), 4));
    EXPECT_TRUE(compare(native(shapes::shaken(shapes::grid(4, 5))), own_scheme(), 3));
}

/// A user-defined dual scheme, which declares its valence; with `Valence` 0 it declares none.
template <int Valence>
struct own_dual {
    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "own dual",
                                   .trusted = true,
                                   .valence = Valence,
                                   .reach = [](int rings) { return rings / 2 + 1; },
                                   .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return kith::dual_split().columns(); }

    template <kith::step_context R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.corners(), [&](auto c) {
            assoc(c, V) = .6 * c.v() + .3 * average(c.f().vertices()) + .1 * average(c.prev().v(), c.next().v());
        });
        kith::dual_split().connect(r);
    }
};

TEST(refine_in_patches, takes_a_dual_scheme_that_says_its_valence)
{
    static_assert(has_patches<own_dual<4>> and not has_patches<own_dual<0>>);
    for (const auto& shape : {shapes::house(), shapes::pentacube(), shapes::both(shapes::house(), shapes::torus(3, 5))})
        for (const int levels : {2, 3, 4})
            EXPECT_TRUE(compare(native(shapes::shaken(shape)), own_dual<4>(), levels));
    // The valence determines the degrees of its faces of vertices only from the second level on, and only without a
    // boundary.
    EXPECT_FALSE(compare(native(shapes::house()), own_dual<4>(), 1));
    EXPECT_FALSE(compare(native(shapes::shaken(shapes::grid(6, 7))), kith::doo_sabin{}, 3));
}

/// 4-8 that declares one ring too few for several steps.
struct nearsighted : kith::four_eight {
    static constexpr auto traits()
    {
        return kith::scheme_traits{
            .name = "nearsighted",
            .faces = kith::face_shape::triangles,
            .trusted = true,
            .reach = [](int rings, int steps) { return std::max(1, reach_of(kith::four_eight(), rings, steps) - 1); },
            .is_marked = [](const auto& e) { return kith::bisection_split::is_marked(e); },
            .ignores_numbers = [] { return true; }};
    }
};

TEST(refine_in_patches, needs_the_rings_that_4_8_says_of_several_steps)
{
    int wrong = 0;
    for (std::uint64_t seed = 1; seed <= (under_sanitizers ? 1 : 3); ++seed) {
        const auto shape = shapes::with_flips(shapes::shaken(shapes::triangulated(shapes::torus(6, 7))), seed, 500);
        const auto mesh = kith::tri_quad(native(shapes::with_joins(shape, seed, 400)));
        for (int levels = 3; levels <= (under_sanitizers ? 4 : 7); ++levels) {
            EXPECT_TRUE(compare(mesh, kith::four_eight{}, levels)) << seed;
            wrong += not same_level(made_by_patches(mesh, nearsighted(), levels, connect::everything, all_templates),
                                    refined_by_levels(mesh, kith::four_eight(), levels, connect::everything));
        }
    }
    EXPECT_GT(wrong, 0);
}

/// A scheme with a quad for each edge, between its ends and the points of its two faces. Every edge must have two
/// faces. So the scheme cannot refine a part of a mesh, which has a boundary, whatever its declared reach.
struct quads_of_edges {
    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "quads of edges",
                                   .closed_only = true,
                                   .trusted = true,
                                   .reach = [](int rings) { return rings + 1; },
                                   .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex, kith::per_face),
                             kith::new_edges(kith::per_corner),
                             kith::new_faces(quads(kith::per_edge)));
    }

    template <kith::step_context R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.faces(), [&](auto f) {
            const auto c = f.first_corner();
            const auto e = c.next_edge();
            assoc(f, V) = average(f.vertices());
            assoc(f, V).starts_at(assoc(e, F).corner(e.lcorner() == c ? 3 : 1), assoc(c, E).right());
        });
        for_each(coarse.vertices(), [&](auto v) {
            const auto c = v.first_corner();
            const auto e = c.next_edge();
            assoc(v, V) = .5 * v + .5 * average(v.corners().map([](auto c) { return c.next().v(); }));
            assoc(v, V).starts_at(assoc(e, F).corner(e.lcorner() == c ? 0 : 2), assoc(c.across().next(), E).left());
        });
        for_each(coarse.edges(), [&](auto e) {
            const auto x = e.lcorner(), y = e.rcorner();
            assoc(e, F) = polygon(assoc(e.org(), V) >> assoc(y.next(), E).left(),
                                  assoc(y.f(), V) >> assoc(y, E).right(),
                                  assoc(e.dst(), V) >> assoc(x.next(), E).left(),
                                  assoc(x.f(), V) >> assoc(x, E).right());
        });
    }
};

TEST(refine_in_patches, leaves_schemes_for_closed_meshes_alone)
{
    static_assert(not has_patches<quads_of_edges>);
    const auto torus = native(shapes::shaken(shapes::torus(9, 10)));
    const auto fine = refine(torus, quads_of_edges{}, 12); // enough faces for patches of other schemes
    EXPECT_EQ(fine.face_count(), 2U * 90 << 11);
    kith::evaluator moved(torus, quads_of_edges{}, 5);
    const auto points = moved.evaluate(torus.points());
    EXPECT_TRUE(std::ranges::equal(points, refine(torus, quads_of_edges{}, 5).points()));
}

TEST(refine_in_patches, takes_the_marks_of_any_level)
{
    for (const auto& shape : {shapes::house(), shapes::grid(3, 4)}) {
        const auto mesh = kith::tri_quad(native(shapes::shaken(shape)));
        EXPECT_FALSE(compare(mesh, kith::four_eight{}, 1)); // only from the next level on marked edges come first
        for (int done = 1; done <= 2; ++done)
            EXPECT_TRUE(compare(refine(mesh, kith::four_eight{}, done), kith::four_eight{}, 5));
    }
    // Its boundary edges are not marked as its generation implies, so that the counts of levels differ from the plan.
    const auto open = kith::tri_quad(native(shapes::shaken(shapes::grid(3, 4))));
    const auto other = of_generation(open, open.generation() + 1);
    kith::patch_refinement<std::array<double, 3>, std::uint32_t, kith::four_eight> patches(
        other, kith::four_eight{}, 4, connect::everything, all_templates);
    ASSERT_TRUE(patches.is_worth_looking());
    kith::four_eight of_level;
    kith::no_last_level none(connect::everything);
    EXPECT_FALSE(kith::refinement_run(other, of_level, 4, all_templates).make_in_patches(none));
}

TEST(refine_in_patches, knows_where_the_corners_of_faces_of_any_degree_begin)
{
    using kith::tuple_kind;
    const auto kind = [](tuple_kind k) { return std::size_t(k); };
    std::vector<kith::column_bases> bases(2);
    for (auto& step : bases) {
        step.degrees[kind(tuple_kind::e)] = 4;
        step.faces_of_each[kind(tuple_kind::f)] = step.faces_of_each[kind(tuple_kind::e)] = 1;
        step.vertices_of_each[kind(tuple_kind::vf)] = 1;
    }
    bases[0].corners[kind(tuple_kind::e)] = 50;
    bases[0].edges[kind(tuple_kind::ef)] = 7;
    bases[1].corners[kind(tuple_kind::f)] = 3;
    bases[1].corners[kind(tuple_kind::e)] = 200;
    bases[1].vertices[kind(tuple_kind::vf)] = 1000;
    const auto path = [](tuple_kind first, tuple_kind second) { return kith::column_path().then(first).then(second); };
    // The path: the face of an edge, its face, and the first corner of that face; then a side and its face.
    EXPECT_EQ(path(tuple_kind::e, tuple_kind::f).base(tuple_kind::vf, bases, 0), 3U + 50);
    EXPECT_EQ(path(tuple_kind::ef, tuple_kind::e).base(tuple_kind::vf, bases, 0), 200U + 4 * 7);
    // The path: the vertex of the first corner of the face of an edge.
    EXPECT_EQ(path(tuple_kind::e, tuple_kind::vf).base(tuple_kind::v, bases, 0), 1000U + 50);
}

TEST(refine_in_patches, keeps_templates_for_one_scheme_and_any_mesh)
{
    const auto triangles = native(shapes::shaken(shapes::triangulated(shapes::pentacube())));
    const auto moved = native(shapes::triangulated(shapes::pentacube()));
    const auto more = native(shapes::shaken(shapes::triangulated(shapes::house())));
    const kith::loop warren{.weights = kith::loop_weights::warren, .sharpness = {}};
    for (int again = 0; again < 2; ++again) {
        EXPECT_TRUE(compare(triangles, kith::loop{}, 3));
        EXPECT_TRUE(compare(moved, kith::loop{}, 3));
        EXPECT_TRUE(compare(triangles, warren, 3));
        EXPECT_TRUE(compare(more, warren, 3));
        EXPECT_TRUE(compare(more, warren, 2));
    }
    for (const std::size_t n : {8, 9, 12}) // the numbers of all columns begin at other values
        EXPECT_TRUE(compare(native(shapes::shaken(shapes::torus(n, n + 1))), kith::catmull_clark{}, 3));
    using templates = kith::kept_templates<double, std::uint32_t>;
    const auto made = templates::of(warren, 0, 2, 3).keep(u"around", {});
    EXPECT_EQ(templates::of(warren, 0, 2, 3).find(u"around"), made);
    EXPECT_EQ(templates::of(warren, 0, 2, 3).find(u""), nullptr);
    EXPECT_EQ(templates::of(kith::loop{}, 0, 2, 3).find(u"around"), nullptr);
    EXPECT_EQ(templates::of(warren, 1, 2, 3).find(u"around"), nullptr);
    EXPECT_EQ(templates::of(warren, 0, 1, 3).find(u"around"), nullptr);
    EXPECT_EQ(templates::of(warren, 0, 2, 2).find(u"around"), nullptr);
}

TEST(refine_in_patches, gives_up_templates_that_nobody_has_asked_for_longest)
{
    using templates = kith::kept_templates<double, std::uint32_t>;
    const auto kept = templates::of(kith::butterfly{}, 0, 2, 3);
    kith::patch_template<double, std::uint32_t> large;
    large.multiples.resize(templates::most_bytes / sizeof(large.multiples[0]) / 16);
    const auto asked_for = kept.keep(u"asked for", large), other = kept.keep(u"other", large);
    EXPECT_EQ(kept.find(u"other"), other);
    for (char16_t i = 0; i < 40; ++i) {
        const auto made = kept.keep(std::u16string(1, i), large);
        EXPECT_EQ(kept.find(std::u16string(1, i)), made);
        EXPECT_EQ(kept.find(u"asked for"), asked_for);
    }
    EXPECT_EQ(kept.find(u"other"), nullptr);
}

TEST(refine_in_patches, makes_templates_for_levels_that_are_made_again_and_again)
{
    const kith::catmull_clark scheme{.corners = kith::boundary_corner::smoothed}; // no other test uses these options
    const auto expect_templates = [&](const mesh3d& mesh, int levels, bool are_made) {
        const auto plan = kith::plan_patches(count(mesh.topology()), mesh.topology().degree, scheme, levels, 0);
        ASSERT_TRUE(plan);
        const auto kept = kith::kept_templates<double, std::uint32_t>::of(
            scheme, plan->begin, plan->rings, plan->bases.size());
        const auto faces = std::size_t(plan->last().faces);
        const auto given = refined_by_levels(mesh, scheme, levels, connect::everything);
        EXPECT_TRUE(same_bits(refine(mesh, scheme, levels), given));
        EXPECT_TRUE(kept.empty()); // for one refinement they would cost more than they save
        EXPECT_EQ(kept.demand(faces, connect::everything).made, faces);
        for (int again = 0; again < 8; ++again)
            EXPECT_TRUE(same_bits(refine(mesh, scheme, levels), given));
        EXPECT_EQ(not kept.empty(), are_made);
        EXPECT_EQ(kept.demand(faces, connect::everything).next_look == 0, are_made);
        EXPECT_EQ(kept.demand(faces, connect::faces).made, 0); // no call has asked for faces alone
    };
    const auto unlike = shapes::with_flips(shapes::triangulated(shapes::torus(15, 15)), 3, 900);
    expect_templates(native(unlike), 4, false); // each would serve one face
    expect_templates(native(shapes::shaken(shapes::torus(12, 24))), 4, true);
}

struct derived_scheme : kith::kobbelt {
    double added = 0;
};
struct empty_scheme : own_scheme {};

TEST(refine_in_patches, tells_schemes_apart_by_all_their_members)
{
    static_assert(kith::comparable_scheme<kith::catmull_clark> and kith::comparable_scheme<kith::loop> and
                  kith::comparable_scheme<kith::kobbelt> and kith::comparable_scheme<kith::butterfly> and
                  kith::comparable_scheme<kith::sqrt3>);
    static_assert(kith::comparable_scheme<empty_scheme>);
    static_assert(std::equality_comparable<derived_scheme> and not kith::comparable_scheme<derived_scheme>);
    using templates = kith::kept_templates<double, std::uint32_t>;
    templates::of(derived_scheme{}, 0, 4, 3).keep(u"around", {});
    EXPECT_EQ(templates::of(derived_scheme{}, 0, 4, 3).find(u"around"), nullptr);
}

TEST(refine_in_patches, takes_other_numbers_and_indices)
{
    const auto shape = shapes::shaken(shapes::both(shapes::house(), shapes::pentacube()));
    const auto of_type = [&]<class Point, class Index>(const Point&, const Index&) {
        std::vector<Point> points(shape.points.size());
        for (std::size_t v = 0; v < points.size(); ++v)
            for (std::size_t i = 0; i < std::tuple_size_v<Point>; ++i)
                points[v][i] = typename Point::value_type(shape.points[v][i % 3] + double(i));
        const auto mesh = kith::make_mesh<Index>(points, shape.faces);
        EXPECT_TRUE(compare(mesh, kith::catmull_clark{}, 3));
    };
    of_type(std::array<float, 3>(), std::uint32_t());
    of_type(std::array<float, 3>(), std::uint64_t());
    of_type(std::array<double, 2>(), std::uint32_t());
    of_type(std::array<double, 4>(), std::uint64_t());
    of_type(std::array<float, 1>(), std::uint16_t());
}

TEST(refine_in_patches, is_what_refine_does_with_a_large_level_on_any_number_of_threads)
{
    const auto torus = native(shapes::shaken(shapes::torus(12, 24)));
    ASSERT_TRUE((kith::patch_refinement<std::array<double, 3>, std::uint32_t, kith::catmull_clark>(
                     torus, kith::catmull_clark{}, 6, connect::everything)
                     .is_worth_looking()));
    for (const connect last :
         under_sanitizers ? std::vector{connect::everything} : std::vector{connect::faces, connect::everything}) {
        const auto given = refined_by_levels(torus, kith::catmull_clark{}, 6, last);
        for (const int threads : under_sanitizers ? std::vector{3} : std::vector{1, 2, 3, 4, 7}) {
            const thread_count count(threads);
            EXPECT_TRUE(same_bits(refine(torus, kith::catmull_clark{}, 6, {.last_level = last}), given)) << threads;
        }
    }
}

TEST(refine_in_patches, is_left_out_where_it_would_be_wrong_or_of_no_use)
{
    const auto looks = [](const mesh3d& mesh, const auto& scheme, int levels) {
        return kith::patch_refinement<std::array<double, 3>, std::uint32_t, std::remove_cvref_t<decltype(scheme)>>(
                   mesh, scheme, levels, connect::everything)
            .is_worth_looking();
    };
    const auto torus = native(shapes::triangulated(shapes::torus(40, 40)));
    EXPECT_TRUE(looks(torus, kith::loop{}, 5));
    EXPECT_TRUE(looks(torus, kith::loop{}, 4));
    EXPECT_FALSE(looks(torus, kith::loop{}, 0));
    EXPECT_FALSE(looks(native(shapes::tetrahedron()), kith::loop{}, 4));  // few faces
    EXPECT_FALSE(looks(refine(torus, kith::loop{}, 2), kith::loop{}, 1)); // the search costs more than refining
    // If the directions of edges and the starts of fans are random, large patches begin with the next level.
    const auto unlike = native(shapes::with_flips(shapes::triangulated(shapes::torus(100, 100)), 3, 20000));
    EXPECT_TRUE(looks(unlike, kith::loop{}, 4));
    EXPECT_TRUE(looks(unlike, kith::loop{}, 3));
    EXPECT_FALSE(looks(unlike, kith::loop{}, 2));
    EXPECT_FALSE(
        looks(native(shapes::with_flips(shapes::triangulated(shapes::torus(50, 50)), 3, 5000)), kith::loop{}, 3));
    EXPECT_FALSE(looks(unlike, kith::sqrt3{}, 4)); // the patches from the third level are small
    EXPECT_FALSE(looks(unlike, kith::butterfly{}, 3));
    EXPECT_TRUE(looks(native(shapes::triangulated(shapes::torus(100, 100))), kith::loop{}, 3));
    EXPECT_TRUE(looks(native(shapes::tetrahedron()), kith::loop{}, 9)); // few classes in any case
    // The columns of sqrt(3) depend on the boundary.
    EXPECT_FALSE(looks(native(shapes::triangulated(shapes::grid(40, 40))), kith::sqrt3{}, 6));
}

TEST(refine_in_patches, tells_a_thin_tube_from_a_thick_one)
{
    // Fans are alike, but a walk around the thin tube reaches a vertex from two sides. So the thin tube must not be the
    // model for the thick one.
    const auto thin = shapes::torus(3, 9), thick = shapes::torus(9, 9);
    EXPECT_TRUE(compare(native(shapes::shaken(shapes::both(thin, thick))), kith::catmull_clark{}, 3));
    EXPECT_TRUE(compare(native(shapes::shaken(shapes::both(thick, thin))), kith::catmull_clark{}, 3));
    const auto triangles = shapes::both(shapes::triangulated(thin), shapes::triangulated(thick));
    EXPECT_TRUE(compare(native(shapes::shaken(triangles)), kith::loop{}, 3));
    EXPECT_TRUE(compare(native(shapes::shaken(triangles)), kith::butterfly{}, 2));
}

TEST(refine_in_patches, does_not_look_at_more_faces_around_a_face_than_it_can_number)
{
    constexpr std::size_t faces = 600; // all of which lie around the apex
    static_assert(faces > kith::face_walk<std::uint32_t>::most_faces);
    EXPECT_TRUE(compare(native(shapes::umbrella(faces)), kith::loop{}, 2));
    // This also holds just after other faces were looked at.
    const auto torus = shapes::triangulated(shapes::torus(9, 9));
    EXPECT_TRUE(compare(native(shapes::shaken(shapes::both(torus, shapes::umbrella(faces)))), kith::loop{}, 2));
}

} // namespace
