// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/step/surface_order.hpp>

#include <kith/loop.hpp>
#include <kith/refine.hpp>

#include "support/all_shapes.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

/// Returns the given mesh, restored from the ordered mesh and its numbers.
mesh3d in_given_order(const kith::ordered_mesh<mesh3d::point_type, mesh3d::index_type>& ordered)
{
    using kith::tuple_kind;
    const auto& [mesh, numbers] = ordered;
    const auto& from = mesh.topology();
    kith::storage<mesh3d::point_type> points(from.vertices);
    auto to = from;
    for (std::size_t v = 0; v < from.vertices; ++v) {
        points[numbers.vertices[v]] = mesh.point(v);
        to.vertex_corner[numbers.vertices[v]] = unsigned(numbers.tuple<tuple_kind::vf>(from.vertex_corner[v]));
    }
    for (std::size_t f = 0; f < from.faces; ++f)
        for (unsigned c = from.first_corner(f); c < from.first_corner(f + 1); ++c) {
            const std::size_t given = numbers.tuple<tuple_kind::vf>(c);
            to.corner_vertex[given] = numbers.vertices[from.corner_vertex[c]];
            to.corner_halfedge[given] = unsigned(numbers.tuple<tuple_kind::ve>(from.corner_halfedge[c]));
            if (from.degree == 0) {
                to.corner_face[given] = numbers.faces[f];
                to.face_corner[numbers.faces[f] + 1] = from.first_corner(f + 1) - from.first_corner(f);
            }
        }
    for (std::size_t f = 0; f + 1 < to.face_corner.size(); ++f)
        to.face_corner[f + 1] += to.face_corner[f];
    for (std::size_t h = 0; h < from.halfedge_corner.size(); ++h) {
        const unsigned c = from.halfedge_corner[h];
        to.halfedge_corner[numbers.tuple<tuple_kind::ve>(h)] = c == from.none
                                                                   ? c
                                                                   : unsigned(numbers.tuple<tuple_kind::vf>(c));
    }
    return {std::move(points), std::move(to), mesh.generation()};
}

TEST(surface_order, takes_every_face_once)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        auto order = surface_order(native(shape).topology());
        std::ranges::sort(order);
        for (std::size_t f = 0; f < order.size(); ++f)
            EXPECT_EQ(order[f], f);
    }
}

TEST(surface_order, goes_from_face_to_face_as_far_as_they_hang_together)
{
    const auto mesh = native(shapes::shuffled(shapes::both(shapes::torus(8, 9), shapes::grid(5, 6)), 7));
    const auto& topology = mesh.topology();
    const auto order = surface_order(topology);
    std::vector<bool> is_taken(mesh.face_count(), false);
    std::size_t starts = 0;
    for (const auto face : order) {
        bool touches = false;
        for (auto c = topology.first_corner(face); c < topology.first_corner(face + 1); ++c)
            if (const auto across = topology.halfedge_corner[topology.corner_halfedge[c] ^ 1]; across != topology.none)
                touches = touches or is_taken[topology.face_of(across)];
        starts += not touches;
        is_taken[face] = true;
    }
    EXPECT_EQ(starts, 2U); // one in each piece
}

TEST(surface_order, changes_nothing_but_the_order)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        const auto given = native(shapes::shaken(shapes::shuffled(shape, 7)));
        const auto ordered = in_surface_order(given);
        EXPECT_TRUE(same_bits(in_given_order(ordered), given));
        EXPECT_TRUE(std::ranges::equal(ordered.numbers.faces, surface_order(given.topology())));
    }
}

TEST(surface_order, brings_together_what_is_scattered)
{
    for (const auto& shape :
         {shapes::torus(80, 80), shapes::grid(80, 80), shapes::triangulated(shapes::torus(60, 60))}) {
        EXPECT_FALSE(is_scattered(native(shape).topology()));
        const auto mesh = native(shapes::shuffled(shape, 7));
        EXPECT_TRUE(is_scattered(mesh.topology()));
        EXPECT_FALSE(is_scattered(in_surface_order(mesh).mesh.topology()));
    }
    EXPECT_FALSE(is_scattered(native(shapes::shuffled(shapes::torus(30, 30), 7)).topology())); // all near in 900 faces
    // Children of scattered faces lie far from their neighbours, but follow one another.
    const auto scattered = native(shapes::shuffled(shapes::triangulated(shapes::torus(60, 60)), 7));
    EXPECT_FALSE(is_scattered(refine(scattered, kith::loop{}, 2).topology()));
}

} // namespace
