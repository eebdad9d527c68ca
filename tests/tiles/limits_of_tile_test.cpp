// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limits_of_tile.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/tiles.hpp"

#include <kith/hierarchy.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace {

/// Calls test(part, scheme) for each of the three tiles of a mesh after one step, with `rings` rings of ghosts.
template <class Scheme, class Test>
void for_each_tile(const mesh3d& mesh, const Scheme& scheme, const std::vector<std::uint32_t>& part_of, int rings,
                   const Test& test)
{
    const kith::partition parts{part_of, 3};
    kith::tiled_refinement tiles(mesh, scheme, 1, parts, rings);
    for (std::size_t t = 0; t < tiles.tiles(); ++t) {
        kith::phase_seconds seconds;
        const auto job = tiles.refine_job(t, kith::connect::everything, seconds);
        test(job.part, job.scheme);
    }
}

struct found_limits {
    std::size_t owned = 0, ghosts = 0, unknown = 0;
};

/// Expects that each limit of a tile equals that of the whole level, and counts the limits.
template <class Whole, class Part, class Tile>
void expect_those_of(const Whole& whole, const Part& limits, const Tile& part, found_limits& found)
{
    for (std::size_t v = 0; v < limits.size(); ++v) {
        if (limits[v]) {
            EXPECT_EQ(limits[v], whole[part.vertex_ids[v]]) << "vertex " << part.vertex_ids[v];
            ++(part.owns_vertex(v) ? found.owned : found.ghosts);
        } else {
            found.unknown += whole[part.vertex_ids[v]].has_value();
        }
    }
}

/// Expects that a tile has all limits of the whole level at the faces that it owns.
template <class Whole, class Part, class Tile>
void expect_own(const Whole& whole, const Part& limits, const Tile& part)
{
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
        if (part.owns_face(f)) {
            for (const auto v : part.mesh.face(f))
                EXPECT_EQ(limits[v].has_value(), whole[part.vertex_ids[v]].has_value()) << part.vertex_ids[v];
        }
}

} // namespace

TEST(limits_of_tile, are_those_of_the_whole_level_or_none)
{
    found_limits positions, normals;
    for_each_of_all_schemes_and_shape([&]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        using level = kith::level_of<mesh3d>;
        if constexpr (kith::reaching_scheme<Scheme> and kith::has_limit_positions<Scheme, kith::vertex<level>, level>) {
            kith::hierarchy whole(mesh, scheme);
            whole.refine(1);
            const auto expected = limit_positions(whole.elements(1), whole.scheme(1));
            std::vector<double> heights;
            for (const auto& p : whole[1].points())
                heights.push_back(p[2]);
            const auto expected_heights = limit_values(
                whole.elements(1), whole.scheme(1), std::span<const double>(heights));
            const auto look_at = [&](const auto& part_of, int rings) {
                for_each_tile(mesh, scheme, part_of, rings, [&](const auto& part, const auto& scheme_there) {
                    const auto limits = limit_positions(part, scheme_there);
                    expect_those_of(expected, limits, part, positions);
                    std::vector<double> heights_there;
                    for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v)
                        heights_there.push_back(part.mesh.point(v)[2]);
                    expect_those_of(expected_heights,
                                    limit_values(part, scheme_there, std::span<const double>(heights_there)),
                                    part,
                                    positions);
                    if (rings > kith::limit_rules<Scheme>::rings(scheme))
                        expect_own(expected, limits, part);
                    if constexpr (kith::has_limit_tangents<Scheme, kith::vertex<level>, level>) {
                        const auto of_whole = limit_normals(whole.elements(1), whole.scheme(1));
                        expect_those_of(of_whole, limit_normals(part, scheme_there), part, normals);
                    }
                });
            };
            for (const int rings : {0, 1, 1 + kith::limit_rules<Scheme>::rings(scheme)})
                look_at(partitions::scattered(mesh.face_count(), 3, 1), rings);
            look_at(partitions::blocks(mesh.face_count(), 3), 1);
        }
    });
    for (const auto& found : {positions, normals}) {
        EXPECT_GT(found.owned, 1000U);
        EXPECT_GT(found.ghosts, 1000U);
        EXPECT_GT(found.unknown, 1000U);
    }
}

TEST(limits_of_tile, need_as_many_rings_as_rings_for_limits_says)
{
    const auto torus = native(shapes::shaken(shapes::torus(12, 24)));
    kith::catmull_clark scheme;
    for (std::size_t e = 0; e < torus.edge_count(); e += 3)
        scheme.sharpness.sharpen_edge(e, e % 2 == 0 ? kith::infinitely_sharp : 1.5);
    const int rings = rings_for_limits(scheme);
    const auto blocks = partitions::blocks(torus.face_count(), 3);
    kith::hierarchy whole(torus, scheme);
    whole.refine(1);
    const auto expected = limit_surface_of(whole, 1);
    const auto expected_corners = normals_of_corners(whole[1], expected);
    std::size_t known = 0, sides = 0;
    for_each_tile(torus, scheme, blocks, rings, [&](const auto& part, const auto& scheme_there) {
        const auto limits = limit_surface_of(part, scheme_there);
        for (std::size_t v = 0; v < limits.is_known.size(); ++v)
            if (limits.is_known[v] != 0) {
                EXPECT_EQ(limits.surface.positions[v], expected.positions[part.vertex_ids[v]]);
                EXPECT_EQ(limits.surface.normals[v], expected.normals[part.vertex_ids[v]]);
                ++known;
            } else {
                EXPECT_EQ(limits.surface.normals[v], kith::normal_vector{});
            }
        const auto corners = normals_of_corners(part.mesh, limits.surface);
        for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
            for (std::size_t k = 0; part.owns_face(f) and k < 4; ++k)
                EXPECT_EQ(corners[4 * f + k], expected_corners[part.corner_id(f, k)]);
        sides += limits.surface.corner_normals.size();
    });
    EXPECT_GT(known, whole[1].vertex_count());
    EXPECT_GT(sides, 100U);
    std::size_t refused = 0; // a tile may have more rings than requested
    for (int fewer = 0; fewer < rings; ++fewer)
        for_each_tile(torus, scheme, blocks, fewer, [&](const auto& part, const auto& scheme_there) {
            if (rings_of_ghosts(part) >= rings or part.mesh.face_count() == whole[1].face_count())
                return;
            const auto text = error_text<kith::mesh_error>(
                [&] { static_cast<void>(limit_surface_of(part, scheme_there)); });
            EXPECT_NE(text.find("lacks neighbours that its limit depends on; refine or keep tiles with " +
                                std::to_string(rings) + " rings of ghosts"),
                      std::string::npos)
                << text;
            ++refused;
        });
    EXPECT_GE(refused, 3U);
}
