// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/step/blocks.hpp>

#include <kith/butterfly.hpp>
#include <kith/catmull_clark.hpp>
#include <kith/loop.hpp>
#include <kith/refine.hpp>
#include <kith/sqrt3.hpp>

#include "support/error_text.hpp"
#include "support/every_level.hpp"
#include "support/own_scheme.hpp"
#include "support/same_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

using namespace kith::targets;

namespace {

constexpr std::size_t blocks = 7;

/// Returns how often the blocks of a level contain each element of one kind.
template <class Part>
std::vector<int> visits(const level_type& level, std::size_t size, const Part& part)
{
    std::vector<int> result(size);
    for (std::size_t i = 0; i < blocks; ++i)
        part(kith::block_of_level<level_type>(level, i, blocks), [&](auto x) { ++result[x.index()]; });
    return result;
}

/// Expects equal bits from a step in blocks and from a step on a level without blocks, which is read through traits.
template <class Scheme>
void expect_same_bits(const Scheme& scheme, const mesh3d& mesh)
{
    kith::numbering_of<Scheme, std::uint32_t> ids;
    const kith::level_elements<kith::mesh_level<mesh3d>> level(mesh);
    const auto whole = kith::refine_level<kith::connect::everything>(level, scheme, 0, ids);
    EXPECT_TRUE(same_bits(kith::refine_mesh<kith::connect::everything>(mesh, scheme, ids), whole));
}

/// Averages faces and then edges over faces, with both loops in the same blocks if `together`. Returns the error.
std::string averages(bool together)
{
    const auto mesh = native(shapes::torus(64, 64)); // 4096 faces, several blocks
    return error_text<kith::association_error>([&] {
        const kith::level_of<mesh3d> coarse(mesh);
        const own_scheme scheme(
            kith::columns(kith::new_vertices(kith::per_face, kith::per_edge), kith::new_faces(quads(kith::per_face))),
            [](const auto&, const auto&) {});
        const kith::numbering_of<decltype(scheme), std::uint32_t> ids(coarse, scheme.columns());
        kith::point_values<kith::level_of<mesh3d>> values;
        const auto text = [together](const auto& r) {
            const auto& assoc = r.assoc;
            const auto of_face = [&](auto f) { assoc(f, V) = average(f.vertices()); };
            const auto of_edge = [&](auto e) { assoc(e, V) = average(assoc(e.lface(), V), assoc(e.rface(), V)); };
            if (not together)
                for_each(r.coarse.faces(), of_face);
            in_blocks(r, [&](const auto& block) {
                if (together)
                    for_each(block.coarse.faces(), of_face);
                for_each(block.coarse.edges(), of_edge);
            });
        };
        kith::run_scheme<kith::connect::nothing, true>(coarse, text, 0, ids, scheme.columns(), values);
    });
}

} // namespace

TEST(blocks, meet_every_element_once)
{
    for (const auto& shape : {shapes::torus(10, 12), shapes::grid(5, 9), shapes::house(), shapes::tetrahedron()}) {
        const auto mesh = native(shape);
        const level_type level(mesh);
        const auto once = [](const std::vector<int>& counts) {
            return std::ranges::count(counts, 1) == int(counts.size());
        };
        EXPECT_TRUE(once(visits(level, level.vertex_count(), [](auto b, auto f) { for_each(b.vertices(), f); })));
        EXPECT_TRUE(once(visits(level, level.edge_count(), [](auto b, auto f) { for_each(b.edges(), f); })));
        EXPECT_TRUE(once(visits(level, level.face_count(), [](auto b, auto f) { for_each(b.faces(), f); })));
        EXPECT_TRUE(once(visits(level, level.corner_count(), [](auto b, auto f) { for_each(b.corners(), f); })));
        EXPECT_TRUE(
            once(visits(level, level.vertex_count(), [](auto b, auto f) { for_each_by_number(b.vertices(), f); })));
    }
}

TEST(blocks, change_no_bit)
{
    const auto quads = native(shapes::shaken(shapes::torus(80, 70)));
    expect_same_bits(kith::catmull_clark(), quads);
    kith::catmull_clark creased;
    creased.sharpness.sharpen_edge(4321, 1.5);
    expect_same_bits(creased, quads);
    expect_same_bits(kith::catmull_clark(), native(shapes::shaken(shapes::grid(80, 70))));
    const auto triangles = kith::refine(native(shapes::shaken(shapes::tetrahedron())), kith::loop(), 6); // 16384
    expect_same_bits(kith::loop(), triangles);
    expect_same_bits(kith::butterfly(), triangles);
    expect_same_bits(kith::sqrt3(), triangles);
}

TEST(blocks, must_not_read_what_they_make)
{
    EXPECT_EQ(averages(false), "no error");
    EXPECT_NE(averages(true).find("is read before it is set"), std::string::npos);
}
