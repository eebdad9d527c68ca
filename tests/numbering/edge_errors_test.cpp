// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/association/association_space.hpp>

#include "support/scheme_fault.hpp"

#include <gtest/gtest.h>

#include <string>

// Tests of the errors of schemes in the edges that they declare.

namespace {

using namespace kith::targets;
using kith::new_edges;

constexpr auto copy_faces_and_edges = [](const auto& coarse, const auto& assoc) {
    for (auto f : coarse.faces())
        assoc(f, F) = polygon(f.corners(), [&](auto c) {
            const auto e = c.next_edge();
            return assoc(c.v(), V) >> assoc(e, E).along(e);
        });
};

} // namespace

TEST(edge_errors, new_edges_of_elements_that_do_not_touch)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        static_cast<void>(assoc(coarse.vertices()[0], coarse.edges()[8], E).id());
    };
    EXPECT_EQ(fault(shapes::cube(), new_edges(kith::per_end), text), "assoc(e 8, v 0) -> E: the elements do not touch");
}

TEST(edge_errors, lines_without_their_side)
{
    EXPECT_EQ(fault(shapes::cube(),
                    new_edges(kith::per_edge),
                    [](const auto& coarse, const auto& assoc) {
                        copy_vertices(coarse, assoc);
                        copy_faces(coarse, assoc);
                    }),
              "assoc(f 0) -> F: the scheme declares edges, so each line needs its side: "
              "assoc(v, V) >> assoc(v, e, E).along(e)");
}

TEST(edge_errors, a_side_with_two_faces)
{
    EXPECT_EQ(fault(shapes::cube(),
                    new_edges(kith::per_edge),
                    [](const auto& coarse, const auto& assoc) {
                        copy_vertices(coarse, assoc);
                        const auto f = coarse.faces()[0];
                        assoc(f, F) = polygon(f.corners(), [&](auto c) {
                            return assoc(c.v(), V) >> assoc(coarse.edges()[8], E).right();
                        });
                    }),
              "assoc(f 0) -> F: side 1 of new edge 8 has a face already");
}

TEST(edge_errors, an_edge_without_a_face_on_its_left)
{
    EXPECT_EQ(fault(shapes::polygon(4),
                    new_edges(kith::per_edge),
                    [](const auto& coarse, const auto& assoc) {
                        copy_vertices(coarse, assoc);
                        const auto f = coarse.faces()[0];
                        assoc(f, F) = polygon(
                            f.corners(), [&](auto c) { return assoc(c.v(), V) >> assoc(c.next_edge(), E).right(); });
                    }),
              "assoc(e 0) -> E has no face on its left side");
}

TEST(edge_errors, a_vertex_in_no_face)
{
    const own_scheme scheme(kith::columns(kith::new_vertices(kith::per_vertex, kith::per_face),
                                          new_edges(kith::per_edge),
                                          kith::new_faces(quads(kith::per_face))),
                            [](const auto& coarse, const auto& assoc) {
                                copy_vertices(coarse, assoc);
                                copy_faces_and_edges(coarse, assoc);
                                for (auto f : coarse.faces())
                                    assoc(f, V) = average(f.vertices());
                            });
    EXPECT_EQ(error_text<kith::association_error>([&] {
                  kith::numbering_of<decltype(scheme), std::uint32_t> ids;
                  kith::refine_mesh<kith::connect::everything>(native(shapes::cube()), scheme, ids);
              }),
              "assoc(f 0) -> V is in no face");
}

TEST(edge_errors, a_vertex_under_a_tuple_without_a_column)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        copy_vertices(coarse, assoc);
        copy_faces_and_edges(coarse, assoc);
        const auto f = coarse.faces();
        assoc(f[0], f[1], V) = average(f[0].vertices());
    };
    EXPECT_EQ(
        fault(shapes::cube(), new_edges(kith::per_edge), text),
        "assoc(f 0, f 1) -> V: a scheme that declares edges cannot make vertices under tuples that no column declares; "
        "leave edges to be matched");
}

TEST(edge_errors, sides_of_one_edge_that_do_not_join_the_same_vertices)
{
    EXPECT_EQ(fault(shapes::cube(),
                    new_edges(kith::per_edge),
                    [](const auto& coarse, const auto& assoc) {
                        copy_vertices(coarse, assoc);
                        for (auto f : coarse.faces()) // each line names the side of the line after it
                            assoc(f, F) = polygon(f.corners(), [&](auto c) {
                                const auto e = c.next().next_edge();
                                return assoc(c.v(), V) >> assoc(e, E).along(e);
                            });
                    }),
              "assoc(e 0) -> E: its two half-edges join different vertices");
}

TEST(edge_errors, a_fan_that_starts_at_a_corner_or_a_side_that_is_not_its_own)
{
    // Starts vertex 3 of a cube `behind` corners after its own, and at the side that `edge_at` gives.
    const auto start = [](std::size_t behind, const auto& edge_at) {
        return fault(shapes::cube(), new_edges(kith::per_edge), [&](const auto& coarse, const auto& assoc) {
            copy_vertices(coarse, assoc);
            copy_faces_and_edges(coarse, assoc);
            const auto v = coarse.vertices()[3];
            const auto c = v.first_corner();
            const auto e = edge_at(c);
            assoc(v, V).starts_at(assoc(c.f(), F).corner(c.index() % 4 + behind), assoc(e, E).along(e));
        });
    };
    constexpr auto next = [](const auto& c) { return c.next_edge(); };
    constexpr auto previous = [](const auto& c) { return c.prev_edge(); };
    const std::string text = "assoc(v 3) -> V has a wrong start: the corner or the half-edge does not belong to it";
    EXPECT_EQ(start(0, next), "no error");
    EXPECT_EQ(start(1, next), text);
    EXPECT_EQ(start(100'000, next), text); // no corner has this number
    EXPECT_EQ(start(0, previous), text);
}

TEST(edge_errors, lines_with_elements_of_a_pass)
{
    const auto lines = [](const auto& vertex_of, const auto& edge_of) {
        return [=](const auto& coarse, const auto& assoc) {
            copy_vertices(coarse, assoc);
            const auto pass = assoc.pass(kith::columns(kith::new_vertices(kith::per_face, kith::per_vertex),
                                                       new_edges(kith::per_side, kith::per_edge),
                                                       kith::new_faces()));
            for (auto f : coarse.faces())
                assoc(f, F) = polygon(f.corners(), [&](auto c) {
                    const auto e = c.next_edge();
                    return vertex_of(assoc, pass)(c.v(), V) >> edge_of(assoc, pass)(e, E).along(e);
                });
        };
    };
    constexpr auto of_step = [](const auto& assoc, const auto&) -> const auto& { return assoc; };
    constexpr auto of_pass = [](const auto&, const auto& pass) -> const auto& { return pass; };
    EXPECT_EQ(fault(shapes::cube(), new_edges(kith::per_edge), lines(of_step, of_step)), "no error");
    const std::string vertex = fault(shapes::cube(), new_edges(kith::per_edge), lines(of_pass, of_step));
    EXPECT_TRUE(vertex.ends_with(
        "does not exist, there are 8; vertices of a pass are not part of a level; use one of the new level"))
        << vertex;
    const std::string edge = fault(shapes::cube(), new_edges(kith::per_edge), lines(of_step, of_pass));
    EXPECT_TRUE(edge.ends_with(
        "does not exist, there are 12; edges of a pass are not part of a level; use one of the new level"))
        << edge;
}

TEST(edge_errors, edges_that_should_join_faces_and_do_not)
{
    EXPECT_EQ(fault(shapes::cube(),
                    new_edges(kith::per_side), // an edge for each side, so that no two faces share an edge
                    [](const auto& coarse, const auto& assoc) {
                        copy_vertices(coarse, assoc);
                        for (auto f : coarse.faces())
                            assoc(f, F) = polygon(f.corners(), [&](auto c) {
                                return assoc(c.v(), V) >> assoc(c.next_edge(), f, E).left();
                            });
                    }),
              "assoc(v 0) -> V is in 3 faces, but a walk across edges reaches only 1; let adjacent faces name the same "
              "new edge");
}
