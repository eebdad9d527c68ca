// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/query/incidence.hpp>

#include "support/every_level.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using kith::common_face;
using kith::common_vertex;
using kith::edge_between;
using kith::shared_edge;

/// A grid of 3 x 2 vertices, numbered row by row. Face 0 lies to the left of face 1.
struct two_quads {
    mesh3d mesh = kith::make_mesh(
        std::vector<std::array<double, 3>>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
        std::vector<std::vector<int>>{{0, 1, 4, 3}, {1, 2, 5, 4}});
    level_type level{mesh};

    auto v(std::size_t i) const { return level.vertices()[i]; }
    auto f(std::size_t i) const { return level.faces()[i]; }
};

} // namespace

TEST(incidence, edge_between_two_vertices)
{
    const two_quads m;
    const auto e = edge_between(m.v(4), m.v(1));
    ASSERT_TRUE(e);
    EXPECT_EQ((std::set{e->org().index(), e->dst().index()}), (std::set<std::size_t>{1, 4}));
    EXPECT_FALSE(e->is_boundary());
    EXPECT_TRUE(edge_between(m.v(3), m.v(0))->is_boundary()); // found by the last edge of the fan
    EXPECT_TRUE(edge_between(m.v(0), m.v(3))->is_boundary());
    EXPECT_FALSE(edge_between(m.v(0), m.v(4))); // across a face
    EXPECT_FALSE(edge_between(m.v(0), m.v(0)));
}

TEST(incidence, edge_that_two_faces_share)
{
    const two_quads m;
    EXPECT_EQ(shared_edge(m.f(0), m.f(1)), edge_between(m.v(1), m.v(4)));
    EXPECT_EQ(shared_edge(m.f(1), m.f(0)), edge_between(m.v(1), m.v(4)));
    EXPECT_EQ(shared_edge(m.f(1), m.f(0))->seen_from().f(), m.f(1));
    EXPECT_FALSE(shared_edge(m.f(0), m.f(0)));
}

TEST(incidence, common_faces_and_vertices)
{
    const two_quads m;
    EXPECT_EQ(common_face(m.v(0), m.v(4)), m.f(0));
    EXPECT_EQ(common_face(m.v(5), m.v(1)), m.f(1));
    EXPECT_FALSE(common_face(m.v(0), m.v(5)));
    const auto left = *edge_between(m.v(0), m.v(3)), middle = *edge_between(m.v(1), m.v(4));
    const auto right = *edge_between(m.v(2), m.v(5)), top = *edge_between(m.v(3), m.v(4));
    EXPECT_EQ(common_face(left, middle), m.f(0));
    EXPECT_EQ(common_face(right, middle), m.f(1));
    EXPECT_EQ(common_face(middle, right), m.f(1));
    EXPECT_FALSE(common_face(left, right));
    EXPECT_EQ(common_vertex(top, left), m.v(3));
    EXPECT_EQ(common_vertex(middle, top), m.v(4));
    EXPECT_FALSE(common_vertex(left, right));
}

TEST(incidence, agrees_with_every_edge_of_every_shape)
{
    for_each_level([](const level_type& level) {
        for (const auto e : level.edges()) {
            const std::set ends{e.org().index(), e.dst().index()};
            for (const auto found : {edge_between(e.org(), e.dst()), edge_between(e.dst(), e.org())}) {
                ASSERT_TRUE(found);
                EXPECT_EQ((std::set{found->org().index(), found->dst().index()}), ends);
            }
            EXPECT_TRUE(common_face(e.org(), e.dst()));
            if (e.is_boundary())
                continue;
            const auto shared = shared_edge(e.lface(), e.rface());
            ASSERT_TRUE(shared);
            EXPECT_EQ((std::set{shared->lface().index(), shared->rface().index()}),
                      (std::set{e.lface().index(), e.rface().index()}));
        }
    });
}
