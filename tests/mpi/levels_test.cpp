// SPDX-License-Identifier: BSD-3-Clause
#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/some_fields.hpp"
#include "on_ranks.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/hierarchy.hpp>
#include <kith/mpi/ranks/repartition.hpp>
#include <kith/refine_by_exchange.hpp>
#include <kith/refine_in_tiles.hpp>

#include <array>
#include <numeric>

namespace {

/// Returns true if two schemes of a tile have the same creases.
template <class Scheme>
bool same_creases(const Scheme& a, const Scheme& b)
{
    if constexpr (kith::scheme_with_creases<Scheme>)
        return a.sharpness.edges() == b.sharpness.edges() and a.sharpness.vertices() == b.sharpness.vertices();
    else
        return true;
}

/// Expects all tiles of this rank, level by level, to match the levels that were refined as a whole. Points are
/// compared bit for bit; numbers, owners and the state of the schemes must agree, too. Collective.
template <class Levels, class Kept>
void expect_levels(const Levels& levels, const std::vector<Kept>& tiles, int from, std::size_t parts)
{
    for (int level = from; level <= levels.depth(); ++level) {
        const auto& whole = levels[level];
        std::vector<int> vertices(whole.vertex_count()), edges(whole.edge_count()), faces(whole.face_count());
        std::uint64_t met = 0;
        for (const auto& kept : tiles)
            if (kept.level == level) {
                ++met;
                EXPECT_EQ(difference(kept.part, whole, vertices, edges, faces), "");
                const auto expected = kith::detail::scheme_of_tile(levels.scheme(level), kept.part);
                EXPECT_TRUE(same_creases(kept.scheme, expected)) << "level " << level;
                EXPECT_EQ(some_fields::difference_in_tile(kept.part, kept.scheme, levels.scheme(level)), "");
            }
        EXPECT_EQ(world().sum(std::array{met})[0], parts);
        for (const auto* owners : {&vertices, &edges, &faces}) {
            const auto all = world().sum(std::vector<std::uint64_t>(owners->begin(), owners->end()));
            EXPECT_TRUE(std::ranges::all_of(all, [](std::uint64_t n) { return n == 1; })) << "level " << level;
        }
    }
}

kith::catmull_clark creased(const mesh3d& mesh)
{
    kith::catmull_clark scheme;
    for (std::size_t e = 0; e < mesh.edge_count(); e += 3)
        scheme.sharpness.sharpen_edge(e, e % 2 == 0 ? 1.5 : kith::infinitely_sharp);
    scheme.sharpness.sharpen_vertex(2, 0.7);
    return scheme;
}

template <class Scheme>
void expect_all_levels(const mesh3d& mesh, const Scheme& plain)
{
    const auto given = some_fields::with_some_fields(plain, mesh);
    const auto mine = world().is_root() ? given : some_fields::without_values(given);
    kith::hierarchy levels(mesh, given);
    levels.refine(3);
    const auto parts = scattered(mesh, 4, 2);
    using kept_type = kith::kept_tile<tile3d, std::remove_cvref_t<decltype(given)>>;

    for (const auto how : {kith::mpi::sharing::spmd, kith::mpi::sharing::manager}) {
        std::vector<kept_type> kept;
        kith::mpi::rank_refinement refinement(world(), mesh, mine, 3, parts, 1);
        const auto done = refinement.refine_levels(how, [&](kept_type&& tile) { kept.push_back(std::move(tile)); });
        EXPECT_EQ(world().sum(std::array{done.owned_faces})[0], levels[3].face_count());
        expect_levels(levels, kept, 0, 4);
        std::vector<int> rank_of(4);
        for (std::size_t t = 0; t < 4; ++t)
            rank_of[t] = int((2 * t + 1) % std::size_t(world().size()));
        kept = kith::mpi::repartition(world(), std::move(kept), rank_of, some_fields::without_values(given));
        EXPECT_TRUE(std::ranges::all_of(kept, [&](const auto& k) { return rank_of[k.number] == world().rank(); }));
        EXPECT_TRUE(std::ranges::is_sorted(kept, {}, [](const auto& k) { return std::pair(k.number, k.level); }));
        expect_levels(levels, kept, 0, 4);
    }

    std::vector<kept_type> kept;
    kith::mpi::exchanging_refinement refinement(world(), mesh, mine, parts, kith::reach_of(given, 1));
    for (int level = 0; level < 3; ++level)
        refinement.refine([&](kept_type&& tile) { kept.push_back(std::move(tile)); });
    for (auto& last : std::move(refinement).take_tiles())
        kept.push_back(std::move(last));
    expect_levels(levels, kept, 0, 4);
}

} // namespace

TEST(levels_of_tiles, are_handed_over_with_their_schemes)
{
    const auto house = native(shapes::shaken(shapes::open_house())); // faces of several degrees
    expect_all_levels(house, creased(house));
    expect_all_levels(house, kith::doo_sabin{});
}

TEST(levels_of_tiles, need_edges_on_the_last_one)
{
    const auto torus = native(shapes::torus(4, 5));
    kith::mpi::rank_refinement refinement(world(), torus, kith::catmull_clark{}, 1, in_blocks(torus, 2));
    const std::string text = error_text<kith::mpi::phase_error>(
        [&] { refinement.refine_levels(kith::mpi::sharing::spmd, [](const auto&) {}); });
    EXPECT_NE(text.find("give last_rings"), std::string::npos) << text;
}

TEST(levels_of_tiles, are_the_same_on_one_machine)
{
    const auto house = native(shapes::shaken(shapes::open_house()));
    const auto scheme = creased(house);
    kith::hierarchy levels(house, scheme);
    levels.refine(2);
    kith::tiled_refinement refinement(house, scheme, 2, scattered(house, 3, 1), 1);
    std::vector<std::vector<int>> owners;
    for (int level = 0; level <= 2; ++level)
        owners.emplace_back(levels[level].face_count());
    for (std::size_t part = 0; part < refinement.tiles(); ++part)
        refinement.refine_levels(part, [&](auto&& kept) {
            const auto& whole = levels[kept.level];
            std::vector<int> vertices(whole.vertex_count()), edges(whole.edge_count());
            EXPECT_EQ(kept.number, part);
            EXPECT_EQ(difference(kept.part, whole, vertices, edges, owners[std::size_t(kept.level)]), "");
            EXPECT_FALSE(kept.level == 0 and kept.scheme.sharpness.empty());
            EXPECT_TRUE(same_creases(kept.scheme, kith::detail::scheme_of_tile(levels.scheme(kept.level), kept.part)));
        });
    for (const auto& faces : owners)
        EXPECT_TRUE(std::ranges::all_of(faces, [](int n) { return n == 1; }));
}
