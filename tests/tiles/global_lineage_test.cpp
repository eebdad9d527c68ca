// SPDX-License-Identifier: BSD-3-Clause
#include <kith/tiles/number/global_lineage.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/family.hpp"
#include "support/shuffled.hpp"
#include "support/tiles.hpp"

#include <kith/refine_in_tiles.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace {

template <class Scheme>
auto lineage_of(const mesh3d& mesh, const Scheme& scheme, int levels)
{
    const kith::partition parts{partitions::blocks(mesh.face_count(), 3), 3};
    return kith::tiled_refinement(mesh, scheme, levels, parts).lineage();
}

/// Calls test(scheme, mesh, levels of a hierarchy, lineage) for all schemes that refine in tiles.
template <class Test>
void for_each_family(int levels, std::size_t most_faces, const Test& test)
{
    for_each_of_all_schemes_and_shape([&]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        if constexpr (kith::reaching_scheme<Scheme>) {
            if (mesh.face_count() > most_faces)
                return;
            const int depth = name_of(scheme) == "nasri-hasbini" ? std::min(levels, 3) : levels; // nine faces of each
            kith::hierarchy all(mesh, scheme);
            all.refine(depth);
            test(all, lineage_of(mesh, scheme, depth));
        }
    });
}

bool same_runs(const kith::prefix_sums& a, const kith::prefix_sums& b)
{
    return std::ranges::equal(a.runs(), b.runs(), [](const auto& x, const auto& y) {
        return x.first == y.first and x.before == y.before and x.each == y.each;
    });
}

} // namespace

TEST(global_lineage, knows_the_ancestors_and_descendants_of_all_elements)
{
    for_each_family(2, 24, [](const auto& levels, const auto& lineage) {
        EXPECT_EQ(lineage.depth(), 2);
        EXPECT_EQ(family::difference(levels, lineage, 2), "");
        EXPECT_EQ(family::difference(levels, lineage, 1), "");
    });
}

TEST(global_lineage, knows_those_over_five_levels)
{
    for_each_family(5, 16, [](const auto& levels, const auto& lineage) {
        EXPECT_EQ(family::difference_of_some(levels, lineage, levels.depth(), 7, 60), "");
    });
}

TEST(global_lineage, leads_over_two_surfaces_that_are_refined_one_after_the_other)
{
    const auto house = native(shapes::shaken(shapes::open_house())); // faces of several degrees
    const auto middle = kith::refine(house, kith::mid_edge{}, 1);    // of odd generation, and with many degrees
    kith::hierarchy levels(middle, kith::mid_edge{});
    levels.refine(3);
    EXPECT_EQ(family::difference(levels, lineage_of(middle, kith::mid_edge{}, 3), 3), "");
}

TEST(global_lineage, knows_marked_edges_wherever_they_are)
{
    const auto house = kith::tri_quad(native(shapes::shaken(shapes::open_house())));
    for (const std::uint32_t seed : {3, 4}) {
        const auto mesh = shuffled<kith::four_eight>(house, seed);
        kith::hierarchy levels(mesh, kith::four_eight{});
        levels.refine(3);
        EXPECT_EQ(family::difference(levels, lineage_of(mesh, kith::four_eight{}, 3), 3), "");
    }
}

TEST(global_lineage, is_made_of_what_tiles_know_as_well)
{
    const auto expect = []<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        kith::tile_cutter cutter(mesh, scheme, partitions::scattered(mesh.face_count(), 4, 1), 4);
        kith::control_runs joined;
        for (std::size_t part = 4; part-- > 0;)
            joined.append(kith::control_runs_of<Scheme>(cutter.cut(part, 1).part));
        const auto ours = joined.joined(), theirs = cutter.runs().joined();
        EXPECT_TRUE(same_runs(ours.corners_of_faces, theirs.corners_of_faces));
        EXPECT_TRUE(same_runs(ours.faces_at_vertices, theirs.faces_at_vertices));
    };
    expect(kith::catmull_clark{}, native(shapes::open_house()));
    expect(kith::doo_sabin{}, native(shapes::open_house()));
    expect(kith::doo_sabin{}, native(shapes::torus(5, 7)));
}

TEST(global_lineage, of_a_mesh_of_quads_is_one_run)
{
    const auto torus = native(shapes::torus(5, 7));
    const auto runs = kith::control_runs_of<kith::doo_sabin>(torus).joined();
    EXPECT_EQ(runs.corners_of_faces.runs().size(), 1U);
    EXPECT_EQ(runs.faces_at_vertices.runs().size(), 1U);
}

TEST(global_lineage, refuses_levels_and_elements_that_are_not_there)
{
    const auto torus = native(shapes::torus(5, 7));
    const auto lineage = lineage_of(torus, kith::catmull_clark{}, 2);
    const auto text = [](const auto& call) { return error_text<kith::mesh_error>(call); };
    using enum kith::element_kind;
    EXPECT_EQ(text([&] { return lineage.ancestor(2, {face, 560}, 0); }),
              "face 560 does not exist on level 2, which has 560 faces; take numbers from tiles of level 2");
    EXPECT_EQ(text([&] { return lineage.descendants(0, {vertex, 35}, 1); }),
              "vertex 35 does not exist on level 0, which has 35 vertices; take numbers from tiles of level 0");
    EXPECT_EQ(text([&] { return lineage.ancestor(3, {face, 0}, 0); }),
              "level 3 does not exist, there are 0 to 2; ask for one of them");
    EXPECT_EQ(text([&] { return lineage.ancestor(1, {edge, 0}, 2); }),
              "level 1 was given as the finer, level 2 as the coarser one; give them the other way round");
    EXPECT_NE(text([&] { return lineage.origin(0, {edge, 0}); }).find("level 0 is the control mesh"),
              std::string::npos);
    EXPECT_EQ(text([&] { return lineage.counts(-1); }),
              "level -1 does not exist, there are 0 to 2; ask for one of them");
}
