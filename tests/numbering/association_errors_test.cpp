// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/association/association_space.hpp>

#include "support/scheme_fault.hpp"

#include <kith/refine.hpp>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

// Each fault of a scheme is reported with its tuple. For faults of new edges see edge_errors_test.cpp.

namespace {

using namespace kith::targets;
using kith::new_edges;
using kith::new_vertices;

template <class Text>
std::string fault(const Text& text)
{
    return fault(shapes::cube(), new_edges<>(), text);
}

} // namespace

TEST(association_errors, a_right_scheme_has_none)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) {
                  copy_vertices(coarse, assoc);
                  copy_faces(coarse, assoc);
              }),
              "no error");
}

TEST(association_errors, reading_before_setting)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) {
                  const auto v = coarse.vertices();
                  assoc(v[0], V) = v[0];
                  assoc(v[1], V) = average(assoc(v[0], V), assoc(v[5], V));
              }),
              "assoc(v 5) -> V is read before it is set");
}

TEST(association_errors, connecting_what_is_never_set)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) { copy_faces(coarse, assoc); }),
              "assoc(v 0) -> V was never set");
}

TEST(association_errors, a_face_may_name_a_vertex_that_is_made_later)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) {
                  copy_faces(coarse, assoc);
                  copy_vertices(coarse, assoc);
              }),
              "no error");
}

TEST(association_errors, setting_twice)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) {
                  copy_vertices(coarse, assoc);
                  assoc(coarse.vertices()[3], V) = coarse.vertices()[2];
              }),
              "assoc(v 3) -> V is set twice");
}

TEST(association_errors, a_vertex_never_set)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) {
                  for (auto v : coarse.vertices())
                      if (v.index() != 7)
                          assoc(v, V) = v;
              }),
              "assoc(v 7) -> V was never set");
}

TEST(association_errors, a_face_never_set)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) { copy_vertices(coarse, assoc); }),
              "assoc(f 0) -> F was never set");
}

TEST(association_errors, a_face_set_twice)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) {
                  copy_vertices(coarse, assoc);
                  copy_faces(coarse, assoc);
                  const auto f = coarse.faces()[2];
                  assoc(f, F) = polygon(assoc(f.vertices(), V));
              }),
              "assoc(f 2) -> F is set twice");
}

TEST(association_errors, a_face_with_too_few_vertices)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) {
                  copy_vertices(coarse, assoc);
                  const auto v = coarse.vertices();
                  assoc(coarse.faces()[1], F) = polygon(assoc(v[0], V), assoc(v[1], V), assoc(v[2], V));
              }),
              "assoc(f 1) -> F has 3 vertices, but its column declares 4");
}

TEST(association_errors, a_face_with_too_many_vertices)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) {
                  copy_vertices(coarse, assoc);
                  const auto v = coarse.vertices();
                  assoc(coarse.faces()[4],
                        F) = polygon(assoc(v[0], V), assoc(v[1], V), assoc(v[2], V), assoc(v[3], V), assoc(v[4], V));
              }),
              "assoc(f 4) -> F has 5 vertices, but its column declares 4");
}

TEST(association_errors, elements_that_do_not_touch)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        assoc(coarse.faces()[1], coarse.vertices()[0], V) = coarse.vertices()[0];
    };
    EXPECT_EQ(error_text<kith::association_error>(
                  [&] { make_vertices(native(shapes::cube()), new_vertices(kith::per_corner), text); }),
              "assoc(f 1, v 0) -> V: the elements do not touch");
}

TEST(association_errors, new_faces_of_elements_that_do_not_touch)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        assoc(coarse.vertices()[0], coarse.faces()[1], F) = polygon(assoc(coarse.faces()[0].vertices(), V));
    };
    const kith::columns columns(new_vertices(kith::per_vertex), kith::new_faces(quads(kith::per_corner)));
    const own_scheme scheme(columns, text);
    EXPECT_EQ(error_text<kith::association_error>([&] { kith::refine(native(shapes::cube()), scheme, 1); }),
              "assoc(f 1, v 0) -> F: the elements do not touch");
}

TEST(association_errors, tuples_that_the_columns_leave_out)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto e : coarse.edges())
            assoc(e, V) = average(e.org(), e.dst());
    };
    EXPECT_EQ(error_text<kith::association_error>(
                  [&] { make_vertices(native(shapes::grid(2, 2)), new_vertices(kith::per_edge.inside()), text); }),
              "assoc(e 0) -> V: the columns of the scheme leave this tuple out");
}

TEST(association_errors, faces_that_form_no_manifold)
{
    const std::string text = fault([](const auto& coarse, const auto& assoc) {
        copy_vertices(coarse, assoc);
        for (auto f : coarse.faces())
            assoc(f, F) = polygon(assoc(coarse.faces()[0].vertices(), V));
    });
    EXPECT_TRUE(text.starts_with("the faces that the scheme made do not form a manifold:\nedge 0-1: 6 faces")) << text;
}

TEST(association_errors, a_face_of_less_than_three_vertices)
{
    const auto pillow = kith::make_mesh(std::vector<std::array<double, 3>>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                        std::vector<std::vector<int>>{{0, 1, 2, 3}, {0, 3, 2, 1}});
    const auto fault_of = [&](auto chosen) { // makes faces of vertices with the chosen corners
        const auto degree = [=](const auto& v) {
            std::size_t corners = 0;
            for (const auto c : v.corners().only(chosen))
                corners += c.v().index() == v.index();
            return corners;
        };
        const auto text = [=](const auto& coarse, const auto& assoc) {
            for (const auto c : coarse.corners())
                assoc(c, V) = c.v();
            for (const auto v : coarse.vertices())
                assoc(v, F) = polygon(assoc(v.corners().only(chosen), V));
        };
        const own_scheme scheme(kith::columns(new_vertices(kith::per_corner),
                                              new_edges<>(),
                                              kith::new_faces(kith::per_vertex.of_degree(degree))),
                                text);
        return error_text<kith::association_error>([&] { kith::refine(pillow, scheme, 1); });
    };
    EXPECT_EQ(fault_of([](const auto&) { return true; }), "assoc(v 0) -> F has 2 vertices; a face has three or more");
    EXPECT_EQ(fault_of([](const auto&) { return false; }), "assoc(v 0) -> F has 0 vertices; a face has three or more");
}
