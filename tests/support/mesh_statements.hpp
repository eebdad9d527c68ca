// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "all_shapes.hpp"
#include "error_text.hpp"
#include "hashes.hpp"
#include "marks_and_parity.hpp"
#include "native_shape.hpp"
#include "own_state.hpp"
#include "same_mesh.hpp"
#include "some_fields.hpp"
#include "thread_count.hpp"
#include "user_mesh.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/hierarchy.hpp>
#include <kith/loop.hpp>
#include <kith/make_creases.hpp>
#include <kith/refine_with_fields.hpp>
#include <kith/schemes/crease/vertex_type.hpp>
#include <kith/sqrt3.hpp>

#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

/// Expects that a scheme with `alone` as a member hands its creases on as `alone` does.
template <class M>
void expect_handed_on(const M& mesh, const kith::catmull_clark& alone)
{
    const own_state::wrapped scheme{alone};
    const auto expected = kith::refine(mesh, alone, 2), fine = kith::refine(mesh, scheme, 2);
    kith::hierarchy levels(mesh, scheme);
    levels.refine(2);
    for (const auto v : kith::level_of<M>(expected).vertices()) {
        const auto handle = v.handle();
        EXPECT_EQ(fine.point(handle), expected.point(handle));
        EXPECT_EQ(levels.finest().point(handle), expected.point(handle));
    }
}

/// Expects equal fields on a mesh and on its native copy, by `refine_with_fields` and in a hierarchy.
template <class M, class Scheme>
void expect_same_fields(const M& mesh, const Scheme& scheme)
{
    const auto native = kith::to_native(mesh);
    auto expected = some_fields::with_some_fields(scheme, native), ours = expected;
    kith::refine_with_fields(native, expected, 2);
    kith::hierarchy levels(mesh, ours);
    levels.refine(2);
    EXPECT_EQ(some_fields::difference(levels.scheme(2), expected), "");
    const M fine = kith::refine_with_fields(mesh, ours, 2);
    EXPECT_EQ(some_fields::difference(ours, expected), "");
    for (const auto v : kith::level_of<M>(fine).vertices())
        EXPECT_EQ(v.point(), ours.template field<5>()[v.index()]);
}

/// The tests that every mesh library passes, instantiated for its mesh types in cgal_test.cpp and openmesh_test.cpp.
template <class M>
class mesh_statements : public testing::Test {
protected:
    using traits = kith::mesh_traits<M>;
    static constexpr bool triangles_only = user_mesh<M>::triangles_only;
    using scheme = std::conditional_t<triangles_only, kith::loop, kith::catmull_clark>;

    /// The untrusted scheme, whose last level is made natively and copied. A trusted one writes directly into an M.
    struct checked : scheme {
        static constexpr auto traits()
        {
            auto result = scheme::traits();
            result.trusted = false;
            return result;
        }
    };

    static M make(const shapes::shape& s) { return user_mesh<M>::make(s.points, s.faces); }
    static auto all() { return triangles_only ? shapes::triangle_shapes() : shapes::all_shapes(); }
    /// Returns the native mesh with the same elements and numbers, and coordinates as doubles.
    static mesh3d as_native(const M& mesh)
    {
        const auto lifted = kith::to_native(mesh);
        kith::storage<shapes::point> points(lifted.vertex_count());
        for (std::size_t v = 0; v < points.size(); ++v)
            points[v] = coordinates(lifted.point(v));
        return {std::move(points), lifted.topology()};
    }
};

TYPED_TEST_SUITE_P(mesh_statements);

TYPED_TEST_P(mesh_statements, is_a_refinable_mesh)
{
    EXPECT_TRUE(kith::mesh<TypeParam>);
    EXPECT_TRUE(kith::refinable_mesh<TypeParam>);
}

TYPED_TEST_P(mesh_statements, the_users_mesh_has_the_users_elements)
{
    for (const auto& [name, shape] : TestFixture::all()) {
        SCOPED_TRACE(name);
        const auto mesh = TestFixture::as_native(TestFixture::make(shape));
        EXPECT_TRUE(std::ranges::equal(mesh.points(), shape.points));
        EXPECT_EQ(as_cycles(faces_of(mesh)), as_cycles(shape.faces));
        EXPECT_EQ(count(mesh.topology()), count(native(shape).topology()));
    }
}

TYPED_TEST_P(mesh_statements, what_is_built_is_read_back_unchanged)
{
    for (const auto& [name, shape] : TestFixture::all()) {
        SCOPED_TRACE(name);
        const auto lifted = kith::to_native(TestFixture::make(shape));
        auto copy = lifted;
        EXPECT_TRUE(same_bits(kith::to_native(TestFixture::traits::build(std::move(copy))), lifted));
    }
}

TYPED_TEST_P(mesh_statements, reading_in_bulk_is_reading_element_by_element)
{
    auto all = TestFixture::all();
    if (not TestFixture::triangles_only)
        all.push_back({"a face of many corners", shapes::polygon(40)});
    for (const auto& [name, shape] : all) {
        SCOPED_TRACE(name);
        const auto mesh = TestFixture::make(shape);
        const auto read = kith::detail::bulk_reader(mesh).read(0);
        ASSERT_TRUE(read.has_value());
        EXPECT_TRUE(same_bits(*read, kith::to_native(kith::level_elements<kith::mesh_level<TypeParam>>(mesh))));
    }
}

TYPED_TEST_P(mesh_statements, refining_through_the_native_mesh_changes_no_operation)
{
    for (const auto& [name, shape] : TestFixture::all()) {
        SCOPED_TRACE(name);
        const auto mesh = TestFixture::make(shape);
        const typename TestFixture::scheme scheme;
        EXPECT_EQ(hashes(mesh, scheme, 2), hashes(TestFixture::as_native(mesh), scheme, 2));
    }
}

TYPED_TEST_P(mesh_statements, a_native_mesh_is_refined_by_the_same_operations_there)
{
    for (const auto& [name, shape] : TestFixture::all()) {
        SCOPED_TRACE(name);
        const auto control = native(shape);
        using point = typename TestFixture::traits::point;
        using scalar = kith::scalar_of<point>;
        kith::storage<point> points(control.vertex_count());
        for (std::size_t v = 0; v < points.size(); ++v) {
            const auto& [x, y, z] = control.point(v);
            points[v] = kith::affine<point>::store({scalar(x), scalar(y), scalar(z)});
        }
        const auto mesh = TestFixture::traits::build({std::move(points), control.topology()});
        const typename TestFixture::scheme scheme;
        EXPECT_EQ(hashes(mesh, scheme, 2), hashes(control, scheme, 2));
    }
}

TYPED_TEST_P(mesh_statements, checking_changes_no_bit)
{
    for (const auto& [name, shape] : TestFixture::all()) {
        SCOPED_TRACE(name);
        const auto mesh = TestFixture::make(shape);
        EXPECT_TRUE(same_bits(kith::refine(mesh, typename TestFixture::checked(), 2),
                              kith::refine(mesh, typename TestFixture::scheme(), 2)));
    }
}

TYPED_TEST_P(mesh_statements, the_refined_mesh_is_sound)
{
    for (const auto& [name, shape] : TestFixture::all()) {
        SCOPED_TRACE(name);
        EXPECT_EQ(
            user_mesh<TypeParam>::complaints(kith::refine(TestFixture::make(shape), typename TestFixture::scheme(), 2)),
            "");
    }
}

TYPED_TEST_P(mesh_statements, the_number_of_threads_changes_no_bit)
{
    const auto bounded = shapes::shaken(shapes::grid(40, 50)); // large enough for threads
    const auto mesh = TestFixture::make(TestFixture::triangles_only ? shapes::triangulated(bounded) : bounded);
    const auto refined = [&](int count) {
        const thread_count here(count);
        return kith::refine(mesh, typename TestFixture::scheme(), 2);
    };
    const auto by_one = refined(1);
    for (const int count : {2, 3, 7}) {
        const auto by_many = refined(count);
        EXPECT_TRUE(same_bits(by_many, by_one));
        EXPECT_EQ(user_mesh<TypeParam>::complaints(by_many), "");
    }
}

TYPED_TEST_P(mesh_statements, the_input_is_left_as_it_was)
{
    const auto mesh = TestFixture::make(shapes::umbrella(5));
    const auto before = kith::to_native(mesh);
    kith::refine(mesh, typename TestFixture::scheme(), 2);
    EXPECT_TRUE(same_bits(kith::to_native(mesh), before));
}

TYPED_TEST_P(mesh_statements, good_meshes_are_valid)
{
    for (const auto& [name, shape] : TestFixture::all())
        EXPECT_EQ(kith::validate(TestFixture::make(shape)).text(), "") << name;
}

TYPED_TEST_P(mesh_statements, a_mesh_without_faces_is_refused)
{
    EXPECT_EQ(error_text<kith::mesh_error>([] { kith::refine(TypeParam(), typename TestFixture::scheme(), 1); }),
              "the mesh has no faces; nothing can be refined");
}

TYPED_TEST_P(mesh_statements, vertices_without_faces_are_refused)
{
    auto shape = shapes::umbrella(5);
    shape.points.push_back({5, 5, 5});
    EXPECT_EQ(error_text<kith::mesh_error>(
                  [&] { kith::refine(TestFixture::make(shape), typename TestFixture::scheme(), 1); }),
              "vertex 6: belongs to no face; remove it or give it a face");
}

TYPED_TEST_P(mesh_statements, fans_that_only_meet_in_a_vertex_are_refused)
{
    const shapes::shape bow_tie{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
    EXPECT_EQ(error_text<kith::mesh_error>(
                  [&] { kith::refine(TestFixture::make(bow_tie), typename TestFixture::scheme(), 1); }),
              "vertex 0: its 2 faces form several fans; split the vertex, one copy per fan");
}

/// Two closed fans at a vertex are refused. The libraries add no such faces: the test changes the native arrays.
TYPED_TEST_P(mesh_statements, closed_fans_that_only_meet_in_a_vertex_are_refused)
{
    using point = typename TestFixture::traits::point;
    const auto apart = kith::to_native(TestFixture::make(shapes::both(shapes::tetrahedron(), shapes::tetrahedron())));
    auto t = apart.topology();
    t.vertices = 7;
    t.vertex_corner = kith::storage<std::uint32_t>(7);
    kith::storage<point> points(7);
    for (std::size_t v = 0; v < 8; ++v)
        if (v != 4) {
            t.vertex_corner[v - (v > 4)] = apart.topology().vertex_corner[v];
            points[v - (v > 4)] = apart.point(v);
        }
    for (std::uint32_t& v : t.corner_vertex) // the first vertex of the second tetrahedron becomes that of the first
        v = v == 4 ? 0 : v - (v > 4);
    const auto mesh = TestFixture::traits::build({std::move(points), std::move(t)});
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::refine(mesh, typename TestFixture::scheme(), 1); }),
              "vertex 0: its 6 faces form several fans; split the vertex, one copy per fan");
}

TYPED_TEST_P(mesh_statements, sqrt3_twice_once_is_once_twice)
{
    for (const auto& [name, shape] : shapes::triangle_shapes()) {
        SCOPED_TRACE(name);
        const auto mesh = TestFixture::make(shape);
        const kith::sqrt3 scheme;
        EXPECT_TRUE(same_bits(kith::refine(kith::refine(mesh, scheme, 1), scheme, 3), kith::refine(mesh, scheme, 4)));
    }
}

TYPED_TEST_P(mesh_statements, marks_and_parity_are_fields)
{
    for (const bool open : {false, true})
        marks_and_parity::expect_marks_and_parity(
            kith::tri_quad(TestFixture::make(open ? shapes::triangulated(shapes::grid(3, 3)) : shapes::tetrahedron())),
            TestFixture::make(
                shapes::triangulated(open ? shapes::shaken(shapes::grid(4, 5)) : shapes::shaken(shapes::torus(6, 6)))));
}

TYPED_TEST_P(mesh_statements, vertices_have_the_types_that_creases_give_them)
{
    for (const auto& [name, shape] : TestFixture::all()) {
        SCOPED_TRACE(name);
        const auto mesh = TestFixture::make(shape);
        const auto copy = TestFixture::as_native(mesh);
        auto sharp = kith::creases_by_angle(mesh, 50);
        EXPECT_EQ(kith::vertex_types(mesh, sharp), kith::vertex_types(copy, kith::creases_by_angle(copy, 50)));
        const kith::level_of<TypeParam> level(mesh);
        for (const auto v : level.vertices()) {
            const auto type = v.is_boundary() ? kith::vertex_type::boundary : kith::vertex_type::inner;
            set_type(sharp, v, type, {}, 1, kith::boundary_corner::smoothed);
            EXPECT_EQ(type_of(v, sharp, kith::boundary_corner::smoothed), type);
        }
        EXPECT_TRUE(sharp.empty());
    }
}

TYPED_TEST_P(mesh_statements, dropped_levels_are_made_again)
{
    const auto mesh = TestFixture::make(shapes::shaken(shapes::tetrahedron()));
    kith::hierarchy all(mesh, typename TestFixture::scheme()), some(mesh, typename TestFixture::scheme());
    some.keep_last(1);
    all.refine(3), some.refine(3);
    EXPECT_FALSE(some.holds(1) or some.holds(2));
    some.restore(2);
    for (const int level : {2, 3})
        EXPECT_TRUE(same_bits(kith::to_native(some[level]), kith::to_native(all[level]))) << level;
    for (const auto f : all.elements(3).faces())
        EXPECT_EQ(some.origin(3, f.handle()).f, all.origin(3, f.handle()).f);
    EXPECT_FALSE(some.refine(1, [](double) { return false; }));
    EXPECT_EQ(some.depth(), 3);
}

TYPED_TEST_P(mesh_statements, negative_levels_are_refused)
{
    EXPECT_THROW(kith::refine(TestFixture::make(shapes::tetrahedron()), typename TestFixture::scheme(), -1),
                 kith::mesh_error);
}

TYPED_TEST_P(mesh_statements, too_much_memory_is_refused)
{
    EXPECT_THROW(
        kith::refine(
            TestFixture::make(shapes::tetrahedron()), typename TestFixture::scheme(), 12, {.memory_limit = 1000}),
        kith::mesh_error);
}

REGISTER_TYPED_TEST_SUITE_P(mesh_statements, is_a_refinable_mesh, the_users_mesh_has_the_users_elements,
                            what_is_built_is_read_back_unchanged, reading_in_bulk_is_reading_element_by_element,
                            refining_through_the_native_mesh_changes_no_operation,
                            a_native_mesh_is_refined_by_the_same_operations_there, checking_changes_no_bit,
                            the_refined_mesh_is_sound, the_number_of_threads_changes_no_bit,
                            the_input_is_left_as_it_was, good_meshes_are_valid, a_mesh_without_faces_is_refused,
                            vertices_without_faces_are_refused, fans_that_only_meet_in_a_vertex_are_refused,
                            closed_fans_that_only_meet_in_a_vertex_are_refused, sqrt3_twice_once_is_once_twice,
                            marks_and_parity_are_fields, vertices_have_the_types_that_creases_give_them,
                            dropped_levels_are_made_again, negative_levels_are_refused, too_much_memory_is_refused);
