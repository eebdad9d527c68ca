// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/step/level_state.hpp>

#include "support/all_shapes.hpp"
#include "support/own_state.hpp"
#include "support/patch_templates.hpp"
#include "support/same_mesh.hpp"
#include "support/tiles.hpp"

#include <kith/evaluator.hpp>
#include <kith/hierarchy.hpp>
#include <kith/plan.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/refine_with_fields.hpp>
#include <kith/selected.hpp>

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

TEST(level_state, columns_may_follow_it)
{
    const auto mesh = native(shapes::shaken(shapes::torus(12, 14)));
    const own_state::two_and_three scheme;
    kith::hierarchy levels(mesh, scheme);
    levels.refine(3);
    const auto planned = kith::plan(levels.elements(0).counts(), scheme, 3);
    for (int level = 0; level <= 3; ++level)
        EXPECT_EQ(planned[std::size_t(level)].counts, levels.elements(level).counts());
    EXPECT_TRUE(same_bits(kith::refine(mesh, scheme, 3), levels.finest()));
    kith::patch_refinement patches(mesh, scheme, 3, kith::connect::everything, all_templates);
    ASSERT_TRUE(patches.is_worth_looking());
    EXPECT_TRUE(same_bits(made_by_patches(mesh, scheme, 3, kith::connect::everything, all_templates), levels.finest()));
    kith::evaluator surface(mesh, scheme, 3);
    EXPECT_TRUE(std::ranges::equal(surface.evaluate(mesh.points()), levels.finest().points()));
    EXPECT_EQ(tiles_differ(mesh, scheme, 3, partitions::blocks(mesh.face_count(), 3), 3), "");
}

TEST(level_state, schemes_may_have_rules_that_capture)
{
    const auto mesh = native(shapes::shaken(shapes::torus(4, 5)));
    const double weight = 1. / 4;
    const own_state::ruled scheme{[weight](auto v) { return (1 - weight) * v + weight * average(v.neighbors()); }};
    const auto expected = kith::refine(mesh, scheme, 2);
    kith::hierarchy levels(mesh, scheme);
    levels.refine(2);
    levels.undo(1);
    levels.redo();
    EXPECT_TRUE(same_bits(levels.finest(), expected));
    kith::evaluator surface(mesh, scheme, 2);
    EXPECT_TRUE(std::ranges::equal(surface.evaluate(mesh.points()), expected.points()));
    auto marks = kith::on_faces(std::vector<int>(mesh.face_count(), 7));
    EXPECT_TRUE(same_bits(kith::refine_with_fields(mesh, scheme, 2, std::tie(marks)), expected));
    auto with_marks = kith::with_fields(scheme, kith::on_faces(std::vector<int>(mesh.face_count(), 7)));
    EXPECT_TRUE(same_bits(kith::refine_with_fields(mesh, with_marks, 2), expected));
    kith::hierarchy some(mesh, kith::selected(scheme));
    some.refine_if([](auto f) { return f.value % 3 == 0; });
    some.refine();
    EXPECT_GT(some.finest().face_count(), mesh.face_count());
    kith::tiled_refinement tiles(mesh, scheme, 2, kith::block_partition(mesh, 3));
    std::vector<int> steps;
    tiles.refine_levels(1, [&](const auto& kept) { steps.push_back(kept.scheme.count.steps - kept.level); });
    EXPECT_EQ(steps, std::vector<int>(3, 0));
    EXPECT_EQ(tiles_differ(mesh, scheme, 2, partitions::blocks(mesh.face_count(), 3), 3), "");
}
