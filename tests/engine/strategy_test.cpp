// SPDX-License-Identifier: BSD-3-Clause
#include <kith/evaluator.hpp>
#include <kith/fields/with_fields.hpp>
#include <kith/hierarchy.hpp>
#include <kith/make_creases.hpp>
#include <kith/refine.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/refine_with_fields.hpp>

#include "support/every_scheme.hpp"
#include "support/forced_way.hpp"
#include "support/same_mesh.hpp"
#include "support/shuffled.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace {

using kith::connect;
using kith::refinement_way;
using kith::strategy_reason;

void expect_strategy(const kith::strategy& how, refinement_way way, strategy_reason reason)
{
    EXPECT_EQ(how.way, way) << explain(how);
    EXPECT_EQ(how.reason, reason) << explain(how);
}

TEST(strategy, tells_how_levels_are_made_and_why)
{
    const auto torus = native(shapes::torus(24, 12)); // 288 quads
    const auto of_torus = [&](const auto& scheme, int levels) {
        return strategy_of(torus, scheme, levels, {.last_level = connect::faces});
    };
    expect_strategy(of_torus(kith::doo_sabin{}, 0), refinement_way::by_levels, strategy_reason::no_patches);
    expect_strategy(of_torus(kith::unified{}, 2), refinement_way::by_levels, strategy_reason::no_patches);
    const auto small = of_torus(kith::catmull_clark{}, 2);
    expect_strategy(small, refinement_way::by_levels, strategy_reason::few_faces);
    EXPECT_EQ(explain(small), "level by level: 4608 faces are fewer than 50000, where templates begin to pay");
    const auto large = of_torus(kith::catmull_clark{}, 6);
    expect_strategy(large, refinement_way::in_patches, strategy_reason::gain);
    EXPECT_EQ(large.begin, 3);
    EXPECT_EQ(explain(large),
              "in patches from level 3 on: " + std::to_string(large.classes) + " classes of faces, " +
                  std::to_string(large.templates) + " with templates");
    EXPECT_LT(0U, large.templates);
    EXPECT_LE(large.templates, large.classes);
    const auto again = of_torus(kith::catmull_clark{}, 6);
    EXPECT_EQ(again.begin, large.begin);
    EXPECT_EQ(again.classes, large.classes);
}

TEST(strategy, puts_scattered_faces_into_the_order_of_the_surface)
{
    const auto scattered = native(shapes::shuffled(shapes::triangulated(shapes::torus(62, 66)), 3));
    const auto how = strategy_of(scattered, kith::butterfly{}, 3, {.last_level = connect::faces});
    EXPECT_EQ(how.way, refinement_way::in_surface_order) << explain(how);
    EXPECT_EQ(explain(how).substr(0, 43), "level by level in the order of the surface:");
    kith::loop creased;
    creased.sharpness.sharpen_edge(0, 2.);
    EXPECT_NE(strategy_of(scattered, creased, 3, {.last_level = connect::faces}).way, refinement_way::in_surface_order)
        << "creases are kept by the numbers of edges";
}

TEST(strategy, can_be_forced)
{
    const auto torus = native(shapes::torus(6, 5));
    {
        const forced_way_here in(refinement_way::in_patches);
        expect_strategy(
            strategy_of(torus, kith::catmull_clark{}, 2), refinement_way::in_patches, strategy_reason::gain);
    }
    {
        const forced_way_here in(refinement_way::in_surface_order);
        expect_strategy(
            strategy_of(torus, kith::catmull_clark{}, 2), refinement_way::in_surface_order, strategy_reason::forced);
    }
    const forced_way_here in(refinement_way::by_levels);
    const auto large = strategy_of(native(shapes::torus(24, 12)), kith::catmull_clark{}, 6);
    expect_strategy(large, refinement_way::by_levels, strategy_reason::forced);
    EXPECT_EQ(explain(large), "level by level: as asked for");
}

/// The results of all functions that refine a native mesh.
struct made_by_doors {
    mesh3d faces, everything, with_state;
    std::vector<mesh3d> levels;
    std::vector<mesh3d> of_tiles;
    std::vector<double> carried, along, beside;
    std::vector<std::array<double, 3>> evaluated;
};

template <class Scheme>
made_by_doors by_all_doors(const mesh3d& mesh, const Scheme& scheme, int steps)
{
    made_by_doors result;
    result.faces = refine(mesh, scheme, steps, {.last_level = connect::faces});
    result.everything = refine(mesh, scheme, steps);
    kith::storage<double> heights(mesh.vertex_count());
    for (std::size_t v = 0; v < heights.size(); ++v)
        heights[v] = mesh.point(v)[2] * mesh.point(v)[0];
    kith::hierarchy levels(mesh, scheme);
    levels.refine(steps);
    for (int level = 0; level <= steps; ++level)
        result.levels.push_back(levels[level]);
    using height_field = kith::field<kith::field_on::vertices, double, kith::by_mask>;
    const auto carried = levels.carry(0, steps, height_field(heights));
    result.carried.assign(carried.values().begin(), carried.values().end());
    height_field along(heights);
    refine_with_fields(mesh, scheme, steps, std::tie(along));
    result.along.assign(along.values().begin(), along.values().end());
    kith::with_fields beside(scheme, height_field(heights));
    result.with_state = refine_with_fields(mesh, beside, steps);
    result.beside.assign(beside.field().values().begin(), beside.field().values().end());
    if constexpr (kith::scheme_with_creases<Scheme>) {
        EXPECT_EQ(beside.plain().sharpness, levels.scheme(steps).sharpness);
    }
    kith::evaluator points(mesh, scheme, steps);
    const auto evaluated = points.evaluate(mesh.points());
    result.evaluated.assign(evaluated.begin(), evaluated.end());
    if constexpr (kith::reaching_scheme<Scheme>) {
        kith::partition parts{{}, 3};
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            parts.part_of.push_back(std::uint32_t(3 * f / mesh.face_count()));
        kith::tiled_refinement tiles(mesh, scheme, steps, parts);
        for (std::size_t t = 0; t < 3; ++t)
            result.of_tiles.push_back(tiles.refine(t).mesh);
    }
    return result;
}

template <class Scheme>
void expect_same_by_all_ways(const mesh3d& mesh, const Scheme& scheme, int steps)
{
    kith::force_way(refinement_way::by_levels);
    const made_by_doors expected = by_all_doors(mesh, scheme, steps);
    for (const refinement_way way : all_ways) {
        const forced_way_here in(way);
        const made_by_doors made = by_all_doors(mesh, scheme, steps);
        EXPECT_TRUE(same_bits(made.faces, expected.faces)) << int(way);
        EXPECT_TRUE(same_bits(made.everything, expected.everything)) << int(way);
        for (std::size_t level = 0; level < made.levels.size(); ++level)
            EXPECT_TRUE(same_bits(made.levels[level], expected.levels[level])) << int(way) << ' ' << level;
        EXPECT_EQ(made.carried, expected.carried) << int(way);
        EXPECT_EQ(made.along, expected.along) << int(way);
        EXPECT_EQ(made.beside, expected.along) << int(way);
        EXPECT_TRUE(same_bits(made.with_state, expected.everything)) << int(way);
        EXPECT_EQ(made.evaluated, expected.evaluated) << int(way);
        for (std::size_t tile = 0; tile < made.of_tiles.size(); ++tile)
            EXPECT_TRUE(same_bits(made.of_tiles[tile], expected.of_tiles[tile])) << int(way) << ' ' << tile;
    }
}

TEST(strategy, makes_the_same_bits_at_every_door_by_every_way)
{
    const auto quads = native(shapes::shaken(shapes::shuffled(shapes::torus(9, 8), 3)));
    const auto triangles = native(shapes::shaken(shapes::shuffled(shapes::triangulated(shapes::torus(6, 7)), 5)));
    expect_same_by_all_ways(quads, kith::catmull_clark{}, 3);
    kith::catmull_clark creased;
    creased.sharpness = kith::make_creases(quads,
                                           [](auto e) { return e.value % 7 == 0 ? double(1 + e.value % 5) : 0; });
    expect_same_by_all_ways(quads, creased, 3);
    expect_same_by_all_ways(quads, kith::kobbelt{}, 2);
    expect_same_by_all_ways(quads, kith::doo_sabin{}, 3);
    expect_same_by_all_ways(triangles, kith::loop{}, 3);
    expect_same_by_all_ways(triangles, kith::sqrt3{}, 3);
    expect_same_by_all_ways(triangles, kith::butterfly{}, 2);
}

} // namespace
