// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/mesh/match.hpp>

#include "support/all_shapes.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using connectivity = kith::connectivity<std::uint32_t>;

/// Calls test(connectivity) for every shape.
template <class Test>
void for_each_shape(const Test& test)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        test(native(shape).topology());
    }
}

std::uint32_t end_of(const connectivity& t, std::uint32_t corner)
{
    return t.target(corner);
}

} // namespace

TEST(match, a_corner_and_its_half_edge_lead_to_each_other)
{
    for_each_shape([](const connectivity& t) {
        for (std::uint32_t c = 0; c < t.corners(); ++c)
            EXPECT_EQ(t.halfedge_corner[t.corner_halfedge[c]], c);
    });
}

TEST(match, the_sides_of_an_edge_run_against_each_other)
{
    for_each_shape([](const connectivity& t) {
        for (std::size_t e = 0; e < t.edges(); ++e) {
            const auto left = t.halfedge_corner[2 * e], right = t.halfedge_corner[2 * e + 1];
            if (right != t.none) {
                EXPECT_EQ(t.corner_vertex[left], end_of(t, right));
                EXPECT_EQ(t.corner_vertex[right], end_of(t, left));
            }
        }
    });
}

TEST(match, every_edge_has_a_face_on_its_left)
{
    for_each_shape([](const connectivity& t) {
        for (std::size_t e = 0; e < t.edges(); ++e)
            EXPECT_NE(t.halfedge_corner[2 * e], t.none);
    });
}

TEST(match, inner_edges_leave_their_smaller_vertex)
{
    for_each_shape([](const connectivity& t) {
        for (std::size_t e = 0; e < t.edges(); ++e)
            if (const auto left = t.halfedge_corner[2 * e]; t.halfedge_corner[2 * e + 1] != t.none) {
                EXPECT_LT(t.corner_vertex[left], end_of(t, left));
            }
    });
}

TEST(match, edges_are_sorted_by_their_ends)
{
    for_each_shape([](const connectivity& t) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
        for (std::size_t e = 0; e < t.edges(); ++e) {
            const auto left = t.halfedge_corner[2 * e];
            ends.push_back(std::minmax(std::uint32_t(t.corner_vertex[left]), end_of(t, left)));
        }
        EXPECT_TRUE(std::ranges::is_sorted(ends));
    });
}

TEST(match, fans_start_at_their_own_vertex)
{
    for_each_shape([](const connectivity& t) {
        for (std::size_t v = 0; v < t.vertices; ++v)
            EXPECT_EQ(t.corner_vertex[t.vertex_corner[v]], v);
    });
}

TEST(match, a_fan_at_the_boundary_starts_at_the_boundary)
{
    for_each_shape([](const connectivity& t) {
        std::set<std::uint32_t> starts(t.vertex_corner.begin(), t.vertex_corner.end());
        for (std::size_t e = 0; e < t.edges(); ++e)
            if (t.halfedge_corner[2 * e + 1] == t.none) {
                EXPECT_TRUE(starts.contains(t.halfedge_corner[2 * e]));
            }
    });
}

TEST(match, an_inner_fan_starts_at_the_smallest_neighbour)
{
    const auto t = native(shapes::cube()).topology();
    for (std::uint32_t c = 0; c < t.corners(); ++c) {
        const auto start = t.vertex_corner[t.corner_vertex[c]];
        EXPECT_LE(end_of(t, start), end_of(t, c));
    }
}

TEST(match, finds_again_what_it_found)
{
    for_each_shape([](const connectivity& found) {
        connectivity again = found;
        again.corner_halfedge = again.halfedge_corner = again.vertex_corner = {};
        kith::mesh_report report;
        kith::match(again, report);
        EXPECT_TRUE(report.ok());
        EXPECT_TRUE(same_arrays(found, again));
    });
}
