// SPDX-License-Identifier: BSD-3-Clause
#include <kith/refine.hpp>

#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/grown.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"

#include <kith/hierarchy.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

using kith::refine;

namespace {

/// Catmull-Clark that throws when it is run.
struct never_run : kith::catmull_clark {
    template <class R>
    void operator()(const R&) const
    {
        throw std::logic_error("the scheme was run");
    }
};

/// A scheme that makes a frame around a hole of each face, so that a closed mesh gets a boundary.
template <bool Trusted>
struct frames {
    static constexpr auto traits() { return kith::scheme_traits{.name = "frames", .trusted = Trusted}; }
    static constexpr auto columns()
    {
        using namespace kith;
        return kith::columns(new_vertices(per_vertex, per_corner),
                             new_edges(per_edge, per_corner, per_side),
                             new_faces(quads(per_side)));
    }
    template <kith::step_context R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) {
            assoc(v, V) = v;
            const auto c = v.first_corner();
            assoc(v, V).starts_at(assoc(c.next_edge(), c.f(), F).corner(0),
                                  assoc(c.next_edge(), E).along(c.next_edge()));
        });
        for_each(coarse.corners(), [&](auto c) {
            assoc(c, V) = .5 * c.v() + .5 * average(c.f().vertices());
            assoc(c, V).starts_at(assoc(c.next_edge(), c.f(), F).corner(3), assoc(c, E).right());
        });
        for_each(coarse.corners(), [&](auto c) {
            const auto e = c.next_edge();
            const auto next = c.next();
            assoc(e, c.f(), F) = polygon(assoc(c.v(), V) >> assoc(e, E).along(e),
                                         assoc(next.v(), V) >> assoc(next, E).left(),
                                         assoc(next, V) >> assoc(e, c.f(), E).left(),
                                         assoc(c, V) >> assoc(c, E).right());
        });
    }
};

std::string refusal(const auto& mesh, const auto& scheme, int levels, const kith::refine_options& options = {})
{
    return error_text<kith::mesh_error>([&] { refine(mesh, scheme, levels, options); });
}

} // namespace

TEST(refine, twice_once_is_once_twice)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        EXPECT_TRUE(same_bits(refine(refine(mesh, scheme, 1), scheme, 1), refine(mesh, scheme, 2)));
    });
}

TEST(refine, no_level_is_the_mesh_itself)
{
    const auto mesh = native(shapes::house());
    EXPECT_TRUE(same_bits(refine(mesh, kith::catmull_clark(), 0), mesh));
}

TEST(refine, counts_its_steps)
{
    EXPECT_EQ(refine(refine(native(shapes::cube()), kith::doo_sabin(), 2), kith::catmull_clark(), 1).generation(), 3);
}

TEST(refine, leaves_the_input_as_it_was)
{
    const auto original = native(shapes::open_house());
    const auto mesh = original;
    refine(mesh, kith::catmull_clark(), 2);
    EXPECT_TRUE(same_bits(mesh, original));
}

TEST(refine, leaves_the_input_as_it_was_when_it_throws)
{
    const auto original = native(shapes::open_house());
    auto mesh = original;
    EXPECT_THROW(mesh = refine(mesh, never_run(), 2), std::logic_error);
    EXPECT_THROW(mesh = refine(mesh, kith::loop(), 1), kith::mesh_error);
    EXPECT_TRUE(same_bits(mesh, original));
}

TEST(refine, a_last_level_of_faces_has_the_same_points_and_faces)
{
    for_each_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        const auto all = refine(mesh, scheme, 2);
        const auto faces = refine(mesh, scheme, 2, {.last_level = kith::connect::faces});
        EXPECT_TRUE(faces.topology().faces_only());
        EXPECT_TRUE(std::ranges::equal(faces.points(), all.points(), same_points<shapes::point>));
        EXPECT_TRUE(std::ranges::equal(faces.topology().corner_vertex, all.topology().corner_vertex));
        EXPECT_TRUE(std::ranges::equal(faces.topology().face_corner, all.topology().face_corner));
    });
}

TEST(refine, a_mesh_of_faces_only_is_refined_to_the_same_surface)
{
    for_each_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        const auto all = refine(mesh, scheme, 2);
        const auto from_faces = refine(refine(mesh, scheme, 1, {.last_level = kith::connect::faces}), scheme, 1);
        EXPECT_EQ(count(from_faces.topology()), count(all.topology()));
        for (const auto& p : all.points())
            EXPECT_TRUE(std::ranges::any_of(from_faces.points(), [&p](const auto& q) {
                return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 1e-12;
            }));
    });
}

TEST(refine, refuses_negative_levels)
{
    EXPECT_EQ(refusal(native(shapes::cube()), kith::catmull_clark(), -1),
              "catmull-clark: -1 levels were asked for; ask for 0 or more");
}

TEST(refine, refuses_polygons_where_a_scheme_takes_triangles)
{
    EXPECT_EQ(refusal(native(shapes::house()), kith::loop(), 1),
              "loop: face 5 has 4 vertices; triangulate the mesh first");
    EXPECT_EQ(refusal(native(shapes::house()), kith::sqrt3(), 0),
              "sqrt3: face 5 has 4 vertices; triangulate the mesh first");
}

TEST(refine, refuses_triangles_back_to_back_of_which_edges_with_the_same_ends_would_come)
{
    const shapes::shape pillow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
    const auto why = [&](const auto& scheme) { return refusal(native(pillow), scheme, 1); };
    const auto expected = [](const std::string& scheme) {
        return scheme +
               ": vertex 0 lies between 2 faces only, the scheme needs three; remove these triangles, which are "
               "back to back, or put a vertex into one of them";
    };
    EXPECT_EQ(why(kith::loop()), expected("loop"));
    EXPECT_EQ(why(kith::sqrt3()), expected("sqrt3"));
    EXPECT_EQ(why(kith::butterfly()), expected("butterfly"));
    EXPECT_EQ(why(kith::linear_triangles()), expected("linear-triangles"));
    EXPECT_EQ(why(kith::doo_sabin()), expected("doo-sabin"));
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::hierarchy(native(pillow), kith::loop()); }), expected("loop"));
    auto beside = shapes::tetrahedron(); // the error is found beside a valid component, too
    for (std::size_t i = 0; i < 3; ++i)
        beside.points.push_back(pillow.points[i]);
    beside.faces.push_back({4, 5, 6});
    beside.faces.push_back({6, 5, 4});
    EXPECT_EQ(refusal(native(beside), kith::loop(), 1).find("loop: vertex 4 lies between 2 faces only"), 0U);
    const shapes::shape repaired{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {2, 1, 0}}};
    EXPECT_EQ(refine(native(repaired), kith::loop(), 2).face_count(), 64U);
}

TEST(refine, what_it_makes_it_takes_again_as_lists_of_faces)
{
    int made = 0;
    const auto check = [&made]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        SCOPED_TRACE(std::string(kith::scheme_name<Scheme>()));
        for (const int levels : {1, 2}) {
            mesh3d fine;
            try {
                fine = refine(mesh, scheme, levels);
            } catch (const kith::mesh_error&) {
                return;
            }
            ++made;
            EXPECT_NO_THROW({
                const auto again = kith::make_mesh(fine.points(), faces_of(fine));
                EXPECT_EQ(again.edge_count(), fine.edge_count());
                if (not std::same_as<Scheme, kith::four_eight>) // a list of faces has no marks
                    refine(again, scheme, 1);
            });
        }
    };
    for (std::uint32_t seed = 1; seed <= 120; ++seed) {
        const auto shape = shapes::grown(seed, seed % 3 == 0 ? 0 : 2 + seed % 3);
        mesh3d mesh;
        try {
            mesh = native(shape);
        } catch (const kith::mesh_error&) {
            continue;
        }
        SCOPED_TRACE(seed);
        check(kith::catmull_clark(), mesh);
        check(kith::doo_sabin(), mesh);
        check(kith::doo_sabin{.boundary = kith::doo_sabin_boundary::clamped}, mesh);
        check(kith::doo_sabin{.boundary = kith::doo_sabin_boundary::drop}, mesh);
        check(kith::linear(), mesh);
        check(kith::mid_edge(), mesh);
        check(kith::nasri_hasbini(), mesh);
        check(kith::unified{.degree = 2}, mesh);
        check(kith::unified{.degree = 3}, mesh);
        check(kith::four_eight(), kith::tri_quad(mesh));
        check(kith::kobbelt(), mesh);
        check(kith::butterfly(), mesh);
        check(kith::interpolatory_sqrt3(), mesh);
        check(kith::linear_triangles(), mesh);
        check(kith::loop(), mesh);
        check(kith::sqrt3(), mesh);
    }
    EXPECT_GT(made, 1000);
}

TEST(refine, refuses_an_empty_mesh)
{
    EXPECT_EQ(refusal(mesh3d(), kith::doo_sabin(), 1), "the mesh has no faces; nothing can be refined");
}

TEST(refine, refuses_points_that_are_not_finite)
{
    auto mesh = native(shapes::cube());
    mesh.points()[3][1] = INFINITY;
    EXPECT_EQ(refusal(mesh, kith::catmull_clark(), 1),
              "vertex 3: a coordinate is not a finite number; give finite coordinates");
}

TEST(refine, refuses_more_memory_than_allowed_before_it_starts)
{
    const std::string text = refusal(native(shapes::cube()), never_run(), 9, {.memory_limit = 1'000'000});
    EXPECT_TRUE(text.starts_with("catmull-clark: 9 levels need "));
    EXPECT_NE(text.find("the limit is 1000000; refine fewer times"), std::string::npos);
}

TEST(refine, takes_as_much_memory_as_allowed)
{
    const auto cube = native(shapes::cube());
    const kith::catmull_clark scheme;
    const auto need = kith::peak_bytes(kith::plan(count(cube.topology()), scheme, 3), false);
    EXPECT_NO_THROW(refine(cube, scheme, 3, {.memory_limit = need}));
    EXPECT_NE(refusal(cube, scheme, 3, {.memory_limit = need - 1}), "no error");
}

TEST(refine, refuses_more_elements_than_the_index_can_number_before_it_starts)
{
    const auto [points, faces] = shapes::cube();
    const auto mesh = kith::make_mesh<std::uint16_t>(points, faces);
    EXPECT_EQ(refusal(mesh, never_run(), 6),
              "catmull-clark: level 6 has 24578 vertices and 49152 edges, more than a 16-bit index can number; "
              "refine at most 5 times, in tiles, or on a native mesh with a 64-bit index");
    EXPECT_EQ(refine(mesh, kith::catmull_clark(), 5).face_count(), 6144U);
    EXPECT_NE(refusal(mesh, never_run(), 1000).find("refine at most 5 times"), std::string::npos);
}

TEST(refine, gives_the_same_bits_with_any_index)
{
    const auto [points, faces] = shapes::open_house();
    const auto narrow = refine(kith::make_mesh<std::uint16_t>(points, faces), kith::catmull_clark(), 3);
    const auto wide = refine(kith::make_mesh<std::uint64_t>(points, faces), kith::catmull_clark(), 3);
    EXPECT_TRUE(std::ranges::equal(narrow.points(), wide.points(), same_points<shapes::point>));
    EXPECT_TRUE(std::ranges::equal(narrow.topology().corner_halfedge, wide.topology().corner_halfedge));
}

TEST(refine, takes_points_of_long_doubles)
{
    const auto [points, faces] = shapes::torus(8, 9);
    std::vector<std::array<long double, 3>> exact;
    for (const auto& p : points)
        exact.push_back({p[0], p[1], p[2]});
    const auto fine = refine(kith::make_mesh(exact, faces), kith::catmull_clark(), 3);
    const auto rounded = refine(kith::make_mesh(points, faces), kith::catmull_clark(), 3);
    ASSERT_EQ(fine.vertex_count(), rounded.vertex_count());
    for (std::size_t v = 0; v < fine.vertex_count(); ++v)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(double(fine.point(v)[i]), rounded.point(v)[i], 1e-14);
}

TEST(refine, may_open_what_was_closed)
{
    const auto cube = native(shapes::cube());
    const auto expect_frames = [&](const auto& scheme) {
        for (const int levels : {1, 2}) {
            const auto fine = refine(cube, scheme, levels);
            EXPECT_TRUE(validate(fine)) << validate(fine).text();
            std::vector<std::size_t> faces(fine.vertex_count()); // of each vertex
            for (std::size_t f = 0; f < fine.face_count(); ++f)
                for (const auto v : fine.face(f))
                    ++faces[v];
            const kith::level_of<mesh3d> level(fine);
            for (const auto v : level.vertices())
                EXPECT_EQ(v.face_count(), faces[v.index()]) << "vertex " << v.index();
            const auto planned = kith::plan(count(cube.topology()), scheme, levels).back().counts;
            EXPECT_EQ(planned.vertices, fine.vertex_count());
            EXPECT_EQ(planned.boundary_edges, count(fine.topology()).boundary_edges);
        }
    };
    expect_frames(frames<false>());
    expect_frames(frames<true>());
    EXPECT_TRUE(same_bits(refine(cube, frames<true>(), 3), refine(cube, frames<false>(), 3)));
    const auto once = refine(cube, frames<false>(), 1);
    EXPECT_EQ(count(once.topology()).boundary_edges, 24U);
    EXPECT_EQ(once.point(8), (shapes::point{-.5, -.5, -1}));
}

TEST(refine, takes_a_list_of_points_and_a_list_of_faces)
{
    const auto house = shapes::shaken(shapes::house());
    const auto right = refine(native(house), kith::catmull_clark(), 2);
    EXPECT_TRUE(same_bits(refine(house.points, house.faces, kith::catmull_clark(), 2), right));
    EXPECT_TRUE(same_bits(refine(house.points, kith::face_list(house.faces), kith::catmull_clark(), 2), right));

    const std::array<shapes::point, 4> points{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
    const std::vector<std::array<int, 3>> faces{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    const auto fine = refine(points, faces, kith::loop(), 1);
    EXPECT_TRUE(same_bits(fine, refine(kith::make_mesh(points, faces), kith::loop(), 1)));
    EXPECT_EQ(error_text<kith::mesh_error>([&] {
                  static_cast<void>(refine(points, std::vector<std::vector<int>>{{0, 1, 7}}, kith::loop(), 1));
              }),
              error_text<kith::mesh_error>(
                  [&] { static_cast<void>(kith::make_mesh(points, std::vector<std::vector<int>>{{0, 1, 7}})); }));
}

TEST(refine, gives_its_faces_as_lists)
{
    const auto house = refine(native(shapes::house()), kith::catmull_clark(), 1);
    const auto quads = house.faces_as<std::array<int, 4>>();
    const auto lists = house.faces_as<std::vector<std::size_t>>();
    ASSERT_EQ(quads.size(), house.face_count());
    ASSERT_EQ(lists.size(), house.face_count());
    for (std::size_t f = 0; f < house.face_count(); ++f) {
        EXPECT_TRUE(std::ranges::equal(quads[f], house.face(f)));
        EXPECT_TRUE(std::ranges::equal(lists[f], house.face(f)));
        EXPECT_TRUE(std::ranges::equal(house.faces()[f], house.face(f)));
    }
    EXPECT_TRUE(same_bits(kith::make_mesh(house.points(), kith::face_list(house.faces())),
                          kith::make_mesh(house.points(), quads)));
    EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(house.faces_as<std::array<int, 3>>()); }),
              "face 0 has 4 vertices, not 3; take faces_as<std::vector<int>>(), or triangulate the mesh first");
}
