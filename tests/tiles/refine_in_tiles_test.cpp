// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/thread_count.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/kobbelt.hpp>
#include <kith/loop.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/require_reach.hpp>
#include <kith/tiles/part/checksum.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// A mid-edge scheme for closed meshes that is checked. At the rim of a tile it omits faces of vertices, so that other
/// faces meet in a single point.
struct checked_mid_edge {
    static constexpr auto traits()
    {
        return kith::scheme_traits{
            .name = "checked mid-edge", .closed_only = true, .reach = [](int rings) { return rings + 1; }};
    }
    static constexpr auto columns()
    {
        using namespace kith;
        return kith::columns(new_vertices(per_edge),
                             new_edges(per_corner),
                             new_faces(per_face.of_degree(same_degree{}),
                                       per_vertex.inside().of_degree([](const auto& v) { return v.valence(); })));
    }
    template <kith::step_context R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
        for_each(coarse.faces(), [&](auto f) {
            assoc(f, F) = polygon(f.corners(),
                                  [&](auto c) { return assoc(c.next_edge(), V) >> assoc(c.next(), E).left(); });
        });
        for_each(coarse.vertices(), [&](auto v) {
            if (not v.is_boundary())
                assoc(v, F) = polygon(v.corners(),
                                      [&](auto c) { return assoc(c.next_edge(), V) >> assoc(c, E).right(); });
        });
        for_each(coarse.edges(), [&](auto e) {
            const auto c = e.lcorner();
            assoc(e, V).starts_at(assoc(c.f(), F).corner(c.index() - c.f().first_corner().index()),
                                  assoc(c.next(), E).left());
        });
    }
};

std::string refusal(const mesh3d& mesh, int levels)
{
    return error_text<kith::mesh_error>(
        [&] { kith::tiled_refinement(mesh, kith::catmull_clark{}, levels, kith::block_partition(mesh, 2)); });
}

} // namespace

TEST(ring_schedule, has_an_entry_per_level)
{
    const kith::catmull_clark scheme;
    EXPECT_EQ(kith::ring_schedule(scheme, 1000).size(), 1001U);
    EXPECT_EQ(kith::ring_schedule(scheme, 2, 3).back(), 3);
    for (const int levels : {1001, 2147483647})
        EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::ring_schedule(scheme, levels); }),
                  "catmull-clark: " + std::to_string(levels) + " levels are too many; ask for at most 1000");
    EXPECT_EQ(error_text<kith::mesh_error>([&] { kith::ring_schedule(scheme, -1); }),
              "catmull-clark: negative levels or rings were asked for; ask for 0 or more");
}

TEST(tiled_refinement, needs_the_edges_of_the_control_mesh)
{
    const auto cube = native(shapes::cube());
    const kith::catmull_clark scheme;
    EXPECT_EQ(refusal(kith::refine(cube, scheme, 1), 1), "no error");
    EXPECT_EQ(refusal(kith::refine(cube, scheme, 1, {kith::connect::faces}), 1),
              "the mesh has face-vertex lists only and no edges; refine it with connect::everything");
}

TEST(tiled_refinement, refuses_levels_that_no_surface_has)
{
    const auto cube = native(shapes::cube());
    EXPECT_EQ(refusal(cube, 1000), "the whole mesh has more elements than 64 bits can number; refine fewer times");
    EXPECT_EQ(refusal(cube, 2147483647), "catmull-clark: 2147483647 levels are too many; ask for at most 1000");
}

TEST(tiled_refinement, gives_the_same_bits_on_several_threads)
{
    const auto cube = native(shapes::cube());
    const auto expected = kith::checksum(kith::refine(cube, kith::catmull_clark{}, 5));
    kith::tiled_refinement tiles(cube, kith::catmull_clark{}, 5, kith::block_partition(cube, 6));
    for (const int threads : {1, 2, 3, 6}) {
        const thread_count so_many(threads);
        std::atomic<std::uint64_t> sum = 0;
        kith::for_each_at_once(tiles.tiles(), kith::tiles_at_once(tiles.tiles()), [&](std::size_t t) {
            sum += kith::checksum(tiles.refine(t)).bits;
        });
        EXPECT_EQ(sum, expected.bits) << threads;
    }
}

TEST(for_each_at_once, calls_each_once_and_ends_after_an_error)
{
    const thread_count four(4);
    for (const std::size_t at_once : {1, 2, 4, 9}) {
        std::vector<std::atomic<int>> calls(100);
        kith::for_each_at_once(calls.size(), at_once, [&](std::size_t i) { ++calls[i]; });
        for (const auto& count : calls)
            EXPECT_EQ(count, 1);
        std::atomic<int> begun = 0;
        const auto fail = [&](std::size_t i) {
            ++begun;
            if (i == 3)
                throw std::runtime_error("the fourth");
        };
        EXPECT_EQ(error_text<std::runtime_error>([&] { kith::for_each_at_once(1'000'000, at_once, fail); }),
                  "the fourth");
        EXPECT_LT(begun, 1'000'000);
        kith::for_each_at_once(0, at_once, [](std::size_t) { FAIL(); });
    }
}

TEST(tiles_at_once, is_one_per_thread_unless_there_are_too_few)
{
    const thread_count four(4);
#if defined(_OPENMP)
    EXPECT_EQ(kith::tiles_at_once(64), 4U);
    EXPECT_EQ(kith::tiles_at_once(64, 3), 3U);
    EXPECT_EQ(kith::tiles_at_once(4), 4U);
#endif
    EXPECT_EQ(kith::tiles_at_once(3), 1U); // with four threads in its loops
    EXPECT_EQ(kith::tiles_at_once(0), 1U);
    EXPECT_EQ(kith::tiles_at_once(64, 0), 1U);
}

namespace {

/// Kobbelt's scheme with a different declared reach.
struct other_reach {
    int beyond_half = 0;

    static constexpr auto traits()
    {
        return kith::scheme_traits{
            .name = "other reach",
            .faces = kith::face_shape::quads,
            .trusted = true,
            .reach = [](const other_reach& s, int rings) { return (rings + 1) / 2 + s.beyond_half; }};
    }
    static constexpr auto columns() { return kith::kobbelt::columns(); }
    template <class R>
    void operator()(const R& r) const
    {
        kith::kobbelt()(r);
    }
};

} // namespace

TEST(require_reach, believes_what_is_true)
{
    const auto house = native(shapes::shaken(shapes::open_house()));
    kith::require_reach(house, kith::catmull_clark());
    kith::require_reach(house, kith::doo_sabin());
    kith::require_reach(native(shapes::shaken(shapes::triangulated(shapes::open_house()))), kith::loop());
    kith::require_reach(native(shapes::shaken(shapes::torus(5, 6))), other_reach{2});
}

TEST(require_reach, names_what_is_different)
{
    const auto text = error_text<kith::mesh_error>(
        [&] { kith::require_reach(native(shapes::shaken(shapes::torus(5, 6))), other_reach{0}); });
    EXPECT_TRUE(text.starts_with("other reach: with ")) << text;
    EXPECT_NE(text.find("differs from the whole mesh; a step reads more rings than traits().reach says"),
              std::string::npos)
        << text;
}

TEST(tiled_refinement, lets_a_scheme_for_closed_meshes_make_anything_at_the_rim_of_a_tile)
{
    const auto torus = native(shapes::shaken(shapes::torus(40, 40)));
    kith::partition parts{std::vector<std::uint32_t>(torus.face_count()), 40};
    for (std::uint32_t f = 0; f < parts.part_of.size(); ++f)
        parts.part_of[f] = (f * 2654435761U >> 7) % 40;
    const auto whole = kith::refine(torus, checked_mid_edge(), 2);
    kith::tiled_refinement tiles(torus, checked_mid_edge(), 2, parts);
    std::size_t faces = 0;
    for (std::size_t t = 0; t < tiles.tiles(); ++t) {
        const auto part = tiles.refine(t);
        for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
            for (std::size_t k = 0; k < part.mesh.face(f).size(); ++k)
                ASSERT_EQ(part.mesh.point(part.mesh.face(f)[k]), whole.point(whole.face(part.face_ids[f])[k]));
        faces += part.mesh.face_count();
    }
    EXPECT_EQ(faces, whole.face_count());
}
