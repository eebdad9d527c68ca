// SPDX-License-Identifier: BSD-3-Clause
#include "support/own_state.hpp"
#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "on_ranks.hpp"

#include <kith/mpi/ranks/repartition.hpp>
#include <kith/refine_by_exchange.hpp>
#include <kith/refine_in_tiles.hpp>

namespace {

/// Expects the same result if only rank 0 has the mesh and the state; all other ranks have only the options.
template <class Scheme>
void expect_same_from_one_rank(const mesh3d& mesh, const Scheme& scheme, const Scheme& options,
                               const kith::partition& parts)
{
    const Scheme& mine = world().is_root() ? scheme : options;
    const auto whole = kith::refine(mesh, scheme, 3);
    for (const auto how : {kith::mpi::sharing::spmd, kith::mpi::sharing::manager})
        expect_same(refined_tiles(mesh, mine, 3, parts, 1, how), whole);

    kith::mpi::exchanging_refinement refinement(world(), mesh, mine, parts, kith::reach_of(scheme, 1));
    for (int level = 1; level <= 3; ++level) {
        refinement.refine();
        expect_same(refinement.tiles(), kith::refine(mesh, scheme, level));
    }
}

template <class Scheme>
void expect_same_on_ranks(const mesh3d& mesh, const Scheme& scheme, const Scheme& options, const kith::partition& parts)
{
    expect_same_from_one_rank(mesh, scheme, options, parts);
    const auto whole = kith::refine(mesh, scheme, 3);
    // These tiles lie on their ranks already, so every rank passes the state.
    kith::tile_cutter cutter(mesh, scheme, parts.part_of, parts.parts);
    auto tiles = cut_tiles_of_rank(cutter, parts.parts, kith::ring_schedule(scheme, 3, 1)[0]);
    auto same = cut_tiles_of_rank(cutter, parts.parts, kith::reach_of(scheme, 1));
    kith::mpi::rank_refinement held(world(), std::move(tiles), cutter.counts(), scheme, 3, 1);
    tiles3d refined;
    held.refine(kith::mpi::sharing::spmd,
                [&](std::uint64_t number, tile3d&& part) { refined.push_back({number, std::move(part)}); });
    expect_same(refined, whole);
    kith::mpi::exchanging_refinement exchanging(
        world(), std::move(same), cutter.counts(), scheme, kith::reach_of(scheme, 1));
    for (int level = 1; level <= 3; ++level)
        exchanging.refine();
    expect_same(exchanging.tiles(), whole);
}

} // namespace

TEST(level_state, is_the_same_on_all_ranks_in_both_modes_and_by_exchange)
{
    const auto house = native(shapes::shaken(shapes::open_house()));
    const auto joined = native(shapes::with_joins(shapes::shaken(shapes::torus(6, 6)), 3, 100));
    for (const auto& mesh : {house, joined}) {
        const auto parts = scattered(mesh, 5, 2);
        for (const auto method : {kith::crease_method::uniform, kith::crease_method::chaikin})
            expect_same_on_ranks(mesh,
                                 own_state::some_wrapped(mesh, method),
                                 own_state::wrapped{{.corners = kith::boundary_corner::smoothed}},
                                 parts);
        expect_same_on_ranks(mesh, own_state::some_drawn(mesh), own_state::drawn{}, parts);
        expect_same_on_ranks(mesh, own_state::some_drawn(mesh), own_state::drawn{}, in_blocks(mesh, 3));
    }
}

TEST(level_state, conditions_of_columns_may_ask_it)
{
    const auto mesh = native(shapes::shaken(shapes::triangulated(shapes::grid(4, 5))));
    own_state::capped_dual scheme;
    scheme.kept.at_vertex.resize(mesh.vertex_count());
    for (std::size_t v = 0; v < mesh.vertex_count(); v += 2)
        scheme.kept.at_vertex[v] = 1;
    auto plain = scheme;
    plain.kept = {};
    EXPECT_NE(kith::refine(mesh, plain, 1).face_count(), kith::refine(mesh, scheme, 1).face_count());
    expect_same_from_one_rank(mesh, scheme, own_state::capped_dual{}, in_blocks(mesh, 3));
}

TEST(level_state, schemes_may_have_rules_that_capture)
{
    const auto mesh = native(shapes::shaken(shapes::torus(5, 6)));
    const double weight = 1. / 4;
    const own_state::ruled scheme{[weight](auto v) { return (1 - weight) * v + weight * average(v.neighbors()); }};
    expect_same_on_ranks(mesh, scheme, scheme, in_blocks(mesh, 3));
    const auto parts = in_blocks(mesh, 5);
    kith::mpi::rank_refinement refinement(world(), mesh, scheme, 2, parts, 0);
    auto kept = refinement.keep_levels(kith::mpi::sharing::spmd);
    std::vector<int> rank_of(parts.parts);
    for (std::size_t t = 0; t < rank_of.size(); ++t)
        rank_of[t] = int(parts.parts - t) % world().size();
    const auto moved = kith::mpi::repartition(world(), std::move(kept), rank_of, scheme);
    std::uint64_t tiles = 0;
    for (const auto& tile : moved) {
        EXPECT_EQ(tile.scheme.count.steps, tile.level);
        tiles += 1;
    }
    EXPECT_EQ(world().sum(std::vector{tiles})[0], 3 * parts.parts);
}

TEST(level_state, of_another_mesh_is_refused_before_it_is_cut)
{
    const auto mesh = native(shapes::shaken(shapes::open_house()));
    const auto parts = scattered(mesh, 5, 2);
    const auto expect_refused = [&](const kith::catmull_clark& scheme, const std::string& expected) {
        EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::refine(mesh, scheme, 1); }), expected);
        EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::tiled_refinement(mesh, scheme, 1, parts); }), expected);
        EXPECT_EQ(
            error_text<kith::mpi::phase_error>([&] { kith::mpi::rank_refinement(world(), mesh, scheme, 1, parts); }),
            expected);
        EXPECT_EQ(error_text<kith::mpi::phase_error>(
                      [&] { kith::mpi::exchanging_refinement(world(), mesh, scheme, parts, 1); }),
                  expected);
    };
    const auto remedy = [](std::size_t count) {
        return " does not exist, there are " + std::to_string(count) + "; make the creases for this mesh and level";
    };
    kith::catmull_clark edges, vertices;
    edges.sharpness.sharpen_edge(3, 2);
    edges.sharpness.sharpen_edge(1000000, 2.5);
    expect_refused(edges, "creases: edge 1000000" + remedy(mesh.edge_count()));
    vertices.sharpness.sharpen_vertex(mesh.vertex_count(), 3);
    expect_refused(vertices, "creases: vertex " + std::to_string(mesh.vertex_count()) + remedy(mesh.vertex_count()));
}
