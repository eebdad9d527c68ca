// SPDX-License-Identifier: BSD-3-Clause
#include <kith/repair.hpp>

#include "support/error_text.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

namespace {

using shapes::polygons;
using indices = std::vector<std::size_t>;
using kith::repair_options;
using kith::repair_step;

/// Returns distinct points: vertex v at (v, v², 0).
std::vector<shapes::point> some_points(std::size_t n)
{
    std::vector<shapes::point> result;
    for (std::size_t v = 0; v < n; ++v)
        result.push_back({double(v), double(v * v), 0});
    return result;
}
auto mend(std::size_t vertices, const polygons& faces, const repair_options& options)
{
    return kith::repair(some_points(vertices), faces, options);
}
template <class Repaired>
polygons faces_of(const Repaired& r)
{
    polygons result;
    for (std::size_t f = 0; f < r.faces.size(); ++f)
        result.emplace_back(r.faces[f].begin(), r.faces[f].end());
    return result;
}
/// Returns the error of make_mesh for the result, or "no error".
template <class Repaired>
std::string refusal(const Repaired& r)
{
    return error_text<kith::mesh_error>([&] { kith::make_mesh(r.points, r.faces); });
}
/// Expects that the maps of the result agree with its points, its faces and the old corners.
template <class Points, class Repaired>
void expect_maps(const Points& points, const polygons& faces, const Repaired& r)
{
    const kith::face_list old(faces);
    ASSERT_EQ(r.points.size(), r.from_vertex.size());
    for (std::size_t v = 0; v < r.points.size(); ++v)
        EXPECT_EQ(r.points[v], points[r.from_vertex[v]]);
    ASSERT_EQ(r.from_face.size(), r.faces.size());
    EXPECT_TRUE(std::ranges::is_sorted(r.from_face));
    ASSERT_EQ(r.from_corner.size(), r.faces.vertices.size());
    ASSERT_EQ(r.vertex_at.size(), old.vertices.size());
    for (std::size_t f = 0; f < r.faces.size(); ++f)
        for (std::size_t c = r.faces.first[f]; c < r.faces.first[f + 1]; ++c) {
            EXPECT_GE(r.from_corner[c], old.first[r.from_face[f]]);
            EXPECT_LT(r.from_corner[c], old.first[r.from_face[f] + 1]);
            EXPECT_EQ(r.vertex_at[r.from_corner[c]], r.faces.vertices[c]);
        }
}
auto mended(std::size_t vertices, const polygons& faces, const repair_options& options)
{
    const auto result = mend(vertices, faces, options);
    expect_maps(some_points(vertices), faces, result);
    EXPECT_EQ(refusal(result), "no error");
    return result;
}

const polygons moebius{{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 3, 0, 5}}; // of 6 vertices
const polygons bow_tie{{0, 1, 2}, {0, 3, 4}};                     // of 5
const polygons book{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};             // of 5
const polygons turned{{0, 1, 2}, {0, 1, 3}};                      // of 4

/// Returns a strip of n quads whose ends are joined with a half twist.
polygons moebius_strip(std::size_t n)
{
    polygons result;
    for (std::size_t i = 0; i + 1 < n; ++i)
        result.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    result.push_back({2 * n - 2, 1, 0, 2 * n - 1});
    return result;
}

} // namespace

TEST(repair, changes_nothing_unless_it_is_told_to)
{
    for (const auto& faces : {moebius, bow_tie, book, turned, polygons{{0, 1, 1, 2}, {0, 1}, {}, {0, 1, 2}}}) {
        const auto r = mend(6, faces, {});
        EXPECT_EQ(faces_of(r), faces);
        EXPECT_EQ(r.report.text(), "");
        expect_maps(some_points(6), faces, r);
    }
}

TEST(repair, leaves_good_meshes_as_they_are)
{
    const auto [points, faces] = shapes::house();
    const auto r = kith::repair(points, faces, {.drop = true, .split = true, .orient = true, .weld = 1e-9});
    EXPECT_EQ(faces_of(r), faces);
    EXPECT_EQ(r.points, points);
    EXPECT_EQ(r.report.text(), "");
}

TEST(repair, refuses_vertices_that_do_not_exist)
{
    const std::string text = "face 1: vertex 7 does not exist, there are 4; correct the index";
    for (const repair_options& options :
         {repair_options{}, repair_options{.drop = true}, repair_options{.split = true, .orient = true, .weld = 1}})
        EXPECT_EQ(error_text<kith::mesh_error>([&] { mend(4, {{0, 1, 2}, {0, 1, 7}}, options); }), text);
    EXPECT_NE(error_text<kith::mesh_error>([&] {
                  kith::repair(some_points(4), kith::face_list(polygons{{0, 1, 7}}), {.drop = true}, 1);
              }).find("face 1: vertex 8 does not exist"),
              std::string::npos);
}

TEST(repair, a_moebius_strip_is_cut_when_edges_may_be_split)
{
    for (const bool orient : {false, true}) {
        const auto r = mended(6, moebius, {.split = true, .orient = orient});
        EXPECT_EQ(faces_of(r), (polygons{{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 6, 7, 5}}));
        EXPECT_EQ(r.from_vertex, (indices{0, 1, 2, 3, 4, 5, 3, 0}));
        EXPECT_EQ(r.report.text(),
                  "edge 0-3: cut, as faces 0 and 2 run through it in the same direction" +
                      std::string(orient ? " and the surface is one-sided" : "") +
                      "\nvertex 0: split into 2 vertices, one for each fan of faces\n"
                      "vertex 3: split into 2 vertices, one for each fan of faces");
        const auto mesh = kith::make_mesh(r.points, r.faces);
        EXPECT_EQ(mesh.vertex_count() + mesh.face_count() - mesh.edge_count(), 1U); // a disc
    }
}

TEST(repair, a_moebius_strip_stays_one_sided_when_faces_may_only_be_turned)
{
    const auto r = mend(6, moebius, {.orient = true});
    EXPECT_EQ(refusal(r),
              "edge 0-3: faces 0 and 2 run through it in the same direction, and reversing faces does not help, as the "
              "surface is one-sided (not orientable); cut it along edges from boundary to boundary");
}

TEST(repair, a_moebius_strip_loses_a_face_when_faces_may_be_dropped)
{
    const auto r = mended(6, moebius, {.drop = true, .orient = true});
    EXPECT_EQ(faces_of(r), (polygons{{0, 1, 4, 3}, {1, 2, 5, 4}}));
    EXPECT_EQ(r.report.text(), "face 2: left out, as another face runs through edge 0-3 in the same direction");
    EXPECT_EQ(faces_of(mended(6, moebius, {.drop = true})), faces_of(r));
}

TEST(repair, long_moebius_strips_are_cut_once)
{
    for (const std::size_t n : {5U, 50U, 51U}) {
        auto strip = moebius_strip(n);
        for (std::size_t f = 0; f < n; f += 3)
            std::ranges::reverse(strip[f]);
        const auto r = mended(2 * n, strip, {.split = true, .orient = true});
        EXPECT_EQ(r.faces.size(), n);
        EXPECT_EQ(r.points.size(), 2 * n + 2);
        EXPECT_EQ(r.report.count(repair_step::cut_edge), 1U);
    }
}

TEST(repair, a_klein_bottle_is_cut_into_a_surface_with_two_sides)
{
    polygons bottle;
    const std::size_t n = 6;
    const auto at = [&](std::size_t i, std::size_t j) { // joins the ends with j reversed
        return i < n ? i * n + j % n : (n - j % n) % n;
    };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            bottle.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    EXPECT_NE(refusal(mend(n * n, bottle, {.orient = true})).find("one-sided"), std::string::npos);
    const auto r = mended(n * n, bottle, {.split = true, .orient = true});
    EXPECT_EQ(r.faces.size(), n * n);
    EXPECT_GT(r.report.count(repair_step::cut_edge), 0U);
    const auto dropped = mended(n * n, bottle, {.drop = true, .orient = true});
    EXPECT_LT(dropped.faces.size(), n * n);
    EXPECT_GT(dropped.faces.size(), n * n / 2);
}

TEST(repair, pinched_vertices_become_one_per_fan)
{
    const auto r = mended(5, bow_tie, {.split = true});
    EXPECT_EQ(faces_of(r), (polygons{{0, 1, 2}, {5, 3, 4}}));
    EXPECT_EQ(r.from_vertex, (indices{0, 1, 2, 3, 4, 0}));
    EXPECT_EQ(r.report.text(), "vertex 0: split into 2 vertices, one for each fan of faces");

    auto cubes = shapes::both(shapes::cube(), shapes::cube());
    for (auto& f : cubes.faces)
        std::ranges::replace(f, std::size_t(8), std::size_t(6));
    const auto two = kith::repair(cubes.points, cubes.faces, {.split = true});
    EXPECT_EQ(two.report.count(repair_step::split_vertex), 1U);
    EXPECT_EQ(two.from_vertex.back(), 6U);
    EXPECT_TRUE(std::ranges::none_of(faces_of(two), [](const auto& f) { return std::ranges::count(f, 8) != 0; }));
}

TEST(repair, the_larger_fan_stays_at_a_pinched_vertex)
{
    const auto r = mended(6, {{0, 1, 2}, {0, 3, 4}, {0, 4, 5}}, {.drop = true});
    EXPECT_EQ(faces_of(r), (polygons{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(r.from_vertex, (indices{0, 3, 4, 5}));
    EXPECT_EQ(r.report.text(),
              "face 0: left out, as it does not join the larger fan of faces at vertex 0\n"
              "vertex 1: left out, it belongs to no face\nvertex 2: left out, it belongs to no face");
    EXPECT_EQ(faces_of(mended(5, bow_tie, {.drop = true})), (polygons{{0, 1, 2}}));
}

TEST(repair, three_sheets_at_an_edge_get_an_edge_each)
{
    const auto r = mended(5, book, {.split = true});
    EXPECT_EQ(faces_of(r), (polygons{{0, 1, 2}, {5, 6, 3}, {7, 8, 4}}));
    EXPECT_EQ(r.from_vertex, (indices{0, 1, 2, 3, 4, 1, 0, 0, 1}));
    EXPECT_EQ(r.report.lines()[0], "edge 0-1: cut, as it has 3 faces");
}

/// The sheet stays whole if a fin on one of its inner edges is cut off.
TEST(repair, a_sheet_stays_whole_where_a_fin_is_cut_off)
{
    auto [points, faces] = shapes::grid(2, 2); // 3 x 3 vertices
    const auto middle = std::size_t(4);
    std::size_t other = 0;
    for (const auto& f : faces)
        if (const auto at = std::ranges::find(f, middle); at != f.end())
            other = f[std::size_t(at - f.begin() + 1) % f.size()];
    points.push_back({.5, .5, 5});
    polygons with_fin = faces;
    with_fin.insert(with_fin.begin(), {middle, other, 9});
    const auto r = kith::repair(points, with_fin, {.split = true});
    ASSERT_EQ(refusal(r), "no error");
    EXPECT_EQ(r.points.size(), 12U);
    const auto mesh = kith::make_mesh(r.points, r.faces);
    EXPECT_EQ(mesh.edge_count(), 12U + 3U);
    const auto dropped = kith::repair(points, with_fin, {.drop = true}); // removes the smaller part of the surface
    EXPECT_EQ(faces_of(dropped), faces);
    EXPECT_EQ(dropped.points.size(), 9U);
}

TEST(repair, two_boxes_that_share_an_edge_become_two_boxes)
{
    auto cubes = shapes::both(shapes::cube(), shapes::cube());
    const auto a = cubes.faces[0][0], b = cubes.faces[0][1];
    for (auto& f : cubes.faces) {
        std::ranges::replace(f, a + 8, a);
        std::ranges::replace(f, b + 8, b);
    }
    const auto r = kith::repair(cubes.points, cubes.faces, {.split = true});
    ASSERT_EQ(refusal(r),
              "vertex " + std::to_string(a + 8) + ": belongs to no face; remove it or give it a face\n" + "vertex " +
                  std::to_string(b + 8) + ": belongs to no face; remove it or give it a face");
    const auto whole = kith::repair(cubes.points, cubes.faces, {.drop = true, .split = true});
    const auto mesh = kith::make_mesh(whole.points, whole.faces);
    EXPECT_EQ(mesh.vertex_count(), 16U);
    EXPECT_EQ(mesh.edge_count(), 24U); // both are closed
}

TEST(repair, faces_beyond_two_at_an_edge_are_left_out)
{
    const auto r = mended(5, book, {.drop = true});
    EXPECT_EQ(faces_of(r), (polygons{{0, 1, 2}, {1, 0, 3}}));
    EXPECT_EQ(r.report.lines()[0], "face 2: left out, as edge 0-1 has 3 faces");
    // If faces may be turned, the directions of two of the three faces make no difference.
    const auto oriented = mended(5, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, {.drop = true, .orient = true});
    EXPECT_EQ(faces_of(oriented), (polygons{{0, 1, 2}, {0, 3, 1}}));
    EXPECT_EQ(oriented.report.lines()[1], "face 1: turned round");
}

TEST(repair, faces_turned_against_each_other_are_turned_back)
{
    const auto r = mended(4, turned, {.orient = true});
    EXPECT_EQ(faces_of(r), (polygons{{0, 1, 2}, {0, 3, 1}}));
    EXPECT_EQ(r.from_corner, (indices{0, 1, 2, 3, 5, 4}));
    EXPECT_EQ(r.report.text(), "face 1: turned round");

    auto [points, faces] = shapes::cube();
    for (const std::size_t f : {0U, 4U}) { // the minority is turned round
        auto bad = faces;
        std::ranges::reverse(bad[f].begin() + 1, bad[f].end());
        const auto good = kith::repair(points, bad, {.orient = true});
        EXPECT_EQ(faces_of(good), faces);
        EXPECT_EQ(good.report.text(), "face " + std::to_string(f) + ": turned round");
        const auto dropped = kith::repair(points, bad, {.drop = true}); // removes the one face against all others
        EXPECT_EQ(dropped.from_face.size(), 5U);
        EXPECT_EQ(std::ranges::count(dropped.from_face, f), 0);
        EXPECT_EQ(refusal(kith::repair(points, bad, {.split = true})), "no error");
    }
}

TEST(repair, repeated_corners_are_left_out)
{
    const auto r = mended(4, {{0, 1, 1, 2, 3, 3, 0}}, {.drop = true});
    EXPECT_EQ(faces_of(r), (polygons{{0, 1, 2, 3}}));
    EXPECT_EQ(r.from_corner, (indices{0, 1, 3, 4}));
    EXPECT_EQ(r.vertex_at, (indices{0, 1, 1, 2, 3, 3, 0}));
    EXPECT_EQ(r.report.text(), "face 0: its repeated corner at vertex 1 is left out");
    EXPECT_EQ(faces_of(mended(4, {{0, 1, 1, 2, 3}}, {.weld = 0})), (polygons{{0, 1, 2, 3}}));
    EXPECT_EQ(faces_of(mended(4, {{0, 1, 1, 2, 3}}, {.split = true})), (polygons{{0, 1, 2, 3}}));
    EXPECT_NE(refusal(mend(4, {{0, 1, 1, 2, 3}}, {.orient = true})).find("contains vertex 1 twice"), std::string::npos);
}

TEST(repair, degenerate_faces_are_left_out)
{
    const auto r = mended(4, {{0, 1}, {}, {2, 2, 2}, {0, 1, 2}, {3, 1, 3, 2}}, {.drop = true});
    EXPECT_EQ(faces_of(r), (polygons{{0, 1, 2}}));
    EXPECT_EQ(r.report.text(),
              "face 0: left out, as it has 2 corners\nface 1: left out, as it has 0 corners\n"
              "face 2: left out, as it has 1 corner\nface 4: left out, as it contains vertex 3 twice\n"
              "vertex 3: left out, it belongs to no face");
    EXPECT_EQ(r.vertex_at[0], r.none);
    EXPECT_EQ(refusal(mend(3, {{0, 1}}, {.drop = true})), "the mesh has no faces; nothing can be refined");
    EXPECT_NE(refusal(mend(4, {{0, 1}, {0, 1, 2}}, {.split = true, .orient = true})).find("has 2 corners"),
              std::string::npos);
}

/// A face with a hole that contains an edge twice is cut along this edge.
TEST(repair, a_face_that_comes_to_an_edge_twice_is_cut_there_or_left_out)
{
    const polygons keyhole{{0, 1, 2, 3, 0, 4, 5, 6, 4}};
    const auto r = mended(7, keyhole, {.split = true});
    EXPECT_EQ(faces_of(r), (polygons{{0, 1, 2, 3, 7, 4, 5, 6, 8}}));
    EXPECT_EQ(r.report.lines()[0], "edge 0-4: cut, as face 0 contains it twice");
    EXPECT_EQ(mend(7, keyhole, {.drop = true}).faces.size(), 0U);
}

TEST(repair, faces_given_twice_are_left_out_once)
{
    auto [points, faces] = shapes::cube();
    auto twice = faces;
    twice.insert(twice.begin() + 1, {faces[0][2], faces[0][3], faces[0][0], faces[0][1]});
    auto back = faces[3];
    std::ranges::reverse(back);
    twice.push_back(back);
    const auto r = kith::repair(points, twice, {.drop = true});
    EXPECT_EQ(faces_of(r), faces);
    EXPECT_EQ(r.report.text(), "face 1: left out, as it repeats face 0\nface 7: left out, as it repeats face 4");
    const polygons leaf{{0, 1, 2}, {2, 1, 0}}; // a closed surface
    EXPECT_EQ(faces_of(mended(3, leaf, {.drop = true})), leaf);
    EXPECT_EQ(faces_of(mended(3, {{0, 1, 2}, {2, 1, 0}, {1, 0, 2}, {1, 2, 0}}, {.drop = true})), leaf);
}

TEST(repair, vertices_without_a_face_are_left_out_with_drop_only)
{
    const polygons triangle{{0, 1, 3}};
    EXPECT_EQ(mended(4, triangle, {.drop = true}).from_vertex, (indices{0, 1, 3}));
    EXPECT_EQ(mend(4, triangle, {.split = true, .orient = true, .weld = .1}).from_vertex, (indices{0, 1, 2, 3}));
}

TEST(repair, equal_points_at_the_boundary_are_joined)
{
    const auto [points, faces] = shapes::cube();
    std::vector<shapes::point> soup;
    polygons apart;
    for (const auto& f : faces) {
        apart.emplace_back();
        for (const std::size_t v : f) {
            apart.back().push_back(soup.size());
            soup.push_back(points[v]);
        }
    }
    const auto r = kith::repair(soup, apart, {.weld = 0});
    expect_maps(soup, apart, r);
    ASSERT_EQ(refusal(r), "no error");
    EXPECT_EQ(r.points.size(), 8U);
    EXPECT_EQ(kith::make_mesh(r.points, r.faces).edge_count(), 12U);
    EXPECT_EQ(r.report.count(repair_step::joined_vertex), 16U);
    EXPECT_EQ(r.report.lines().back(), "and 8 more: joined vertices");
    EXPECT_EQ(kith::coinciding_vertices(soup, kith::face_list(apart)).size(), 16U);
    for (std::size_t c = 0; c < 24; ++c)
        EXPECT_EQ(r.points[r.vertex_at[c]], soup[c]);
}

TEST(repair, points_within_the_tolerance_are_joined_with_the_first_one)
{
    std::vector<shapes::point> points{
        {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1 + 1e-12, 1e-12, 0}, {-1e-12, 1, 0}, {1, 1, 0}};
    const polygons faces{{0, 1, 2}, {3, 5, 4}};
    EXPECT_EQ(kith::repair(points, faces, {.weld = 0}).points.size(), 6U);
    EXPECT_EQ(kith::repair(points, faces, {.weld = 1e-13}).points.size(), 6U);
    const auto r = kith::repair(points, faces, {.weld = 2e-12});
    EXPECT_EQ(faces_of(r), (polygons{{0, 1, 2}, {1, 3, 2}}));
    EXPECT_EQ(r.points[1], points[1]);
    EXPECT_EQ(r.points[3], points[5]);
    EXPECT_EQ(r.report.text(), "vertex 3: joined with vertex 1\nvertex 4: joined with vertex 2");
    EXPECT_GT(kith::rounding_distance(points), 1e-6);
    EXPECT_LT(kith::rounding_distance(points), 2e-6);
}

TEST(repair, faces_whose_vertices_are_joined_are_left_out)
{
    const std::vector<shapes::point> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1e-9, 0}};
    const polygons faces{{0, 1, 2, 3}, {4, 0, 3}};
    const auto r = kith::repair(points, faces, {.weld = 1e-8});
    EXPECT_EQ(faces_of(r), (polygons{{0, 1, 2, 3}}));
    EXPECT_EQ(r.vertex_at, (indices{0, 1, 2, 3, r.none, r.none, r.none}));
    EXPECT_EQ(r.report.text(), "vertex 4: joined with vertex 0\nface 1: left out, as its vertices were joined");
}

/// Two boxes that touch in a corner keep two vertices there. Joining these would make a vertex with two fans.
TEST(repair, vertices_that_faces_surround_are_not_joined)
{
    const auto cubes = shapes::both(shapes::cube(), shapes::cube()); // both at the same place
    const auto r = kith::repair(cubes.points, cubes.faces, {.weld = 0});
    EXPECT_EQ(faces_of(r), cubes.faces);
    EXPECT_TRUE(kith::coinciding_vertices(cubes.points, kith::face_list(cubes.faces)).empty());
}

TEST(repair, tolerances_of_all_sizes)
{
    const double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
    const std::vector<shapes::point> points{{huge, 0, 0}, {-huge, 0, 0}, {0, tiny, 0}, {0, -0., 0}, {1e300, 1, 1}};
    const polygons faces{{0, 1, 2}, {0, 3, 4}};
    for (const double tolerance : {0., tiny, 1e-300, 1e-9, 1.})
        EXPECT_EQ(kith::repair(points, faces, {.weld = tolerance}).points.size(), tolerance == 0 ? 5U : 4U)
            << tolerance;
    for (const double bad : {-1., std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::repair(points, faces, {.weld = bad}); }),
                  "the distance within which vertices are joined is not a finite number of 0 or more; give one");
    const std::vector<shapes::point> not_finite{{std::nan(""), 0, 0}, {std::nan(""), 0, 0}, {1, 0, 0}};
    EXPECT_EQ(kith::repair(not_finite, polygons{{0, 1, 2}}, {.weld = 1}).points.size(), 3U);
}

TEST(repair, all_ways_together_mend_anything)
{
    std::size_t seed = 1;
    const auto random = [&](std::size_t n) {
        seed = seed * 6364136223846793005U + 1442695040888963407U;
        return std::size_t(seed >> 33) % n;
    };
    for (int round = 0; round < 300; ++round) {
        const std::size_t n = 4 + random(8);
        polygons faces;
        for (std::size_t f = 0, end = 1 + random(14); f < end; ++f) {
            faces.emplace_back();
            for (std::size_t i = 0, corners = 2 + random(4); i < corners; ++i)
                faces.back().push_back(random(n));
        }
        for (const repair_options& options : {repair_options{.drop = true},
                                              repair_options{.drop = true, .split = true},
                                              repair_options{.drop = true, .orient = true},
                                              repair_options{.drop = true, .split = true, .orient = true, .weld = 0}}) {
            const auto r = mend(n, faces, options);
            expect_maps(some_points(n), faces, r);
            const auto report = kith::validate(r.points, r.faces);
            EXPECT_TRUE(report.ok() or r.faces.size() == 0) << report.text();
            const auto again = mend(n, faces, options);
            EXPECT_EQ(faces_of(again), faces_of(r));
            EXPECT_EQ(again.report.text(), r.report.text());
        }
    }
}

TEST(repair, splitting_alone_mends_edges_and_vertices)
{
    std::size_t seed = 7;
    const auto random = [&](std::size_t n) {
        seed = seed * 6364136223846793005U + 1442695040888963407U;
        return std::size_t(seed >> 33) % n;
    };
    for (int round = 0; round < 300; ++round) {
        const std::size_t n = 5 + random(4);
        polygons faces;
        for (std::size_t f = 0, end = 2 + random(14); f < end; ++f) {
            indices vertices(n);
            std::ranges::generate(vertices, [v = std::size_t(0)]() mutable { return v++; });
            for (std::size_t i = n; i > 1; --i)
                std::swap(vertices[i - 1], vertices[random(i)]);
            vertices.resize(3 + random(2));
            faces.push_back(vertices);
        }
        for (const bool orient : {false, true}) {
            const auto r = mend(n, faces, {.split = true, .orient = orient});
            EXPECT_EQ(r.faces.size(), faces.size());
            const auto report = kith::validate(r.points, r.faces);
            EXPECT_EQ(report.lines().size(), std::min<std::size_t>(report.count(kith::problem::isolated_vertex), 9))
                << report.text();
        }
    }
}

TEST(repair, twice_as_many_faces_take_about_twice_as_long)
{
    const auto seconds = [](std::size_t n, const auto& work) {
        double least = 1e9;
        for (int i = 0; i < 3; ++i) {
            const std::clock_t start = std::clock(); // time of this process only
            work(n);
            least = std::min(least, double(std::clock() - start) / CLOCKS_PER_SEC);
        }
        return least;
    };
    const auto expect_linear = [&](const char* name, const auto& work) {
        const double once = seconds(1000, work), four_times = seconds(4000, work);
        EXPECT_LT(four_times, 9 * once + .01) << name; // quadratic: 16
    };
    expect_linear("cracks", [](std::size_t n) { // unconnected triangles
        std::vector<shapes::point> points;
        polygons faces;
        for (std::size_t f = 0; f < n; ++f) {
            faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
            points.insert(points.end(), {{double(f), 0, 0}, {double(f) + 1, 0, 0}, {double(f), 1, 0}});
        }
        EXPECT_EQ(kith::repair(points, faces, {.weld = 1e-6}).points.size(), 2 * n + 1);
    });
    expect_linear("equal points", [](std::size_t n) {
        const std::vector<shapes::point> points(3 * n);
        polygons faces;
        for (std::size_t f = 0; f < n; ++f)
            faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
        EXPECT_EQ(kith::repair(points, faces, {.weld = 1e-6}).points.size(), 1U);
    });
    expect_linear("a book", [](std::size_t n) {
        polygons pages;
        for (std::size_t f = 0; f < n; ++f)
            pages.push_back({0, 1, f + 2});
        EXPECT_EQ(mend(n + 2, pages, {.drop = true}).faces.size(), 1U);
        EXPECT_EQ(mend(n + 2, pages, {.split = true}).points.size(), 3 * n);
    });
    expect_linear("a bundle", [](std::size_t n) {
        polygons leaves;
        for (std::size_t f = 0; f < n; ++f)
            leaves.push_back({0, 2 * f + 1, 2 * f + 2});
        EXPECT_EQ(mend(2 * n + 1, leaves, {.drop = true}).faces.size(), 1U);
        EXPECT_EQ(mend(2 * n + 1, leaves, {.split = true}).points.size(), 3 * n);
    });
}
