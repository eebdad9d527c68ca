// SPDX-License-Identifier: BSD-3-Clause
#include "support/all_shapes.hpp"
#include "support/native_shape.hpp"

#include <kith/core/mesh/connectivity.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

using connectivity = kith::connectivity<std::uint32_t>;
using corners = std::vector<std::uint32_t>;

corners list(const kith::storage<std::uint32_t>& array)
{
    return {array.begin(), array.end()};
}

/// Calls test(connectivity, faces) for every shape. Each face is the list of its corners, which have consecutive
/// numbers.
template <class Test>
void for_each_shape(const Test& test)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        std::vector<corners> faces;
        std::uint32_t corner = 0;
        for (const auto& face : shape.faces) {
            faces.emplace_back();
            for (std::size_t k = 0; k < face.size(); ++k)
                faces.back().push_back(corner++);
        }
        test(native(shape).topology(), faces);
    }
}

} // namespace

TEST(connectivity, goes_around_each_face_both_ways)
{
    for_each_shape([](const connectivity& t, const std::vector<corners>& faces) {
        for (std::size_t f = 0; f < faces.size(); ++f)
            for (std::size_t k = 0, n = faces[f].size(); k < n; ++k) {
                const std::uint32_t c = faces[f][k], after = faces[f][(k + 1) % n];
                EXPECT_EQ(t.face_of(c), f);
                EXPECT_EQ(t.next(c), after);
                EXPECT_EQ(t.prev(after), c);
                EXPECT_EQ(t.target(c), t.corner_vertex[after]);
            }
    });
}

TEST(connectivity, crosses_each_edge_and_back)
{
    for_each_shape([](const connectivity& t, const auto&) {
        for (std::size_t e = 0; e < t.edges(); ++e) {
            const std::uint32_t left = t.halfedge_corner[2 * e], right = t.across(left);
            EXPECT_EQ(t.is_boundary(e), right == t.none);
            EXPECT_EQ(t.ends(e), (std::array{t.corner_vertex[left], t.target(left)}));
            if (right != t.none) {
                EXPECT_EQ(t.across(right), left);
                EXPECT_EQ(t.ends(e), (std::array{t.target(right), t.corner_vertex[right]}));
            }
        }
    });
}

TEST(connectivity, meets_all_corners_of_a_vertex_in_its_fan)
{
    for_each_shape([](const connectivity& t, const auto&) {
        std::size_t met = 0;
        for (std::size_t v = 0; v < t.vertices; ++v) {
            std::uint32_t c = t.vertex_corner[v];
            do {
                EXPECT_EQ(t.corner_vertex[c], v);
                ++met;
                c = t.next_in_fan(c);
            } while (c != t.none and c != t.vertex_corner[v]);
        }
        EXPECT_EQ(met, t.corners());
    });
}

TEST(connectivity, has_room_for_faces_of_the_degrees_that_it_is_told)
{
    connectivity t;
    const std::vector<std::size_t> degrees{3, 5, 4};
    t.allocate_faces(3, 0, [&](std::size_t f) { return degrees[f]; });
    EXPECT_EQ(t.faces, 3U);
    EXPECT_EQ(t.corners(), 12U);
    EXPECT_EQ(list(t.face_corner), (corners{0, 3, 8, 12}));
    EXPECT_EQ(list(t.corner_face), (corners{0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2, 2}));

    t.allocate_edges(7);
    EXPECT_EQ(list(t.halfedge_corner), corners(14, t.none));
    t.set_side(2, 9);
    EXPECT_EQ(t.corner_halfedge[2], 9U);
    EXPECT_EQ(t.halfedge_corner[9], 2U);
}

TEST(connectivity, asks_no_degree_where_all_are_alike)
{
    connectivity t;
    t.allocate_faces(5, 4, [](std::size_t) -> std::size_t { throw 0; });
    EXPECT_EQ(t.corners(), 20U);
    EXPECT_EQ(t.first_corner(4), 16U);
    EXPECT_TRUE(t.face_corner.empty() and t.corner_face.empty());
}

TEST(connectivity, cuts_off_degrees_that_come_to_too_much)
{
    connectivity t;
    t.faces = 3;
    t.face_corner = kith::storage<std::uint32_t>(corners{7, 3, 5, 4});
    EXPECT_EQ(t.sum_degrees(6), 6U);
    EXPECT_EQ(list(t.face_corner), (corners{0, 3, 6, 6}));
}
