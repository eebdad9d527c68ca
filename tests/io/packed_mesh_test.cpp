// SPDX-License-Identifier: BSD-3-Clause
#include <kith/packed_mesh.hpp>

#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/same_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

using namespace kith;

namespace {

/// Returns true if the arrays of a mesh are refused after a change.
template <class Change>
bool is_refused_with(const mesh3d& mesh, const Change& change)
{
    auto t = mesh.topology();
    change(t);
    return not io::detail::is_consistent(t, mesh.vertex_count());
}

} // namespace

TEST(packed_mesh, is_the_mesh_again)
{
    const auto mesh = refine(native(shapes::tetrahedron()), sqrt3(), 1);
    packer out;
    io::pack_mesh(out, mesh);
    const auto bytes = out.take();
    unpacker in(bytes);
    const auto again = io::unpack_mesh<std::array<double, 3>, std::uint32_t>(in);
    EXPECT_TRUE(same_bits(again, mesh));
    EXPECT_EQ(again.generation(), mesh.generation());
    EXPECT_TRUE(in.is_at_end());
}

TEST(packed_mesh, is_refused_when_its_arrays_do_not_fit_each_other)
{
    const auto mesh = native(shapes::house());
    auto t = mesh.topology();
    t.corner_vertex[3] = 999;
    packer out;
    io::pack_mesh(out, mesh3d(storage<std::array<double, 3>>(mesh.points()), std::move(t)));
    const auto bytes = out.take();
    unpacker in(bytes);
    EXPECT_EQ(error_text<pack_error>([&] { io::unpack_mesh<std::array<double, 3>, std::uint32_t>(in); }),
              "the arrays of the control mesh do not fit each other; who wrote them is at fault");
}

TEST(packed_mesh, is_refused_when_it_is_of_a_generation_that_none_has)
{
    const auto mesh = native(shapes::house());
    for (const int generation : {-1, std::numeric_limits<int>::max()}) {
        auto t = mesh.topology();
        packer out;
        io::pack_mesh(out, mesh3d(storage<std::array<double, 3>>(mesh.points()), std::move(t), generation));
        const auto bytes = out.take();
        unpacker in(bytes);
        EXPECT_EQ(error_text<pack_error>([&] { io::unpack_mesh<std::array<double, 3>, std::uint32_t>(in); }),
                  "the control mesh is said to have been refined " + std::to_string(generation) +
                      " times; who wrote that is at fault");
    }
}

TEST(packed_mesh, refuse_arrays_that_do_not_fit_each_other)
{
    const auto mesh = native(shapes::house()); // has triangles and quads
    const auto is_refused = [&](const auto& change) { return is_refused_with(mesh, change); };
    EXPECT_FALSE(is_refused([](auto&) {}));
    EXPECT_TRUE(is_refused([](auto& t) { t.corner_vertex[3] = 999; }));
    EXPECT_TRUE(is_refused([](auto& t) { t.corner_vertex[3] = t.corner_vertex[4]; }));
    EXPECT_TRUE(is_refused([](auto& t) { t.corner_halfedge[3] = 9999; }));
    EXPECT_TRUE(is_refused([](auto& t) { std::swap(t.halfedge_corner[0], t.halfedge_corner[2]); }));
    EXPECT_TRUE(is_refused([](auto& t) { std::swap(t.vertex_corner[0], t.vertex_corner[1]); }));
    EXPECT_TRUE(is_refused([](auto& t) { t.face_corner[1] = 99; }));
    EXPECT_TRUE(is_refused([](auto& t) { t.corner_face[0] = 1; }));
    EXPECT_TRUE(is_refused([](auto& t) { t.faces = std::numeric_limits<std::size_t>::max(), t.face_corner = {}; }));
    EXPECT_TRUE(is_refused([](auto& t) { t.degree = 3; }));
    EXPECT_TRUE(is_refused([](auto& t) { t.vertices += 1; }));
}

TEST(packed_mesh, refuse_a_boundary_that_walks_do_not_find)
{
    const auto mesh = native(shapes::grid(2, 2));
    const auto& all = mesh.topology();
    constexpr auto none = std::remove_cvref_t<decltype(all)>::none;
    std::size_t rim = 0;
    while (not all.is_boundary(rim) or all.next_in_fan(all.halfedge_corner[2 * rim]) == none)
        ++rim;
    const auto start = all.halfedge_corner[2 * rim]; // at the start of a fan of two faces
    EXPECT_FALSE(is_refused_with(mesh, [](auto&) {}));
    EXPECT_TRUE(
        is_refused_with(mesh, [&](auto& t) { t.vertex_corner[t.corner_vertex[start]] = t.next_in_fan(start); }));
    EXPECT_TRUE(is_refused_with(mesh, [&](auto& t) {
        t.halfedge_corner[2 * rim] = none;
        t.set_side(start, 2 * rim + 1);
    })) << "the face of an edge at the boundary is on its side 0";
    EXPECT_TRUE(is_refused_with(mesh, [&](auto& t) {
        storage<std::uint32_t> sides(2 * t.edges() + 2, none);
        std::copy(t.halfedge_corner.begin(), t.halfedge_corner.end(), sides.begin());
        t.halfedge_corner = std::move(sides);
    })) << "each edge has a face";
}

TEST(packed_mesh, the_arrays_of_meshes_fit_each_other)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        for (int level = 0; level <= 2; ++level) {
            const auto refined = refine(mesh, scheme, level);
            EXPECT_TRUE(io::detail::is_consistent(refined.topology(), refined.vertex_count()));
        }
    });
}
