// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/association/tuples.hpp>

#include "support/every_level.hpp"

#include <gtest/gtest.h>

#include <set>

namespace {

using kith::tuple_kind;

/// Expects that the indices in `numbers`, collected by a walk over the elements, are those of all tuples of one kind.
/// Each index must occur once.
void expect_all_once(const level_type& level, tuple_kind kind, const std::multiset<std::size_t>& numbers)
{
    std::multiset<std::size_t> all;
    for (std::size_t i = 0; i < kith::tuple_count(level, kind); ++i)
        all.insert(i);
    EXPECT_EQ(numbers, all);
}

} // namespace

TEST(tuples, vertices_edges_and_faces_are_their_own_numbers)
{
    const auto mesh = native(shapes::house());
    const level_type level(mesh);
    EXPECT_EQ(index_tuple(level.vertices()[7]).value, 7U);
    EXPECT_EQ(index_tuple(level.edges()[13]).value, 13U);
    EXPECT_EQ(index_tuple(level.faces()[10]).value, 10U);
}

TEST(tuples, vertex_and_face_are_a_corner)
{
    for_each_level([](const level_type& level) {
        std::multiset<std::size_t> numbers;
        for (const auto f : level.faces())
            for (const auto& v : f.vertices()) {
                numbers.insert(index_tuple(v, f).value);
                EXPECT_EQ(index_tuple(f, v).value, index_tuple(v, f).value);
            }
        expect_all_once(level, tuple_kind::vf, numbers);
    });
}

TEST(tuples, edge_and_face_are_a_corner)
{
    for_each_level([](const level_type& level) {
        std::multiset<std::size_t> numbers;
        for (const auto f : level.faces())
            for (const auto& e : f.edges()) {
                numbers.insert(index_tuple(e, f).value);
                EXPECT_EQ(index_tuple(f, e).value, index_tuple(e, f).value);
            }
        expect_all_once(level, tuple_kind::ef, numbers);
    });
}

TEST(tuples, vertex_and_edge_are_an_end)
{
    for_each_level([](const level_type& level) {
        std::multiset<std::size_t> numbers;
        for (const auto v : level.vertices())
            for (const auto& e : v.edges()) {
                numbers.insert(index_tuple(v, e).value);
                EXPECT_EQ(index_tuple(e, v).value, index_tuple(v, e).value);
                EXPECT_EQ(index_tuple(v, e).value, 2 * e.index() + (e.org() == v ? 0 : 1));
            }
        expect_all_once(level, tuple_kind::ve, numbers);
    });
}

TEST(tuples, vertex_face_and_edge_are_a_side_of_a_corner)
{
    for_each_level([](const level_type& level) {
        std::multiset<std::size_t> numbers;
        for (const auto c : level.corners()) {
            const auto v = c.v();
            const auto f = c.f();
            for (const auto& e : {c.next_edge(), c.prev_edge()}) {
                const std::size_t i = index_tuple(v, f, e).value;
                numbers.insert(i);
                EXPECT_EQ(index_tuple(v, e, f).value, i);
                EXPECT_EQ(index_tuple(f, v, e).value, i);
                EXPECT_EQ(index_tuple(f, e, v).value, i);
                EXPECT_EQ(index_tuple(e, v, f).value, i);
                EXPECT_EQ(index_tuple(e, f, v).value, i);
                EXPECT_EQ(index_tuple(c, e).value, i);
                EXPECT_EQ(index_tuple(e, c).value, i);
            }
        }
        expect_all_once(level, tuple_kind::vfe, numbers);
    });
}

TEST(tuples, neighbouring_vertices_are_their_edge)
{
    const auto mesh = native(shapes::house());
    const level_type level(mesh);
    for (const auto e : level.edges()) {
        EXPECT_EQ(index_tuple(e.org(), e.dst()).value, e.index());
        EXPECT_EQ(index_tuple(e.dst(), e.org()).value, e.index());
    }
}

TEST(tuples, neighbouring_faces_are_their_edge)
{
    const auto mesh = native(shapes::house());
    const level_type level(mesh);
    for (const auto e : level.edges()) {
        EXPECT_EQ(index_tuple(e.lface(), e.rface()).value, e.index());
        EXPECT_EQ(index_tuple(e.rface(), e.lface()).value, e.index());
    }
}

TEST(tuples, elements_that_do_not_touch_have_no_index)
{
    const auto mesh = native(shapes::cube());
    const level_type level(mesh);
    const auto v = level.vertices()[0];
    const auto far = level.vertices()[6];
    const auto top = level.faces()[1]; // 4 5 6 7
    const auto none = kith::tuple_index<tuple_kind::e>::not_incident;
    EXPECT_EQ(index_tuple(v, far).value, none);
    EXPECT_EQ(index_tuple(v, top).value, none);
    EXPECT_EQ(index_tuple(v, far.first_corner().next_edge()).value, none);
    EXPECT_EQ(index_tuple(level.faces()[0], top).value, none);
    EXPECT_EQ(index_tuple(v.first_corner().next_edge(), top).value, none);
    EXPECT_EQ(index_tuple(v, top, top.first_corner().next_edge()).value, none);
    EXPECT_EQ(index_tuple(far, top, v.first_corner().next_edge()).value, none);
}

TEST(tuples, listing_is_the_inverse_of_numbering)
{
    for_each_level([](const level_type& level) {
        for (const auto c : level.corners()) {
            const auto v = c.v();
            const auto f = c.f();
            const auto e = c.next_edge();
            EXPECT_EQ(list_tuple(level, tuple_kind::vf, index_tuple(v, f).value), list_tuple(v, f));
            EXPECT_EQ(list_tuple(level, tuple_kind::ef, index_tuple(e, f).value), list_tuple(e, f));
            EXPECT_EQ(list_tuple(level, tuple_kind::ve, index_tuple(v, e).value), list_tuple(v, e));
            EXPECT_EQ(list_tuple(level, tuple_kind::vfe, index_tuple(v, f, e).value), list_tuple(v, f, e));
        }
        EXPECT_EQ(list_tuple(level, tuple_kind::v, 1), list_tuple(level.vertices()[1]));
        EXPECT_EQ(list_tuple(level, tuple_kind::e, 1), list_tuple(level.edges()[1]));
        EXPECT_EQ(list_tuple(level, tuple_kind::f, 0), list_tuple(level.faces()[0]));
    });
}

TEST(tuples, are_written_by_letters_and_numbers)
{
    const auto mesh = native(shapes::cube());
    const level_type level(mesh);
    const auto f = level.faces()[3];
    EXPECT_EQ(kith::to_string(list_tuple(f, f.first_corner().v())), "(f 3, v 1)");
    EXPECT_EQ(kith::to_string(list_tuple(level.vertices()[5], level.vertices()[2])), "(v 2, v 5)");
}

TEST(tuples, a_vertex_is_no_neighbour_of_itself)
{
    for_each_level([](const level_type& level) {
        for (const auto v : level.vertices()) {
            const auto tuple = index_tuple(v, v);
            EXPECT_EQ(tuple.value, tuple.not_incident);
        }
    });
}
