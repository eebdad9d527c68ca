// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/association/association_space.hpp>

#include "support/error_text.hpp"
#include "support/own_scheme.hpp"

#include <gtest/gtest.h>

#include <vector>

// Each test is a row of the thesis's table 4.1: it sets vertices under tuples of this kind and reads them by other
// elements.

namespace {

using namespace kith::targets;
using kith::new_vertices;
using points = std::vector<shapes::point>;

const shapes::shape control = shapes::shaken(shapes::house());

shapes::point mean(const std::vector<std::size_t>& vertices)
{
    shapes::point result{};
    for (const std::size_t v : vertices)
        for (std::size_t i = 0; i < 3; ++i)
            result[i] += control.points[v][i] / double(vertices.size());
    return result;
}
points face_centres()
{
    points result;
    for (const auto& f : control.faces)
        result.push_back(mean(f));
    return result;
}
points edge_centres()
{
    const auto mesh = native(control);
    points result;
    for (std::size_t e = 0; e < mesh.edge_count(); ++e) {
        const auto& t = mesh.topology();
        const auto left = t.halfedge_corner[2 * e], right = t.halfedge_corner[2 * e + 1];
        result.push_back(mean({t.corner_vertex[left], t.corner_vertex[right]}));
    }
    return result;
}

/// Expects the last of the new vertices at these points.
void expect_last(const points& made, const points& last)
{
    ASSERT_GE(made.size(), last.size());
    for (std::size_t i = 0; i < last.size(); ++i)
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_NEAR(made[made.size() - last.size() + i][j], last[i][j], 1e-14) << "vertex " << i;
}

} // namespace

TEST(association_space, under_vertices)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto v : coarse.vertices())
            assoc(v, V) = v;
        for (auto f : coarse.faces())
            assoc(f, V) = average(assoc(f.vertices(), V));
    };
    const auto made = make_vertices(native(control), new_vertices(kith::per_vertex, kith::per_face), text);
    EXPECT_TRUE(std::equal(control.points.begin(), control.points.end(), made.begin()));
    expect_last(made, face_centres());
}

TEST(association_space, under_edges)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto e : coarse.edges())
            assoc(e, V) = average(e.org(), e.dst());
        for (auto f : coarse.faces())
            assoc(f, V) = average(assoc(f.edges(), V));
    };
    const auto made = make_vertices(native(control), new_vertices(kith::per_edge, kith::per_face), text);
    expect_last(made, face_centres());
}

TEST(association_space, under_faces)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto f : coarse.faces())
            assoc(f, V) = average(f.vertices());
        for (auto e : coarse.edges())
            assoc(e, V) = average(assoc(e.lface(), V), assoc(e.rface(), V));
    };
    const auto made = make_vertices(native(control), new_vertices(kith::per_face, kith::per_edge), text);
    EXPECT_EQ(made.size(), 31U);
    const auto centres = face_centres();
    EXPECT_NEAR(made[11][0], (centres[0][0] + centres[4][0]) / 2, 1e-14); // edge 0-1 between faces 0 and 4
    EXPECT_TRUE(std::equal(made.begin(), made.begin() + 11, centres.begin(), [](const auto& a, const auto& b) {
        return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) < 1e-14;
    }));
}

TEST(association_space, under_vertex_and_face)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto c : coarse.corners()) {
            const auto v = c.v();
            assoc(v, c.f(), V) = v;
        }
        for (auto f : coarse.faces())
            assoc(f, V) = average(assoc(f, f.vertices(), V));
    };
    const auto made = make_vertices(native(control), new_vertices(kith::per_corner, kith::per_face), text);
    expect_last(made, face_centres());
}

TEST(association_space, under_vertex_and_edge)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto v : coarse.vertices())
            for (auto e : v.edges())
                assoc(v, e, V) = v;
        for (auto e : coarse.edges())
            assoc(e, V) = average(assoc(e.org(), e, V), assoc(e, e.dst(), V));
    };
    const auto made = make_vertices(native(control), new_vertices(kith::per_end, kith::per_edge), text);
    expect_last(made, edge_centres());
}

TEST(association_space, under_edge_and_face)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto f : coarse.faces())
            for (auto e : f.edges())
                assoc(e, f, V) = average(e.org(), e.dst());
        for (auto f : coarse.faces())
            assoc(f, V) = average(assoc(f, f.edges(), V));
    };
    const auto made = make_vertices(native(control), new_vertices(kith::per_side, kith::per_face), text);
    expect_last(made, face_centres());
}

TEST(association_space, under_vertex_face_and_edge)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto c : coarse.corners()) {
            const auto v = c.v();
            assoc(v, c.f(), c.next_edge(), V) = v;
            assoc(c.prev_edge(), v, c.f(), V) = c.prev().v();
        }
        for (auto f : coarse.faces()) // averages each vertex twice: as itself and as the previous vertex
            assoc(f, V) = 1. / 2 * average(f.corners().map([&](auto c) {
                              return assoc(c.f(), c.v(), c.next_edge(), V) + assoc(c, c.prev_edge(), V);
                          }));
    };
    const auto made = make_vertices(native(control), new_vertices(kith::per_corner_side, kith::per_face), text);
    expect_last(made, face_centres());
}

TEST(association_space, under_two_neighbouring_vertices)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto e : coarse.edges())
            assoc(e.dst(), e.org(), V) = average(e.org(), e.dst());
        for (auto v : coarse.vertices()) {
            const auto w = v.first_corner().next().v();
            assoc(v, V) = 2. * assoc(v, w, V) - w;
        }
    };
    const auto made = make_vertices(native(control), new_vertices(kith::per_vertex, kith::per_edge), text);
    expect_last(made, edge_centres());
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(made[7][i], control.points[7][i], 1e-14);
}

TEST(association_space, under_two_neighbouring_faces)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto e : coarse.edges())
            assoc(e.lface(), e.rface(), V) = average(e.org(), e.dst());
        for (auto f : coarse.faces())
            assoc(f, V) = average(f.corners().map([&](auto c) { return assoc(c.across().f(), c.f(), V); }));
    };
    const auto made = make_vertices(native(control), new_vertices(kith::per_face, kith::per_edge), text);
    expect_last(made, edge_centres());
    EXPECT_NEAR(made[10][2], face_centres()[10][2], 1e-14);
}

TEST(association_space, a_vertex_may_be_a_copy_of_another)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        const auto v = coarse.vertices();
        assoc(v[1], V) = v[2];
        assoc(v[0], V) = assoc(v[1], V);
        auto last = assoc(v[2], V);
        last = assoc(v[0], V);
    };
    const auto made = make_vertices(native(shapes::polygon(3)), new_vertices(kith::per_vertex), text);
    EXPECT_EQ(made, (points{3, shapes::polygon(3).points[2]}));
}

TEST(association_space, of_a_pass_between_two_levels)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        const auto corners = assoc.pass(new_vertices(kith::per_corner));
        for (auto c : coarse.corners())
            corners(c, V) = c.v();
        for (auto f : coarse.faces())
            assoc(f, V) = average(corners(f.corners(), V));
    };
    expect_last(make_vertices(native(control), new_vertices(kith::per_face), text), face_centres());
}

TEST(association_space, masks_join_the_coarse_level_passes_and_the_next_level)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        const auto edges = assoc.pass(new_vertices(kith::per_edge));
        for (auto e : coarse.edges())
            edges(e, V) = average(e.org(), e.dst());
        for (auto f : coarse.faces()) // edge midpoints and vertices have the same mean
            assoc(f, V) = 1. / 4 * average(edges(f.edges(), V)) + 3. / 4 * average(f.vertices());
        for (auto v : coarse.vertices())
            assoc(v, V) = assoc(v.first_corner().f(), V) + v - edges(v.first_corner().next_edge(), V);
    };
    const auto made = make_vertices(native(control), new_vertices(kith::per_vertex, kith::per_face), text);
    expect_last(made, face_centres());
    const auto mesh = native(control);
    const kith::level_of<mesh3d> level(mesh);
    const auto c = level.vertices()[3].first_corner();
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(
            made[3][i], face_centres()[c.f().index()][i] + c.v().point()[i] / 2 - c.next().v().point()[i] / 2, 1e-14);
}

TEST(association_space, of_a_pass_is_checked_like_any_other)
{
    const auto run = [](const auto& text) {
        return error_text<kith::association_error>(
            [&] { make_vertices(native(control), new_vertices(kith::per_face), text); });
    };
    EXPECT_EQ(run([](const auto& coarse, const auto& assoc) {
                  const auto edges = assoc.pass(new_vertices(kith::per_edge));
                  assoc(coarse.faces()[0], V) = average(edges(coarse.faces()[0].edges(), V));
              }),
              "assoc(e 0) -> V is read before it is set");
    EXPECT_EQ(run([](const auto& coarse, const auto& assoc) {
                  const auto corners = assoc.pass(new_vertices(kith::per_corner));
                  for (int i = 0; i < 2; ++i)
                      corners(coarse.corners()[0], V) = coarse.corners()[0].v();
              }),
              "assoc(f 0, v 0) -> V is set twice");
}

TEST(association_space, of_a_pass_can_be_written_again)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        const auto faces = assoc.pass(new_vertices(kith::per_face));
        for (auto f : coarse.faces())
            faces(f, V) = f.first_corner().v();
        const auto& again = faces.again();
        for (auto f : coarse.faces())
            again(f, V) = average(f.vertices());
        for (auto f : coarse.faces())
            assoc(f, V) = again(f, V);
    };
    expect_last(make_vertices(native(control), new_vertices(kith::per_face), text), face_centres());
}
