// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/association/association.hpp>

#include "support/error_text.hpp"
#include "support/own_scheme.hpp"
#include "support/same_mesh.hpp"
#include "support/thread_count.hpp"

#include <kith/core/level/mesh_level.hpp>
#include <kith/numbering/step/blocks.hpp>
#include <kith/refine.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

// Tests of single associations and of the dictionary, which holds vertices under elements that do not touch or have no
// column.

namespace {

using namespace kith::targets;
using kith::new_vertices;
using points = std::vector<shapes::point>;

/// Runs text(coarse, assoc) on the cube after its vertices are copied. Returns the points after these vertices.
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
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) { // the column of these edges is missing
                  assoc(coarse.vertices()[0], coarse.vertices()[6], V) = average(assoc(coarse.faces()[2].edges(), V));
              }),
              "assoc(e 0) -> V is read before it is set; declare per_edge among the new vertices, or set it first");
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

/// Returns a scheme that makes a fan of triangles around the middle of the only face. The middle is kept under two
/// opposite vertices.
auto fan_of_the_only_face()
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
    return own_scheme(columns, text);
}

TEST(association, vertices_of_the_dictionary_can_be_corners_of_faces)
{
    const auto scheme = fan_of_the_only_face();
    kith::numbering_of<decltype(scheme), std::uint32_t> ids;
    const auto fine = kith::refine_mesh<kith::connect::everything>(native(shapes::polygon(4)), scheme, ids);
    EXPECT_EQ(fine.vertex_count(), 5U);
    EXPECT_EQ(fine.edge_count(), 8U);
    EXPECT_EQ(fine.points().size(), 5U);
    EXPECT_EQ(fine.face(3)[2], 4U);
}

TEST(association, vertices_of_the_dictionary_are_counted_on_a_last_level_of_faces)
{
    const auto scheme = fan_of_the_only_face();
    const auto fine = kith::refine(native(shapes::polygon(4)), scheme, 1, {.last_level = kith::connect::faces});
    EXPECT_EQ(fine.points().size(), 5U);
    EXPECT_EQ(fine.vertex_count(), 5U);
}

namespace {

/// The loops whose bodies run in undefined order.
enum class loop { elements, numbers, blocks, refinement };

/// A scheme that splits faces into triangles around their middle, for which it declares no column.
struct forgets_its_column {
    loop where;

    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex), kith::new_faces(triangles(kith::per_corner)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        const auto make = [&](auto f) { assoc(f, V) = average(f.vertices()); };
        if (where == loop::elements)
            for_each(coarse.faces(), make);
        else if (where == loop::numbers)
            for_each_by_number(coarse.faces(), make);
        else if (where == loop::blocks)
            in_blocks(r, [&](const auto& block) { for_each(block.coarse.faces(), make); });
        else
            for (auto f : coarse.faces())
                make(f);
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        for_each(coarse.corners(),
                 [&](auto c) { assoc(c, F) = polygon(assoc(c.v(), V), assoc(c.next().v(), V), assoc(c.f(), V)); });
    }
};

/// Returns the mesh refined by forgets_its_column, with each step in the body of a loop over another mesh.
mesh3d refined_in_a_loop(const mesh3d& mesh, const mesh3d& other)
{
    mesh3d fine;
    for_each(kith::level_of<mesh3d>(other).faces(),
             [&](auto) { fine = kith::refine(mesh, forgets_its_column{loop::refinement}, 1); });
    return fine;
}

constexpr auto of_a_face = "assoc(f 0) -> V is in no column and is written inside for_each or in_blocks, whose order "
                           "is undefined; declare per_face among the new vertices, or write it in a plain loop: for "
                           "(auto f : coarse.faces())";

/// Returns the error of a text that for_each runs for every vertex of a cube.
template <class Text>
std::string fault_in_a_loop(const Text& text)
{
    return fault([&](const auto& coarse, const auto& assoc) {
        for_each(coarse.vertices(), [&](auto v) { text(v, coarse, assoc); });
    });
}

} // namespace

TEST(association, the_dictionary_refuses_loops_without_order_on_any_number_of_threads)
{
    for (const int threads : {1, 2, 4})
        for (const auto& shape : {shapes::cube(), shapes::torus(100, 100)}) // large enough for threads
            for (const auto where : {loop::elements, loop::numbers, loop::blocks}) {
                const thread_count so_many(threads);
                EXPECT_EQ(error_text<kith::association_error>(
                              [&] { kith::refine(native(shape), forgets_its_column{where}, 1); }),
                          of_a_face);
            }
    const auto cube = native(shapes::cube());
    const kith::level_elements<kith::mesh_level<mesh3d>> foreign(cube);
    kith::numbering_of<forgets_its_column, std::uint32_t> ids;
    EXPECT_EQ(error_text<kith::association_error>([&] {
                  kith::refine_level<kith::connect::everything>(foreign, forgets_its_column{loop::blocks}, 0, ids);
              }),
              of_a_face);
}

TEST(association, the_dictionary_is_written_in_plain_loops_whatever_the_threads)
{
    const auto torus = native(shapes::torus(100, 100));
    const auto refine = [&] { return kith::refine(torus, forgets_its_column{loop::refinement}, 1); };
    const auto one = refine();
    EXPECT_EQ(faces_of(one)[4 * 4321 + 1][2], 10000U + 4321U);
    const thread_count four(4);
    EXPECT_EQ(faces_of(refine()), faces_of(one));
    EXPECT_TRUE(std::ranges::equal(refine().points(), one.points()));
    EXPECT_TRUE(std::ranges::equal(refined_in_a_loop(torus, native(shapes::polygon(3))).points(), one.points()));
}

TEST(association, the_dictionary_names_what_can_be_done_about_each_tuple)
{
    const auto remedy = [](const std::string& text) { return text.substr(text.find(';') + 2); };
    EXPECT_EQ(remedy(fault_in_a_loop(
                  [](auto v, const auto&, const auto& assoc) { assoc(v, v.first_corner().next_edge(), V) = v; })),
              "declare per_end among the new vertices, or write it in a plain loop: for (auto e : coarse.edges())");
    EXPECT_EQ(remedy(fault_in_a_loop([](auto v, const auto&, const auto& assoc) { assoc(v.first_corner(), V) = v; })),
              "declare per_corner among the new vertices, or write it in a plain loop: for (auto f : coarse.faces())");
    EXPECT_EQ(remedy(fault_in_a_loop(
                  [](auto v, const auto&, const auto& assoc) { assoc(v, v.first_corner().next().v(), V) = v; })),
              "declare per_edge among the new vertices, or write it in a plain loop: for (auto e : coarse.edges())");
    EXPECT_EQ(fault_in_a_loop([](auto v, const auto& coarse, const auto& assoc) {
                  assoc(coarse.vertices()[0], coarse.vertices()[6], V).refers_to(assoc(v, V));
              }),
              "assoc(v 0, v 6) -> V is in no column and is written inside for_each or in_blocks, whose order is "
              "undefined; write it in a plain loop: for (auto v : coarse.vertices())");
}

TEST(association, the_dictionary_of_a_pass_and_the_pass_itself_are_not_changed_in_loops)
{
    EXPECT_NE(fault_in_a_loop([](auto v, const auto&, const auto& assoc) {
                  const auto pass = assoc.pass(new_vertices(kith::per_edge));
                  pass(v, V) = v;
              }).find(" -> V is in no column"),
              std::string::npos);
    EXPECT_EQ(fault([](const auto& coarse, const auto& assoc) {
                  const auto pass = assoc.pass(new_vertices(kith::per_edge));
                  for_each(coarse.vertices(), [&](auto) { pass.again(); });
              }),
              "again() is called inside for_each or in_blocks, where other threads may read the pass; call it outside");
}

TEST(association, the_dictionary_may_be_read_in_any_loop)
{
    const auto made = after_the_vertices([](const auto& coarse, const auto& assoc) {
        const auto pass = assoc.pass(new_vertices(kith::per_vertex));
        for (auto e : coarse.edges())
            assoc(e, V) = average(e.org(), e.dst());
        for_each(coarse.vertices(), [&](auto v) { pass(v, V) = assoc(v.first_corner().next_edge(), V); });
        assoc(coarse.faces()[0], V) = pass(coarse.vertices()[0], V);
    });
    EXPECT_EQ(made.size(), 13U);
    EXPECT_EQ(made.back(), made[0]);
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
