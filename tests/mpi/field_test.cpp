// SPDX-License-Identifier: BSD-3-Clause
#include "support/all_shapes.hpp"
#include "support/marks_and_parity.hpp"
#include "support/some_fields.hpp"
#include "on_ranks.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/refine_by_exchange.hpp>
#include <kith/refine_with_fields.hpp>

namespace {

/// Expects the fields of a tile of this rank to be those of the mesh that was refined as a whole.
template <class Scheme>
void expect_same(const tile3d& part, const Scheme& scheme, const Scheme& whole)
{
    EXPECT_EQ(some_fields::difference_in_tile(part, scheme, whole), "");
}

/// Expects the same fields on all ranks, though only rank 0 has the values; all other ranks have only the rules.
template <class Scheme>
void expect_same_on_ranks(const mesh3d& mesh, const Scheme& plain, const kith::partition& parts)
{
    const auto given = some_fields::with_some_fields(plain, mesh);
    const auto mine = world().is_root() ? given : some_fields::without_values(given);
    auto whole = given;
    const auto fine = kith::refine_with_fields(mesh, whole, 2);

    for (const auto how : {kith::mpi::sharing::spmd, kith::mpi::sharing::manager}) {
        std::uint64_t tiles = 0;
        kith::mpi::rank_refinement refinement(world(), mesh, mine, 2, parts, 1);
        refinement.refine(how, [&](std::uint64_t, tile3d&& part, const auto& scheme) {
            ++tiles;
            expect_same(part, scheme, whole);
        });
        EXPECT_EQ(world().sum(std::array{tiles})[0], parts.parts);
    }

    kith::tile_cutter cutter(mesh, given, parts.part_of, parts.parts);
    // These tiles lie on their ranks already, so every rank passes the fields.
    auto tiles = cut_tiles_of_rank(cutter, parts.parts, kith::reach_of(given, 1));
    kith::mpi::exchanging_refinement dealt(world(), mesh, mine, parts, kith::reach_of(given, 1));
    kith::mpi::exchanging_refinement held(world(), std::move(tiles), cutter.counts(), given, kith::reach_of(given, 1));
    for (auto* refinement : {&dealt, &held}) {
        refinement->refine();
        refinement->refine();
        ASSERT_EQ(refinement->schemes().size(), refinement->tiles().size());
        for (std::size_t t = 0; t < refinement->tiles().size(); ++t)
            expect_same(refinement->tiles()[t].part, refinement->schemes()[t], whole);
    }
}

/// Expects that looks(mesh, scheme) finds no fault in any tile after two steps.
template <class Scheme, class Looks>
void expect_on_ranks(const mesh3d& mesh, const Scheme& given, const Looks& looks)
{
    const auto parts = scattered(mesh, 4, 2);
    const auto mine = world().is_root() ? given : some_fields::without_values(given);
    for (const auto how : {kith::mpi::sharing::spmd, kith::mpi::sharing::manager}) {
        kith::mpi::rank_refinement refinement(world(), mesh, mine, 2, parts, 1);
        refinement.refine(
            how, [&](std::uint64_t, tile3d&& part, const auto& scheme) { EXPECT_EQ(looks(part.mesh, scheme), ""); });
    }
    kith::mpi::exchanging_refinement dealt(world(), mesh, mine, parts, kith::reach_of(given, 1));
    for (int step = 0; step < 2; ++step)
        dealt.refine();
    for (std::size_t t = 0; t < dealt.tiles().size(); ++t)
        EXPECT_EQ(looks(dealt.tiles()[t].part.mesh, dealt.schemes()[t]), "");
}

} // namespace

TEST(field, is_the_same_on_all_ranks_in_both_modes_and_by_exchange)
{
    const auto house = native(shapes::shaken(shapes::open_house())); // faces of several degrees
    const auto joined = native(shapes::with_joins(shapes::shaken(shapes::torus(6, 6)), 3, 100));
    expect_same_on_ranks(house, kith::catmull_clark{}, scattered(house, 4, 2));
    expect_same_on_ranks(joined, kith::catmull_clark{}, in_blocks(joined, 3));
    expect_same_on_ranks(house, kith::doo_sabin{}, scattered(house, 4, 2));
    expect_same_on_ranks(joined, kith::doo_sabin{}, in_blocks(joined, 3));
}

TEST(marks_and_parity, are_fields_on_all_ranks_in_both_modes_and_by_exchange)
{
    using namespace marks_and_parity;
    for (const bool open : {false, true}) {
        const auto halved = some_tri_quad(open), triangles = some_triangles(open);
        expect_on_ranks(
            halved, with_marks(halved), [](const auto& mesh, const auto& scheme) { return wrong_marks(mesh, scheme); });
        expect_on_ranks(triangles, with_parity(triangles, false), [](const auto& mesh, const auto& scheme) {
            return wrong_parity(mesh, scheme, 2);
        });
    }
}
