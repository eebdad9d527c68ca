// SPDX-License-Identifier: BSD-3-Clause
#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/own_state.hpp"
#include "support/some_fields.hpp"
#include "on_ranks.hpp"

#include <kith/butterfly.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/kobbelt.hpp>
#include <kith/loop.hpp>
#include <kith/mid_edge.hpp>
#include <kith/refine_by_exchange.hpp>

#include <utility>

namespace {

/// Refines tiles that already lie on their ranks, with `rings` rings of ghosts.
template <class Scheme>
tiles3d refined_from(const mesh3d& mesh, const Scheme& scheme, int levels, const kith::partition& parts, int rings)
{
    kith::tile_cutter cutter(mesh, scheme, parts.part_of, parts.parts);
    kith::mpi::rank_refinement held(
        world(), cut_tiles_of_rank(cutter, parts.parts, rings), cutter.counts(), scheme, levels, 1);
    tiles3d result;
    held.refine(kith::mpi::sharing::spmd,
                [&](std::uint64_t number, tile3d&& part) { result.push_back({number, std::move(part)}); });
    return result;
}

template <class Scheme>
void expect_rings_are_fetched(const mesh3d& mesh, const Scheme& scheme)
{
    for (const int levels : {1, 2, 3}) {
        const auto whole = kith::refine(mesh, scheme, levels);
        for (const auto& parts : {in_blocks(mesh, 3), scattered(mesh, 5, 2)})
            expect_same(refined_from(mesh, scheme, levels, parts, 1), whole);
    }
}

/// A state that cannot be merged from parts.
struct counted {
    int steps = 0;

    [[nodiscard]] counted after(const auto&, const auto&) const { return {steps + 1}; }
    [[nodiscard]] counted of_part(const auto&) const { return *this; }
    void pack(auto& out) const { out.add(steps); }
    void unpack(auto& in) { steps = in.template get<int>(); }
};
struct without_add_part {
    counted count;

    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "without add_part",
                                   .reach = [](int rings) { return rings + 1; },
                                   .state = &without_add_part::count};
    }
    static constexpr auto columns() { return kith::catmull_clark::columns(); }
    template <class R>
    void operator()(const R& r) const
    {
        kith::catmull_clark()(r);
    }
};

/// Returns `root` on rank 0 and `others` on all other ranks.
template <class T>
T other_on_root(T root, T others)
{
    return world().is_root() ? root : others;
}

} // namespace

TEST(held_tiles, rings_that_are_missing_are_fetched)
{
    const auto house = native(shapes::shaken(shapes::open_house()));
    const auto torus = native(shapes::shaken(shapes::torus(6, 7)));
    const auto triangles = native(shapes::shaken(shapes::triangulated(shapes::torus(6, 7))));
    expect_rings_are_fetched(house, kith::catmull_clark{});
    expect_rings_are_fetched(torus, kith::kobbelt{});
    expect_rings_are_fetched(torus, kith::doo_sabin{});
    expect_rings_are_fetched(torus, kith::mid_edge{});
    expect_rings_are_fetched(triangles, kith::butterfly{});
    expect_rings_are_fetched(triangles, kith::loop{});
}

TEST(held_tiles, state_is_fetched_with_the_rings)
{
    const auto house = native(shapes::shaken(shapes::open_house()));
    expect_rings_are_fetched(house, own_state::some_wrapped(house, kith::crease_method::chaikin));
    expect_rings_are_fetched(house, own_state::some_drawn(house));

    // Each tile has its own state, and no rank has that of the whole mesh.
    const auto scheme = own_state::some_drawn(house);
    const auto parts = scattered(house, 5, 2);
    kith::tile_cutter cutter(house, scheme, parts.part_of, parts.parts);
    std::vector<kith::kept_tile<tile3d, own_state::drawn>> mine;
    for (auto t = std::uint64_t(world().rank()); t < parts.parts; t += std::uint64_t(world().size())) {
        auto job = cutter.cut(t, 1);
        mine.push_back({t, 0, std::move(job.part), std::move(job.scheme)});
    }
    kith::mpi::rank_refinement held(world(), std::move(mine), cutter.counts(), own_state::drawn{}, 3, 1);
    tiles3d refined;
    held.refine(kith::mpi::sharing::spmd,
                [&](std::uint64_t number, tile3d&& part) { refined.push_back({number, std::move(part)}); });
    expect_same(refined, kith::refine(house, scheme, 3));
}

TEST(held_tiles, kept_levels_are_refined_further)
{
    const auto torus = native(shapes::shaken(shapes::torus(6, 7)));
    const kith::kobbelt scheme;
    const auto parts = scattered(torus, 5, 2);
    const auto further = [&](int last_rings) {
        kith::mpi::rank_refinement first(world(), torus, scheme, 1, parts, last_rings);
        auto kept = first.keep_levels(kith::mpi::sharing::spmd);
        std::erase_if(kept, [](const auto& tile) { return tile.level != 1; });
        kith::mpi::rank_refinement next(world(), std::move(kept), first.whole().counts(1), scheme, 2, 0);
        tiles3d refined;
        next.refine(kith::mpi::sharing::spmd,
                    [&](std::uint64_t number, tile3d&& part) { refined.push_back({number, std::move(part)}); });
        return refined;
    };
    expect_same(further(1), kith::refine(torus, scheme, 3));
    const std::string text = error_text<kith::mpi::phase_error>([&] { (void)further(0); });
    EXPECT_NE(text.find(" has no complete ring of ghosts, from which more can be fetched; cut or read the tiles with "
                        "at least one ring"),
              std::string::npos)
        << text;
}

TEST(held_tiles, exchanging_refinement_fetches_rings_for_its_first_step)
{
    const auto torus = native(shapes::shaken(shapes::torus(6, 7)));
    const kith::kobbelt scheme;
    const auto parts = scattered(torus, 5, 2);
    kith::tile_cutter cutter(torus, scheme, parts.part_of, parts.parts);
    kith::mpi::exchanging_refinement refinement(
        world(), cut_tiles_of_rank(cutter, parts.parts, 1), cutter.counts(), scheme, kith::reach_of(scheme, 1));
    refinement.refine();
    expect_same(refinement.tiles(), kith::refine(torus, scheme, 1));
}

TEST(held_tiles, state_that_cannot_be_joined_needs_all_rings)
{
    const auto torus = native(shapes::shaken(shapes::torus(6, 7)));
    const auto parts = in_blocks(torus, 3);
    expect_same(refined_from(torus, without_add_part{}, 2, parts, 3), kith::refine(torus, without_add_part{}, 2));
    EXPECT_EQ(error_text<kith::mpi::phase_error>([&] { refined_from(torus, without_add_part{}, 2, parts, 1); }),
              "tile 0 has 1 complete rings of ghosts and needs 3; cut or read tiles with 3 rings (ring_schedule), or "
              "add add_part to the state of the scheme, so that rings can be fetched");
}

TEST(rank_refinement, refuses_what_differs_between_ranks)
{
    if (world().size() == 1)
        return;
    const auto torus = native(shapes::torus(5, 7));
    const auto parts = in_blocks(torus, 3);
    const auto text = [&](const kith::catmull_clark& scheme, int levels, std::optional<int> last_rings) {
        return error_text<kith::mpi::phase_error>(
            [&] { kith::mpi::rank_refinement(world(), torus, scheme, levels, parts, last_rings); });
    };
    const std::string remedy = " on rank 1 differs from rank 0; give all ranks the same";
    EXPECT_EQ(text({}, 2, 1), "no error");
    EXPECT_EQ(text({}, other_on_root(2, 3), 1), "the number of levels" + remedy);
    EXPECT_EQ(text({}, 2, other_on_root(std::optional<int>(), std::optional(1))), "last_rings" + remedy);
    EXPECT_EQ(text({.corners = other_on_root(kith::boundary_corner::kept, kith::boundary_corner::smoothed)}, 2, 1),
              "an option of the scheme" + remedy);
    kith::mpi::rank_refinement refinement(world(), torus, kith::catmull_clark{}, 1, parts);
    const auto refine = [&](kith::mpi::sharing how, const std::vector<std::uint64_t>& numbers) {
        return error_text<kith::mpi::phase_error>(
            [&] { refinement.refine(how, numbers, [](std::uint64_t, tile3d&&) {}); });
    };
    using kith::mpi::sharing;
    const std::string tiles = "the list of tiles, or the way of sharing them," + remedy;
    EXPECT_EQ(refine(sharing::spmd, {0, 2}), "no error");
    EXPECT_EQ(refine(sharing::spmd, other_on_root<std::vector<std::uint64_t>>({0, 2}, {2, 0})), tiles);
    EXPECT_EQ(refine(other_on_root(sharing::spmd, sharing::manager), {0, 2}), tiles);
    EXPECT_EQ(refine(sharing::manager, {0, 2}), "no error");
}

TEST(rank_refinement, an_exception_of_one_callback_ends_all_ranks_alike)
{
    const auto torus = native(shapes::torus(5, 7));
    const auto parts = in_blocks(torus, 3);
    for (const auto how : {kith::mpi::sharing::spmd, kith::mpi::sharing::manager}) {
        kith::mpi::rank_refinement refinement(world(), torus, kith::catmull_clark{}, 1, parts, 0);
        const auto text = [&](const auto& what) {
            return error_text<kith::mpi::phase_error>([&] {
                refinement.refine(how, [&](std::uint64_t number, tile3d&&) {
                    if (number == 2)
                        throw what;
                });
            });
        };
        EXPECT_EQ(text(std::runtime_error("the disk is full")), "the disk is full");
        EXPECT_EQ(text(42), "an exception not derived from std::exception");
        EXPECT_EQ(text(std::bad_alloc()), "there is not enough memory for a tile; use more tiles or fewer levels");
    }
}

TEST(rank_refinement, refuses_tiles_beyond_its_memory_limit)
{
    const auto torus = native(shapes::torus(24, 24));
    const kith::catmull_clark scheme;
    const auto refine = [&](std::size_t tiles, std::uint64_t limit, std::size_t at_once) {
        return error_text<kith::mpi::phase_error>([&] {
            kith::mpi::rank_refinement refinement(world(), torus, scheme, 4, in_blocks(torus, tiles), {}, limit);
            std::uint64_t faces = 0;
            refinement.refine(
                kith::mpi::sharing::spmd,
                [&](std::uint64_t, tile3d&& part) { faces += kith::owned_count(part.face_marks); },
                at_once);
            EXPECT_EQ(world().sum(std::array{faces})[0], 256 * torus.face_count());
        });
    };
    // Each rank has its own limit. The error names the limit that is exceeded: that of the last rank.
    const auto last = world().rank() == world().size() - 1;
    const std::uint64_t limit = last ? 2'000'000 : ~std::uint64_t(0);
    const std::string text = refine(4, limit, 1);
    EXPECT_TRUE(text.starts_with("catmull-clark: the largest tile needs ")) << text;
    EXPECT_NE(text.find(" bytes at once, the limit of a rank is 2000000; cut it into "), std::string::npos) << text;
    const auto enough = std::size_t(std::stoul(text.substr(text.find("cut it into ") + 12)));
    EXPECT_GT(enough, 4U);
    EXPECT_LT(enough, 40U);
    EXPECT_EQ(refine(enough + 2, limit, 1), "no error"); // parts are not of one size
    EXPECT_NE(refine(4, 1000, 1).find("; no number of tiles would fit, or refine fewer times"), std::string::npos);

    kith::tile_cutter cutter(torus, scheme, in_blocks(torus, 4).part_of, 4);
    const std::string held = error_text<kith::mpi::phase_error>([&] {
        kith::mpi::rank_refinement(
            world(), cut_tiles_of_rank(cutter, 4, 1), cutter.counts(), scheme, 4, std::nullopt, 2'000'000);
    });
    EXPECT_TRUE(held.starts_with("catmull-clark: the largest tile needs ")) << held;

    // Levels that are kept need more memory than levels that are handed over.
    const auto keep = [&](std::uint64_t most) {
        return error_text<kith::mpi::phase_error>([&] {
            kith::mpi::rank_refinement refinement(world(), torus, scheme, 3, in_blocks(torus, 12), 0, most);
            (void)refinement.keep_levels(kith::mpi::sharing::spmd);
        });
    };
    EXPECT_EQ(keep(100'000'000), "no error");
    const std::string kept = keep(2'000'000);
    EXPECT_TRUE(kept.starts_with("catmull-clark: all levels of ")) << kept;
    EXPECT_NE(kept.find(" bytes, the limit of a rank is 2000000; use "), std::string::npos) << kept;
}
