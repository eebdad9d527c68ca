// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/basic_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

/// A check that the connectivity arrays of a mesh are consistent. The arrays that schemes write directly must be those
/// that matching would find.
template <class Index>
struct consistent {
    explicit consistent(const kith::connectivity<Index>& topology)
        : t(topology), corner_face(t.corners()), next(t.corners())
    {
        for (std::size_t f = 0; f < t.faces; ++f) {
            const Index first = t.first_corner(f), end = t.first_corner(f + 1);
            for (Index c = first; c < end; ++c) {
                corner_face[c] = Index(f);
                next[c] = c + 1 == end ? first : c + 1;
            }
        }
    }

    void expect_all() const
    {
        expect_faces();
        expect_sides();
        expect_edges();
        expect_fans();
    }

    void expect_faces() const
    {
        ASSERT_EQ(t.corner_halfedge.size(), t.corners());
        ASSERT_EQ(t.vertex_corner.size(), t.vertices);
        ASSERT_EQ(t.first_corner(t.faces), t.corners());
        if (t.degree == 0) {
            EXPECT_TRUE(std::ranges::equal(t.corner_face, corner_face));
        }
        for (const Index v : t.corner_vertex)
            ASSERT_LT(v, t.vertices);
    }
    /// Expects that corners and half-edges refer to each other and that every edge has a left face.
    void expect_sides() const
    {
        for (Index c = 0; c < t.corners(); ++c) {
            ASSERT_LT(t.corner_halfedge[c], 2 * t.edges());
            EXPECT_EQ(t.halfedge_corner[t.corner_halfedge[c]], c);
        }
        std::size_t with_face = 0;
        for (const Index c : t.halfedge_corner)
            with_face += c != t.none;
        EXPECT_EQ(with_face, t.corners());
        for (std::size_t e = 0; e < t.edges(); ++e)
            EXPECT_NE(t.halfedge_corner[2 * e], t.none) << "edge " << e;
    }
    /// Expects that the two half-edges of an edge run in opposite directions and that no edge is missing or repeated.
    void expect_edges() const
    {
        std::map<std::pair<Index, Index>, std::size_t> halves;
        for (Index c = 0; c < t.corners(); ++c)
            ++halves[{t.corner_vertex[c], t.corner_vertex[next[c]]}];
        std::map<std::pair<Index, Index>, std::size_t> edges;
        for (std::size_t e = 0; e < t.edges(); ++e) {
            const Index l = t.halfedge_corner[2 * e], r = t.halfedge_corner[2 * e + 1];
            const Index from = t.corner_vertex[l], to = t.corner_vertex[next[l]];
            ++edges[std::minmax(from, to)];
            if (r != t.none) {
                EXPECT_EQ(t.corner_vertex[r], to) << "edge " << e;
                EXPECT_EQ(t.corner_vertex[next[r]], from) << "edge " << e;
            }
        }
        for (const auto& [ends, count] : edges)
            EXPECT_EQ(count, std::max(halves[ends], halves[{ends.second, ends.first}]))
                << "edge " << ends.first << '-' << ends.second;
    }
    /// Expects that the fan of each vertex has all faces of the vertex, and starts at the boundary if there is one.
    void expect_fans() const
    {
        std::vector<std::size_t> faces(t.vertices, 0);
        for (const Index v : t.corner_vertex)
            ++faces[v];
        std::vector<Index> prev(t.corners());
        for (Index c = 0; c < t.corners(); ++c)
            prev[next[c]] = c;
        const auto across = [&](Index c) { return t.halfedge_corner[t.corner_halfedge[c] ^ 1]; };
        for (std::size_t v = 0; v < t.vertices; ++v) {
            const Index first = t.vertex_corner[v];
            ASSERT_LT(first, t.corners()) << "vertex " << v;
            EXPECT_EQ(t.corner_vertex[first], v);
            std::size_t fan = 1;
            Index c = across(prev[first]);
            for (; c != t.none and c != first and fan <= faces[v]; c = across(prev[c]))
                ++fan;
            EXPECT_EQ(fan, faces[v]) << "vertex " << v;
            EXPECT_EQ(c == t.none, across(first) == t.none) << "vertex " << v;
        }
    }

    const kith::connectivity<Index>& t;
    std::vector<Index> corner_face, next;
};

template <class Index>
void expect_consistent(const kith::connectivity<Index>& topology)
{
    consistent<Index>(topology).expect_all();
}
