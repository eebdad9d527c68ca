// SPDX-License-Identifier: BSD-3-Clause
#include "support/every_scheme.hpp"
#include "support/family.hpp"
#include "support/shuffled.hpp"
#include "on_ranks.hpp"

#include <kith/mpi/ranks/repartition.hpp>
#include <kith/refine_by_exchange.hpp>

namespace {

/// Compares the lineage of random elements of this rank's tiles, including ghosts.
template <class Levels, class Lineage>
std::string difference_in_tiles(const Levels& levels, const Lineage& lineage, int level, const tiles3d& tiles)
{
    std::mt19937 random(std::uint32_t(world().rank()));
    for (const auto& [number, part] : tiles)
        for (const auto kind : {kith::element_kind::vertex, kith::element_kind::edge, kith::element_kind::face})
            for (int i = 0; i < 4 and part.face_ids.size() > 0; ++i) {
                const auto ids = ids_of(part, kind);
                const kith::numbered_element x{kind, ids[random() % ids.size()]};
                if (auto text = family::difference(levels, lineage, level, x, int(random() % unsigned(level + 1)));
                    not text.empty())
                    return text;
            }
    return {};
}

std::vector<int> other_ranks(std::size_t tiles)
{
    std::vector<int> rank_of(tiles);
    for (std::size_t t = 0; t < tiles; ++t)
        rank_of[t] = int((3 * t + 1) % std::size_t(world().size()));
    return rank_of;
}

template <class Scheme>
void expect_family(const Scheme& scheme, const mesh3d& mesh, int depth)
{
    kith::hierarchy levels(mesh, scheme);
    levels.refine(depth);
    const mesh3d nothing;
    kith::mpi::rank_refinement refinement(
        world(), world().is_root() ? mesh : nothing, scheme, depth, scattered(mesh, 5, 1), 1);
    const auto lineage = refinement.lineage();
    tiles3d tiles;
    refinement.refine(kith::mpi::sharing::spmd,
                      [&](std::uint64_t number, tile3d&& part) { tiles.push_back({number, std::move(part)}); });
    EXPECT_EQ(difference_in_tiles(levels, lineage, depth, tiles), "");
    tiles = kith::mpi::repartition(world(), std::move(tiles), other_ranks(5));
    EXPECT_EQ(difference_in_tiles(levels, lineage, depth, tiles), "");
}

template <class Scheme>
void expect_family_by_exchange(const Scheme& scheme, const mesh3d& mesh, int depth)
{
    kith::hierarchy levels(mesh, scheme);
    levels.refine(depth);
    const auto refined = [&](auto refinement) {
        for (int level = 0; level < depth; ++level)
            refinement.refine();
        EXPECT_EQ(family::difference_of_some(levels, refinement.lineage(), depth, 3, 30), "");
    };
    const auto parts = scattered(mesh, 5, 1);
    refined(kith::mpi::exchanging_refinement(world(), mesh, scheme, parts, kith::reach_of(scheme, 1)));
    if constexpr (not kith::marks_edges<Scheme>) {
        kith::tile_cutter cutter(mesh, scheme, parts.part_of, parts.parts);
        auto tiles = cut_tiles_of_rank(cutter, parts.parts, kith::reach_of(scheme, 1));
        refined(kith::mpi::exchanging_refinement(
            world(), std::move(tiles), cutter.counts(), scheme, kith::reach_of(scheme, 1)));
    }
}

} // namespace

TEST(lineage_on_ranks, leads_from_level_5_up_and_down_before_and_after_a_repartition)
{
    for_each_of_all_schemes_and_shape([]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        if constexpr (kith::reaching_scheme<Scheme>)
            if (mesh.face_count() <= 8) // each rank has all levels, to compare
                expect_family(
                    scheme, mesh, name_of(scheme) == "nasri-hasbini" and mesh.face_count() > 4 ? 3 : 5); // nine of each
    });
    const auto house = native(shapes::shaken(shapes::open_house())); // faces of several degrees
    expect_family(kith::catmull_clark{}, house, 3);
    expect_family(kith::doo_sabin{}, house, 3);
    expect_family(kith::mid_edge{}, house, 3);
    expect_family(kith::four_eight{}, shuffled<kith::four_eight>(kith::tri_quad(house), 3), 4);
}

TEST(lineage_on_ranks, is_known_where_ghosts_are_fetched)
{
    const auto house = native(shapes::shaken(shapes::open_house()));
    expect_family_by_exchange(kith::catmull_clark{}, house, 2);
    expect_family_by_exchange(kith::doo_sabin{}, house, 2);
    expect_family_by_exchange(kith::four_eight{}, kith::tri_quad(house), 3);
}

TEST(lineage_on_ranks, is_known_of_tiles_that_lie_on_their_ranks)
{
    const auto torus = native(shapes::with_joins(shapes::shaken(shapes::torus(6, 6)), 3, 100));
    const auto parts = in_blocks(torus, 3);
    const kith::doo_sabin scheme;
    kith::tile_cutter cutter(torus, scheme, parts.part_of, parts.parts);
    auto tiles = cut_tiles_of_rank(cutter, parts.parts, kith::ring_schedule(scheme, 2, 0)[0]);
    kith::mpi::rank_refinement refinement(world(), std::move(tiles), cutter.counts(), scheme, 2, 0);
    kith::hierarchy levels(torus, scheme);
    levels.refine(2);
    EXPECT_EQ(family::difference_of_some(levels, refinement.lineage(), 2, 3, 60), "");
}
