// SPDX-License-Identifier: BSD-3-Clause
#include <kith/step/level_state.hpp>

#include "all_shapes.hpp"
#include "own_state.hpp"
#include "same_mesh.hpp"
#include "tiles.hpp"

#include <kith/hierarchy.hpp>

#include <gtest/gtest.h>

namespace {

mesh3d some_mesh(bool open)
{
    return native(open ? shapes::shaken(shapes::grid(6, 7))
                       : shapes::with_joins(shapes::shaken(shapes::torus(6, 8)), 3, 100));
}

} // namespace

TEST(level_state, is_handed_on_from_level_to_level_whatever_its_member_is_called)
{
    for (const bool open : {false, true}) {
        const auto mesh = some_mesh(open);
        for (const auto method : {kith::crease_method::uniform, kith::crease_method::chaikin}) {
            const auto scheme = own_state::some_wrapped(mesh, method);
            const auto expected = kith::refine(mesh, scheme.inner, 3);
            EXPECT_TRUE(same_bits(kith::refine(mesh, scheme, 3), expected));
            kith::hierarchy levels(mesh, scheme);
            levels.refine(1);
            levels.refine(2);
            EXPECT_TRUE(same_bits(levels.finest(), expected));
        }
        kith::hierarchy levels(mesh, own_state::some_drawn(mesh));
        levels.refine(2);
        EXPECT_EQ(levels.scheme(2).kept.levels, 2);
        EXPECT_EQ(levels.scheme(2).kept.of_vertex(4), 4. / 8 / 4);
        EXPECT_FALSE(levels.scheme(2).sharp.empty());
    }
}

TEST(level_state, is_cut_and_handed_on_in_tiles)
{
    for (const bool open : {false, true}) {
        const auto mesh = some_mesh(open);
        const std::size_t faces = mesh.face_count();
        const auto run = [&](const auto& scheme) {
            EXPECT_EQ(tiles_differ(mesh, scheme, 3, partitions::blocks(faces, 3), 3), "");
            EXPECT_EQ(tiles_differ(mesh, scheme, 3, partitions::scattered(faces, 5, 1), 7), "");
            EXPECT_EQ(tiles_differ(mesh, scheme, 2, partitions::blocks(faces, faces), faces), "");
        };
        run(own_state::some_wrapped(mesh, kith::crease_method::uniform));
        run(own_state::some_wrapped(mesh, kith::crease_method::chaikin));
        run(own_state::some_drawn(mesh));
    }
}

TEST(level_state, comes_out_of_a_message_as_it_went_in)
{
    const auto mesh = some_mesh(true);
    const auto parts = partitions::blocks(mesh.face_count(), 3);
    const auto scheme = own_state::some_drawn(mesh);
    const auto job = kith::tile_cutter(mesh, scheme, parts, 3).cut(1, 1);
    const auto bytes = kith::pack(job);
    const auto other = kith::unpack<shapes::point, std::uint32_t>(bytes, own_state::drawn{});
    EXPECT_EQ(kith::pack(other), bytes);
    EXPECT_EQ(other.scheme.kept.at_face, job.scheme.kept.at_face);
    EXPECT_EQ(other.scheme.sharp.edges(), job.scheme.sharp.edges());
    const auto options = kith::unpack<shapes::point, std::uint32_t>(
        kith::pack(
            kith::tile_cutter(mesh, own_state::some_wrapped(mesh, kith::crease_method::chaikin), parts, 3).cut(1, 1)),
        own_state::wrapped{{.corners = kith::boundary_corner::smoothed}});
    EXPECT_EQ(options.scheme.inner.corners, kith::boundary_corner::smoothed);
    EXPECT_EQ(options.scheme.inner.sharpness.method, kith::crease_method::chaikin);
}
