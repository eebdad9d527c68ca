// SPDX-License-Identifier: BSD-3-Clause
#include <kith/association.hpp>

#include "error_text.hpp"
#include "own_scheme.hpp"

#include <kith/refine.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Single associations, and the dictionary: vertices under elements that do not touch, or that have no column.

namespace {

using namespace kith::targets;
using kith::new_vertices;
using points = std::vector<shapes::point>;

/// Runs text(coarse, assoc) on the cube after its vertices have been copied, and returns what comes after them.
template <class Text>
points after_the_vertices(const Text& text)
{
    const auto all = make_vertices(
        native(shapes::cube()), new_vertices(kith::per_vertex), [&](const auto& coarse, const auto& assoc) {
            for (auto v : coarse.vertices())
                assoc(v, V) = v;
            text(coarse, assoc);
        });
    return {all.begin() + 8, all.end()};
}
template <class Text>
std::string fault(const Text& text)
{
    return error_text<kith::association_error>([&] { after_the_vertices(text); });
}

} // namespace

TEST(association, the_dictionary_holds_vertices_that_do_not_touch)
{
    EXPECT_EQ(after_the_vertices([](const auto& coarse, const auto& assoc) {
                  const auto v = coarse.vertices();
                  assoc(v[0], v[6], V) = 3. / 4 * v[0] + 1. / 4 * v[6];
              }),
              (points{{-0.5, -0.5, -0.5}}));
}

TEST(association, the_dictionary_does_not_mind_the_order_of_elements)
{
    EXPECT_EQ(after_the_vertices([](const auto& coarse, const auto& assoc) {
                  const auto v = coarse.vertices();
                  assoc(v[0], v[6], V) = v[0];
                  assoc(coarse.faces()[0], coarse.faces()[1], V) = 2. * assoc(v[6], v[0], V);
                  EXPECT_EQ(assoc(v[0], v[6], V).id(), assoc(v[6], v[0], V).id());
              }),
              (points{{-1, -1, -1}, {-2, -2, -2}}));
}

TEST(association, the_dictionary_holds_pairs_of_faces)
{
    EXPECT_EQ(after_the_vertices([](const auto& coarse, const auto& assoc) {
                  const auto f = coarse.faces();
                  assoc(f[2], f[4], V) = average(sum(f[2].vertices()), sum(f[4].vertices()));
              }),
              (points{{0, 0, 0}}));
}

TEST(association, tuples_without_a_column_are_in_the_dictionary)
{
    const auto made = after_the_vertices([](const auto& coarse, const auto& assoc) {
        const auto e = coarse.vertices()[0].first_corner().next_edge();
        assoc(e, V) = average(e.org(), e.dst());
        assoc(e, e.lface(), V) = assoc(e, V);
        assoc(e.org(), e.lface(), e, V) = coarse.vertices()[6];
    });
    EXPECT_EQ(made, (points{{0, -1, -1}, {0, -1, -1}, {1, 1, 1}}));
}

TEST(association, an_edge_and_its_ends_are_one_tuple_of_the_dictionary)
{
    const auto made = after_the_vertices([](const auto& coarse, const auto& assoc) {
        const auto v = coarse.vertices();
        assoc(v[0], v[1], V) = v[2];
        const auto e = v[0].first_corner().next_edge();
        EXPECT_EQ(assoc(e, V).id(), assoc(v[1], v[0], V).id());
    });
    EXPECT_EQ(made.size(), 1U);
}

TEST(association, a_vertex_may_be_known_under_several_tuples)
{
    const auto made = after_the_vertices([](const auto& coarse, const auto& assoc) {
        const auto v = coarse.vertices();
        assoc(v[0], v[6], V) = v[3];
        assoc(v[1], v[7], V).refers_to(assoc(v[0], v[6], V));
        assoc(v[2], v[4], V).refers_to(assoc(v[5], V));
        EXPECT_EQ(assoc(v[1], v[7], V).id(), assoc(v[0], v[6], V).id());
        assoc(v[3], v[5], V) = average(assoc(v[7], v[1], V), assoc(v[2], v[4], V));
    });
    EXPECT_EQ(made, (points{{-1, 1, -1}, {0, 0, 0}}));
}

TEST(association, the_dictionary_refuses_to_read_what_is_not_set)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) {
                  const auto v = coarse.vertices();
                  assoc(v[0], v[6], V) = assoc(v[1], v[7], V);
              }),
              "assoc(v 1, v 7) -> V is read before it is set");
}

TEST(association, the_dictionary_refuses_to_set_twice)
{
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) {
                  const auto v = coarse.vertices();
                  assoc(v[0], v[6], V) = v[0];
                  assoc(v[6], v[0], V) = v[6];
              }),
              "assoc(v 0, v 6) -> V is set twice");
}

TEST(association, an_association_can_be_kept_and_set_later)
{
    EXPECT_EQ(after_the_vertices([](const auto& coarse, const auto& assoc) {
                  const auto v = coarse.vertices();
                  auto diagonal = assoc(v[0], v[6], V);
                  auto other = assoc(v[1], v[7], V);
                  diagonal = average(v[0], v[1]);
                  other = diagonal;
                  EXPECT_EQ(diagonal.id() + 1, other.id());
              }),
              (points{{0, -1, -1}, {0, -1, -1}}));
}

TEST(association, vertices_of_the_dictionary_can_be_corners_of_faces)
{
    // A fan of triangles around the middle of the only face, which is kept under two of its opposite vertices.
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto v : coarse.vertices())
            assoc(v, V) = v;
        const auto first = coarse.vertices()[0], opposite = coarse.vertices()[2];
        assoc(first, opposite, V) = average(coarse.faces()[0].vertices());
        for (auto c : coarse.corners())
            assoc(c, F) = polygon(assoc(c.v(), V), assoc(c.next().v(), V), assoc(opposite, first, V));
    };
    const kith::columns columns(new_vertices(kith::per_vertex), kith::new_faces(triangles(kith::per_corner)));
    const own_scheme scheme(columns, text);
    kith::numbering_of<decltype(scheme), std::uint32_t> ids;
    const auto fine = kith::refine_mesh<kith::connect::everything>(native(shapes::polygon(4)), scheme, ids);
    EXPECT_EQ(fine.vertex_count(), 5U);
    EXPECT_EQ(fine.edge_count(), 8U);
    EXPECT_EQ(fine.points().size(), 5U);
    EXPECT_EQ(fine.face(3)[2], 4U);
}

TEST(association, vertices_of_the_dictionary_are_counted_on_a_last_level_of_faces)
{
    const auto text = [](const auto& coarse, const auto& assoc) {
        for (auto v : coarse.vertices())
            assoc(v, V) = v;
        const auto first = coarse.vertices()[0], opposite = coarse.vertices()[2];
        assoc(first, opposite, V) = average(coarse.faces()[0].vertices());
        for (auto c : coarse.corners())
            assoc(c, F) = polygon(assoc(c.v(), V), assoc(c.next().v(), V), assoc(opposite, first, V));
    };
    const kith::columns columns(new_vertices(kith::per_vertex), kith::new_faces(triangles(kith::per_corner)));
    const own_scheme scheme(columns, text);
    const auto fine = kith::refine(native(shapes::polygon(4)), scheme, 1, {.last_level = kith::connect::faces});
    EXPECT_EQ(fine.points().size(), 5U);
    EXPECT_EQ(fine.vertex_count(), 5U);
}

namespace {

struct reads_early {
    static constexpr auto degree_of = [](const auto& f) { return f.degree(); };
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex),
                             kith::new_faces(kith::per_face.of_degree(degree_of)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto v = r.coarse.vertices();
        r.assoc(v[0], v[6], V).refers_to(r.assoc(v[1], V));
        r.assoc(v[0], V) = r.assoc(v[0], v[6], V);
    }
};

} // namespace

TEST(association, a_vertex_that_another_tuple_refers_to_is_not_read_before_it_is_set)
{
    EXPECT_EQ(error_text<kith::association_error>([] { kith::refine(native(shapes::cube()), reads_early(), 1); }),
              "assoc(v 0, v 6) -> V is read before it is set");
}
