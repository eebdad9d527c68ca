// SPDX-License-Identifier: BSD-3-Clause
#include <kith/surface_of_tile.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/tiles.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/hierarchy.hpp>
#include <kith/loop.hpp>
#include <kith/refine_in_tiles.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace {

/// Calls test(part, scheme) for three tiles after one step, with `rings` rings of ghosts.
template <class Scheme, class Test>
void for_each_tile(const mesh3d& mesh, const Scheme& scheme, int rings, const Test& test)
{
    kith::tiled_refinement tiles(mesh, scheme, 1, {partitions::blocks(mesh.face_count(), 3), 3}, rings);
    for (std::size_t t = 0; t < tiles.tiles(); ++t) {
        kith::phase_seconds seconds;
        const auto job = tiles.refine_job(t, kith::connect::everything, seconds);
        test(job.part, job.scheme);
    }
}

/// Expects the bits of the whole level on all faces that tiles own.
template <class Scheme>
void expect_bits_of_whole(const mesh3d& mesh, Scheme scheme, kith::crease_method method, int rings)
{
    scheme.sharpness.method = method;
    for (std::size_t edge = 0; edge < mesh.edge_count(); edge += 5)
        scheme.sharpness.sharpen_edge(edge, edge % 2 == 0 ? kith::infinitely_sharp : 2.5);
    kith::hierarchy whole(mesh, scheme);
    whole.refine(1);
    kith::surface_locator surface(whole[1], whole.scheme(1));
    std::size_t faces = 0;
    for_each_tile(mesh, scheme, rings, [&](const auto& part, const auto& scheme_there) {
        std::vector<kith::surface_place> here, there;
        for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
            if (part.owns_face(f)) {
                here.push_back({f, .125, .7});
                there.push_back({std::size_t(part.face_ids[f]), .125, .7});
            }
        faces += here.size();
        const auto made = locate_in_tile(part, scheme_there, here)
                              .evaluate(part.mesh.points(), kith::derivatives::first);
        const auto expected = surface.locate(there).evaluate(whole[1].points(), kith::derivatives::first);
        EXPECT_TRUE(std::ranges::equal(made.points, expected.points));
        EXPECT_TRUE(std::ranges::equal(made.du, expected.du));
        EXPECT_TRUE(std::ranges::equal(made.dv, expected.dv));
    });
    EXPECT_EQ(faces, whole[1].face_count());
}

} // namespace

TEST(surface_of_tile, has_the_bits_of_the_whole_level)
{
    const auto polygons = native(shapes::with_joins(shapes::shaken(shapes::torus(6, 6)), 3, 100));
    const auto triangles = native(shapes::shaken(shapes::with_flips(shapes::triangulated(shapes::torus(5, 6)), 7)));
    expect_bits_of_whole(polygons, kith::catmull_clark{}, kith::crease_method::uniform, 1);
    expect_bits_of_whole(polygons, kith::catmull_clark{}, kith::crease_method::chaikin, 2);
    expect_bits_of_whole(triangles, kith::loop{}, kith::crease_method::uniform, 1);
}

TEST(surface_of_tile, refuses_what_a_tile_does_not_know)
{
    const auto mesh = native(shapes::torus(5, 6));
    std::size_t known = 0, unknown = 0;
    const auto look_at = [&](const auto& part, const auto& scheme) {
        for (std::size_t f = 0; f < part.mesh.face_count(); ++f) {
            const std::vector<kith::surface_place> places{{f, .5, .5}};
            const std::string text = error_text<kith::mesh_error>([&] { locate_in_tile(part, scheme, places); });
            const std::string which = "place 0: face " + std::to_string(f) + " of the tile ";
            if (not part.owns_face(f)) {
                EXPECT_EQ(text, which + "is a ghost; ask the tile that owns face " + std::to_string(part.face_ids[f]));
            } else if (text == "no error") {
                ++known;
            } else {
                EXPECT_EQ(text,
                          which + "lacks neighbours that its surface depends on; refine or keep tiles with 1 ring of "
                                  "ghosts");
                ++unknown;
            }
        }
    };
    for_each_tile(mesh, kith::catmull_clark{}, 1, look_at);
    EXPECT_EQ(known, 4 * mesh.face_count());
    EXPECT_EQ(unknown, 0U);
    for_each_tile(mesh, kith::catmull_clark{}, 0, look_at);
    EXPECT_GT(known, 4 * mesh.face_count());
    EXPECT_GT(unknown, 0U);
}
