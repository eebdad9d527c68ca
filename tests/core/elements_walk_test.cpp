// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/level/level_elements.hpp>

#include "support/every_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using indices = std::vector<std::size_t>;

indices numbers(const auto& range)
{
    indices result;
    for (const auto& x : range)
        result.push_back(x.index());
    return result;
}

} // namespace

TEST(elements, edges_of_a_vertex_lead_to_its_neighbours_in_the_same_order)
{
    for_each_level([](const level_type& level) {
        for (const auto v : level.vertices()) {
            indices ends;
            for (const auto& e : v.edges())
                ends.push_back((e.org() == v ? e.dst() : e.org()).index());
            EXPECT_EQ(ends, numbers(v.neighbors()));
            EXPECT_EQ(ends.size(), v.valence());
        }
    });
}

TEST(elements, edges_of_a_vertex_are_seen_from_the_face_to_their_left)
{
    for_each_level([](const level_type& level) {
        for (const auto v : level.vertices()) {
            const auto edges = v.edges();
            std::size_t i = 0;
            for (const auto& e : edges)
                if (i++ < v.face_count()) {
                    EXPECT_EQ(e.seen_from().v(), v);
                } else { // the last one at the boundary
                    EXPECT_EQ(e.seen_from().next().v(), v);
                    EXPECT_TRUE(e.is_boundary());
                }
        }
    });
}

TEST(elements, a_fan_turns_from_each_face_to_the_next)
{
    for_each_level([](const level_type& level) {
        for (const auto v : level.vertices()) {
            auto last = v.first_corner();
            bool first = true;
            for (const auto& c : v.corners()) {
                EXPECT_EQ(c.v(), v);
                if (not first) {
                    EXPECT_EQ(last.prev().across(), c);
                }
                last = c;
                first = false;
            }
            EXPECT_EQ(last.prev().is_boundary(), v.is_boundary());
        }
    });
}

TEST(elements, the_fans_hold_every_corner_once)
{
    for_each_level([](const level_type& level) {
        indices corners;
        for (const auto v : level.vertices())
            for (const auto& c : v.corners())
                corners.push_back(c.index());
        std::ranges::sort(corners);
        EXPECT_EQ(corners, numbers(level.corners()));
    });
}

TEST(elements, a_corner_knows_its_neighbours_in_the_face)
{
    for_each_level([](const level_type& level) {
        for (const auto c : level.corners()) {
            EXPECT_EQ(c.next().prev(), c);
            EXPECT_EQ(c.next().f(), c.f());
            EXPECT_EQ(c.prev_edge(), c.prev().next_edge());
            EXPECT_EQ(numbers(c.vertices_from_here()).front(), c.v().index());
            EXPECT_EQ(numbers(c.vertices_from_here()).size(), c.f().degree());
        }
    });
}

TEST(elements, across_an_edge_and_back_is_the_same_corner)
{
    for_each_level([](const level_type& level) {
        for (const auto c : level.corners())
            if (not c.is_boundary()) {
                EXPECT_EQ(c.across().across(), c);
                EXPECT_EQ(c.across().v(), c.next().v());
                EXPECT_EQ(c.across().next_edge(), c.next_edge());
                EXPECT_EQ(c.across().halfedge(), c.halfedge() ^ 1);
            }
    });
}

TEST(elements, an_edge_has_its_left_face_on_the_left)
{
    for_each_level([](const level_type& level) {
        for (const auto e : level.edges()) {
            EXPECT_EQ(e.lcorner().v(), e.org());
            EXPECT_EQ(e.lcorner().next().v(), e.dst());
            EXPECT_EQ(e.lcorner().f(), e.lface());
            if (not e.is_boundary()) {
                EXPECT_EQ(e.rcorner().v(), e.dst());
                EXPECT_EQ(e.rcorner().f(), e.rface());
            }
        }
    });
}

TEST(elements, an_edge_keeps_its_direction_whatever_it_is_seen_from)
{
    for_each_level([](const level_type& level) {
        for (const auto c : level.corners()) {
            const auto seen = c.next_edge(), listed = level.edges()[seen.index()];
            EXPECT_EQ(seen.org(), listed.org());
            EXPECT_EQ(seen.seen_from(), c);
            EXPECT_EQ(listed.seen_from(), listed.lcorner());
        }
    });
}
