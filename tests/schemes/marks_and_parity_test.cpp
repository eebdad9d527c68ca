// SPDX-License-Identifier: BSD-3-Clause
#include "support/marks_and_parity.hpp"

#include "support/some_fields.hpp"
#include "support/tiles.hpp"

#include <kith/refine_in_tiles.hpp>

using namespace marks_and_parity;

namespace {

/// Expects "" from looks(mesh, scheme, level) for each tile of level 3, and for level 0 after a message.
template <class Scheme, class Looks>
void expect_in_tiles(const mesh3d& mesh, const Scheme& given, const Looks& looks)
{
    for (const std::size_t parts : {3, 5}) {
        const auto part_of = partitions::scattered(mesh.face_count(), parts, 2);
        EXPECT_EQ(tiles_differ(mesh, given, 3, part_of, parts, 1), "");
        kith::tiled_refinement refinement(mesh, given, 3, {part_of, parts}, 1);
        kith::tile_cutter cutter(mesh, given, part_of, parts);
        for (std::size_t p = 0; p < parts; ++p) {
            kith::phase_seconds seconds;
            const auto job = refinement.refine_job(p, kith::connect::everything, seconds);
            EXPECT_EQ(looks(job.part.mesh, job.scheme, 3), "");
            const auto cut = cutter.cut(std::uint32_t(p), 1);
            const auto bytes = kith::pack(cut);
            const auto other = kith::unpack<shapes::point, std::uint32_t>(bytes, some_fields::without_values(given));
            EXPECT_EQ(looks(other.part.mesh, other.scheme, 0), "");
            EXPECT_EQ(kith::pack(other), bytes);
        }
    }
}

} // namespace

TEST(marks_and_parity, are_fields_that_say_what_the_levels_say)
{
    for (const bool open : {false, true})
        expect_marks_and_parity(some_tri_quad(open), some_triangles(open));
}

TEST(marks_and_parity, are_cut_packed_and_refined_in_tiles)
{
    for (const bool open : {false, true}) {
        const auto halved = some_tri_quad(open), triangles = some_triangles(open);
        expect_in_tiles(halved, with_marks(halved), [](const auto& mesh, const auto& scheme, int) {
            return wrong_marks(mesh, scheme);
        });
        expect_in_tiles(triangles, with_parity(triangles, false), [](const auto&... arguments) {
            return wrong_parity(arguments...);
        });
    }
}

/// Marks chosen by the user become those of the mesh and are returned unchanged.
TEST(marks_and_parity, marks_of_a_users_own_come_back)
{
    const auto mesh = native(shapes::shape{{{0, 0, 0}, {2, 0, 0}, {2, 1, 1}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
    for (const auto& [a, b] : {std::pair(0U, 2U), std::pair(2U, 0U)}) {
        const auto marked = kith::mark_edges(mesh, {{a, b}});
        const auto marks = kith::marked_edges(marked);
        const kith::level_of<mesh3d> level(marked);
        for (const auto e : level.edges())
            EXPECT_EQ(marks[e.index()], e.org().index() + e.dst().index() == 2 and not e.is_boundary());
    }
}
