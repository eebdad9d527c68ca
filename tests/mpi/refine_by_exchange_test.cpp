// SPDX-License-Identifier: BSD-3-Clause
#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/same_mesh.hpp"
#include "on_ranks.hpp"

#include <kith/butterfly.hpp>
#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/refine_by_exchange.hpp>
#include <kith/sqrt3.hpp>

namespace {

/// A scheme that does not declare its reach.
template <class Scheme>
struct unknown_reach {
    Scheme known;

    static constexpr auto traits() { return kith::scheme_traits{.name = "unknown", .state = &unknown_reach::known}; }

    auto columns(int generation = 0) const { return columns_of(known, generation); }
    template <class R>
    void operator()(const R& r) const
    {
        known(r);
    }
};
static_assert(not kith::reaching_scheme<unknown_reach<kith::catmull_clark>>);

/// Refines level by level and compares every element of every tile with the mesh that was refined as a whole.
template <class Refinement, class Scheme>
void expect_same_levels(Refinement refinement, mesh3d whole, const Scheme& scheme, int levels)
{
    for (int level = 0; level <= levels; ++level) {
        if (level > 0) {
            refinement.refine();
            whole = kith::refine(whole, scheme, 1);
        }
        std::vector<int> vertices(whole.vertex_count()), edges(whole.edge_count()), faces(whole.face_count());
        for (const auto& [number, part] : refinement.tiles()) {
            EXPECT_EQ(difference(part, whole, vertices, edges, faces), "") << "tile " << number << ", level " << level;
            const auto incomplete = kith::incomplete_vertices(part);
            for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
                for (const auto v : part.mesh.face(f))
                    EXPECT_FALSE(part.owns_face(f) and incomplete[v] != 0) << "a ring is not complete";
        }
        for (const auto* owners : {&vertices, &edges, &faces})
            for (const auto n : world().sum(std::vector<std::uint64_t>(owners->begin(), owners->end())))
                EXPECT_EQ(n, 1U) << level;
    }
}

template <class Scheme>
void expect_same(const mesh3d& control, const Scheme& scheme, int levels, const kith::partition& parts)
{
    expect_same_levels(
        kith::mpi::exchanging_refinement(world(), control, unknown_reach<Scheme>{scheme}, parts, reach_of(scheme, 1)),
        control,
        scheme,
        levels);
}

/// Expects that ghosts grown from one ring equal the ghosts of a tile that was refined with more rings from the
/// beginning.
template <class Scheme>
void expect_same_ghosts(const mesh3d& control, const Scheme& scheme, const kith::partition& parts)
{
    for (const int rings : {2, 3}) {
        auto grown = refined_tiles(control, scheme, 2, parts, 1);
        const auto expected = refined_tiles(control, scheme, 2, parts, rings);
        kith::mpi::grow_ghosts(world(), std::span(grown), rings);
        for (std::size_t t = 0; t < grown.size(); ++t) {
            const auto &a = grown[t].part, &b = expected[t].part;
            EXPECT_TRUE(same_bits(a.mesh, b.mesh));
            for (const auto kind : {kith::element_kind::vertex, kith::element_kind::edge, kith::element_kind::face}) {
                EXPECT_TRUE(std::ranges::equal(ids_of(a, kind), ids_of(b, kind)));
                EXPECT_TRUE(std::ranges::equal(marks_of(a, kind), marks_of(b, kind)));
            }
            EXPECT_TRUE(std::ranges::equal(a.first_corner_ids, b.first_corner_ids));
            EXPECT_TRUE(std::ranges::equal(a.corners_before, b.corners_before));
            for (std::size_t f = 0; f < a.mesh.face_count(); ++f)
                EXPECT_EQ(a.root(f), b.root(f));
        }
    }
}

} // namespace

TEST(grow_ghosts, fetches_the_rings_that_are_missing)
{
    const auto house = native(shapes::shaken(shapes::open_house()));
    expect_same_ghosts(house, kith::doo_sabin{}, scattered(house, 4, 1));
    const auto torus = native(shapes::with_flips(shapes::shaken(shapes::triangulated(shapes::torus(8, 9))), 1));
    expect_same_ghosts(torus, kith::doo_sabin{}, in_blocks(torus, 6));
    expect_same_ghosts(torus, kith::doo_sabin{}, scattered(torus, 9, 2));
}

TEST(exchanging_refinement, equals_the_whole_mesh_bit_for_bit)
{
    const auto house = native(shapes::shaken(shapes::open_house()));
    const auto grid = native(shapes::shaken(shapes::triangulated(shapes::grid(5, 6))));
    const auto torus = native(shapes::with_flips(shapes::shaken(shapes::triangulated(shapes::torus(6, 8))), 1));
    const auto joined = native(shapes::with_joins(shapes::shaken(shapes::torus(6, 6)), 3, 100));
    for (const std::uint32_t seed : {1, 2}) {
        expect_same(house, kith::catmull_clark{}, 3, scattered(house, 4, seed));
        expect_same(joined, kith::catmull_clark{}, 2, scattered(joined, 7, seed));
        expect_same(house, kith::doo_sabin{}, 3, scattered(house, 4, seed));
        expect_same(
            house, kith::doo_sabin{.boundary = kith::doo_sabin_boundary::clamped}, 3, scattered(house, 5, seed));
        expect_same(joined, kith::doo_sabin{}, 2, scattered(joined, 3, seed));
        for (const auto& triangles : {grid, torus}) {
            expect_same(triangles, kith::butterfly{}, 2, scattered(triangles, 4, seed));
            expect_same(triangles, kith::sqrt3{}, 3, scattered(triangles, 5, seed));
        }
    }
    expect_same(torus, kith::butterfly{}, 2, in_blocks(torus, 3));
    expect_same(grid, kith::sqrt3{}, 4, in_blocks(grid, 2));
}

TEST(exchanging_refinement, takes_tiles_of_quads_alone_beside_others)
{
    for (const std::size_t quad : {3, 40, 128, 250}) {
        const auto torus = native(shapes::shaken(shapes::torus_with_two_triangles(16, quad)));
        expect_same(torus, kith::doo_sabin{}, 3, in_blocks(torus, 2));
        expect_same(torus, kith::catmull_clark{}, 2, in_blocks(torus, 5));
    }
}

TEST(exchanging_refinement, takes_tiles_of_any_generation)
{
    const kith::sqrt3 scheme; // its odd steps cut the edges of the boundary
    const auto grid = native(shapes::shaken(shapes::triangulated(shapes::grid(4, 5))));
    for (const int generation : {1, 2}) {
        const auto control = kith::refine(grid, scheme, generation);
        for (const std::size_t parts : {1, 4}) { // with one part, most ranks have no tile
            const auto partition = scattered(control, parts, 1);
            kith::tile_cutter cutter(control, scheme, partition.part_of, partition.parts);
            auto tiles = cut_tiles_of_rank(cutter, parts, reach_of(scheme, 1));
            expect_same_levels(kith::mpi::exchanging_refinement(world(),
                                                                std::move(tiles),
                                                                cutter.counts(),
                                                                unknown_reach<kith::sqrt3>{scheme},
                                                                reach_of(scheme, 1)),
                               control,
                               scheme,
                               2);
        }
    }
}

TEST(exchanging_refinement, says_when_a_step_needs_more_rings)
{
    const auto torus = native(shapes::shaken(shapes::triangulated(shapes::torus(9, 10))));
    const auto text = [&](int rings) {
        return error_text<kith::mpi::phase_error>([&] {
            kith::mpi::exchanging_refinement refinement(
                world(), torus, unknown_reach<kith::butterfly>{}, in_blocks(torus, 4), rings);
            refinement.refine();
        });
    };
    EXPECT_EQ(text(2), "no error");
    EXPECT_NE(text(1).find("1 rings per step are too few for unknown, ask for more"), std::string::npos) << text(1);
    EXPECT_EQ(text(0), "unknown: 0 rings per step; a step needs 1 or more");
}

TEST(exchanging_refinement, needs_the_edges_of_the_control_mesh)
{
    const auto cube = native(shapes::cube());
    const auto faces = kith::refine(cube, kith::catmull_clark{}, 1, {kith::connect::faces});
    const std::string refusal = "the mesh has face-vertex lists only and no edges; refine it with connect::everything";
    EXPECT_EQ(error_text<kith::mpi::phase_error>(
                  [&] { kith::mpi::exchanging_refinement(world(), faces, kith::doo_sabin{}, in_blocks(faces, 2), 2); }),
              refusal);
    EXPECT_EQ(error_text<kith::mpi::phase_error>(
                  [&] { kith::mpi::rank_refinement(world(), faces, kith::doo_sabin{}, 1, in_blocks(faces, 2)); }),
              refusal);
}
