// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/level/validate.hpp>

#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/native_shape.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/convert.hpp>
#include <kith/fields/property_mesh.hpp>
#include <kith/hierarchy.hpp>
#include <kith/require_reach.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

// For meshes of other libraries see cgal_test.cpp and openmesh_test.cpp, for lists of faces make_mesh_test.cpp.

TEST(validate, finds_nothing_wrong_with_good_meshes)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        EXPECT_EQ(kith::validate(native(shape)).text(), "") << name;
        EXPECT_EQ(kith::validate(shape.points, kith::face_list(shape.faces)).text(), "") << name;
    }
}

TEST(validate, finds_points_that_are_not_finite)
{
    auto mesh = native(shapes::cube());
    mesh.points()[2][0] = std::nan("");
    const auto report = kith::validate(mesh);
    EXPECT_EQ(report.count(kith::problem::not_finite), 1U);
    EXPECT_EQ(report.text(), "vertex 2: a coordinate is not a finite number; give finite coordinates");
}

namespace {

/// Expects this text from validate, and as the error of the functions that read a native mesh.
void expect_refusal(const mesh3d& mesh, const std::string& text)
{
    EXPECT_EQ(kith::validate(mesh).text(), text);
    const auto refusal = [&](const auto& f) { return error_text<kith::mesh_error>(f); };
    EXPECT_EQ(refusal([&] { kith::refine(mesh, kith::catmull_clark(), 1); }), text);
    EXPECT_EQ(refusal([&] { kith::hierarchy<mesh3d, kith::catmull_clark>(mesh, kith::catmull_clark()); }), text);
    EXPECT_EQ(refusal([&] { kith::require_reach(mesh, kith::catmull_clark()); }), text);
    EXPECT_EQ(refusal([&] { kith::convert<kith::property_mesh<>>(mesh); }), text);
}

} // namespace

TEST(validate, finds_vertices_that_start_elsewhere)
{
    auto open = shapes::cube();
    open.faces.pop_back();
    for (const auto& shape : {shapes::cube(), open}) {
        const auto good = native(shape);
        const auto with_start = [&](std::size_t vertex, std::uint32_t corner) {
            auto topology = good.topology();
            topology.vertex_corner[vertex] = corner;
            return mesh3d(kith::storage<shapes::point>(good.points()), std::move(topology));
        };
        for (std::size_t v = 0; v < good.vertex_count(); ++v) {
            const std::size_t other = (v + 3) % good.vertex_count();
            const auto corner = good.topology().vertex_corner[other];
            expect_refusal(with_start(v, corner),
                           "vertex " + std::to_string(v) + ": its half-edge " +
                               std::to_string(good.topology().corner_halfedge[corner]) + " leaves vertex " +
                               std::to_string(other) + "; give it an outgoing half-edge of one of its faces");
        }
        expect_refusal(
            with_start(2, 24),
            "vertex 2: its half-edge leads to none of its faces; give it an outgoing half-edge of one of its faces");
        expect_refusal(with_start(2, kith::connectivity<std::uint32_t>::none),
                       "vertex 2: belongs to no face; remove it or give it a face");
    }
}

TEST(validate, finds_vertices_at_the_boundary_that_start_within_their_fan)
{
    auto open = shapes::cube();
    open.faces.pop_back();
    const auto good = native(open);
    const auto& t = good.topology();
    std::size_t found = 0;
    for (std::uint32_t c = 0; c < t.corners(); ++c) {
        const auto v = t.corner_vertex[c], start = t.vertex_corner[v];
        if (c == start or t.halfedge_corner[t.corner_halfedge[start] ^ 1U] != t.none)
            continue;
        auto topology = t;
        topology.vertex_corner[v] = c;
        expect_refusal(mesh3d(kith::storage<shapes::point>(good.points()), std::move(topology)),
                       "vertex " + std::to_string(v) + ": its half-edge " + std::to_string(t.corner_halfedge[c]) +
                           " has faces on both sides, half-edge " + std::to_string(t.corner_halfedge[start]) +
                           " lies on the boundary; give it that one");
        ++found;
    }
    EXPECT_EQ(found, 4U);
}

TEST(validate, finds_an_empty_mesh)
{
    EXPECT_TRUE(kith::validate(mesh3d()).has(kith::problem::empty_mesh));
}

TEST(validate, names_the_kinds_of_problems_in_a_list_of_faces)
{
    const auto [points, faces] = shapes::cube();
    auto bad = faces;
    bad.push_back({0, 3, 2, 1});
    EXPECT_EQ(kith::validate(points, kith::face_list(bad)).count(kith::problem::nonmanifold_edge), 4U);
    bad.back() = {0, 1, 2, 99};
    EXPECT_TRUE(kith::validate(points, kith::face_list(bad)).has(kith::problem::bad_index));
    bad.back() = {0, 0, 0};
    EXPECT_TRUE(kith::validate(points, kith::face_list(bad)).has(kith::problem::degenerate_face));
}

namespace {

/// A mesh whose traits forbid next and prev on boundary half-edges, and give vertices any outgoing half-edge.
struct island : mesh3d {
    using mesh3d::mesh3d;
};

} // namespace

template <>
struct kith::mesh_traits<island> : kith::mesh_traits<mesh3d> {
    using native = kith::mesh_traits<mesh3d>;

    static halfedge next(const island& m, halfedge h)
    {
        EXPECT_FALSE(native::is_boundary(m, h));
        return native::next(m, h);
    }
    static halfedge prev(const island& m, halfedge h)
    {
        EXPECT_FALSE(native::is_boundary(m, h));
        return native::prev(m, h);
    }
    using native::halfedge_of;
    static halfedge halfedge_of(const island& m, vertex v)
    {
        halfedge last;
        for (const auto e : native::edges(m))
            for (const auto h : {native::halfedge_of(m, e), native::opposite(m, native::halfedge_of(m, e))})
                if (native::source(m, h) == v)
                    last = h;
        return last;
    }
};

TEST(validate, asks_nothing_of_what_lies_beyond_the_boundary)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        const auto mesh = native(shape);
        const island same(kith::storage<shapes::point>(mesh.points()), mesh.topology(), 0);
        EXPECT_EQ(kith::validate(same).text(), "") << name;
        EXPECT_TRUE(
            std::ranges::equal(kith::to_native(same).topology().corner_halfedge, mesh.topology().corner_halfedge))
            << name;
    }
}
